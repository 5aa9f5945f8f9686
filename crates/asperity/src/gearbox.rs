//! Losses of seals, bearings, oil jets and tables on the shafts of a train.
//!
//! The meshes are computed with the whole torque of the case, and all losses count against the power in: what bearings and
//! seals take before a mesh is not taken off its torque. Bearings whose load is not stated carry the forces of all teeth on
//! their shaft, without friction of the teeth and without weights.

use std::borrow::Cow;

use asperity_core::OutOfRange;
use asperity_core::quantity::{AngularSpeed, Force, Power, Speed, Temperature, Torque, VolumeFlow};
use asperity_efficiency::EfficiencyError;
use asperity_efficiency::loss_table::LossTable;
use asperity_efficiency::oil_jet::jet_power;
use asperity_efficiency::shaft_seal::seal_torque;
use asperity_gear::gear_train::Torques;
use asperity_gear::planetary::{PlanetaryOperation, PlanetarySet, PlanetarySpeeds};
use asperity_gear::shaft_statics::{BearingLoad, ShaftForce, bearing_loads};
use asperity_oil::LubricantState;

use crate::result::gearbox::{GearboxPart, GearboxReport};
use asperity_case::case::train::Train;
use asperity_case::case::{
    BearingLoads, Case, Flow, Gearbox, Hand, MeshLoad, MeshPlace, PartKind, Shafting, StageKind,
};
use asperity_case::error::PositionError;

/// The losses of all parts of the gearbox at an operating point of the input shaft and a temperature of the operation, with the
/// loss of one mesh of each kind in each stage, which matter if the train passes them on; none without parts.
///
/// # Errors
/// When a speed or torque does not follow, a table does not reach the point, or the oil has no state at the temperature.
///
/// ```
/// use asperity::case::{self, MeshLoad};
/// use asperity::gearbox::parts;
/// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
/// let case = case::load_with(file, &|input| {
///     let seal = r#"[{ shaft = "pinion", diameter = "40 mm" }]"#;
///     let _ = input.set("gearbox.seals", seal);
/// })?;
/// let at = MeshLoad { torque: "145 N m".parse()?, speed: "3000 1/min".parse()? };
/// let found = parts(&case.into(), at, "90 °C".parse()?, &[])?;
/// assert!((found[0].loss_w - 36.912).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn parts(
    train: &Train,
    at: MeshLoad,
    temperature: Temperature,
    losses: &[Vec<Power>],
) -> Result<Vec<GearboxPart>, PositionError> {
    let Some(gearbox) = &train.gearbox else {
        return Ok(Vec::new());
    };
    Gears::of_train(train)?.parts(gearbox, at, temperature, losses)
}

/// The parts of the gearbox of a pair of gears at the operating point of its case.
pub(crate) fn parts_of_mesh(case: &Case) -> Result<Vec<GearboxPart>, PositionError> {
    let Some(gearbox) = &case.gearbox else {
        return Ok(Vec::new());
    };
    Gears::of_mesh(case).parts(
        gearbox,
        MeshLoad::from_case(case),
        case.stated_temperature,
        &[],
    )
}

/// The gearbox of a train with its meshes, and the flow of its powers.
pub(crate) fn report(
    train: &Train,
    flow: &Flow,
    losses: &[Vec<Power>],
) -> Result<Option<(GearboxReport, Flow)>, PositionError> {
    let Some(gearbox) = &train.gearbox else {
        return Ok(None);
    };
    Ok(Some(Gears::of_train(train)?.report(gearbox, flow, losses)?))
}

/// The gearbox of a pair of gears whose mesh loses `mesh`.
pub(crate) fn report_of_mesh(
    case: &Case,
    mesh: Power,
) -> Result<Option<GearboxReport>, PositionError> {
    let Some(gearbox) = &case.gearbox else {
        return Ok(None);
    };
    let gears = Gears::of_mesh(case);
    let losses = [vec![mesh]];
    let flow = gears.shafting.flow(&losses)?;
    Ok(Some(gears.report(gearbox, &flow, &losses)?.0))
}

/// Kind of a part, with the law of its loss.
const SEAL: (&str, &str) = ("seal", "ISO/TR 14179-2, as quoted");
const BEARING: (&str, &str) = ("bearing", "SKF's form");
const JET: (&str, &str) = ("jet", "Ariura, as quoted");
const TABLE: (&str, &str) = ("table", "the user's table");

/// Shafts from which a part takes its torque, each with its share of the torque.
type Drags = Vec<(usize, f64)>;

/// Kind and law of a part, its loss torque, and the inputs outside the range of the law.
type PartLoss = ((&'static str, &'static str), Torque, Vec<OutOfRange>);

/// Speeds and torques of the shafts.
#[derive(Clone, Copy)]
struct Turning<'a> {
    speeds: &'a [AngularSpeed],
    torques: &'a Torques,
}

/// The gears on their shafts.
struct Gears<'a> {
    shafting: Cow<'a, Shafting>,
    /// The first mesh of each stage.
    cases: Vec<&'a Case>,
}

/// Torque of the operation, speed of a part, and temperature of its oil.
struct At {
    torque: Torque,
    speed: AngularSpeed,
    temperature: Temperature,
}

impl<'a> Gears<'a> {
    fn of_train(train: &'a Train) -> Result<Self, PositionError> {
        let stages = train.stages.iter();
        let cases = stages.map(|stage| Some(&stage.meshes.first()?.case.case));
        Ok(Self {
            shafting: Cow::Borrowed(&train.shafting),
            cases: { cases.collect::<Option<Vec<_>>>() }
                .filter(|cases| !cases.is_empty())
                .ok_or_else(PositionError::no_profile)?,
        })
    }

    fn of_mesh(case: &'a Case) -> Self {
        Self {
            shafting: Cow::Owned(Shafting::of_one_mesh(case)),
            cases: vec![case],
        }
    }

    fn parts(
        &self,
        gearbox: &Gearbox,
        at: MeshLoad,
        temperature: Temperature,
        losses: &[Vec<Power>],
    ) -> Result<Vec<GearboxPart>, PositionError> {
        let there = self.shafting.at(at);
        let speeds = there.shafts.speeds()?;
        let torques = there.loading_torques(&speeds, losses)?;
        let turning = Turning {
            speeds: &speeds,
            torques: &torques,
        };
        let found = self.dragging(gearbox, turning, at.torque, temperature)?;
        Ok(found.into_iter().map(|(_, part)| part).collect())
    }

    /// The report on `gearbox`, and the flow of the powers with its parts.
    fn report(
        &self,
        gearbox: &Gearbox,
        flow: &Flow,
        losses: &[Vec<Power>],
    ) -> Result<(GearboxReport, Flow), PositionError> {
        let shafting = &self.shafting;
        let temperature = self.cases[0].stated_temperature;
        let torques = shafting.loading_torques(&flow.speeds, losses)?;
        let torque = shafting.operation().torque;
        let turning = Turning {
            speeds: &flow.speeds,
            torques: &torques,
        };
        let found = self.dragging(gearbox, turning, torque, temperature)?;
        let mut drags = vec![Torque::from_si(0.0); flow.speeds.len()];
        for (of_part, part) in &found {
            for (shaft, sign) in of_part {
                drags[*shaft] = drags[*shaft] + Torque::from_si(sign * part.torque_nm);
            }
        }
        let input = flow.power_in();
        let flow = shafting.with_drags(&drags).flow(losses)?;
        let parts: Vec<GearboxPart> = found.into_iter().map(|(_, part)| part).collect();
        let parts_w: f64 = parts.iter().map(|part| part.loss_w).sum();
        let loss_w = shafting.loss(losses).si() + parts_w;
        // Losses above the power in enter through the output as well, and none is left.
        if flow.power_out().si() == 0.0 {
            let loss = Power::from_si(loss_w);
            return Err(EfficiencyError::loss_exceeds_input(loss, input).into());
        }
        let power_in_w = flow.power_in().si();
        let report = GearboxReport {
            efficiency: 1.0 - loss_w / power_in_w,
            loss_w,
            parts_w,
            power_in_w,
            temperature_c: gearbox.temperature.unwrap_or(temperature).celsius(),
            parts,
        };
        Ok((report, flow))
    }

    /// The parts, at a torque and a temperature of the operation, with the shafts of each.
    fn dragging(
        &self,
        gearbox: &Gearbox,
        turning: Turning<'_>,
        torque: Torque,
        temperature: Temperature,
    ) -> Result<Vec<(Drags, GearboxPart)>, PositionError> {
        let temperature = gearbox.temperature.unwrap_or(temperature);
        let mut found = Vec::with_capacity(gearbox.parts.len());
        for part in &gearbox.parts {
            let named = |error| PositionError::gearbox_part(&part.name, error);
            let (relative, shafts) = self.relative(part.shaft, &part.kind, turning)?;
            let at = At {
                torque,
                speed: AngularSpeed::from_si(relative.abs()),
                temperature,
            };
            let ((kind, law), torque, outside) =
                (self.loss(gearbox, part.shaft, &part.kind, turning, &at)).map_err(named)?;
            let of_part = GearboxPart::new(&part.name, [kind, law], torque, at.speed, &outside);
            let against = shafts
                .into_iter()
                .map(|(shaft, share)| (shaft, share * relative.signum()));
            found.push((against.collect(), of_part));
        }
        Ok(found)
    }

    /// Speed of a part \[rad/s\], and the shafts that its torque acts on: two of them, or a shaft and the housing.
    fn relative(
        &self,
        shaft: usize,
        kind: &PartKind,
        turning: Turning<'_>,
    ) -> Result<(f64, Drags), PositionError> {
        let speed_of = |shaft: usize| turning.speeds[shaft].si();
        Ok(match *kind {
            PartKind::Table {
                against: Some(other),
                ..
            } => (
                speed_of(shaft) - speed_of(other),
                vec![(shaft, 1.0), (other, -1.0)],
            ),
            PartKind::PlanetBearing { stage, .. } => {
                let turns = self.planet(stage, turning)?.1;
                // ω_p − ω_c = −(ω_s − ω_c) z_s/z_p.
                (turns.planet_relative.si(), self.planet_shafts(stage))
            }
            _ => (speed_of(shaft), vec![(shaft, 1.0)]),
        })
    }

    /// Kind, law and loss torque of a part, with the inputs outside the range of the law.
    fn loss(
        &self,
        gearbox: &Gearbox,
        shaft: usize,
        kind: &PartKind,
        turning: Turning<'_>,
        at: &At,
    ) -> Result<PartLoss, PositionError> {
        let inside = |law, torque| Ok((law, torque, Vec::new()));
        // A shaft that does not turn loses nothing.
        let stands = at.speed.si() == 0.0;
        let none = Torque::from_si(0.0);
        match kind {
            PartKind::Seal(_) if stands => inside(SEAL, none),
            PartKind::Bearing { .. } | PartKind::PlanetBearing { .. } if stands => {
                inside(BEARING, none)
            }
            PartKind::Jet { .. } if stands => inside(JET, none),
            PartKind::Table { .. } if stands => inside(TABLE, none),
            PartKind::Seal(diameter) => inside(SEAL, seal_torque(*diameter)?),
            PartKind::Bearing { bearing, load } => {
                let load = match load {
                    BearingLoads::Stated { load, at_torque } => {
                        let growth = at_torque.map_or(1.0, |stated| (at.torque / stated).abs());
                        load.map(|force| Force::from_si(force.si() * growth))
                    }
                    BearingLoads::OfTeeth {
                        places,
                        number,
                        locating,
                    } => {
                        let forces = self.forces(gearbox, shaft, turning.torques)?;
                        let BearingLoad { radial, axial } =
                            bearing_loads(*places, *locating, &forces)?[*number];
                        [radial, axial]
                    }
                };
                let torque = bearing.torque(load, at.speed, self.oil(at)?.kinematic_viscosity)?;
                Ok((BEARING, torque.value.total(), torque.outside))
            }
            PartKind::PlanetBearing {
                stage,
                bearing,
                mass,
                per_planet,
            } => {
                let (set, _, operation) = self.planet(*stage, turning)?;
                let load = set.planet_load(&operation, *mass)? / f64::from(*per_planet);
                let load = [load, Force::from_si(0.0)];
                let torque = bearing.torque(load, at.speed, self.oil(at)?.kinematic_viscosity)?;
                let count = f64::from(set.planets * per_planet);
                Ok((BEARING, torque.value.total() * count, torque.outside))
            }
            PartKind::Jet { stage, flow, speed } => {
                inside(JET, jet_torque(self.cases[*stage], *flow, *speed, at)?)
            }
            PartKind::Table { table, .. } => inside(TABLE, table_torque(table, at)?),
        }
    }

    /// The oil of all meshes.
    fn oil(&self, at: &At) -> Result<LubricantState, PositionError> {
        Ok(self.cases[0].lubricant.at(at.temperature)?.value)
    }

    /// Set of a stage, its speeds, and its operating point.
    fn planet(
        &self,
        stage: usize,
        turning: Turning<'_>,
    ) -> Result<(&PlanetarySet, PlanetarySpeeds, PlanetaryOperation), PositionError> {
        let StageKind::Planetary {
            set,
            load_share_factor,
        } = &self.shafting.kinds[stage]
        else {
            return Err(PositionError::no_profile());
        };
        let gears = self.shafting.shafts.stages[stage].gears;
        let [sun_speed, ring_speed] = gears.map(|shaft| turning.speeds[shaft]);
        let [sun_torque, _, _] = turning.torques.stages[stage];
        let operation = PlanetaryOperation {
            sun_torque,
            sun_speed,
            ring_speed,
            load_share_factor: *load_share_factor,
        };
        Ok((set, set.speeds(sun_speed, ring_speed)?, operation))
    }

    /// Sun and carrier of a set, with their shares of a torque between planets and carrier.
    fn planet_shafts(&self, stage: usize) -> Drags {
        let shafts = &self.shafting.shafts.stages[stage];
        let StageKind::Planetary { set, .. } = &self.shafting.kinds[stage] else {
            return Vec::new();
        };
        let [sun, planet] = set.sun_planet.teeth.map(f64::from);
        let carrier = shafts.carrier.map(|carrier| (carrier, sun / planet));
        std::iter::once((shafts.gears[0], -sun / planet))
            .chain(carrier)
            .collect()
    }

    /// Forces of all teeth on a shaft.
    fn forces(
        &self,
        gearbox: &Gearbox,
        shaft: usize,
        torques: &Torques,
    ) -> Result<Vec<ShaftForce>, PositionError> {
        let mut forces = Vec::new();
        for (stage, place) in self.shafting.shafts.places_of(shaft) {
            let gears = &self.cases[stage].gears;
            let MeshPlace {
                at,
                angle,
                hand,
                is_set,
                ..
            } = &gearbox.places[stage];
            // Without need of a place it does not matter.
            let (at, direction) = (at.unwrap_or_default(), angle.unwrap_or_default());
            let [torque, _, _] = torques.stages[stage];
            let of_gears = gears.shaft_forces(torque, at, direction, *hand == Some(Hand::Left))?;
            let balanced = |on: ShaftForce| ShaftForce {
                force: [0.0, 0.0, on.force[2]],
                arm: [0.0; 2],
                ..on
            };
            match (place, *is_set) {
                (0 | 1, false) => forces.push(of_gears[place]),
                // The planets hold the radial forces of sun and ring in balance, and none of theirs reaches the carrier.
                (0 | 1, true) => forces.push(balanced(of_gears[place])),
                _ => {}
            }
        }
        Ok(forces)
    }
}

/// Torque of an oil jet onto the gears of `case` at its pinion.
fn jet_torque(
    case: &Case,
    flow: VolumeFlow,
    speed: Speed,
    at: &At,
) -> Result<Torque, PositionError> {
    let oil = case.lubricant.at(at.temperature)?.value;
    let radius = case.gears.working_pitch_radius[0].si().abs();
    let pitch = Speed::from_si(at.speed.si() * radius);
    let power = jet_power(oil.density, flow, pitch, speed)?;
    Ok(Torque::from_si(power.si() / at.speed.si()))
}

/// Loss torque of a table.
fn table_torque(table: &LossTable, at: &At) -> Result<Torque, PositionError> {
    let rpm = at.speed.si() * 30.0 / std::f64::consts::PI;
    let celsius = at.temperature.celsius();
    // Nodes written in 1/min and °C are met although both are kept in SI.
    let torque = table.loss_torque(at.torque.si(), rounded(rpm), rounded(celsius))?;
    Ok(Torque::from_si(torque))
}

/// A number without the last bits that a change of its unit leaves.
fn rounded(value: f64) -> f64 {
    const DIGITS: f64 = 1e9;
    (value * DIGITS).round() / DIGITS
}
