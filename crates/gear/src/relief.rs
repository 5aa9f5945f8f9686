//! Modifications of the flanks, as drawings give them, and the gap that they open between the teeth.
//!
//! Source: ISO 21771:2007 and ISO 1328-1:2013 (definitions).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | e(ξ, y) | separation of unloaded flanks, normal to the flank; positive removes material | m |
//! | C_a, L, n | amount, roll length and power of a relief | m, m, - |
//! | C_c, C_l, C_p, C_Ca | crowning, lead slope, profile slope, profile crowning of the pair | m |
//! | b | face width | m |
//!
//! Amounts count along the transverse base tangent, as inspection charts print them, and are then
//! multiplied by cos β_b; [`AmountDirection::Normal`] takes them normal to the flank as they are.

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::Length;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{Gear, GearError};
use crate::pair::GearPair;

/// The direction in which amounts are measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum AmountDirection {
    /// Along the transverse base tangent (ISO 1328).
    #[default]
    Transverse,
    /// Normal to the flank.
    Normal,
}

/// Extent of a relief.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum ReliefExtent {
    /// Roll length from the end of the active flank.
    RollLength(Length),
    /// Diameter at which the relief starts.
    StartDiameter(Length),
}

/// Shape of a relief from its start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum ReliefShape {
    /// In proportion to the roll length, n = 1.
    #[default]
    Linear,
    /// With its square, n = 2.
    Parabolic,
}

/// Relief of the tips or roots of a gear.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Relief {
    /// Amount at the end of the active flank.
    pub amount: Length,
    /// Extent of the relief.
    pub extent: ReliefExtent,
    /// Shape of the relief.
    #[serde(default)]
    pub shape: ReliefShape,
}

/// Relief of both ends of the face.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EndRelief {
    /// Amount at the ends of the face width.
    pub amount: Length,
    /// Length along the face width.
    pub length: Length,
    /// Shape of the relief.
    #[serde(default)]
    pub shape: ReliefShape,
}

/// All modifications of a pair. Index 0 is gear 1; the rest is the sum over both gears.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MicroGeometry {
    /// Tip relief of each gear.
    pub tip_relief: [Option<Relief>; 2],
    /// Root relief of each gear.
    pub root_relief: [Option<Relief>; 2],
    /// Crowning C_c along the face, zero in the middle.
    pub crowning: Length,
    /// Relief of both ends of the face.
    pub end_relief: Option<EndRelief>,
    /// Lead slope C_l over the face: cutting, bearings and shafts together.
    pub lead_slope: Length,
    /// Profile slope C_p over the path of contact.
    pub profile_slope: Length,
    /// Profile crowning C_Ca, zero in the middle of the path.
    pub profile_crowning: Length,
    /// Pitch deviations of successive pairs of teeth; the mesh cycle has as many pitches.
    pub pitch: Vec<Length>,
    /// The direction in which all amounts are measured.
    pub direction: AmountDirection,
}

impl MicroGeometry {
    /// Tip relief of this amount, roll length and shape on both gears.
    ///
    /// ```
    /// use asperity_gear::{MicroGeometry, ReliefShape};
    /// let relief = MicroGeometry::tip_relief("10 um".parse()?, "2.9 mm".parse()?, ReliefShape::Linear);
    /// assert_eq!(relief.tip_relief[0], relief.tip_relief[1]);
    /// assert!(!relief.is_unmodified());
    /// # Ok::<(), asperity_core::quantity::QuantityError>(())
    /// ```
    pub fn tip_relief(amount: Length, roll_length: Length, shape: ReliefShape) -> Self {
        let relief = Relief {
            amount,
            extent: ReliefExtent::RollLength(roll_length),
            shape,
        };
        Self {
            tip_relief: [Some(relief); 2],
            ..Self::default()
        }
    }

    /// Whether nothing is modified.
    pub fn is_unmodified(&self) -> bool {
        let slopes = [
            self.crowning,
            self.lead_slope,
            self.profile_slope,
            self.profile_crowning,
        ];
        self.tip_relief == [None; 2]
            && self.root_relief == [None; 2]
            && self.end_relief.is_none()
            && slopes.iter().all(|c| c.si() == 0.0)
            && self.pitch.iter().all(|c| c.si() == 0.0)
    }

    /// Whether tips or roots are relieved.
    pub fn relieves_profile(&self) -> bool {
        self.tip_relief != [None; 2] || self.root_relief != [None; 2]
    }
}

/// A relief in the coordinates of the path.
#[derive(Debug, Clone, Copy)]
struct End {
    /// ξ from which it grows.
    start: f64,
    /// Towards E when positive.
    direction: f64,
    /// Length in base pitches.
    length: f64,
    amount: f64,
    squared: bool,
}

impl End {
    fn at(&self, xi: f64) -> f64 {
        let t = ((xi - self.start) * self.direction / self.length).max(0.0);
        self.amount * if self.squared { t * t } else { t }
    }
}

/// e(ξ, y) of a pair, in SI units and normal to the flank.
#[derive(Debug, Clone)]
pub(crate) struct Separation {
    ends: Vec<End>,
    crowning: f64,
    end_relief: Option<(f64, f64, bool)>,
    lead_slope: f64,
    profile_slope: f64,
    profile_crowning: f64,
    pitch: Vec<f64>,
    eps_alpha: f64,
}

impl Separation {
    pub(crate) fn new(micro: &MicroGeometry, pair: &GearPair) -> Result<Self, GearError> {
        cite!("Relief-1");
        let to_normal = match micro.direction {
            AmountDirection::Transverse => pair.base_helix.si().cos(),
            AmountDirection::Normal => 1.0,
        };
        let normal = |name, amount: Length| -> Result<f64, DomainError> {
            Ok(to_normal * DomainError::finite(name, amount)?)
        };
        let mut ends = Vec::new();
        for gear in 0..2 {
            for (relief, tip) in [
                (micro.tip_relief[gear], true),
                (micro.root_relief[gear], false),
            ] {
                let Some(relief) = relief else { continue };
                let amount = normal("relief", relief.amount)?;
                let length =
                    roll_length(pair, gear, tip, relief.extent)? / pair.path.base_pitch.si();
                // The tip of gear 1 and the root of gear 2 touch at E.
                let at_e = (gear == 0) == tip;
                ends.push(End {
                    start: if at_e {
                        pair.path.eps_alpha - length
                    } else {
                        length
                    },
                    direction: if at_e { 1.0 } else { -1.0 },
                    length,
                    amount,
                    squared: relief.shape == ReliefShape::Parabolic,
                });
            }
        }
        let width = pair.face_width.si();
        let end_relief = match micro.end_relief {
            None => None,
            Some(end) => Some((
                normal("end relief", end.amount)?,
                DomainError::positive("length of the end relief", end.length)? / width,
                end.shape == ReliefShape::Parabolic,
            )),
        };
        let pitch = (micro.pitch.iter())
            .map(|p| normal("pitch deviation", *p))
            .collect::<Result<Vec<f64>, _>>()?;
        Ok(Self {
            ends,
            crowning: normal("crowning", micro.crowning)?,
            end_relief,
            lead_slope: normal("lead slope", micro.lead_slope)?,
            profile_slope: normal("profile slope", micro.profile_slope)?,
            profile_crowning: normal("profile crowning", micro.profile_crowning)?,
            pitch: if pitch.is_empty() { vec![0.0] } else { pitch },
            eps_alpha: pair.path.eps_alpha,
        })
    }

    /// e = Σ C_a ((ξ − ξ₁) p_et/L)ⁿ + C_c (2y/b − 1)² + C_l (y/b − ½) + C_p (ξ/ε_α − ½)
    /// + C_Ca (2ξ/ε_α − 1)² + pitch                                            [Relief-1]
    ///
    /// `across` is y/b; `tooth` counts the pairs of teeth.
    pub(crate) fn at(&self, xi: f64, across: f64, tooth: i64) -> f64 {
        let along = xi / self.eps_alpha - 0.5;
        let from_middle = across - 0.5;
        let profile = self.profile_slope * along + self.profile_crowning * 4.0 * along * along;
        let lead = self.lead_slope * from_middle + self.crowning * 4.0 * from_middle * from_middle;
        let reliefs: f64 = self.ends.iter().map(|end| end.at(xi)).sum();
        let face_ends = self.end_relief.map_or(0.0, |(amount, length, squared)| {
            let t = (1.0 - across.min(1.0 - across) / length).max(0.0);
            amount * if squared { t * t } else { t }
        });
        let turn = tooth.rem_euclid(self.pitch.len() as i64) as usize;
        reliefs + profile + lead + face_ends + self.pitch.get(turn).copied().unwrap_or(0.0)
    }

    /// Coordinates within the path where a relief starts.
    pub(crate) fn knots(&self) -> Vec<f64> {
        (self.ends.iter().map(|end| end.start))
            .filter(|xi| *xi > 0.0 && *xi < self.eps_alpha)
            .collect()
    }

    pub(crate) fn varies_across_the_face(&self) -> bool {
        self.crowning != 0.0 || self.lead_slope != 0.0 || self.end_relief.is_some()
    }

    /// Number of pitches after which the deviations repeat.
    pub(crate) fn pitches(&self) -> usize {
        self.pitch.len()
    }
}

/// L = |√(r_end² − r_b²) − √(r_start² − r_b²)|                                    [Relief-2]
///
/// The end is that of the active flank: the tip, or the lowest point of contact.
fn roll_length(
    pair: &GearPair,
    gear: usize,
    tip: bool,
    extent: ReliefExtent,
) -> Result<f64, GearError> {
    cite!("Relief-2");
    let diameter = match extent {
        ReliefExtent::RollLength(length) => {
            return Ok(DomainError::positive("roll length of the relief", length)?);
        }
        ReliefExtent::StartDiameter(diameter) => diameter,
    };
    let radius = 0.5 * DomainError::positive("start diameter of the relief", diameter)?;
    let base = pair.base_radius[gear].si().abs();
    DomainError::require(
        radius >= base,
        "start diameter of the relief",
        diameter.si(),
        "m",
        "must not be below the base circle",
    )?;
    let start = ((radius - base) * (radius + base)).sqrt();
    let end_of_path = if (gear == 0) == tip {
        pair.path.e
    } else {
        pair.path.a
    };
    let end = match gear {
        0 => end_of_path.si(),
        _ => (pair.path.t1t2 - end_of_path).si().abs(),
    };
    // Roll lengths grow towards the tip, on a ring towards the root.
    let towards_tip = if pair.internal && gear == 1 {
        -1.0
    } else {
        1.0
    };
    let length = (end - start) * towards_tip * if tip { 1.0 } else { -1.0 };
    if length > 0.0 {
        Ok(length)
    } else {
        Err(GearError::ReliefStart {
            gear: if gear == 0 { Gear::Pinion } else { Gear::Wheel },
            diameter,
            length: Length::from_si(length),
        })
    }
}
