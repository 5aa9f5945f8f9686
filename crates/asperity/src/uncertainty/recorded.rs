//! Draws of a loss, from contacts or from reference solutions.
//!
//! A record takes minutes, so that none is solved for a draw: over the constants and the lay the loss changes as by the model,
//! which agrees with records within some percent. Its own error and β_i give way to the errors of the records, and to the two rules
//! of their boundary friction.

use asperity_uncertainty::{COMPARED, Predictive, RecordedRule, SamplingError};

use super::evaluations::{
    EvaluatedLosses, Nominal, Windows, by_contacts, evaluated, has_band, travelled, widest,
};
use super::other_models::step_rule_of;
use crate::contacts::Contacts;
use crate::pipeline::{Options, by_solved_contacts, contacts as contacts_of, settled};
use crate::result::{Losses, PositionRow, RecordedFriction};
use crate::sampling::windows_of_traces;
use asperity_case::case::{LoadedCase, OperatingCase};
use asperity_case::error::Error;
use asperity_case::flanks::AVERAGING_WIDTH;

/// The draws of a loss that is known already, with contacts made before, if any; `None` if the case has no
/// uncertainty.
///
/// # Errors
/// As [`Run::losses`](crate::Run::losses).
pub fn predictive(
    loaded: &LoadedCase,
    nominal: &Losses,
    contacts: Option<&Contacts>,
) -> Result<Option<Predictive>, Error> {
    if !has_band(loaded) {
        return Ok(None);
    }
    let computed;
    let contacts = match contacts {
        Some(contacts) => contacts,
        None => {
            computed = contacts_of(loaded, &[])?;
            &computed
        }
    };
    predictive_of(loaded, nominal, Windows::few(contacts))
}

/// The draws of a loss that is known already, by some windows of its contacts.
pub(super) fn predictive_of(
    loaded: &LoadedCase,
    nominal: &Losses,
    windows: Windows<'_>,
) -> Result<Option<Predictive>, Error> {
    if !has_band(loaded) {
        return Ok(None);
    }
    let found = settled(loaded, &Options::known(windows.contacts))?;
    let evaluated = evaluate(&found, &Nominal::from_losses(nominal), windows, &|_| {})?;
    Ok(Some(evaluated.predictive))
}

/// Evaluates a case around `nominal`, its losses at the medians; `done` is called after each evaluation.
pub(super) fn evaluate(
    loaded: &OperatingCase,
    nominal: &Nominal<'_>,
    windows: Windows<'_>,
    done: &(dyn Fn(usize) + Sync),
) -> Result<EvaluatedLosses, Error> {
    match nominal.summary.recorded_friction {
        Some(friction) => by_records(loaded, nominal, friction, done),
        None => by_contacts(loaded, nominal, windows, done),
    }
}

/// Evaluates a case around `nominal`, its losses by records with the friction `friction`.
///
/// ```text
/// S(θ) = S_records S_fast(θ)/S_fast(θ₀)                                            [Record-draw]
/// ```
///
/// S_records: sliding loss of the run at the medians θ₀, its lay included.
fn by_records(
    loaded: &OperatingCase,
    nominal: &Nominal<'_>,
    friction: RecordedFriction,
    done: &(dyn Fn(usize) + Sync),
) -> Result<EvaluatedLosses, Error> {
    asperity_core::cite!("Record-draw");
    let fast = by_solved_contacts(loaded)?;
    let contacts = contacts_of(&fast, &[])?;
    let losses = evaluated(&fast, Some(&contacts))?;
    let mut found = by_contacts(
        &fast,
        &Nominal::from_losses(&losses),
        Windows::few(&contacts),
        done,
    )?;
    let summary = nominal.summary;
    let predictive = &mut found.predictive;
    predictive.at_medians_w = summary.loss_w;
    predictive.power_in_w = summary.power_in_w;
    predictive.parts_w = [
        summary.sliding_w,
        summary.rolling_w,
        summary.loss_w - summary.sliding_w - summary.rolling_w,
    ];
    predictive.asperity_share = summary.asperity_share;
    predictive.recorded = Some(RecordedRule {
        stepped: friction.stepped,
    });
    if let Some(of_records) = travelled(loaded, nominal, summary.asperity_share) {
        predictive.sampling.standard_error = of_records.standard_error;
        predictive.sampling.freedom = of_records.freedom;
    }
    Ok(found)
}

/// Whether records would narrow the interval of a case that the model has solved: up to the roughness over film that the records
/// are a reference for, and where their own errors are smaller.
///
/// Expected of records are their error, the rule of their boundary friction with the mean effect that it has in records, and the
/// sampling of the traces by the travel that the case requires.
pub(super) fn would_narrow(
    loaded: &OperatingCase,
    predictive: &Predictive,
    nominal: &Nominal<'_>,
) -> bool {
    let summary = nominal.summary;
    let is_judged = |row: &PositionRow| row.roughness_over_film.is_none_or(|s| s <= COMPARED);
    if predictive.inner_boundary.is_none()
        || predictive.far_lay.is_some()
        || loaded.surfaces.several_teeth().is_some()
        || !nominal.path.iter().all(is_judged)
    {
        return false;
    }
    let choices = &loaded.case.model.ehl;
    let passed = choices.records as f64 * choices.travel / AVERAGING_WIDTH;
    let half_width = widest(nominal.path);
    let of_traces = windows_of_traces(&loaded.surfaces, loaded.case.model.window, half_width);
    let now = of_traces.map_or(passed, |windows| windows.min(summary.offsets as f64));
    let of_travel = (now / passed).max(1.0).sqrt();
    let expected = Predictive {
        inner_boundary: None,
        recorded: Some(RecordedRule {
            stepped: 1.0 + step_rule_of(loaded, nominal) / summary.sliding_w,
        }),
        sampling: SamplingError {
            standard_error: of_travel * predictive.sampling.standard_error,
            ..predictive.sampling
        },
        ..predictive.clone()
    };
    expected.quantiles().sd_ln < predictive.quantiles().sd_ln
}
