//! Checks and scaling common to all recipes.

use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};

/// Maximum number of points of a generated profile: 10⁸ heights need 800 MB.
const MAX_POINTS: usize = 100_000_000;

/// Range of root mean square heights \[m\], from atomically flat surfaces to far beyond machined ones.
const RQ: std::ops::RangeInclusive<f64> = 1e-12..=1e-3;

/// Returns `points` if it is a permitted number of points.
pub(super) fn check_points(points: usize) -> Result<usize, DomainError> {
    const RULE: &str = "must lie between 4 and 100000000";
    DomainError::require(
        (4..=MAX_POINTS).contains(&points),
        "points",
        points as f64,
        "-",
        RULE,
    )?;
    Ok(points)
}

/// Profile of `heights` scaled to zero mean and a root mean square of `rq`.
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
