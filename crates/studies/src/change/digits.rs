//! Digits of numbers that measured traces leave.

use asperity::result::loss_band::Digits;
use asperity_core::Estimate;
use asperity_report::Cell;

/// Last place that a measured trace leaves of a height \[nm\].
pub(crate) const LEAST_NM: f64 = 0.1;

/// Digits of an interval, which traces without noise narrow to less than `least`, the last place that a measured trace leaves.
pub(crate) fn digits(estimate: Estimate, least: f64) -> Digits {
    let half = 5.0 * least;
    let [low, high] = [estimate.value - half, estimate.value + half];
    Digits::of_difference([estimate.low.min(low), estimate.high.max(high)])
}

/// A height in nm with its interval.
pub(crate) fn height(nm: Estimate) -> Cell {
    shown(nm, LEAST_NM)
}

pub(crate) fn shown(estimate: Estimate, least: f64) -> Cell {
    Cell::estimate(digits(estimate, least).interval(estimate), Some(estimate))
}
