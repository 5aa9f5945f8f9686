//! Size and height that every recipe shares.

use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};

/// Most points of a generated profile: 10⁸ heights fill a gigabyte.
const MOST_POINTS: usize = 100_000_000;

/// Root mean square heights from those of an atomically flat surface to far beyond those of any worked one \[m\].
const RQ: std::ops::RangeInclusive<f64> = 1e-12..=1e-3;

/// `points` where a profile may have so many.
pub(super) fn check_points(points: usize) -> Result<usize, DomainError> {
    const RULE: &str = "must lie between 4 and 100000000";
    DomainError::require(
        (4..=MOST_POINTS).contains(&points),
        "points",
        points as f64,
        "-",
        RULE,
    )?;
    Ok(points)
}

/// `heights` about zero and with a root mean square of `rq`.
pub(super) fn scaled(
    spacing: Length,
    mut heights: Vec<f64>,
    rq: Length,
) -> Result<Profile, DomainError> {
    let n = heights.len() as f64;
    let mean = heights.iter().sum::<f64>() / n;
    let square = heights.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / n;
    let rule = "must lie from 1e-12 to 1e-3 m";
    let rq = DomainError::require(RQ.contains(&rq.si()), "rq", rq.si(), "m", rule)?;
    let factor = rq / square.sqrt();
    DomainError::require(
        factor.is_finite(),
        "mean square height",
        square,
        "m2",
        "must be positive: the recipe gives a flat profile",
    )?;
    heights.iter_mut().for_each(|z| *z = (*z - mean) * factor);
    Profile::new(spacing, heights)
}
