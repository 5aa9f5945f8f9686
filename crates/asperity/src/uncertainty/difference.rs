//! Difference of two finishes by the same draws, and what it decides.

use serde::{Deserialize, Serialize};

use super::predictive::Predictive;
use super::quantiles::sorted_quantiles;
use crate::result::{AlternativeRow, Uncertainty};

/// Probability from which the sign of a difference holds.
const SURE: f64 = 0.95;

/// Difference of the losses of two finishes on the same gears, draw by draw: what both have in common, as the friction of
/// their oil, cancels.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PairedDifference {
    /// Difference of the runs, with every constant at its median \[W\].
    pub at_medians_w: f64,
    /// Median of the difference \[W\].
    pub median_w: f64,
    /// 5 % and 95 % quantiles \[W\].
    pub quantiles_w: [f64; 2],
    /// Median of the difference over the loss of the first.
    pub median_share: f64,
    /// 5 % and 95 % quantiles of that.
    pub share_quantiles: [f64; 2],
    /// Share of the draws with the sign of the median.
    pub probability: f64,
    /// The difference by every model that was tried, the refuted ones included.
    pub models: Vec<AlternativeRow>,
}

/// What a difference decides.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Verdict {
    /// The cases do not differ.
    Equal,
    /// The sign holds in the draws and under every model.
    Holds,
    /// The sign holds in the draws, but not under these models.
    Except(Vec<String>),
    /// The draws leave the sign open.
    Undecided,
}

impl PairedDifference {
    /// The verdict, by the draws and the models.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        if self.quantiles_w == [0.0, 0.0] && self.median_w == 0.0 {
            return Verdict::Equal;
        }
        if self.probability < SURE {
            return Verdict::Undecided;
        }
        let disagrees =
            |row: &&AlternativeRow| row.loss_w.is_some_and(|d| d * self.median_w <= 0.0);
        let others: Vec<String> = self
            .models
            .iter()
            .filter(disagrees)
            .map(|row| row.name.clone())
            .collect();
        match others.is_empty() {
            true => Verdict::Holds,
            false => Verdict::Except(others),
        }
    }

    /// The least and the largest difference by the models \[W\]; none without models.
    #[must_use]
    pub fn model_range_w(&self) -> Option<[f64; 2]> {
        let known: Vec<f64> = self.models.iter().filter_map(|row| row.loss_w).collect();
        let ends = known
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], d| {
                [low.min(*d), high.max(*d)]
            });
        (!known.is_empty()).then_some(ends)
    }
}

/// The loss of `other` minus that of `first`, draw by draw. Cases that differ in nothing differ by exactly 0.
///
/// ```text
/// δ_j = P_other,j − P_first,j                                                [Paired-difference]
/// ```
///
/// Constants, structure, tip relief and weights are the same in both; model error and sampling are drawn apart unless
/// the flanks are the same (`same_flanks`).
#[must_use]
pub fn difference(
    (first, of_first): (&Predictive, &Uncertainty),
    (other, of_other): (&Predictive, &Uncertainty),
    same_flanks: bool,
) -> PairedDifference {
    asperity_core::cite!("Paired-difference");
    let own = first.losses(0);
    let theirs = other.losses(usize::from(!same_flanks));
    let deltas: Vec<f64> = own.iter().zip(&theirs).map(|(a, b)| b - a).collect();
    let shares: Vec<f64> = own
        .iter()
        .zip(&deltas)
        .map(|(a, delta)| delta / a)
        .collect();
    let probabilities = [0.05, 0.5, 0.95];
    let [low, median_w, high] = sorted_quantiles(&deltas, probabilities);
    let [least, median_share, most] = sorted_quantiles(&shares, probabilities);
    let agreeing = deltas
        .iter()
        .filter(|delta| **delta * median_w > 0.0)
        .count();
    let rows = |of: &Uncertainty| -> Vec<AlternativeRow> {
        of.structures
            .iter()
            .chain(&of.other_models)
            .cloned()
            .collect()
    };
    let (ours, others) = (rows(of_first), rows(of_other));
    let models = ours.into_iter().filter_map(|row| {
        let other = others.iter().find(|other| other.name == row.name)?;
        let loss_w = row.loss_w.zip(other.loss_w).map(|(a, b)| b - a);
        Some(AlternativeRow { loss_w, ..row })
    });
    PairedDifference {
        at_medians_w: other.at_medians_w - first.at_medians_w,
        median_w,
        quantiles_w: [low, high],
        median_share,
        share_quantiles: [least, most],
        probability: agreeing as f64 / deltas.len() as f64,
        models: models.collect(),
    }
}
