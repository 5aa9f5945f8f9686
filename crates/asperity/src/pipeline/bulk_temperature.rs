//! Equilibrium bulk temperature of the flanks.
//!
//! Film and friction see the flanks' bulk temperature; where a case states the temperature of the oil instead, the loss
//! causes the rise and the rise changes the loss. The rough contacts are solved once: a further temperature costs film
//! laws only. All properties of the oil, its density included, are taken at the bulk temperature.

use asperity_core::provenance::Provenance;
use asperity_core::quantity::{Length, Power, Speed, Temperature};
use asperity_efficiency::bulk_temperature::{
    self, BulkTemperature, fixed_point, iso_rise, lowest_fixed_point,
};
use asperity_tribo_friction::flash::heat_share;

use crate::mesh::Mesh;
use crate::result::Losses;
use asperity_case::case::{BulkModel, BulkReport, LoadedCase, Lubrication, OperatingCase};
use asperity_case::error::{Error, PositionError};

/// The case at the bulk temperature of `model`; `losses` computes a case at a bulk temperature, and `mesh` its mesh.
/// A hotter equilibrium is sought if `seeks_hotter` is set.
pub(crate) fn settle(
    loaded: &LoadedCase,
    model: BulkModel,
    mesh: impl Fn(&LoadedCase) -> Result<Mesh, PositionError>,
    losses: impl Fn(&OperatingCase) -> Result<Losses, Error>,
    seeks_hotter: bool,
) -> Result<OperatingCase, Error> {
    let used = Provenance::new();
    let law = used.collect(|| EquilibriumLaw::new(loaded, model, mesh));
    let law = law.map_err(Box::new)?;
    let oil = loaded.case.stated_temperature;
    let made = |bulk: Temperature| {
        let losses = losses(&loaded.at(bulk)?)?;
        let [pinion, wheel] = law
            .rises(Power::from_si(losses.summary.loss_w))
            .map_err(Box::new)?;
        Ok::<_, Error>(Temperature::from_si(oil.si() + 0.5 * (pinion + wheel)))
    };
    let found = used.collect(|| {
        if seeks_hotter {
            fixed_point(oil, made)
        } else {
            lowest_fixed_point(oil, made)
        }
    })?;
    loaded.at_found(found.temperature, law.report(oil, &found), &used)
}

/// Power of the loss to which the rise of a law is proportional.
pub(super) const fn rise_exponent(model: BulkModel) -> f64 {
    match model {
        BulkModel::Iso(_) => bulk_temperature::OSTER_EXPONENT,
        BulkModel::Network(_) => 1.0,
    }
}

/// A law with what it needs of the case.
struct EquilibriumLaw<'a> {
    loaded: &'a LoadedCase,
    model: BulkModel,
    /// Share of the heat that goes into the pinion.
    pinion: f64,
}

impl<'a> EquilibriumLaw<'a> {
    fn new(
        loaded: &'a LoadedCase,
        model: BulkModel,
        mesh: impl Fn(&LoadedCase) -> Result<Mesh, PositionError>,
    ) -> Result<Self, PositionError> {
        let pinion = match model {
            BulkModel::Iso(_) => 0.5,
            BulkModel::Network(_) => pinion_share(loaded, &mesh(loaded)?)?,
        };
        Ok(Self {
            loaded,
            model,
            pinion,
        })
    }

    /// Rises of pinion and wheel over the oil \[K\].
    fn rises(&self, loss: Power) -> Result<[f64; 2], PositionError> {
        Ok(match self.model {
            BulkModel::Iso(lubrication) => {
                let gears = &self.loaded.case.gears;
                // The centre distance of a ring is negative.
                let distance = Length::from_si(gears.centre_distance.si().abs());
                let width = gears.face_width;
                [iso_rise(loss, distance, width, lubrication.factor())?; 2]
            }
            BulkModel::Network(network) => network.rises(loss, self.pinion)?,
        })
    }

    fn report(&self, oil: Temperature, found: &BulkTemperature) -> BulkReport {
        let celsius = Temperature::celsius;
        let [hotter, from] = found.hotter_ends(oil);
        let is_network = matches!(self.model, BulkModel::Network(_));
        // The rises are in proportion to the loss, so that their ratio is known from any.
        let rises = self.rises(Power::from_si(1.0)).ok();
        let rise = found.temperature.si() - oil.si();
        let split = rises.map(|[a, b]| [a, b].map(|one| celsius(oil) + rise * 2.0 * one / (a + b)));
        BulkReport {
            law: match self.model {
                BulkModel::Iso(lubrication) => {
                    format!("iso, unconfirmed, {}", words(lubrication))
                }
                BulkModel::Network(_) => "network".to_owned(),
            },
            oil_c: celsius(oil),
            bulk_c: celsius(found.temperature),
            gears_c: split.filter(|_| is_network),
            pinion_heat_share: is_network.then_some(self.pinion),
            residual_k: found.residual,
            steps: found.steps,
            hotter_c: hotter.map(celsius),
            runs_away_from_c: from.map(celsius),
        }
    }
}

const fn words(lubrication: Lubrication) -> &'static str {
    match lubrication {
        Lubrication::Jet => "jet",
        Lubrication::Dip => "dip",
        Lubrication::JetAndDip => "jet and dip",
        Lubrication::Submerged => "submerged",
    }
}

/// Mean over the path of the share of the frictional heat that goes into the pinion.
fn pinion_share(loaded: &LoadedCase, mesh: &Mesh) -> Result<f64, PositionError> {
    let [pinion, wheel] = &loaded.case.materials;
    let (mut sum, mut weight) = (0.0, 0.0);
    for at in &mesh.positions {
        let speeds = [at.motion.u1, at.motion.u2];
        let speeds = speeds.map(|speed| Speed::from_si(speed.si().abs()));
        sum += at.weight * heat_share([pinion, wheel], speeds)?;
        weight += at.weight;
    }
    Ok(sum / weight)
}
