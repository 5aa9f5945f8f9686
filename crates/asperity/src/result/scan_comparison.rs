//! Comparison of patches of scans with rows of them.

use serde::{Deserialize, Serialize};

use super::{MeshOutcome, Summary};

/// The mesh with patches of its scans in contact, and with rows of them as traces.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ScanComparison {
    /// Rows of the scans of pinion and wheel, each row of one with each of the other.
    pub rows: [usize; 2],
    /// By patches, which this result is of.
    pub patches: ScanLoss,
    /// By the rows, otherwise the same case.
    pub lines: ScanLoss,
    /// Median of the loss by patches minus the loss by the rows, draw by draw, and its 5 and 95 % quantiles \[W\]; `None` without
    /// draws.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub difference_w: Option<[f64; 3]>,
    /// Number of the position, from A, whose contact is compared.
    pub position: usize,
    /// Its contact over the mean gap.
    pub gaps: Vec<GapRow>,
}

/// Loss of a mesh, and its contact at one position.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ScanLoss {
    /// Loss \[W\]: the median of the draws, without draws the loss of the run.
    pub loss_w: f64,
    /// 5 and 95 % quantiles of the loss \[W\]; `None` without draws.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_quantiles_w: Option<[f64; 2]>,
    /// Loss in the film \[W\].
    pub film_w: f64,
    /// Loss in lubricated asperities \[W\].
    pub lubricated_asperity_w: f64,
    /// Loss in the boundary layer \[W\].
    pub boundary_w: f64,
    /// Rolling loss \[W\].
    pub rolling_w: f64,
    /// Share of the load on the asperities, mean over mesh time.
    pub asperity_share: f64,
    /// Standard deviation of the roughness left in the contact of the position \[µm\].
    pub attenuated_rms_um: f64,
    /// Mean gap that its inlet supplies without asperities, over the smooth film.
    pub inlet_factor: f64,
    /// Mean gap of its contact \[µm\].
    pub mean_gap_um: f64,
}

/// Contact of a position at a mean gap.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct GapRow {
    /// Mean gap \[µm\].
    pub gap_um: f64,
    /// Share of the load on the asperities of the patch.
    pub share_patch: f64,
    /// The same of the rows, mean over their windows.
    pub share_lines: f64,
    /// Flow through the patch in the inlet over the flow of a smooth gap.
    pub flow_patch: f64,
    /// The same of the rows.
    pub flow_lines: f64,
}

impl ScanComparison {
    /// The same of losses that are `factor` times as large.
    pub(crate) fn times(mut self, factor: f64) -> Self {
        (self.patches, self.lines) = (self.patches.times(factor), self.lines.times(factor));
        self.difference_w = self
            .difference_w
            .map(|ends| ends.map(|watts| factor * watts));
        self
    }
}

impl ScanLoss {
    fn times(self, factor: f64) -> Self {
        Self {
            loss_w: factor * self.loss_w,
            loss_quantiles_w: self
                .loss_quantiles_w
                .map(|ends| ends.map(|loss| factor * loss)),
            film_w: factor * self.film_w,
            lubricated_asperity_w: factor * self.lubricated_asperity_w,
            boundary_w: factor * self.boundary_w,
            rolling_w: factor * self.rolling_w,
            ..self
        }
    }

    pub(crate) fn new(outcome: &MeshOutcome, contact: [f64; 3]) -> Self {
        let Summary {
            loss_w,
            film_w,
            lubricated_asperity_w,
            boundary_w,
            rolling_w,
            asperity_share,
            ..
        } = outcome.result.summary;
        let drawn = outcome.result.uncertainty.as_ref();
        let [attenuated_rms_um, inlet_factor, mean_gap_um] = contact;
        Self {
            loss_w,
            loss_quantiles_w: drawn.map(|drawn| drawn.loss.quantiles_w),
            film_w,
            lubricated_asperity_w,
            boundary_w,
            rolling_w,
            asperity_share,
            attenuated_rms_um,
            inlet_factor,
            mean_gap_um,
        }
    }
}
