//! Interval of a loss: sampling of the flanks, uncertain parameters, and alternative models next to it.
//!
//! A run with its band costs no further contact: the contacts of the run are kept, and a draw of boundary and oil
//! constants costs film laws only. The same draws serve every case, so that two finishes differ by their flanks and
//! not by the luck of the draw.
//!
//! ```
//! use asperity::{Run, case};
//! let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
//! let case = case::load_with(file, &|input| {
//!     (input.model.positions, input.model.offsets) = (Some(4), Some(4));
//! })?;
//! let result = Run::new(&case).band(true).execute()?.result;
//! let band = result.band.ok_or("the default model has a band")?;
//! assert!(band.quantiles_w[0] < band.nominal_w && band.nominal_w < band.quantiles_w[1]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod alternatives;
mod calibrated;
mod difference;
mod drawn_losses;
mod draws;
mod hypercube;
mod mixture;
mod set;

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity_core::cancel::checkpoint;
use asperity_core::provenance::Provenance;

use crate::assembly::equations_used;
use crate::case::{Formulation, FullFilmName, LoadShareName, LoadedCase};
use crate::contacts::Contacts;
use crate::error::Error;
use crate::parameters::parameters;
use crate::pipeline::KeptFields;
use crate::pipeline::{Progress, outcome, settled};
use crate::result::{AlternativeRow, BandParameter, LossBand, PairSampling, SamplingPart, Trust};
use crate::result::{Losses, Outcome, PositionRow, RunResult};

pub use crate::parameters::UncertainParameter;
pub use crate::sampling::{CONFIDENCE, effective_windows, pair_sampling, window_sampling};
pub use difference::{PairedDifference, difference};
pub use drawn_losses::DrawnLosses;
pub use mixture::{Drawn, five_to_ninety_five, quantile};
pub(crate) use set::quantiles_of_set;

use alternatives::Alternative;
use draws::{Draws, evaluated};

/// Draws of the parameters.
pub const DRAWS: usize = 24;

/// Whether a case has a band: the paper's formulation takes everything as printed, and records of mixed
/// lubrication take minutes a draw.
#[must_use]
pub fn has_band(loaded: &LoadedCase) -> bool {
    let model = &loaded.case.model;
    loaded.case.formulation == Formulation::Corrected
        && model.load_share != LoadShareName::Ehl
        && model.full_film == FullFilmName::Formulas
}

/// Runs a case with the interval of its loss; the losses of every draw, which [`difference`] compares, are the nominal
/// ones only of a case without an interval.
pub(crate) fn run_and_draw(
    loaded: &LoadedCase,
    pictures: Option<&KeptFields>,
    progress: Progress<'_>,
) -> Result<(Outcome, DrawnLosses), Error> {
    let found = settled(loaded, None)?;
    let loaded = found.as_ref();
    // Each draw and each alternative counts like a position.
    let others = match has_band(loaded) {
        true => alternatives::alternatives(loaded),
        false => Vec::new(),
    };
    let more = if has_band(loaded) { DRAWS } else { 0 } + others.len();
    let before = AtomicUsize::new(0);
    let shown = |done, total| {
        before.store(total, Ordering::Relaxed);
        progress(done, total + more);
    };
    let (mut outcome, contacts) = outcome(loaded, pictures, &shown)?;
    if !has_band(loaded) {
        let rows = &outcome.result.path;
        let drawn = DrawnLosses::new(loaded, &outcome.offsets, rows, &[]);
        return Ok((outcome, drawn));
    }
    let used = Provenance::new();
    let before = before.into_inner();
    let done = |evaluated| progress(before + evaluated, before + more);
    let found = used.collect(|| band(loaded, &outcome, &contacts, others, &done));
    let (band, drawn) = found?;
    outcome.result.band = Some(band);
    note(&mut outcome.result, &used.tags());
    Ok((outcome, drawn))
}

/// 5 % and 95 % quantiles of a loss \[W\] that is known already, those of a run with its interval at less cost: without fields,
/// alternatives and effects, with contacts made before, if any. None of a case without a band.
///
/// # Errors
/// As [`losses`](crate::losses).
pub fn quantiles(
    loaded: &LoadedCase,
    nominal: &Losses,
    tables: Option<&Contacts>,
) -> Result<Option<[f64; 2]>, Error> {
    if !has_band(loaded) {
        return Ok(None);
    }
    let found = settled(loaded, tables)?;
    let loaded = found.as_ref();
    let (ranged, _) = parameters(loaded).map_err(|error| Error::Whole(Box::new(error)))?;
    let draws = Draws::of(loaded, tables, &ranged, DRAWS, &|_| {})?;
    let mut drawn = DrawnLosses::new(loaded, &nominal.offsets, &nominal.path, &draws.losses);
    drawn.misplaced = misplaced(loaded, nominal.summary.loss_w)?;
    Ok(Some(drawn.quantiles()))
}

/// Adds the equations of the interval to the equations of the run.
fn note(result: &mut RunResult, tags: &BTreeSet<&'static str>) {
    let before = result.equations.iter().map(|found| found.tag.as_ref());
    let known = crate::equations::all().iter().map(|known| known.tag);
    let before: BTreeSet<&str> = before.collect();
    let all: BTreeSet<&'static str> = known
        .filter(|tag| before.contains(tag) || tags.contains(tag))
        .collect();
    (result.equations, result.references) = equations_used(&all);
}

fn band(
    loaded: &LoadedCase,
    outcome: &Outcome,
    contacts: &Contacts,
    alternatives: Vec<Alternative>,
    done: &dyn Fn(usize),
) -> Result<(LossBand, DrawnLosses), Error> {
    let (ranged, held) = parameters(loaded).map_err(|error| Error::Whole(Box::new(error)))?;
    let draws = Draws::of(loaded, Some(contacts), &ranged, DRAWS, done)?;
    let effects = draws.effects(&ranged);
    let alternatives = alternatives.into_iter().zip(1..);
    let alternatives = alternatives.map(|((name, other), number)| {
        // An alternative without solution here is no error of the case.
        let found = evaluated(&other, Some(contacts)).ok();
        done(DRAWS + number);
        AlternativeRow {
            name: name.to_owned(),
            loss_w: found.map(|found| found.summary.loss_w),
        }
    });
    let rows = &outcome.result.path;
    let mut drawn = DrawnLosses::new(loaded, &outcome.offsets, rows, &draws.losses);
    drawn.misplaced = misplaced(loaded, outcome.result.summary.loss_w)?;
    let summary = &outcome.result.summary;
    let quantiles_w = drawn.quantiles();
    let [low, high] = quantiles_w.map(|loss| 1.0 - loss / summary.power_in_w);
    let parameters = ranged.iter().zip(&effects);
    let band = LossBand {
        nominal_w: summary.loss_w,
        quantiles_w,
        efficiency_quantiles: [high, low],
        parameter_quantiles_w: five_to_ninety_five(&drawn.exact()),
        parameters: parameters
            .map(|((_, ranged), effect)| BandParameter {
                name: ranged.kind.name().to_owned(),
                value: ranged.value,
                low: ranged.low,
                high: ranged.high,
                unit: ranged.kind.unit().to_owned(),
                is_logarithmic: ranged.kind.is_logarithmic(),
                is_calibrated: ranged.calibrated.is_some(),
                effect_w: *effect,
            })
            .collect(),
        held,
        draws: draws.losses.len(),
        draws_w: draws
            .losses
            .iter()
            .map(|found| found.summary.loss_w)
            .collect(),
        sampling: drawn.sampling(loaded),
        alternatives: alternatives.collect(),
        trust: trust(loaded),
        path_sliding_w_per_m: along_path(rows, &draws.losses, None),
        path_with_sampling_w_per_m: along_path(rows, &draws.losses, Some(&drawn)),
    };
    // A cancelled alternative is not one without solution.
    checkpoint()?;
    Ok((band, drawn))
}

/// Changes of the loss where placed traces are misplaced by two half-widths against each other; none where they are
/// not placed.
fn misplaced(loaded: &LoadedCase, nominal: f64) -> Result<Vec<f64>, Error> {
    const HALF_WIDTHS: f64 = 2.0;
    let changes = [-HALF_WIDTHS, HALF_WIDTHS].into_iter().filter_map(|by| {
        let surfaces = loaded.surfaces.misplaced(by)?;
        let mut other = loaded.clone();
        other.surfaces = surfaces;
        Some(evaluated(&other, None).map(|found| found.summary.loss_w - nominal))
    });
    changes.collect()
}

fn trust(loaded: &LoadedCase) -> Trust {
    let law = loaded.case.load_share();
    match (loaded.surfaces.are_measured(), law.supply()) {
        (false, _) => Trust::RoughnessValues,
        (true, Some(_)) => Trust::SolvedContact,
        (true, None) => Trust::ShareFormula,
    }
}

/// Quantiles of the sliding loss of every position over the draws, each mean with its sampling error where the losses
/// `sampled` have one.
fn along_path(
    nominal: &[PositionRow],
    draws: &[Losses],
    sampled: Option<&DrawnLosses>,
) -> Vec<[f64; 2]> {
    let at = |k: usize| {
        let drawn = draws.iter().filter_map(|found| found.path.get(k));
        let mut values: Vec<Drawn> = drawn.map(|row| drawn_mean(row, sampled)).collect();
        if values.is_empty() {
            values.push(drawn_mean(&nominal[k], sampled));
        }
        five_to_ninety_five(&values)
    };
    (0..nominal.len()).map(at).collect()
}

/// The mean sliding loss of a position with its standard error: between traces, or s/√n_e over n_e windows that count
/// as independent.
fn drawn_mean(row: &PositionRow, sampled: Option<&DrawnLosses>) -> Drawn {
    let value = row.sliding_w_per_m;
    let Some(sampled) = sampled else {
        return Drawn::exact(value);
    };
    let windows = sampled.effective_windows().filter(|windows| *windows > 1.0);
    let between = row
        .sliding_standard_error_w_per_m
        .zip(row.sliding_error_freedom);
    let error = match (between, row.sliding_deviation_w_per_m, windows) {
        (Some((standard_error, freedom)), ..) => Some([standard_error, freedom]),
        (None, Some(deviation), Some(windows)) => Some([deviation / windows.sqrt(), windows - 1.0]),
        _ => None,
    };
    match error {
        Some([standard_error, freedom]) if standard_error > 0.0 => Drawn {
            value,
            standard_error,
            freedom,
        },
        _ => Drawn::exact(value),
    }
}

impl DrawnLosses {
    /// Contribution of the sampling of the flanks, or the reason why there is no interval.
    fn sampling(&self, loaded: &LoadedCase) -> SamplingPart {
        let nominal = self.nominal();
        let misplaced_w = match self.misplaced[..] {
            [down, up] => Some([down, up]),
            _ => None,
        };
        if let Some(found) = self.between_pairs(nominal) {
            return SamplingPart::Pairs(PairSampling {
                misplaced_w,
                ..found
            });
        }
        if let Some(changes) = misplaced_w {
            return SamplingPart::OnePair(changes);
        }
        match window_sampling(nominal, self.effective_windows().unwrap_or(0.0)) {
            Some(found) => SamplingPart::Windows(found),
            None if !loaded.surfaces.are_measured() => {
                SamplingPart::None("no traces, no sampling error".to_owned())
            }
            None if nominal.len() < 2 => SamplingPart::None("one window, no interval".to_owned()),
            None => SamplingPart::None(
                "the traces leave the window less than three averaging widths: one window, no interval"
                    .to_owned(),
            ),
        }
    }
}
