//! Cut of a trace to a range, before anything is made of its heights.

use std::ops::Range;

use asperity_core::Profile;
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use super::error::{ReadError, ReadFault};
use super::grid;
use super::options::TraceRange;

/// Record of a cut.
///
/// ```
/// use asperity_profile_io::read::{ReadOptions, TraceRange, read_bytes};
/// let rows: String = (0..2000).map(|i| format!("{};{}.5\n", i, i % 7)).collect();
/// let range: TraceRange = "0.5 mm .. 1.5 mm".parse()?;
/// let options = ReadOptions { range: Some(range), ..ReadOptions::default() };
/// let reading = read_bytes("a.csv", format!("x [um];z [um]\n{rows}").as_bytes(), &options)?;
/// assert_eq!((reading.points, reading.profile.heights()[0]), (1001, 3.5e-6));
/// assert_eq!(reading.cut.map(|cut| cut.of), Some("1.999 mm".parse()?));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TraceCut {
    /// Range as stated.
    pub range: TraceRange,
    /// Distance of the first point of the range from the first point of the trace.
    pub start: Length,
    /// Length of the whole trace.
    pub of: Length,
}

impl TraceCut {
    /// The points at the ascending positions `x` \[m\] that are in `range`, with a record of the cut.
    pub(super) fn cut(x: &[f64], range: TraceRange) -> Result<(Range<usize>, Self), ReadFault> {
        /// Part of the length by which rounding moves an end.
        const ROUNDING: f64 = 1e-9;
        let [first, last] = [x.first(), x.last()].map(|x| x.copied().unwrap_or_default());
        let length = last - first;
        let slack = ROUNDING * length;
        if range.to.si() > length + slack {
            return Err(ReadFault::range_outside(range, Length::from_si(length)));
        }
        let start = x.partition_point(|x| x - first < range.from.si() - slack);
        let end = x.partition_point(|x| x - first <= range.to.si() + slack);
        grid::enough(end - start)?;
        let record = Self {
            range,
            start: Length::from_si(x[start] - first),
            of: Length::from_si(length),
        };
        Ok((start..end, record))
    }

    /// The part of a profile called `name` in `range`, with a record of the cut.
    ///
    /// # Errors
    /// When the range ends behind the last point, or contains fewer points than a profile needs.
    pub fn of_profile(
        name: &str,
        profile: &Profile,
        range: TraceRange,
    ) -> Result<(Profile, Self), ReadError> {
        let spacing = profile.spacing().si();
        let x: Vec<f64> = (0..profile.len()).map(|i| spacing * i as f64).collect();
        let (points, record) = Self::cut(&x, range).map_err(|fault| fault.in_file(name))?;
        let part = profile.slice(points).unwrap_or_else(|| profile.clone());
        Ok((part, record))
    }
}
