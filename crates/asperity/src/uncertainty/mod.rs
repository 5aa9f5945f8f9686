//! Uncertainty of a loss: draws of its logarithm over constants, sampling of the flanks, tip relief that the case does
//! not state, error of the model and the boundary share of spots that form inside the contact. Models that records or measurements
//! contradict have a table of their own.
//!
//! The draws are the same for every case, so that two finishes differ by their flanks and not by the luck of the draw.
//! A surface through some fifty evaluations gives the sliding loss of every draw; an evaluation costs film laws only, as
//! it reuses the contacts of the run.
//!
//! ```
//! use asperity::{Run, case};
//! let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
//! let case = case::load_with(file, &|input| {
//!     (input.model.positions, input.model.offsets) = (Some(4), Some(4));
//! })?;
//! let result = Run::new(&case).interval(true).execute()?.into_only()?.result;
//! let loss = result.uncertainty.ok_or("the default model has an uncertainty")?.loss;
//! assert!(loss.drawn().low < loss.drawn().value && loss.drawn().value < loss.drawn().high);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod change;
mod common_draws;
mod deciding;
mod difference;
mod evaluations;
mod mesh_run;
mod other_models;
mod recorded;
mod scans;

use asperity_core::{Code, Estimate};
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity_core::cancel::checkpoint;
use asperity_core::provenance::Provenance;

use crate::assembly::{equations_used, far_lay, relief_warning, sources_used};
use crate::contacts::Contacts;
use crate::pipeline::{Kept, Options, outcome};
use crate::result::{
    AlternativeRow, DrawnConstant, LossDistribution, Losses, MeshOutcome, PairSampling, RunResult,
    SamplingPart, Trust, Uncertainty, UncertaintyPart,
};
use crate::sampling::{length_for, windows_of_traces};
use asperity_case::balance::impossible_efficiency;
use asperity_case::case::{LoadedCase, OperatingCase, ShareLaw};
use asperity_case::error::{Error, PositionError};
use asperity_case::message::{Subject, Warning};
use asperity_uncertainty::{
    Component, InnerBoundary, Measured, Ranged, UncertainParameter as Constant,
};

pub use crate::sampling::{Independent, independent_windows, pair_sampling, window_sampling};
pub use asperity_uncertainty::{
    Common, ENDS, Expected, MODEL_LENGTHS, Measurement, MeshDraws, Predictive, Quantiles,
    UncertainParameter, deviation_of_curves, median_with_ends, model_correlation, model_deviation,
    range, sorted_quantiles,
};
pub use change::{ChangeDraws, few_offsets_of, sampling_error_of_changes, sampling_interval};
pub use common_draws::{CommonConstant, DrawnCase, common_draws};
pub use deciding::{DecidingMeasurement, deciding};
pub use difference::{
    DrawnMesh, PairedDifference, Verdict, beside, change_between, change_of, difference,
    difference_of_meshes, difference_of_places, differences, losses_of_meshes,
};
pub use evaluations::has_band;
pub use recorded::predictive;

use evaluations::{
    EvaluatedLosses, Nominal, Windows, count, evaluated, of_windows, travelled, widest,
};
use mesh_run::MeshRun;
use other_models::{OtherModel, by_formula, other_models};

/// Error of ln loss by the interpolation of the draws that is worth a warning.
const PRECISE: f64 = 0.02;

/// Evaluations of a case for its draws, other models among them.
#[must_use]
pub fn evaluations(loaded: &LoadedCase) -> usize {
    if has_band(loaded) {
        let number = |case: OperatingCase| Ok(count(&case) + other_models(&case)?.len());
        loaded.at_stated().and_then(number).unwrap_or(0)
    } else {
        0
    }
}

/// Runs a mesh, with its draws if its interval is requested.
pub(crate) fn run_and_draw(loaded: &LoadedCase, options: &Options<'_>) -> Result<MeshRun, Error> {
    let (kept, progress) = (&options.kept, options.progress);
    // Each evaluation counts like a position, and the run of the rows like the run of the patches.
    let more = if options.interval {
        evaluations(loaded)
    } else {
        0
    };
    let before = AtomicUsize::new(0);
    let runs = if scans::is_due(loaded, kept) { 2 } else { 1 };
    let by_rows = |rows: &LoadedCase, interval: bool| {
        let patches = before.load(Ordering::Relaxed) + more;
        let of_rows = Options {
            kept: Kept::NoPictures,
            interval,
            progress: &|done, total| progress(patches + done, patches + total),
            known: Vec::new(),
            ..options.clone()
        };
        run_and_draw(rows, &of_rows)
    };
    let shown = |done, total| {
        before.store(total, Ordering::Relaxed);
        progress(done, runs * (total + more));
    };
    let (mut outcome, loaded, contacts) = outcome(loaded, options, &shown)?;
    if !options.interval || !has_band(&loaded) {
        scans::compare_with_rows(&mut outcome, None, &loaded, &contacts, kept, &by_rows)?;
        return Ok(MeshRun {
            outcome,
            drawn: None,
            contacts,
        });
    }
    let used = Provenance::new();
    let positions = before.load(Ordering::Relaxed);
    let done = |evaluated| progress(positions + evaluated, runs * (positions + more));
    let found = used.collect(|| uncertainty(&loaded, &outcome, &contacts, &done));
    let (uncertainty, predictive) = found?;
    let warnings = &mut outcome.result.warnings;
    let of_lay = far_lay(&loaded, predictive.at_confirmed_lay());
    let of_lay = of_lay.map_err(|error| Error::Whole(Box::new(error)))?;
    let of_relief = relief_warning(&loaded, predictive.at_ends_of_relief());
    // What was drawn states what the finding is worth.
    for with_worth in of_relief.into_iter().chain(of_lay) {
        let known = warnings
            .iter_mut()
            .find(|known| known.code == with_worth.code);
        if let Some(known) = known {
            *known = with_worth;
        }
    }
    if predictive.surface_rms > PRECISE {
        let percent = 100.0 * predictive.surface_rms;
        let text = format!("the samples interpolate ln loss over the constants to {percent:.1} %");
        warnings.push(Warning::new(Code::W440, text));
    }
    if uncertainty.beyond_power > 0 {
        let text = format!(
            "{} of {} samples exceeded the power into the mesh and were set to it",
            uncertainty.beyond_power, uncertainty.draws
        );
        warnings.push(Warning::new(Code::W440, text));
    }
    used.collect(|| outcome.restate(&loaded.case, uncertainty.loss.median_w))?;
    outcome.result.uncertainty = Some(uncertainty);
    note(&mut outcome.result, &used.tags());
    let drawn = Some(&predictive);
    scans::compare_with_rows(&mut outcome, drawn, &loaded, &contacts, kept, &by_rows)?;
    Ok(MeshRun {
        outcome,
        drawn: Some(predictive),
        contacts,
    })
}

/// Standard error of ln loss by the sampling of the flanks, as in the draws; 0 without traces.
///
/// # Errors
/// As [`Run::losses`](crate::Run::losses), of misplaced traces.
pub fn standard_error(loaded: &OperatingCase, nominal: &Losses) -> Result<f64, Error> {
    evaluations::standard_error(loaded, &Nominal::from_losses(nominal))
}

/// Adds the equations of the uncertainty to the equations of the run.
fn note(result: &mut RunResult, tags: &BTreeSet<&'static str>) {
    let before = result.equations.iter().map(|found| found.tag.as_ref());
    let known = crate::equations::all().iter().map(|known| known.tag);
    let before: BTreeSet<&str> = before.collect();
    let all: BTreeSet<&'static str> = known
        .filter(|tag| before.contains(tag) || tags.contains(tag))
        .collect();
    (result.equations, result.references) = (equations_used(&all), sources_used(&all));
}

fn uncertainty(
    loaded: &OperatingCase,
    outcome: &MeshOutcome,
    contacts: &Contacts,
    done: &(dyn Fn(usize) + Sync),
) -> Result<(Uncertainty, Predictive), Error> {
    let nominal = Nominal::of_outcome(outcome);
    let EvaluatedLosses {
        predictive,
        of_positions,
        held,
        evaluations,
    } = recorded::evaluate(loaded, &nominal, Windows::few(contacts), done)?;
    let of_model = |(model, number): (OtherModel, usize)| {
        // A model without solution here is no error of the case.
        let found = evaluated(&model.case, Some(contacts)).ok();
        done(evaluations + number);
        AlternativeRow {
            name: model.name.to_owned(),
            loss_w: found.map(|found| found.summary.loss_w),
            refuted_by: model.refuted_by.to_owned(),
        }
    };
    let others = other_models(loaded)?.into_iter().zip(1..).map(of_model);
    let others = others.chain(by_formula(loaded, &nominal));
    let mut others: Vec<AlternativeRow> = others.collect();
    // A cancelled model is not one without solution.
    checkpoint()?;
    let draws_w = predictive.draws_w();
    let Quantiles { drawn, sd_ln } = Quantiles::from_draws(&draws_w);
    let to_median = if predictive.at_medians_w > 0.0 {
        drawn.value / predictive.at_medians_w
    } else {
        1.0
    };
    for loss in others.iter_mut().filter_map(|row| row.loss_w.as_mut()) {
        *loss *= to_median;
    }
    let power = predictive.power_in_w;
    let efficiency = drawn.map(|loss| 1.0 - loss / power);
    if drawn.high >= power {
        let of = "5 % quantile of the efficiency";
        let impossible = impossible_efficiency(of, efficiency.low);
        return Err(Error::Whole(Box::new(PositionError::from(impossible))));
    }
    let places: &[f64] = match predictive.recorded {
        Some(_) => &[0.0, 1.0],
        None => &[0.0, 0.5, 1.0],
    };
    let structures = places.iter().filter_map(|place| {
        Some(AlternativeRow {
            name: match predictive.recorded {
                Some(_) if *place > 0.5 => "whole boundary friction below 20 nm".to_owned(),
                Some(_) => "boundary friction that falls with the film".to_owned(),
                None => format!(
                    "boundary share of inner contacts {}",
                    InnerBoundary::value(*place)
                ),
            },
            loss_w: Some(to_median * predictive.at_inner_boundary(*place)?),
            refuted_by: String::new(),
        })
    });
    let sliding_w_per_m = nominal.path.iter().map(|row| row.sliding_w_per_m);
    let found = Uncertainty {
        loss: LossDistribution {
            median_w: drawn.value,
            quantiles_w: drawn.ends(),
            sd_ln,
            parts: parts(loaded, &predictive, &nominal, to_median),
        },
        efficiency_median: efficiency.value,
        efficiency_quantiles: efficiency.ends(),
        constants: predictive.constants.iter().map(drawn_constant).collect(),
        held,
        draws: Predictive::count(),
        beyond_power: draws_w.iter().filter(|loss| **loss >= power).count(),
        evaluations,
        interpolation_error: predictive.surface_rms,
        roughness_over_film: predictive.roughness_over_film,
        sampling: sampling(loaded, &predictive, &nominal, to_median),
        boundary_w: predictive.inner_boundary.as_ref().map(|inner| {
            let of_run = nominal.summary.boundary_w * to_median;
            ENDS.map(|place| of_run * inner.boundary_at(place))
        }),
        structures: structures.collect(),
        other_models: others,
        trust: trust(loaded),
        with_traces_w: predictive.with_traces().map(|found| found.drawn.ends()),
        path_sliding_w_per_m: predictive.quantiles_along_path(
            &draws_w,
            &sliding_w_per_m.collect::<Vec<_>>(),
            &of_positions,
        ),
        evidence: Vec::new(),
    };
    Ok((found, predictive))
}

fn drawn_constant(ranged: &Ranged) -> DrawnConstant {
    let Estimate { value, low, high } = ranged.quantiles();
    DrawnConstant {
        name: ranged.kind.name().to_owned(),
        value,
        low,
        high,
        unit: ranged.kind.unit().to_owned(),
        is_calibrated: ranged.measured == Some(Measured::Calibration),
    }
}

/// Measurement that narrows the constants of the film friction.
const TRACTION: &str = "a traction curve of the oil";
/// Measurement that narrows the constants of the boundary layer.
const RIG: &str = "losses measured on a rig (asperity calibrate)";
/// Solution that is more certain than the model, and takes minutes.
const RECORDS: &str = "reference solutions: model.load_share = \"ehl\"";

/// The measurement that would narrow a constant.
fn measurement_of(ranged: &Ranged) -> &'static str {
    match ranged.kind {
        Constant::BoundaryFriction | Constant::BoundaryLayer => RIG,
        Constant::Lay if ranged.measured.is_some() => "longer areal scans of the flanks",
        Constant::Lay => "an areal scan of the flank: model.lay",
        Constant::LimitingShear | Constant::EyringStress if ranged.measured.is_none() => TRACTION,
        Constant::LimitingShear
        | Constant::EyringStress
        | Constant::LimitingShearTemperature
        | Constant::PressureViscosityFactor => "further traction curves of the oil",
        Constant::PressureViscosity => "lubricant.pressure_viscosity of the oil",
        Constant::TemperatureError => "a thermocouple: operation.temperature_deviation",
    }
}

/// The measurement that would narrow a component of the loss.
fn remedy_of(
    component: Component,
    loaded: &OperatingCase,
    predictive: &Predictive,
    nominal: &Nominal<'_>,
) -> String {
    let half_width = widest(nominal.path);
    let windows = || {
        windows_of_traces(&loaded.surfaces, loaded.case.model.window, half_width)
            .unwrap_or(f64::INFINITY)
    };
    let remedy = match component {
        Component::Constant(k) => measurement_of(&predictive.constants[k]),
        Component::Sampling if loaded.surfaces.is_surrogate() => "traces of the flanks",
        Component::Sampling if windows() < 8.0 => {
            let length = length_for(8.0, loaded.case.model.window, half_width);
            let millimetres = 1e3 * length.si();
            return format!("traces of {millimetres:.1} mm or more, or of more teeth");
        }
        Component::Sampling => "traces of more teeth",
        Component::Relief => "gears.pinion.tip_relief and gears.wheel.tip_relief",
        Component::Model | Component::InnerBoundary => {
            if recorded::would_narrow(loaded, predictive, nominal) {
                RECORDS
            } else {
                RIG
            }
        }
        Component::HeldThermal => "losses measured at this temperature",
        Component::FilmLaw => match loaded.case.oil_file.as_ref() {
            Some(file) if file.film_friction.is_far(loaded.temperature()) => {
                "traction curves at the temperature of the flanks"
            }
            _ => RIG,
        },
        Component::PressureLaw => "traction curves at further pressures",
        Component::Rolling => "a spin-loss measurement",
        Component::FarLay | Component::PatchFlow | Component::Constants => RIG,
    };
    remedy.to_owned()
}

/// Every component, drawn with all others at their medians and scaled `to_median`, the largest first.
fn parts(
    loaded: &OperatingCase,
    predictive: &Predictive,
    nominal: &Nominal<'_>,
    to_median: f64,
) -> Vec<UncertaintyPart> {
    let law = predictive.law();
    let alone = Component::all(predictive).filter_map(|component| {
        let found = law.alone(component)?;
        let constant = |k: usize| predictive.constants.get(k).map(|ranged| ranged.kind);
        let about = match component {
            Component::Sampling => Some(Subject::Sampling),
            Component::Relief => Some(Subject::TipRelief),
            Component::Model if predictive.recorded.is_none() => Some(Subject::FastModel),
            Component::FarLay | Component::PatchFlow => Some(Subject::Lay),
            Component::Constant(k) => constant(k)
                .filter(|kind| *kind == Constant::PressureViscosity)
                .map(|_| Subject::PressureViscosity),
            _ => None,
        };
        Some(UncertaintyPart {
            name: component.name(predictive).to_owned(),
            about,
            sd_ln: found.sd_ln,
            quantiles_w: found.drawn.ends().map(|loss| to_median * loss),
            remedy: remedy_of(component, loaded, predictive, nominal),
        })
    });
    let mut parts: Vec<UncertaintyPart> = alone.collect();
    parts.sort_by(|a, b| b.half_range_w().total_cmp(&a.half_range_w()));
    parts
}

fn trust(loaded: &OperatingCase) -> Trust {
    if loaded.surfaces.is_surrogate() {
        return Trust::Surrogates;
    }
    match loaded.case.share_law() {
        _ if !loaded.surfaces.are_measured() => Trust::RoughnessValues,
        ShareLaw::Reference => Trust::SolvedContact,
        law if law.contact().is_some() => Trust::SolvedContact,
        _ => Trust::ShareFormula,
    }
}

/// Contribution of the sampling of the flanks, or the reason why there is none.
fn sampling(
    loaded: &OperatingCase,
    predictive: &Predictive,
    nominal: &Nominal<'_>,
    to_median: f64,
) -> SamplingPart {
    let loss_w = to_median * predictive.at_medians_w;
    let shifts = predictive.sampling.shifts;
    let misplaced_w = shifts.map(|shifts| shifts.map(|shift| loss_w * (shift.exp() - 1.0)));
    if loaded.surfaces.is_surrogate() {
        let pairs = loaded.surfaces.pairs();
        return SamplingPart::None(format!(
            "{pairs} pairs of surrogate flanks, no trace was measured"
        ));
    }
    if let Some(of_records) = travelled(loaded, nominal, predictive.asperity_share) {
        return SamplingPart::Windows(of_records);
    }
    if let Some(found) = nominal.pairs {
        return SamplingPart::Pairs(PairSampling {
            misplaced_w,
            ..found.times(to_median)
        });
    }
    if let Some(changes) = misplaced_w {
        return SamplingPart::OnePair(changes);
    }
    let found = of_windows(loaded, nominal, predictive.asperity_share);
    match found.ok().flatten() {
        Some(found) => SamplingPart::Windows(found),
        None => SamplingPart::None("no traces, no sampling error".to_owned()),
    }
}
