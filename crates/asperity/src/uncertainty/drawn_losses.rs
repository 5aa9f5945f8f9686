//! Losses of one case at every offset of every draw.

use asperity_core::quantity::Length;

use crate::case::LoadedCase;
use crate::flanks::Surfaces;
use crate::result::PairSampling;
use crate::result::{Losses, OffsetRow, PositionRow};

use super::mixture::{Drawn, five_to_ninety_five};
use crate::sampling::{effective_windows, free_way, window_sampling};
use crate::sampling::{means_of_pairs, pair_sampling};

/// Losses of a case, nominal and drawn, at each offset \[W\].
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnLosses {
    nominal: Vec<f64>,
    draws: Vec<Vec<f64>>,
    effective: Option<f64>,
    /// Teeth of pinion and wheel, where several were sampled: the offsets then go on from pair to pair.
    teeth: Option<[usize; 2]>,
    /// Changes by a misplacement of placed traces \[W\].
    pub(super) misplaced: Vec<f64>,
    surfaces: Surfaces,
}

impl DrawnLosses {
    /// The losses of `loaded` with every parameter at its default, nothing drawn.
    #[must_use]
    pub fn of(loaded: &LoadedCase, nominal: &Losses) -> Self {
        Self::new(loaded, &nominal.offsets, &nominal.path, &[])
    }

    pub(super) fn new(
        loaded: &LoadedCase,
        nominal: &[OffsetRow],
        path: &[PositionRow],
        draws: &[Losses],
    ) -> Self {
        let at_offsets = |rows: &[OffsetRow]| rows.iter().map(|row| row.loss_w).collect();
        Self {
            nominal: at_offsets(nominal),
            draws: draws
                .iter()
                .map(|found| at_offsets(&found.offsets))
                .collect(),
            effective: match loaded.surfaces.several_teeth() {
                // The traces themselves are the sample.
                Some(_) => None,
                None => independent(loaded, nominal.len(), path),
            },
            teeth: loaded.surfaces.several_teeth(),
            misplaced: Vec::new(),
            surfaces: loaded.surfaces.clone(),
        }
    }

    /// Losses at each offset with every parameter at its default.
    #[must_use]
    pub fn nominal(&self) -> &[f64] {
        &self.nominal
    }

    /// Losses at each offset, draw by draw; the nominal ones where nothing was drawn.
    #[must_use]
    pub fn draws(&self) -> &[Vec<f64>] {
        match self.draws.is_empty() {
            true => std::slice::from_ref(&self.nominal),
            false => &self.draws,
        }
    }

    /// Windows that count as independent; `None` without a sampling error.
    #[must_use]
    pub fn effective_windows(&self) -> Option<f64> {
        self.effective
    }

    /// Whether there is a sampling error: windows of a trace, or traces of several teeth.
    #[must_use]
    pub fn is_sampled(&self) -> bool {
        self.effective.is_some() || self.teeth.is_some()
    }

    /// Teeth of pinion and wheel, where several were sampled.
    #[must_use]
    pub fn teeth(&self) -> Option<[usize; 2]> {
        self.teeth
    }

    /// Whether a flank of this and another case is the same.
    #[must_use]
    pub fn shares_a_flank(&self, other: &Self) -> bool {
        [0, 1]
            .into_iter()
            .any(|body| self.surfaces.has_flank_of(body, &other.surfaces))
    }

    /// Half the width of the 95 % interval of the mean of `values`, one at each offset, as losses or their changes \[W\]; none
    /// where there is no sampling error to tell.
    #[must_use]
    pub fn half_width_of(&self, values: &[f64]) -> Option<f64> {
        match self.teeth {
            Some(_) => self.between_pairs(values).map(|found| found.half_width_w),
            None => window_sampling(values, self.effective?).map(|found| found.half_width_w),
        }
    }

    /// The sampling error of the mean of `losses`, one at each offset, over the pairs of teeth.
    pub(super) fn between_pairs(&self, losses: &[f64]) -> Option<PairSampling> {
        pair_sampling(&means_of_pairs(losses, self.surfaces.pairs()), self.teeth?)
    }

    /// 5 % and 95 % quantiles of the loss, sampling of the flanks included \[W\].
    #[must_use]
    pub fn quantiles(&self) -> [f64; 2] {
        five_to_ninety_five(&self.with_sampling())
    }

    /// The mean loss of every draw without sampling error.
    pub(super) fn exact(&self) -> Vec<Drawn> {
        let means = self.draws().iter().map(|losses| mean(losses));
        means.map(Drawn::exact).collect()
    }

    /// The mean loss of every draw with its sampling error.
    pub(super) fn with_sampling(&self) -> Vec<Drawn> {
        let draws = self.draws().iter();
        let drawn = draws.map(|losses| self.drawn(losses));
        let places = self.places();
        drawn
            .flat_map(|drawn| {
                let moved = move |change: f64| Drawn {
                    value: drawn.value + change,
                    ..drawn
                };
                places.iter().copied().map(moved).collect::<Vec<_>>()
            })
            .collect()
    }

    /// Changes by where placed traces lie, none among them \[W\].
    pub(super) fn places(&self) -> Vec<f64> {
        std::iter::once(0.0)
            .chain(self.misplaced.iter().copied())
            .collect()
    }

    /// The mean of `losses`, one at each offset, with its sampling error.
    pub(super) fn drawn(&self, losses: &[f64]) -> Drawn {
        let value = mean(losses);
        if let Some(found) = self.between_pairs(losses) {
            return Drawn::between_traces(value, &found);
        }
        let effective = self.effective.unwrap_or(0.0);
        match window_sampling(losses, effective) {
            None => Drawn::exact(value),
            Some(found) => Drawn {
                value,
                standard_error: found.standard_error_w,
                freedom: effective - 1.0,
            },
        }
    }
}

impl Drawn {
    /// A mean over pairs of teeth with its error.
    pub(super) fn between_traces(value: f64, found: &PairSampling) -> Self {
        match found.standard_error_w > 0.0 {
            true => Self {
                value,
                standard_error: found.standard_error_w,
                freedom: found.freedom,
            },
            false => Self::exact(value),
        }
    }
}

pub(super) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Independent windows of the shorter trace under the half width that the loss weights.
fn independent(loaded: &LoadedCase, offsets: usize, path: &[PositionRow]) -> Option<f64> {
    let weight = |row: &PositionRow| row.weight_m * row.sliding_w_per_m;
    let total: f64 = path.iter().map(weight).sum();
    let weighted = path
        .iter()
        .map(|row| weight(row) * row.half_width_um * 1e-6);
    let half_width = Length::from_si(weighted.sum::<f64>() / total);
    let free = free_way(&loaded.surfaces, loaded.case.model.window, half_width)?;
    effective_windows(offsets, free, half_width)
}
