//! Flank modifications as stated on drawings, and the resulting separation of the flanks.
//!
//! Source: ISO 21771:2007 and ISO 1328-1:2013 (definitions).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | e(ξ, y) | separation of unloaded flanks, normal to the flank; positive for removed material | m |
//! | C_a, L, n | amount, roll length and exponent of a relief | m, m, - |
//! | C_c, C_l, C_p, C_Ca | crowning, lead slope, profile slope, profile crowning of the pair | m |
//! | w_i(ρ) | measured form of gear i over its roll length, above the involute | m |
//! | b | face width | m |
//!
//! Amounts are measured along the transverse base tangent, as on inspection charts, and multiplied by cos β_b. With
//! [`AmountDirection::Normal`] they are normal to the flank.

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::numerics::{interpolate, interpolate_between};
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use crate::error::{Gear, GearError};
use crate::pair::GearPair;

/// The direction in which amounts are measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum AmountDirection {
    /// Along the transverse base tangent (ISO 1328).
    #[default]
    Transverse,
    /// Normal to the flank.
    Normal,
}

/// Extent of a relief.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum ReliefExtent {
    /// Roll length from the end of the active flank.
    RollLength(Length),
    /// Diameter at which the relief starts.
    StartDiameter(Length),
}

/// Shape of a relief from its start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum ReliefShape {
    /// Proportional to the roll length, n = 1.
    #[default]
    Linear,
    /// Proportional to the square of the roll length, n = 2.
    Parabolic,
}

/// Tip or root relief of a gear.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
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

/// End relief at both ends of the face.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
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

/// Measured form deviation of the flank of a gear from the involute, normal to the flank.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MeasuredForm {
    /// Roll lengths in ascending order.
    pub roll_length: Vec<Length>,
    /// Heights above the involute at the roll lengths, with linear interpolation, constant beyond the ends.
    pub height: Vec<Length>,
}

impl MeasuredForm {
    /// Height at a roll length \[m\].
    #[must_use]
    pub fn at(&self, roll: Length) -> f64 {
        let above = self.roll_length.partition_point(|point| *point <= roll);
        let point = |k: usize| Some((self.roll_length.get(k)?.si(), self.height.get(k)?.si()));
        interpolate_between(
            above.checked_sub(1).and_then(point),
            point(above),
            roll.si(),
        )
    }

    /// Mean of several forms of a gear over their common range of roll lengths; `None` without forms or without a
    /// common range.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_gear::MeasuredForm;
    /// let form = |height: [f64; 2]| MeasuredForm {
    ///     roll_length: [4e-3, 9e-3].map(Length::from_si).to_vec(),
    ///     height: height.map(Length::from_si).to_vec(),
    /// };
    /// let mean = MeasuredForm::mean(&[form([0.0, 2e-6]), form([4e-6, 2e-6])]).unwrap();
    /// assert!((mean.at(Length::from_si(4e-3)) - 2e-6).abs() < 1e-18);
    /// ```
    #[must_use]
    pub fn mean(forms: &[Self]) -> Option<Self> {
        let [first, others @ ..] = forms else {
            return None;
        };
        if others.is_empty() {
            return Some(first.clone());
        }
        let ends = |form: &Self| {
            Some([
                form.roll_length.first()?.si(),
                form.roll_length.last()?.si(),
            ])
        };
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for form in forms {
            let [from, to] = ends(form)?;
            (low, high) = (low.max(from), high.min(to));
        }
        let common = first.roll_length.iter().copied();
        let roll_length: Vec<Length> = common
            .filter(|roll| (low..=high).contains(&roll.si()))
            .collect();
        let mean_at = |roll: &Length| {
            forms.iter().map(|form| form.at(*roll)).sum::<f64>() / forms.len() as f64
        };
        let height = roll_length
            .iter()
            .map(|roll| Length::from_si(mean_at(roll)))
            .collect();
        (!roll_length.is_empty()).then_some(Self {
            roll_length,
            height,
        })
    }
}

/// All modifications of a pair. Arrays hold gears 1 and 2; other fields are sums over both gears.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(default, deny_unknown_fields)]
pub struct MicroGeometry {
    /// Tip relief of each gear.
    pub tip_relief: [Option<Relief>; 2],
    /// Root relief of each gear.
    pub root_relief: [Option<Relief>; 2],
    /// Crowning C_c along the face, zero in the middle.
    pub crowning: Length,
    /// End relief at both ends of the face.
    pub end_relief: Option<EndRelief>,
    /// Lead slope C_l over the face, the sum of manufacture, bearings and shafts.
    pub lead_slope: Length,
    /// Profile slope C_p over the path of contact.
    pub profile_slope: Length,
    /// Profile crowning C_Ca, zero in the middle of the path.
    pub profile_crowning: Length,
    /// Pitch deviations of successive pairs of teeth; their number is the number of pitches in the mesh cycle.
    pub pitch: Vec<Length>,
    /// Measured form of each gear, always normal to the flank.
    pub measured: [Option<MeasuredForm>; 2],
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

    /// Whether the flanks have no modifications.
    pub fn is_unmodified(&self) -> bool {
        let slopes = [
            self.crowning,
            self.lead_slope,
            self.profile_slope,
            self.profile_crowning,
        ];
        self.tip_relief == [None; 2]
            && self.root_relief == [None; 2]
            && self.measured == [None, None]
            && self.end_relief.is_none()
            && slopes.iter().all(|c| c.si() == 0.0)
            && self.pitch.iter().all(|c| c.si() == 0.0)
    }

    /// Whether there is tip or root relief, or a measured form.
    pub fn relieves_profile(&self) -> bool {
        self.tip_relief != [None; 2]
            || self.root_relief != [None; 2]
            || self.measured != [None, None]
    }
}

/// A tip or root relief in coordinates of the path.
#[derive(Debug, Clone, Copy)]
struct PathRelief {
    /// ξ at the start of the relief.
    start: f64,
    /// 1 towards E, −1 towards A.
    direction: f64,
    /// Length in base pitches.
    length: f64,
    amount: f64,
    squared: bool,
}

impl PathRelief {
    fn at(&self, xi: f64) -> f64 {
        let t = ((xi - self.start) * self.direction / self.length).max(0.0);
        self.amount * if self.squared { t * t } else { t }
    }
}

/// e(ξ, y) of a pair, in SI units and normal to the flank.
#[derive(Debug, Clone)]
pub(crate) struct Separation {
    ends: Vec<PathRelief>,
    crowning: f64,
    end_relief: Option<(f64, f64, bool)>,
    lead_slope: f64,
    profile_slope: f64,
    profile_crowning: f64,
    pitch: Vec<f64>,
    /// Separation due to the measured form of each gear, over ξ.
    measured: Vec<Vec<(f64, f64)>>,
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
        // Material that is left at a tip or an end would be pressed into the other flank.
        let removed = |name, amount: Length| -> Result<f64, DomainError> {
            Ok(to_normal * DomainError::non_negative(name, amount)?)
        };
        let mut ends = Vec::new();
        for gear in 0..2 {
            for (relief, tip) in [
                (micro.tip_relief[gear], true),
                (micro.root_relief[gear], false),
            ] {
                let Some(relief) = relief else { continue };
                let amount = removed("relief", relief.amount)?;
                let length =
                    roll_length(pair, gear, tip, relief.extent)? / pair.path.base_pitch.si();
                // The tip of gear 1 and the root of gear 2 are in contact at E.
                let at_e = (gear == 0) == tip;
                ends.push(PathRelief {
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
            Some(end) => {
                let name = "length of the end relief";
                let length = DomainError::positive(name, end.length)?;
                let rule = "must not be longer than the face width";
                DomainError::require(length <= width, name, length, "m", rule)?;
                let is_squared = end.shape == ReliefShape::Parabolic;
                Some((
                    removed("end relief", end.amount)?,
                    length / width,
                    is_squared,
                ))
            }
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
            measured: measured(micro, pair)?,
            eps_alpha: pair.path.eps_alpha,
        })
    }

    /// e = Σ C_a ((ξ − ξ₁) p_et/L)ⁿ + C_c (2y/b − 1)² + C_l (y/b − ½) + C_p (ξ/ε_α − ½)
    /// + C_Ca (2ξ/ε_α − 1)² + Σ e_i(ξ) + pitch                                 [Relief-1]
    ///
    /// `across` is y/b; `tooth` is the number of the pair of teeth.
    pub(crate) fn at(&self, xi: f64, across: f64, tooth: i64) -> f64 {
        let along = xi / self.eps_alpha - 0.5;
        let from_middle = across - 0.5;
        let profile = self.profile_slope * along + self.profile_crowning * 4.0 * along * along;
        let lead = self.lead_slope * from_middle + self.crowning * 4.0 * from_middle * from_middle;
        let reliefs: f64 = self.ends.iter().map(|end| end.at(xi)).sum();
        let measured: f64 = (self.measured.iter())
            .map(|form| interpolate(form, xi))
            .sum();
        let face_ends = self.end_relief.map_or(0.0, |(amount, length, squared)| {
            let t = (1.0 - across.min(1.0 - across) / length).max(0.0);
            amount * if squared { t * t } else { t }
        });
        let turn = tooth.rem_euclid(self.pitch.len() as i64) as usize;
        reliefs
            + profile
            + measured
            + lead
            + face_ends
            + self.pitch.get(turn).copied().unwrap_or(0.0)
    }

    /// Coordinates of the starts of reliefs within the path.
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

/// e_i(ξ) = w̄_i − w_i(ρ_i(ξ)),  ρ₁ = s_A + ξ p_et,  ρ₂ = |T₁T₂ − ρ₁|              [Relief-3]
///
/// w̄_i is the mean over the active flank by roll length, because a constant only rotates the gears.
fn measured(micro: &MicroGeometry, pair: &GearPair) -> Result<Vec<Vec<(f64, f64)>>, DomainError> {
    /// Intervals of the mean over the active flank.
    const INTERVALS: usize = 512;
    let path = &pair.path;
    let mut separations = Vec::new();
    for (gear, form) in micro.measured.iter().enumerate() {
        let Some(form) = form else { continue };
        cite!("Relief-3");
        let rolls = &form.roll_length;
        let rule = "must have as many heights as roll lengths, in ascending order";
        let rises = rolls.windows(2).all(|two| two[0].si() < two[1].si());
        let matches = rises && !rolls.is_empty() && rolls.len() == form.height.len();
        DomainError::require(matches, "measured form", rolls.len() as f64, "points", rule)?;
        let coordinate = |roll: f64| {
            let s = match (gear, pair.internal) {
                (0, _) => roll,
                (_, false) => path.t1t2.si() - roll,
                (_, true) => path.t1t2.si() + roll,
            };
            (s - path.a.si()) / path.base_pitch.si()
        };
        let mut line = Vec::with_capacity(rolls.len());
        for (roll, height) in rolls.iter().zip(&form.height) {
            let height = DomainError::finite("height of the measured form", *height)?;
            line.push((
                coordinate(DomainError::finite("roll length", *roll)?),
                -height,
            ));
        }
        if line.len() > 1 && line[0].0 > line[1].0 {
            line.reverse();
        }
        let step = path.eps_alpha / INTERVALS as f64;
        let middles = (0..INTERVALS).map(|k| (k as f64 + 0.5) * step);
        let mean = middles.map(|xi| interpolate(&line, xi)).sum::<f64>() / INTERVALS as f64;
        for (_, separation) in &mut line {
            *separation -= mean;
        }
        separations.push(line);
    }
    Ok(separations)
}

/// L = |√(r_end² − r_b²) − √(r_start² − r_b²)|                                    [Relief-2]
///
/// The end is the end of the active flank: the tip, or the lowest point of contact.
fn roll_length(
    pair: &GearPair,
    gear: usize,
    tip: bool,
    extent: ReliefExtent,
) -> Result<f64, GearError> {
    cite!("Relief-2");
    let diameter = match extent {
        ReliefExtent::RollLength(length) => {
            let name = "roll length of the relief";
            let rolled = DomainError::positive(name, length)?;
            let longest = 2.0 * (pair.path.e - pair.path.a).si();
            let rule = "must not be longer than twice the path of contact";
            DomainError::require(rolled <= longest, name, rolled, "m", rule)?;
            return Ok(rolled);
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
    // Roll lengths increase towards the tip, on a ring towards the root.
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
