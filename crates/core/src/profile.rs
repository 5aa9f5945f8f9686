//! A measured or generated surface profile on an even grid.

use std::sync::Arc;

use serde::{Deserialize, Serialize, Serializer};

use crate::error::DomainError;
use crate::quantity::Length;

/// Heights along a trace, evenly spaced, pointing out of the material.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// let profile = Profile::new(Length::from_si(0.5e-6), vec![0.0, 1e-7, -1e-7])?;
/// assert_eq!(profile.len(), 3);
/// assert_eq!(profile.mirrored().heights(), &[-1e-7, 1e-7, 0.0]);
/// # Ok::<(), asperity_core::DomainError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "RawProfile")]
pub struct Profile {
    spacing: Length,
    /// Copies share them: a trace is in its reading, its evaluation, and a result.
    #[serde(serialize_with = "listed")]
    heights: Arc<Vec<f64>>,
}

fn listed<S: Serializer>(heights: &Arc<Vec<f64>>, serializer: S) -> Result<S::Ok, S::Error> {
    heights.as_slice().serialize(serializer)
}

/// Points of the widest spike that dust or lost light makes; a pit or scratch is wider.
pub const WIDEST_SPIKE: usize = 6;

/// The finer of two spacings that count as equal, or `None` if they differ by more than 1e-5.
///
/// Positions in a file are rounded, so that the spacings of two traces of one instrument differ in their last digits.
/// A difference of 1e-5 shifts the ends of a window of 10⁴ points by a tenth of a point.
///
/// ```
/// use asperity_core::profile::common_spacing;
/// let (first, second) = ("356.0493 nm".parse()?, "356.0509 nm".parse()?);
/// assert_eq!(common_spacing(second, first), Some(first));
/// assert_eq!(common_spacing(first, "356.06 nm".parse()?), None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn common_spacing(first: Length, second: Length) -> Option<Length> {
    const SAME: f64 = 1e-5;
    let (finer, coarser) = if first < second {
        (first, second)
    } else {
        (second, first)
    };
    (coarser / finer - 1.0 <= SAME).then_some(finer)
}

#[derive(Deserialize)]
struct RawProfile {
    spacing: Length,
    heights: Vec<f64>,
}

impl TryFrom<RawProfile> for Profile {
    type Error = DomainError;

    fn try_from(raw: RawProfile) -> Result<Self, DomainError> {
        Self::new(raw.spacing, raw.heights)
    }
}

impl Profile {
    /// A profile of `heights` \[m\] with `spacing` between neighbours.
    ///
    /// # Errors
    /// When the spacing is not positive, there is no point, or a height is not finite.
    pub fn new(spacing: Length, mut heights: Vec<f64>) -> Result<Self, DomainError> {
        DomainError::positive("spacing", spacing)?;
        DomainError::require(
            !heights.is_empty(),
            "points",
            0.0,
            "-",
            "a profile needs at least one point",
        )?;
        if let Some(&bad) = heights.iter().find(|z| !z.is_finite()) {
            return Err(DomainError {
                name: "height",
                value: bad,
                unit: "m",
                rule: "every height must be finite",
            });
        }
        heights.shrink_to_fit();
        Ok(Self {
            spacing,
            heights: Arc::new(heights),
        })
    }

    /// Distance between neighbouring points.
    pub fn spacing(&self) -> Length {
        self.spacing
    }

    /// Heights \[m\], out of the material.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Heights \[m\], given away; copied if another profile shares them.
    pub fn into_heights(self) -> Vec<f64> {
        Arc::unwrap_or_clone(self.heights)
    }

    /// Number of points, never zero.
    pub fn len(&self) -> usize {
        self.heights.len()
    }

    /// Always false: a profile has at least one point.
    pub fn is_empty(&self) -> bool {
        self.heights.is_empty()
    }

    /// Traced length (n − 1)·dx.
    pub fn length(&self) -> Length {
        self.spacing * (self.len() - 1) as f64
    }

    /// The same trace run from its other end.
    pub fn mirrored(&self) -> Self {
        Self {
            spacing: self.spacing,
            heights: Arc::new(self.heights.iter().rev().copied().collect()),
        }
    }

    /// The points `range`, or `None` when it is empty or reaches past an end.
    pub fn slice(&self, range: std::ops::Range<usize>) -> Option<Self> {
        let heights = self.heights.get(range)?.to_vec();
        (!heights.is_empty()).then_some(Self {
            spacing: self.spacing,
            heights: Arc::new(heights),
        })
    }
}

/// `points` heights from index `start`, which may be negative; beyond its ends the trace is mirrored.
///
/// ```
/// use asperity_core::profile::mirrored_window;
/// let heights = [0.0, 1.0, 2.0, 3.0];
/// assert_eq!(mirrored_window(&heights, -2, 4), [2.0, 1.0, 0.0, 1.0]);
/// assert_eq!(mirrored_window(&heights, 2, 4), [2.0, 3.0, 2.0, 1.0]);
/// ```
pub fn mirrored_window(heights: &[f64], start: isize, points: usize) -> Vec<f64> {
    let indices = mirrored_indices(heights.len(), start, points);
    indices.map(|i| heights[i]).collect()
}

/// Indices of `points` heights from index `start` in a trace of `length` points, which is mirrored beyond its ends.
pub fn mirrored_indices(length: usize, start: isize, points: usize) -> impl Iterator<Item = usize> {
    let last = length as isize - 1;
    let period = (2 * last).max(1);
    (0..points as isize).map(move |k| {
        let i = (start + k).rem_euclid(period);
        (if i > last { period - i } else { i }) as usize
    })
}
