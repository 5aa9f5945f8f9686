//! Draws of a loss whose friction comes from records of mixed lubrication.
//!
//! A record takes minutes, so that none is solved for a draw: over the constants and the lay the loss changes as by the fast model,
//! which agrees with records within some percent. Its own error and β_i give way to the errors of the records, and to the two rules
//! of their boundary friction.

use asperity_ehl_regime::inlet_flow::Lay;
use asperity_uncertainty::{COMPARED, Predictive, RecordedRule, SamplingError};

use super::evaluations::{Evaluated, Nominal, by_contacts, evaluated, widest};
use super::other_models::step_rule_of;
use crate::pipeline::contacts;
use crate::result::RecordedFriction;
use crate::result::loss_band::WindowSampling;
use crate::sampling::{travel_sampling, windows_of_traces};
use asperity_case::case::{LoadShareName, LoadedCase};
use asperity_case::error::Error;
use asperity_case::flanks::AVERAGING_WIDTH;

/// The case by the fast model, with β_i as it is: the records have no spots.
fn by_solved_contacts(loaded: &LoadedCase) -> LoadedCase {
    let mut fast = loaded.clone();
    let (model, input) = (&mut fast.case.model, &mut fast.case.input.model);
    model.load_share = LoadShareName::Solved;
    input.inner_boundary = Some(model.inner_boundary);
    fast
}

/// Evaluates a case around `nominal`, its losses by records with the friction `friction`.
///
/// ```text
/// S(θ) = S_records S_fast(θ)/S_fast(θ₀, lay 0)                                     [Record-draw]
/// ```
pub(super) fn evaluate(
    loaded: &LoadedCase,
    nominal: &Nominal<'_>,
    friction: RecordedFriction,
    done: &(dyn Fn(usize) + Sync),
) -> Result<Evaluated, Error> {
    asperity_core::cite!("Record-draw");
    let fast = by_solved_contacts(loaded);
    let contacts = contacts(&fast)?;
    let losses = evaluated(&fast, Some(&contacts))?;
    let mut found = by_contacts(&fast, &Nominal::of(&losses), &contacts, done)?;
    let mut across = fast;
    across.case.model.lay = [Lay::ACROSS; 2];
    let of_lay = match evaluated(&across, Some(&contacts))?.summary.sliding_w {
        at_records if at_records > 0.0 => losses.summary.sliding_w / at_records,
        _ => 1.0,
    };
    let summary = nominal.summary;
    let predictive = &mut found.predictive;
    predictive.at_medians_w = summary.loss_w;
    predictive.power_in_w = summary.power_in_w;
    predictive.parts_w = [
        of_lay * summary.sliding_w,
        summary.rolling_w,
        summary.loss_w - summary.sliding_w - summary.rolling_w,
    ];
    predictive.asperity_share = summary.asperity_share;
    predictive.recorded = Some(RecordedRule {
        stepped: friction.stepped,
    });
    if let Some(of_records) = sampling(loaded, nominal, summary.asperity_share) {
        predictive.sampling.standard_error = of_records.standard_error;
        predictive.sampling.freedom = of_records.freedom;
    }
    Ok(found)
}

/// Sampling error of a loss by records: of the windows that passed through their contacts, and of no more than the traces have;
/// `None` without records.
pub(super) fn sampling(
    loaded: &LoadedCase,
    nominal: &Nominal<'_>,
    asperity_share: f64,
) -> Option<WindowSampling> {
    let friction = nominal.summary.recorded_friction?;
    let of_traces = windows_of_traces(
        &loaded.surfaces,
        loaded.case.model.window,
        widest(nominal.path),
    )?;
    let travel = match friction.standard_error.is_finite() {
        true => (
            friction.windows.round().max(1.0) as usize,
            friction.standard_error,
        ),
        // A travel of one block says nothing of its scatter.
        false => (1, 0.0),
    };
    Some(travel_sampling(travel, of_traces, asperity_share))
}

/// Whether records would narrow the interval of a case that the fast model has solved: up to the roughness over film that the records
/// are a reference for, and where their own errors are smaller.
///
/// Expected of records are their error, the rule of their boundary friction with the mean effect that it has in records, and the
/// sampling of the traces by the travel that the case asks for.
pub(super) fn would_narrow(
    loaded: &LoadedCase,
    predictive: &Predictive,
    nominal: &Nominal<'_>,
) -> bool {
    let summary = nominal.summary;
    let over_film = nominal.path.iter().map(|row| row.roughness_over_film);
    let is_judged = |over_film: Option<f64>| over_film.is_none_or(|s| s <= COMPARED);
    if predictive.inner_boundary.is_none()
        || predictive.far_lay.is_some()
        || loaded.surfaces.several_teeth().is_some()
        || !over_film.into_iter().all(is_judged)
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
