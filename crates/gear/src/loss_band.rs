//! Uncertainty of the loss factor of a load map due to its constants, and the effect of tip edge contact.
//!
//! | source | range | from |
//! |---|---|---|
//! | factor C_M of theory to measurement | 0.65 to 1.0 | spread of theory and measurement |
//! | coupling along the face, λ/m_n | 1.2 to 2.0 | finite elements |
//! | tip edge contact, only without relief | off to on | edges wear in |
//! | tip chamfer | 0 to 0.1 m_n | drawings that name none |
//! | amounts of tip relief | given tolerance | drawing |

use asperity_core::Estimate;
use asperity_core::numerics::range;
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use crate::error::GearError;
use crate::load_map::{LoadMap, LoadMapSettings};
use crate::relief::MicroGeometry;

/// Range of the factor C_M.
const STIFFNESS_FACTORS: [f64; 2] = [0.65, 1.0];

/// Range of the coupling along the face, in normal modules.
const FACE_COUPLINGS: [f64; 2] = [1.2, 2.0];

/// Upper bound of a chamfer that a drawing does not state, in normal modules.
const UNSTATED_CHAMFER: f64 = 0.1;

/// Approach above which tip edge contact of unrelieved teeth is reported.
const NOTEWORTHY_APPROACH: Length = Length::from_si(5e-6);

/// A cause of uncertainty.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BandSource {
    /// Factor of theory to measurement.
    StiffnessFactor,
    /// Coupling along the face.
    FaceCoupling,
    /// Contact of tip edges outside the path of contact.
    EdgeContact,
    /// A tip chamfer that the case does not state.
    TipChamfer,
    /// Tolerance of the amounts of tip relief.
    ReliefAmount,
}

/// Range of the loss factor due to one cause.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BandPart {
    /// The cause.
    pub source: BandSource,
    /// Lowest H_V, at most the value of the map.
    pub low: f64,
    /// Highest H_V, at least the value of the map.
    pub high: f64,
}

/// Uncertainty interval of the loss factor.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LossFactorBand {
    /// H_V of the map; its ends are the deviations of the parts combined as a root sum of squares.
    #[serde(flatten)]
    pub whole: Estimate,
    /// The individual causes that apply to the pair.
    pub parts: Vec<BandPart>,
}

/// Effect of contact of tip edges on a pair without relief.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct EdgeContactNote {
    /// Mean approach of the teeth, normal to the flank.
    pub approach: Length,
    /// H_V without contact outside the path of contact.
    pub without: f64,
    /// H_V with tip edge contact.
    pub with: f64,
}

impl LoadMap {
    /// The uncertainty interval of H_V; `None` for laws without deflections.
    ///
    /// `relief_tolerance` is the tolerance of the amounts of tip relief. Each part costs one or two load maps.
    ///
    /// # Errors
    /// As [`LoadMap::new`].
    pub fn loss_factor_band(
        &self,
        relief_tolerance: Option<Length>,
    ) -> Result<Option<LossFactorBand>, GearError> {
        if !self.is_elastic() {
            return Ok(None);
        }
        let mut parts = Vec::new();
        let mut part = |source, factors: Vec<f64>| {
            let [low, high] = range(factors.into_iter().chain([self.loss_factor()]));
            parts.push(BandPart { source, low, high });
        };
        let settings = self.settings();
        part(
            BandSource::StiffnessFactor,
            self.factors(STIFFNESS_FACTORS.map(|stiffness_factor| LoadMapSettings {
                stiffness_factor,
                ..*settings
            }))?,
        );
        if !self.gears().is_spur() {
            part(
                BandSource::FaceCoupling,
                self.factors(FACE_COUPLINGS.map(|face_coupling| LoadMapSettings {
                    face_coupling,
                    ..*settings
                }))?,
            );
        }
        if let Some(with) = self.with_edge_contact()? {
            part(BandSource::EdgeContact, vec![with]);
        }
        let chamfer = self.gears().normal_module * UNSTATED_CHAMFER;
        // Without its full tips a pair may have no continuous contact.
        if let Ok(pair) = self.gears().with_tip_chamfer([chamfer; 2]) {
            let chamfered = self.variant(&pair, self.micro_geometry(), settings)?;
            part(BandSource::TipChamfer, vec![chamfered.loss_factor()]);
        }
        if let Some(tolerance) = relief_tolerance {
            let factors = [tolerance, -tolerance]
                .into_iter()
                .map(|change| {
                    let micro = with_relief_changed(self.micro_geometry(), change);
                    Ok(self.variant(self.gears(), &micro, settings)?.loss_factor())
                })
                .collect::<Result<Vec<f64>, GearError>>()?;
            part(BandSource::ReliefAmount, factors);
        }
        Ok(Some(combine(self.loss_factor(), parts)))
    }

    /// Effect of tip edge contact on unrelieved teeth with an approach above 5 µm; `None` if the map already includes
    /// it.
    ///
    /// # Errors
    /// As [`LoadMap::new`].
    pub fn edge_contact_note(&self) -> Result<Option<EdgeContactNote>, GearError> {
        let Some(approach) = self.evidence().mean_approach else {
            return Ok(None);
        };
        if approach <= NOTEWORTHY_APPROACH {
            return Ok(None);
        }
        Ok(self.with_edge_contact()?.map(|with| EdgeContactNote {
            approach,
            without: self.loss_factor(),
            with,
        }))
    }

    fn with_edge_contact(&self) -> Result<Option<f64>, GearError> {
        let with = || self.solved_with_edge_contact();
        Ok(*self.edge_contact.get_or_make(with)?)
    }

    fn solved_with_edge_contact(&self) -> Result<Option<f64>, GearError> {
        let known = self.settings().edge_contact || !self.is_elastic();
        if known || self.gears().internal || self.micro_geometry().relieves_profile() {
            return Ok(None);
        }
        let settings = LoadMapSettings {
            edge_contact: true,
            ..*self.settings()
        };
        let with = self.variant(self.gears(), self.micro_geometry(), &settings)?;
        Ok(Some(with.loss_factor()))
    }

    fn factors(&self, settings: [LoadMapSettings; 2]) -> Result<Vec<f64>, GearError> {
        (settings.iter())
            .map(|settings| {
                let map = self.variant(self.gears(), self.micro_geometry(), settings)?;
                Ok(map.loss_factor())
            })
            .collect()
    }
}

/// `micro` with all amounts of tip relief changed by `change`, but not below zero.
fn with_relief_changed(micro: &MicroGeometry, change: Length) -> MicroGeometry {
    let mut changed = micro.clone();
    for relief in changed.tip_relief.iter_mut().flatten() {
        relief.amount = Length::from_si((relief.amount + change).si().max(0.0));
    }
    changed
}

fn combine(value: f64, parts: Vec<BandPart>) -> LossFactorBand {
    let root_sum = |deviation: fn(&BandPart, f64) -> f64| {
        let squares: f64 = parts
            .iter()
            .map(|part| deviation(part, value).powi(2))
            .sum();
        squares.sqrt()
    };
    LossFactorBand {
        whole: Estimate {
            value,
            low: value - root_sum(|part, value| value - part.low),
            high: value + root_sum(|part, value| part.high - value),
        },
        parts,
    }
}
