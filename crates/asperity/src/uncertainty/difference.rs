//! Difference of two finishes by the same draws, and what it decides.

use serde::{Deserialize, Serialize};

use super::predictive::Predictive;
use super::quantiles::{PROBABILITIES, sorted_quantiles};
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
    /// Decision by the draws and the models.
    pub verdict: Verdict,
}

/// Decision that a difference allows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
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

impl Verdict {
    fn of(
        median_w: f64,
        quantiles_w: [f64; 2],
        probability: f64,
        models: &[AlternativeRow],
    ) -> Self {
        if quantiles_w == [0.0, 0.0] && median_w == 0.0 {
            return Self::Equal;
        }
        if probability < SURE {
            return Self::Undecided;
        }
        let disagrees = |row: &&AlternativeRow| row.loss_w.is_some_and(|d| d * median_w <= 0.0);
        let others = models.iter().filter(disagrees);
        let others: Vec<String> = others.map(|row| row.name.clone()).collect();
        match others.is_empty() {
            true => Self::Holds,
            false => Self::Except(others),
        }
    }
}

impl PairedDifference {
    /// The least and the largest difference by the models \[W\]; none without models.
    #[must_use]
    pub fn model_range_w(&self) -> Option<[f64; 2]> {
        let known: Vec<f64> = self.models.iter().filter_map(|row| row.loss_w).collect();
        let low = known.iter().copied().reduce(f64::min)?;
        let high = known.iter().copied().reduce(f64::max)?;
        Some([low, high])
    }
}

/// The loss of `other` minus the loss of `first`, draw by draw. Cases that differ in nothing differ by exactly 0.
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
    let shares: Vec<f64> = deltas.iter().zip(&own).map(|(d, a)| d / a).collect();
    let [low, median_w, high] = sorted_quantiles(&deltas, PROBABILITIES);
    let [least, median_share, most] = sorted_quantiles(&shares, PROBABILITIES);
    let agreeing = deltas.iter().filter(|d| **d * median_w > 0.0).count();
    let quantiles_w = [low, high];
    let probability = agreeing as f64 / deltas.len() as f64;
    let of_models = of_first.models().filter_map(|row| {
        let other = of_other.models().find(|other| other.name == row.name)?;
        let loss_w = row.loss_w.zip(other.loss_w).map(|(a, b)| b - a);
        let row = row.clone();
        Some(AlternativeRow { loss_w, ..row })
    });
    let models: Vec<AlternativeRow> = of_models.collect();
    PairedDifference {
        at_medians_w: other.at_medians_w - first.at_medians_w,
        median_w,
        quantiles_w,
        median_share,
        share_quantiles: [least, most],
        probability,
        verdict: Verdict::of(median_w, quantiles_w, probability, &models),
        models,
    }
}
