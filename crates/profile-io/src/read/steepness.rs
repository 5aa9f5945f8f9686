//! Detection of implausible heights by their slopes: wrong units, marks for missing points, spikes.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | Rdq | root mean square of the slopes between neighbours | - |
//! | s | root mean square of the flattest 90 % of the slopes | - |
//!
//! A wrong unit makes all slopes implausible, spikes only a few: if s is plausible and Rdq is not, outlying points are
//! spikes.
//!
//! Ground and superfinished flanks have Rdq of 0.02 to 0.3. Stylus tips have flanks of 45 or 30 degrees to
//! the vertical, so a stylus follows no slope above 2; a single step may be steeper, at a burr or a chip. Steps above 2 at one end
//! only, beyond which the trace does not return, are an edge.
//! Mirrors have Rdq of 1e-4; no surface has less than 1e-6.

use std::fmt;

use asperity_core::numerics::{median, range};
use asperity_core::profile::WIDEST_SPIKE;
use asperity_core::quantity::Length;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Profile, number};
use serde::{Deserialize, Serialize};

use super::options::{FEWEST_POINTS, LengthUnit};

/// Maximum plausible Rdq.
const LARGEST_RDQ: f64 = 2.0;
/// Minimum plausible Rdq, unless all heights are equal.
const SMALLEST_RDQ: f64 = 1e-6;
/// Maximum plausible slope of a single step.
const STEEPEST_STEP: f64 = 5.0;
/// Range of Rdq of flanks, from mirror finish to coarse turning.
const USUAL_RDQ: std::ops::RangeInclusive<f64> = 1e-4..=1.0;

/// Recommended robust deviations for the replacement of spikes.
const USUAL_OUTLIERS: &str = "6";
/// Fraction of the slopes, the flattest, that represent the surface between spikes.
const BULK: f64 = 0.9;

/// Minimum distance of a mark from the heights, divided by their range.
const FAR: f64 = 20.0;
/// Maximum fraction of marked points.
const MOST_MARKED: f64 = 0.2;

/// Implausible slopes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Steepness {
    /// Root mean square of the slopes between neighbours.
    pub rdq: f64,
    /// Steepest slope between neighbours.
    pub steepest: f64,
    /// Index of the point before the steepest step.
    pub at: usize,
    /// Likely cause of the slopes.
    pub suspicion: Suspicion,
}

/// Likely cause of implausible slopes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Suspicion {
    /// The heights would be plausible in another unit.
    Unit {
        /// Unit they were read in.
        read: LengthUnit,
        /// Unit in which they are plausible.
        likely: LengthUnit,
    },
    /// The scale in the header of the file is off by this factor.
    Scale {
        /// Factor with which they would be plausible.
        factor: f64,
    },
    /// One value far away from all others marks missing points.
    Sentinel {
        /// The value, in the unit of the file.
        value: f64,
        /// Unit of the file.
        unit: LengthUnit,
        /// Number of points with the value.
        points: usize,
    },
    /// The steep steps are all at one end, as where a trace runs over the edge of a flank.
    Edge {
        /// Start of the part that is plausible, from the first point.
        from: Length,
        /// Its end.
        to: Length,
    },
    /// A few outlying points of an otherwise plausible profile, due to dust or lost light.
    Spikes {
        /// Number of spikes.
        spikes: usize,
        /// Points of the widest one.
        widest: usize,
        /// Largest distance from the running median.
        height: Length,
    },
    /// No single cause was identified.
    Unknown,
}

impl Suspicion {
    /// The cause on a trace of which the profile is a part that begins at `start`.
    #[must_use]
    pub fn on_trace(self, start: Length) -> Self {
        match self {
            Self::Edge { from, to } => Self::Edge {
                from: from + start,
                to: to + start,
            },
            other => other,
        }
    }

    /// The cause for a file with its own scale of heights, to which a stated unit does not apply.
    pub(super) fn of_scaled(self) -> Self {
        match self {
            Self::Unit { read, likely } => Self::Scale {
                factor: likely.metres(1.0) / read.metres(1.0),
            },
            other => other,
        }
    }

    /// Remedy.
    pub fn remedy(self) -> Remedy {
        match self {
            Self::Unit { likely, .. } => {
                Remedy::set(Setting::ZUnit, Value::This(likely.to_string().into()))
            }
            Self::Scale { .. } => Remedy::act("export the heights again, as text with their unit"),
            Self::Sentinel { .. } => Remedy::act("write NaN for the missing points"),
            Self::Edge { from, to } => {
                let range = format!("{:.2} mm .. {:.2} mm", 1e3 * from.si(), 1e3 * to.si());
                Remedy::set(Setting::Range, Value::This(range.into()))
                    .because("to use the rest of the trace")
            }
            Self::Spikes { .. } => {
                Remedy::set(Setting::Outliers, Value::This(USUAL_OUTLIERS.into()))
                    .because("to replace them by straight lines")
            }
            Self::Unknown => Remedy::act("look for single spikes")
                .or_set(Setting::ZUnit, Value::Any)
                .or_set(Setting::Spacing, Value::Any),
        }
    }
}

impl fmt::Display for Steepness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let how = if self.rdq < SMALLEST_RDQ {
            "smooth"
        } else {
            "steep"
        };
        write!(
            f,
            "no flank is as {how} as these heights: slopes of {} root mean square, {} after point {}",
            three_digits(self.rdq),
            three_digits(self.steepest),
            self.at + 1
        )?;
        match self.suspicion {
            Suspicion::Unit { read, likely } => write!(
                f,
                "; they were read in {read} and would be plausible in {likely}"
            ),
            Suspicion::Scale { factor } => write!(
                f,
                "; they were scaled as the header says and would be plausible times {}",
                number(factor)
            ),
            Suspicion::Sentinel {
                value,
                unit,
                points,
            } => write!(
                f,
                "; {points} of them read {} {unit}, which seems to mark missing points",
                number(value)
            ),
            Suspicion::Edge { from, .. } => write!(
                f,
                "; all steep steps are at the {} of the trace, as where it runs over the edge of the flank",
                if from.si() > 0.0 { "start" } else { "end" }
            ),
            Suspicion::Spikes {
                spikes,
                widest,
                height,
            } => write!(
                f,
                "; {spikes} spike{} of up to {widest} point{} and {height:.4} stand out of heights that are plausible otherwise",
                plural(spikes),
                plural(widest)
            ),
            Suspicion::Unknown => Ok(()),
        }
    }
}

/// A slope with three digits.
fn three_digits(slope: f64) -> String {
    number(format!("{slope:.2e}").parse().unwrap_or(slope))
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

/// The slopes of `profile` if they are implausible; its heights were read in `unit`.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_profile_io::read::{LengthUnit, steepness::{Suspicion, implausible}};
/// let z = |i: usize| 1e-6 * (0.1 * i as f64).sin();
/// let of = |scale: f64| Profile::new(Length::from_si(0.5e-6), (0..400).map(|i| scale * z(i)).collect());
/// assert_eq!(implausible(&of(1.0)?, LengthUnit::Micrometre), None);
/// let found = implausible(&of(1e3)?, LengthUnit::Micrometre).unwrap();
/// let (read, likely) = (LengthUnit::Micrometre, LengthUnit::Nanometre);
/// assert_eq!(found.suspicion, Suspicion::Unit { read, likely });
/// # Ok::<(), asperity_core::DomainError>(())
/// ```
pub fn implausible(profile: &Profile, unit: LengthUnit) -> Option<Steepness> {
    let slopes = Slopes::from_heights(profile.heights().iter().copied(), profile.spacing().si());
    // A fall at one end is an edge also where a rounding makes its single steps less steep.
    let edge = edge(profile);
    if slopes.are_plausible() && edge.is_none() {
        return None;
    }
    let suspicion = edge
        .or_else(|| sentinel(profile, unit))
        .or_else(|| spikes(profile, slopes.bulk))
        .or_else(|| other_unit(slopes.bulk, unit))
        .unwrap_or(Suspicion::Unknown);
    Some(Steepness {
        rdq: slopes.rdq,
        steepest: slopes.steepest,
        at: slopes.at,
        suspicion,
    })
}

/// Root mean squares and steepest slope.
struct Slopes {
    rdq: f64,
    /// Rdq of the flattest slopes; Rdq itself if these are all zero.
    bulk: f64,
    steepest: f64,
    at: usize,
}

impl Slopes {
    fn from_heights(heights: impl Iterator<Item = f64>, dx: f64) -> Self {
        let mut before = None;
        let mut squares = Vec::new();
        let (mut steepest, mut at) = (0.0_f64, 0);
        for (i, z) in heights.enumerate() {
            if let Some(before) = before.replace(z) {
                let slope = (z - before) / dx;
                squares.push(slope * slope);
                if slope.abs() > steepest {
                    (steepest, at) = (slope.abs(), i - 1);
                }
            }
        }
        let root_mean =
            |squares: &[f64]| (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt();
        let rdq = root_mean(&squares);
        let flattest = (BULK * squares.len() as f64) as usize;
        if flattest < squares.len() {
            squares.select_nth_unstable_by(flattest, f64::total_cmp);
        }
        let bulk = match root_mean(&squares[..flattest]) {
            0.0 => rdq,
            bulk => bulk,
        };
        Self {
            rdq,
            bulk,
            steepest,
            at,
        }
    }

    fn are_plausible(&self) -> bool {
        let too_smooth = self.rdq > 0.0 && self.rdq < SMALLEST_RDQ;
        self.rdq <= LARGEST_RDQ && self.steepest <= STEEPEST_STEP && !too_smooth
    }
}

/// The part of the profile without one of its ends, if all steep steps are there and the part is plausible.
fn edge(profile: &Profile) -> Option<Suspicion> {
    /// Largest part of the trace that is cut off.
    const LARGEST_END: f64 = 0.3;
    /// Part of the trace between the first steep step and the remaining part, where the edge is rounded.
    const ROUNDED: f64 = 0.01;
    /// Length over which an edge that is rounded still falls, and its least slope there: that of the waves of a flank is less.
    const BLOCK: f64 = 10e-6;
    const FALL: f64 = 0.2;
    /// Hundredths of a millimetre, in which the part is stated.
    const DIGIT: f64 = 1e-5;
    let (z, dx) = (profile.heights(), profile.spacing().si());
    let is_steep = |i: &usize| (z[i + 1] - z[*i]).abs() > LARGEST_RDQ * dx;
    let steps = z.len().saturating_sub(1);
    let first = (0..steps).find(is_steep)?;
    let last = (0..steps).rfind(is_steep)?;
    let margin = (ROUNDED * z.len() as f64).ceil() as usize;
    let far = (LARGEST_END * z.len() as f64) as usize;
    let block = ((BLOCK / dx).ceil() as usize).max(1);
    let falls = |i: usize| (z[i + block] - z[i]).abs() > FALL * block as f64 * dx;
    let (begin, end) = if first >= z.len() - far {
        let mut end = first;
        while end >= block && end > far && falls(end - block) {
            end -= block;
        }
        (0, end.saturating_sub(margin))
    } else if last < far {
        let mut begin = last + 1;
        while begin + block < z.len() && begin < z.len() - far && falls(begin) {
            begin += block;
        }
        (begin + margin, z.len() - 1)
    } else {
        return None;
    };
    let from = (begin as f64 * dx / DIGIT).ceil() * DIGIT;
    let to = (end as f64 * dx / DIGIT).floor() * DIGIT;
    let part = z
        .get(begin..=end)
        .filter(|part| part.len() >= FEWEST_POINTS)?;
    // Beyond an edge the trace does not return to the flank.
    let [low, high] = range(part.iter().copied());
    let outermost = if begin == 0 { z[z.len() - 1] } else { z[0] };
    let is_off = outermost < low - (high - low) || outermost > high + (high - low);
    let is_plausible =
        is_off && to > from && Slopes::from_heights(part.iter().copied(), dx).are_plausible();
    is_plausible.then(|| Suspicion::Edge {
        from: Length::from_si(from),
        to: Length::from_si(to),
    })
}

/// The value farthest from the others, if the profile is plausible without it.
fn sentinel(profile: &Profile, unit: LengthUnit) -> Option<Suspicion> {
    let z = profile.heights();
    // The median: a mark may occur often, but not at half of the points.
    let middle = median(z.iter().copied())?;
    let far = z
        .iter()
        .max_by(|a, b| (**a - middle).abs().total_cmp(&(**b - middle).abs()))?;
    let points = z.iter().filter(|z| *z == far).count();
    let others = || z.iter().copied().filter(|z| z != far);
    let [low, high] = range(others());
    let is_far = high > low && (far - middle).abs() > FAR * (high - low);
    let is_rare = points as f64 <= MOST_MARKED * z.len() as f64;
    let is_mark =
        is_far && is_rare && Slopes::from_heights(others(), profile.spacing().si()).are_plausible();
    is_mark.then(|| Suspicion::Sentinel {
        value: far / unit.metres(1.0),
        unit,
        points,
    })
}

/// The points whose distance from the running median exceeds the steepest plausible step, if the profile is plausible
/// without them.
fn spikes(profile: &Profile, bulk: f64) -> Option<Suspicion> {
    if !(SMALLEST_RDQ..=LARGEST_RDQ).contains(&bulk) {
        return None;
    }
    let (z, dx) = (profile.heights(), profile.spacing().si());
    let distances = running_distances(z);
    let is_spike = |i: usize| distances[i] > STEEPEST_STEP * dx;
    let (mut spikes, mut widest, mut run) = (0, 0, 0);
    for i in 0..z.len() {
        run = if is_spike(i) { run + 1 } else { 0 };
        spikes += usize::from(run == 1);
        widest = widest.max(run);
    }
    let others = (0..z.len()).filter(|i| !is_spike(*i)).map(|i| z[i]);
    let is_plausible = spikes > 0 && Slopes::from_heights(others, dx).are_plausible();
    is_plausible.then(|| Suspicion::Spikes {
        spikes,
        widest,
        height: Length::from_si(distances.iter().copied().fold(0.0, f64::max)),
    })
}

/// Distance of every point from the median of the points around it; the window narrows towards the ends.
fn running_distances(z: &[f64]) -> Vec<f64> {
    let mut window = Vec::with_capacity(2 * WIDEST_SPIKE + 1);
    let distance = |i: usize| {
        let reach = WIDEST_SPIKE.min(i).min(z.len() - 1 - i);
        window.clear();
        window.extend_from_slice(&z[i - reach..=i + reach]);
        let (_, middle, _) = window.select_nth_unstable_by(reach, f64::total_cmp);
        (z[i] - *middle).abs()
    };
    (0..z.len()).map(distance).collect()
}

/// The coarsest finer unit, or the finest coarser one, in which the slopes are plausible.
fn other_unit(rdq: f64, read: LengthUnit) -> Option<Suspicion> {
    use LengthUnit::{Metre, Micrometre, Millimetre, Nanometre};
    let plausible = |likely: &LengthUnit| {
        let factor = likely.metres(1.0) / read.metres(1.0);
        let is_right_way = if rdq < SMALLEST_RDQ {
            factor > 2.0
        } else {
            rdq > LARGEST_RDQ && factor < 0.5
        };
        is_right_way && USUAL_RDQ.contains(&(rdq * factor))
    };
    let mut finer = [Metre, Millimetre, Micrometre, Nanometre];
    if rdq < SMALLEST_RDQ {
        finer.reverse();
    }
    let likely = finer.into_iter().find(plausible)?;
    Some(Suspicion::Unit { read, likely })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rough(scale: f64) -> Profile {
        let z = |i: i32| scale * ((0.3 * f64::from(i)).sin() + (0.05 * f64::from(i)).cos());
        Profile::new(Length::from_si(0.5e-6), (0..2000).map(z).collect()).unwrap()
    }

    #[test]
    fn heights_in_a_wrong_unit_name_the_right_one() {
        let found = |scale, unit| implausible(&rough(scale), unit).map(|found| found.suspicion);
        assert_eq!(found(0.2e-6, LengthUnit::Micrometre), None);
        let (read, likely) = (LengthUnit::Millimetre, LengthUnit::Micrometre);
        let expected = Suspicion::Unit { read, likely };
        assert_eq!(found(0.2e-3, LengthUnit::Millimetre), Some(expected));
        let likely = LengthUnit::Nanometre;
        let expected = Suspicion::Unit { read, likely };
        assert_eq!(found(0.2, LengthUnit::Millimetre), Some(expected));
    }

    #[test]
    fn heights_that_are_too_small_name_a_coarser_unit_and_a_plane_is_one() {
        let found = implausible(&rough(0.2e-12), LengthUnit::Micrometre).unwrap();
        let (read, likely) = (LengthUnit::Micrometre, LengthUnit::Metre);
        assert_eq!(found.suspicion, Suspicion::Unit { read, likely });
        assert!(found.to_string().starts_with("no flank is as smooth as"));
        assert_eq!(implausible(&rough(0.0), LengthUnit::Micrometre), None);
    }

    #[test]
    fn a_mark_for_missing_points_is_named_with_its_number() {
        for mark in [-9999.0, 1e30] {
            let mut heights = rough(0.2e-6).into_heights();
            for at in [100, 101, 900] {
                heights[at] = mark / 1e6;
            }
            let profile = Profile::new(Length::from_si(0.5e-6), heights).unwrap();
            let found = implausible(&profile, LengthUnit::Micrometre).unwrap();
            let Suspicion::Sentinel { value, points, .. } = found.suspicion else {
                panic!("{found:?}");
            };
            assert!((value / mark - 1.0).abs() < 1e-12 && points == 3);
        }
    }

    #[test]
    fn spikes_are_named_with_count_and_size_whatever_the_root_mean_square_slope() {
        for (count, height) in [(1, 4e-6), (25, 9e-6), (25, 300e-6), (60, 20e-6)] {
            let mut heights = rough(0.2e-6).into_heights();
            for k in 0..count {
                let at = 40 + 31 * k;
                heights[at] += height * if k % 3 == 0 { -1.0 } else { 1.0 };
            }
            // The first is two points wide.
            heights[41] = heights[40];
            let profile = Profile::new(Length::from_si(0.5e-6), heights).unwrap();
            let found = implausible(&profile, LengthUnit::Micrometre).unwrap();
            let Suspicion::Spikes {
                spikes,
                widest,
                height: largest,
            } = found.suspicion
            else {
                panic!("{count} of {height}: {found:?}");
            };
            assert_eq!((spikes, widest), (count, 2));
            assert!((largest.si() / height - 1.0).abs() < 0.1, "{largest}");
            let remedy = found.suspicion.remedy().to_string();
            assert_eq!(
                remedy,
                "Set outliers to 6 to replace them by straight lines"
            );
        }
    }

    #[test]
    fn a_wrong_unit_is_named_even_with_spikes() {
        let mut heights = rough(0.2e-3).into_heights();
        heights[500] += 5e-3;
        let profile = Profile::new(Length::from_si(0.5e-6), heights).unwrap();
        let found = implausible(&profile, LengthUnit::Millimetre).unwrap();
        let (read, likely) = (LengthUnit::Millimetre, LengthUnit::Micrometre);
        assert_eq!(found.suspicion, Suspicion::Unit { read, likely });
    }

    #[test]
    fn one_step_of_a_chip_is_refused_from_a_slope_of_five() {
        let step = |slope: f64| {
            let z = |i: i32| if i < 100 { 0.0 } else { slope * 0.5e-6 };
            Profile::new(Length::from_si(0.5e-6), (0..200).map(z).collect()).unwrap()
        };
        assert_eq!(implausible(&step(4.9), LengthUnit::Micrometre), None);
        let found = implausible(&step(5.1), LengthUnit::Micrometre).unwrap();
        assert_eq!((found.at, found.suspicion), (99, Suspicion::Unknown));
    }

    #[test]
    fn a_fall_at_one_end_leaves_the_range_before_it() {
        // 1 mm of a flank, then the edge: a fall of 60 um, and the lower end of the range of the instrument.
        let z = |i: usize| {
            let rough = 0.2e-6 * (0.3 * i as f64).sin();
            match i {
                0..1600 => rough,
                1600..1620 => rough - 3e-6 * (i - 1599) as f64,
                _ => -60e-6,
            }
        };
        let heights: Vec<f64> = (0..2000).map(z).collect();
        let of = |heights: Vec<f64>| {
            let profile = Profile::new(Length::from_si(0.5e-6), heights).unwrap();
            implausible(&profile, LengthUnit::Micrometre).unwrap()
        };
        let found = of(heights.clone());
        assert_eq!(
            found.suspicion.remedy().to_string(),
            "Set range to 0.00 mm .. 0.78 mm to use the rest of the trace"
        );
        assert!(
            found
                .to_string()
                .ends_with("at the end of the trace, as where it runs over the edge of the flank")
        );
        let turned = of(heights.into_iter().rev().collect());
        let range = turned
            .suspicion
            .on_trace(Length::from_si(1e-3))
            .remedy()
            .to_string();
        assert!(
            range.starts_with("Set range to 1.21 mm .. 1.99 mm"),
            "{range}"
        );
        // What is left is a profile.
        let part = Profile::new(Length::from_si(0.5e-6), (0..1560).map(z).collect()).unwrap();
        assert_eq!(implausible(&part, LengthUnit::Micrometre), None);
    }

    #[test]
    fn numbers_have_no_noise_of_floating_point() {
        let mut heights = rough(0.2e-6).into_heights();
        for at in [100, 101, 900] {
            heights[at] = 1e-6 * -60.000_000_000_000_01;
        }
        let profile = Profile::new(Length::from_si(0.5e-6), heights).unwrap();
        let said = implausible(&profile, LengthUnit::Micrometre)
            .unwrap()
            .to_string();
        assert!(
            said.ends_with("; 3 of them read -60 um, which seems to mark missing points"),
            "{said}"
        );
    }
}
