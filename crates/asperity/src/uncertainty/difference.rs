//! Difference of two finishes by the same draws.

use serde::{Deserialize, Serialize};

use super::drawn_losses::{DrawnLosses, mean};
use super::mixture::{Drawn, five_to_ninety_five};
use crate::sampling::window_sampling;

/// Difference of the losses of two finishes on the same gears.
///
/// What both have in common, as the friction of their oil, cancels; the sampling errors of different flanks add.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PairedDifference {
    /// Difference with every parameter at its default \[W\].
    pub nominal_w: f64,
    /// 5 % and 95 % quantiles \[W\].
    pub quantiles_w: [f64; 2],
    /// Interval from the parameters only \[W\].
    pub parameter_quantiles_w: [f64; 2],
    /// Half the width of the 95 % interval by the sampling of both flanks \[W\]; `None` if one was not sampled.
    pub sampling_half_width_w: Option<f64>,
    /// The nominal difference over the first loss.
    pub nominal_share: f64,
    /// 5 % and 95 % quantiles of that.
    pub share_quantiles: [f64; 2],
}

/// The loss of `other` minus that of `first`, draw by draw. Cases that differ in nothing differ by exactly 0.
///
/// ```text
/// δ_j = P_other(θ_j) − P_first(θ_j),  SE_j² = SE_other² + SE_first²           [Paired-difference]
/// ```
///
/// Where both have a flank in common their windows are the same, and the error is that of the differences from
/// window to window, or from pair to pair of teeth.
#[must_use]
pub fn difference(first: &DrawnLosses, other: &DrawnLosses) -> PairedDifference {
    asperity_core::cite!("Paired-difference");
    let shared = first.shares_a_flank(other);
    let pairs = || first.draws().iter().zip(other.draws());
    let deltas: Vec<Drawn> = pairs()
        .map(|(a, b)| delta(first, other, a, b, shared))
        .collect();
    let exact: Vec<Drawn> = deltas
        .iter()
        .map(|drawn| Drawn::exact(drawn.value))
        .collect();
    let shares: Vec<Drawn> = pairs()
        .zip(&deltas)
        .map(|((a, b), drawn)| share(first, other, a, b, drawn, shared))
        .collect();
    let nominal = delta(first, other, first.nominal(), other.nominal(), shared);
    let both_sampled = first.is_sampled() && other.is_sampled();
    let moves = moves(first, other, shared);
    let (deltas, shares) = (
        moved(&deltas, &moves, 1.0),
        moved(&shares, &moves, base(first)),
    );
    PairedDifference {
        nominal_w: nominal.value,
        quantiles_w: five_to_ninety_five(&deltas),
        parameter_quantiles_w: five_to_ninety_five(&exact),
        sampling_half_width_w: both_sampled.then(|| half_width(&nominal)),
        nominal_share: nominal.value / base(first),
        share_quantiles: five_to_ninety_five(&shares),
    }
}

fn base(first: &DrawnLosses) -> f64 {
    mean(first.nominal())
}

/// Changes of the difference by where placed traces lie; flanks in common lie where they lie.
fn moves(first: &DrawnLosses, other: &DrawnLosses, shared: bool) -> Vec<f64> {
    if shared {
        return vec![0.0];
    }
    let changes = other.places().into_iter();
    let against = first.places();
    changes
        .flat_map(|change| {
            against
                .iter()
                .map(move |by| change - by)
                .collect::<Vec<_>>()
        })
        .collect()
}

/// Every draw with every change, over `scale`.
fn moved(draws: &[Drawn], moves: &[f64], scale: f64) -> Vec<Drawn> {
    let with = |drawn: &Drawn| {
        let drawn = *drawn;
        let moved = move |change: &f64| Drawn {
            value: drawn.value + change / scale,
            ..drawn
        };
        moves.iter().map(moved).collect::<Vec<_>>()
    };
    draws.iter().flat_map(with).collect()
}

fn half_width(drawn: &Drawn) -> f64 {
    use asperity_core::numerics::student_t_quantile;
    match drawn.standard_error > 0.0 {
        true => {
            drawn.standard_error * student_t_quantile(crate::sampling::CONFIDENCE, drawn.freedom)
        }
        false => 0.0,
    }
}

fn delta(first: &DrawnLosses, other: &DrawnLosses, a: &[f64], b: &[f64], shared: bool) -> Drawn {
    let value = mean(b) - mean(a);
    if shared && a.len() == b.len() {
        let differences: Vec<f64> = a.iter().zip(b).map(|(a, b)| b - a).collect();
        if first.teeth().is_some() && first.teeth() == other.teeth() {
            return match first.between_pairs(&differences) {
                None => Drawn::exact(value),
                Some(found) => Drawn::between_traces(value, &found),
            };
        }
        let windows = first.effective_windows().zip(other.effective_windows());
        let effective = windows.map_or(0.0, |(a, b)| a.min(b));
        return match window_sampling(&differences, effective) {
            None => Drawn::exact(value),
            Some(found) => Drawn {
                value,
                standard_error: found.standard_error_w,
                freedom: effective - 1.0,
            },
        };
    }
    added(value, &first.drawn(a), &other.drawn(b), 1.0)
}

/// (P_other − P_first)/P_first with its error to first order.
fn share(
    first: &DrawnLosses,
    other: &DrawnLosses,
    a: &[f64],
    b: &[f64],
    delta: &Drawn,
    shared: bool,
) -> Drawn {
    let base = mean(a);
    let value = delta.value / base;
    if shared {
        return Drawn {
            value,
            standard_error: delta.standard_error / base,
            freedom: delta.freedom,
        };
    }
    let summed = added(value, &first.drawn(a), &other.drawn(b), 1.0 + value);
    Drawn {
        standard_error: summed.standard_error / base,
        ..summed
    }
}

/// `value` with the errors of both, the first's times `factor`; degrees of freedom after Welch and Satterthwaite.
fn added(value: f64, first: &Drawn, other: &Drawn, factor: f64) -> Drawn {
    let squares = [factor * first.standard_error, other.standard_error].map(|error| error * error);
    let sum = squares[0] + squares[1];
    if sum == 0.0 {
        return Drawn::exact(value);
    }
    let fourth = squares[0] * squares[0] / first.freedom + squares[1] * squares[1] / other.freedom;
    Drawn {
        value,
        standard_error: sum.sqrt(),
        freedom: sum * sum / fourth,
    }
}
