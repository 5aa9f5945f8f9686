//! Worth of the change of traces in a case: wear coefficient, loss before and after, and the prediction of `operation.running_in`.

use std::path::PathBuf;

use asperity::Error;
use asperity::Run;
use asperity::case::{FlankPlaceInput, LoadedCase, TraceInput, TraceStart};
use asperity::flanks::Surfaces;
use asperity::flanks::surfaces::FlankReport;
use asperity::gear::Gear;
use asperity::mesh::Mesh;
use asperity::message::Warning;
use asperity::pipeline::Kept;
use asperity::result::MeshOutcome;
use asperity::uncertainty::{PairedDifference, Predictive, difference_of_places};
use asperity_core::numerics::mean;
use asperity_core::quantity::Length;
use asperity_core::{Code, Estimate, EstimateKeys, Fault, Profile, cite, estimate_keys};
use asperity_roughness::material_ratio::rk_parameters;
use asperity_roughness::relocation::Relocation;
use asperity_roughness::section_heights::section_heights;
use schemars::JsonSchema;
use serde::de::IntoDeserializer;
use serde::{Deserialize, Serialize};

use super::pairs::TracePair;
use super::wear::{AtPlace, Severity, WearCoefficient, coefficient};

/// Cubic millimetres per newton metre in 1/Pa.
const MM3_PER_N_M: f64 = 1e9;
const MICRO: f64 = 1e6;

/// Flank that a test changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum WornFlank {
    /// Flank of the pinion.
    Pinion,
    /// Flank of the wheel.
    Wheel,
}

impl std::str::FromStr for WornFlank {
    type Err = serde::de::value::Error;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::deserialize(name.into_deserializer())
    }
}

impl WornFlank {
    const BOTH: [Self; 2] = [Self::Pinion, Self::Wheel];

    pub(super) const fn gear(self) -> Gear {
        match self {
            Self::Pinion => Gear::Pinion,
            Self::Wheel => Gear::Wheel,
        }
    }

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Pinion => "pinion",
            Self::Wheel => "wheel",
        }
    }
}

estimate_keys! {
    SlidingKeys: "sliding_um" "sliding_quantiles_um";
    WearKeys: "k_mm3_per_n_m" "k_quantiles_mm3_per_n_m";
    RemovedKeys: "removed_nm" "removed_quantiles_nm";
}

/// A flank of the case, changed by the test.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FlankChange {
    /// The flank.
    pub flank: WornFlank,
    /// Pairs of traces on it.
    pub pairs: usize,
    /// Whether the case states the place of every trace.
    pub is_placed: bool,
    /// Mean height removed, the scatter from pair to pair not in its interval.
    #[serde(flatten, with = "RemovedKeys")]
    pub removed_nm: Estimate,
    /// Sliding distance of a point in an engagement, as mean over the traces, with the places at which they may lie.
    #[serde(flatten, with = "SlidingKeys")]
    pub sliding_um: Estimate,
    /// Engagements of a tooth of this gear; `None` if the engagements are not stated.
    pub engagements: Option<f64>,
    /// Sliding distance of a point in all engagements.
    pub sliding_m: Option<f64>,
    /// Archard's wear coefficient; `None` without engagements, or if noise explains the removal.
    #[serde(flatten, serialize_with = "WearKeys::serialize")]
    pub k_mm3_per_n_m: Option<Estimate>,
    /// Its largest value where noise explains the removal.
    pub k_at_most_mm3_per_n_m: Option<f64>,
    /// The coefficient times the indentation hardness: without a dimension.
    pub k_times_hardness: Option<f64>,
    /// Rq as prepared for the case, before the test.
    pub before_rq_um: f64,
    /// Rq after it.
    pub after_rq_um: f64,
    /// Rq of the flank before that `operation.running_in` predicts.
    pub run_in_rq_um: Option<f64>,
    /// Rpk before the test.
    pub before_rpk_um: f64,
    /// Rpk after it.
    pub after_rpk_um: f64,
    /// Rpk that `operation.running_in` predicts.
    pub run_in_rpk_um: Option<f64>,
}

/// Loss of the mesh with the flanks of one state.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct StateLoss {
    /// State of the flanks.
    pub state: &'static str,
    /// Loss: the median of the draws, without draws the loss of the run.
    pub loss_w: f64,
    /// 5 and 95 % quantiles; `None` if the model has no uncertainty.
    pub loss_quantiles_w: Option<[f64; 2]>,
    /// Loss of the run with every constant at its median; `None` without draws.
    pub loss_at_medians_w: Option<f64>,
}

impl StateLoss {
    /// The loss with its quantiles; `None` if the model has no uncertainty.
    #[must_use]
    pub fn drawn_w(&self) -> Option<Estimate> {
        let ends = self.loss_quantiles_w?;
        Some(Estimate::new(self.loss_w, ends))
    }
}

/// Worth of the change in a case.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ChangeInCase {
    /// Title of the case.
    pub case: String,
    /// Operating point.
    pub conditions: String,
    /// Flanks that changed.
    pub flanks: Vec<FlankChange>,
    /// Losses before and after the test, and as `operation.running_in` predicts it.
    pub states: Vec<StateLoss>,
    /// Loss after minus loss before, draw by draw; `None` if the model has no uncertainty, or the windows have no scatter.
    pub difference: Option<PairedDifference>,
    /// Reason for a missing prediction of `operation.running_in`.
    pub no_run_in: Option<String>,
    /// Warnings of the case.
    pub warnings: Vec<Warning>,
}

impl ChangeInCase {
    /// The loss in a state of the flanks.
    pub(super) fn loss(&self, state: &str) -> Option<&StateLoss> {
        self.states.iter().find(|loss| loss.state == state)
    }
}

/// Names of the states.
pub(super) const BEFORE: &str = "before";
pub(super) const AFTER: &str = "after";
pub(super) const RUN_IN: &str = "run in by the model";

/// A pair of traces with its match.
pub(super) type Matched = (TracePair, Relocation);

/// A pair of traces on its flank.
struct OnFlank<'a> {
    flank: WornFlank,
    pair: &'a TracePair,
    found: &'a Relocation,
    site: Site,
    /// Arc of the first point of the trace before \[m\], and its growth along the trace; `None` where the place is not known.
    place: Option<[f64; 2]>,
}

/// The worth of the changes of all pairs in `case`; `stated` is the flank of pairs that the case does not show, `engagements` are
/// of a tooth of the pinion.
pub(super) fn in_case(
    case: &LoadedCase,
    stated: Option<WornFlank>,
    engagements: Option<f64>,
    matched: &[Matched],
    step: &dyn Fn(usize),
) -> Result<ChangeInCase, Fault> {
    let placed = matched
        .iter()
        .map(|(pair, found)| on_flank(case, pair, found, stated));
    let mut pairs = placed.collect::<Result<Vec<_>, Fault>>()?;
    for flank in WornFlank::BOTH {
        let of_flank = |pair: &&mut OnFlank<'_>| pair.flank == flank;
        if pairs
            .iter()
            .any(|pair| pair.flank == flank && pair.place.is_none())
        {
            pairs
                .iter_mut()
                .filter(of_flank)
                .for_each(|pair| pair.place = None);
        }
    }
    let measured = pairs.iter().map(|on| {
        let [before, after] = &on.pair.traces;
        Ok(on.found.as_measured(before, after)?)
    });
    let measured = measured.collect::<Result<Vec<[Profile; 2]>, Fault>>()?;
    let state = |after: usize| with_traces(case, &pairs, &measured, after);
    let (before, after) = (state(0)?, state(1)?);
    let (first, first_draws) = drawn(&before)?;
    step(1);
    let offsets = first.result.summary.offsets;
    let after = after.with(|input| input.model.offsets = Some(offsets))?;
    let (second, second_draws) = drawn(&after)?;
    step(2);
    let (run_in, no_run_in) = run_in(&before)?;
    let uncertainties = [&first, &second].map(|of| of.result.uncertainty.as_ref());
    let difference = match (first_draws, second_draws, uncertainties) {
        (Some(own), Some(other), [Some(of_first), Some(of_second)]) => {
            let changed = |flank: &WornFlank| pairs.iter().any(|pair| pair.flank == *flank);
            let changed = WornFlank::BOTH.into_iter().filter(changed);
            let concordance = concordance_of([&before, &after], changed)?;
            Some(difference_of_places(
                (&before, &own, of_first),
                (&after, &other, of_second),
                concordance,
            ))
        }
        _ => None,
    };
    let mesh = Mesh::new(&before.case)?;
    let flanks = WornFlank::BOTH.into_iter().map(|flank| {
        let states = [&before, &after];
        flank_change(&mesh, flank, engagements, &pairs, states, run_in.as_ref())
    });
    let flanks = flanks
        .filter_map(Result::transpose)
        .collect::<Result<_, _>>()?;
    let mut states = vec![of_state(BEFORE, &first), of_state(AFTER, &second)];
    states.extend(run_in.as_ref().and_then(|run| {
        let found = run.result.run_in.as_ref()?;
        let measured = &first.result.summary;
        // It is not drawn, and has the ratio of the flanks before.
        let to_median = measured.loss_w / measured.at_medians_w();
        Some(StateLoss {
            state: RUN_IN,
            loss_w: to_median * found.summary.loss_w,
            loss_quantiles_w: None,
            loss_at_medians_w: None,
        })
    }));
    Ok(ChangeInCase {
        case: case.case.title.clone(),
        conditions: case.case.conditions(),
        flanks,
        states,
        difference,
        no_run_in,
        warnings: warnings([&first, &second]),
    })
}

/// Warnings of both runs; a warning of one run has its state.
fn warnings(runs: [&MeshOutcome; 2]) -> Vec<Warning> {
    let [before, after] = runs.map(|run| run.result.warnings.as_slice());
    let tagged = |own: &[Warning], other: &[Warning], state: &str| {
        let alone = own.iter().filter(|warning| !other.contains(warning));
        let of_state = alone.map(|warning| Warning {
            text: format!("{} [{state}]", warning.text),
            ..warning.clone()
        });
        of_state.collect::<Vec<_>>()
    };
    let common = before.iter().filter(|warning| after.contains(warning));
    let mut found: Vec<Warning> = common.cloned().collect();
    found.extend(tagged(before, after, BEFORE));
    found.extend(tagged(after, before, AFTER));
    found
}

fn drawn(case: &LoadedCase) -> Result<(MeshOutcome, Option<Predictive>), Error> {
    let run = Run::new(case).pictures(Kept::Nothing).interval(true);
    run.execute()?.only_with_draws()
}

/// The flanks before run in by the model, or why the case does not allow it.
fn run_in(before: &LoadedCase) -> Result<(Option<MeshOutcome>, Option<String>), Error> {
    let case = match before.case.running_in {
        Some(_) => Ok(before.clone()),
        None => before.with_key("operation.running_in", "true"),
    };
    let case = match case {
        Ok(case) => case,
        Err(error) => return Ok((None, Some(error.to_string()))),
    };
    let outcome = Run::new(&case).pictures(Kept::NoPictures).execute()?;
    Ok((Some(outcome.into_only()?), None))
}

fn of_state(state: &'static str, outcome: &MeshOutcome) -> StateLoss {
    let uncertainty = outcome.result.uncertainty.as_ref();
    let summary = &outcome.result.summary;
    StateLoss {
        state,
        loss_w: summary.loss_w,
        loss_quantiles_w: uncertainty.map(|found| found.loss.quantiles_w),
        loss_at_medians_w: summary.loss_at_medians_w,
    }
}

/// Number of the tooth and place across the face of a trace, where the case states them.
type Site = (Option<u32>, Option<Length>);

/// Reports on the traces of a flank, with their sites.
fn reports(case: &LoadedCase, flank: WornFlank) -> Vec<(&FlankReport, Site)> {
    let body = flank as usize;
    match &case.sampled {
        Some(sampled) => {
            let traces = sampled.traces[body].iter();
            traces.map(|of| (&of.report, (of.number, of.y))).collect()
        }
        None => vec![(&case.flanks[body], (None, None))],
    }
}

/// Whether this is the trace of a flank, of which spikes may have been replaced.
fn is_trace_of(report: &FlankReport, trace: &Profile) -> bool {
    report.trace.as_ref().is_some_and(|own| {
        let both = own.heights().iter().zip(trace.heights());
        let equal = both.filter(|(a, b)| a == b).count();
        own.len() == trace.len() && own.spacing() == trace.spacing() && 2 * equal > own.len()
    })
}

/// The flank that has the trace before the test, with its place there.
fn on_flank<'a>(
    case: &LoadedCase,
    pair: &'a TracePair,
    found: &'a Relocation,
    stated: Option<WornFlank>,
) -> Result<OnFlank<'a>, Fault> {
    let [name, after] = &pair.names;
    let trace = &pair.traces[0];
    let of = |flank| {
        let mut known = reports(case, flank).into_iter();
        known.find(|(report, _)| is_trace_of(report, trace))
    };
    let known = WornFlank::BOTH.map(of);
    let refused = |why: &str, help: &'static str| {
        let message = format!("{name}, {after}: {why}");
        Err(Fault::new(Code::E205, message).helping(help))
    };
    let flank = match (stated, known) {
        (Some(flank), [None, None]) => flank,
        (Some(flank), known) if known[flank as usize].is_some() => flank,
        (Some(_), _) => {
            return refused(
                "the case has the first trace on the other flank",
                "Leave flank out, or correct the case.",
            );
        }
        (None, [Some(_), None]) => WornFlank::Pinion,
        (None, [None, Some(_)]) => WornFlank::Wheel,
        (None, [Some(_), Some(_)]) => {
            return refused(
                "the case has the first trace on both flanks",
                "State flank, pinion or wheel: the one that the test changed.",
            );
        }
        (None, [None, None]) => {
            return refused(
                "the case has the first trace on neither flank",
                "Name the traces before the test in the case, or state flank, pinion or wheel.",
            );
        }
    };
    let known = known[flank as usize];
    Ok(OnFlank {
        flank,
        pair,
        found,
        site: known.map_or((None, None), |(_, site)| site),
        place: known.and_then(|(report, _)| place_of(case, flank, report)),
    })
}

/// Arc of the first point of a trace as it was measured \[m\], and its growth along the trace.
fn place_of(case: &LoadedCase, flank: WornFlank, report: &FlankReport) -> Option<[f64; 2]> {
    let gears = &case.case.gears;
    let trace = report.trace.as_ref()?;
    let [first, _] = report.roll_lengths?;
    let base = gears.base_radius[flank as usize].si().abs();
    let direction = gears.arc_direction(flank.gear());
    let growth = if report.mirrored {
        -direction
    } else {
        direction
    };
    let dropped = report.preparation.as_ref()?.dropped_each_end;
    let index = if report.mirrored {
        trace.len() - 1 - dropped
    } else {
        dropped
    };
    let arc = first.si() * first.si() / (2.0 * base);
    Some([arc - growth * trace.spacing().si() * index as f64, growth])
}

impl OnFlank<'_> {
    /// Arcs of the ends of the common length \[m\].
    fn arcs(&self) -> Option<[f64; 2]> {
        let [first, growth] = self.place?;
        let start = self.found.start.si();
        let ends = [start, start + self.found.before.length().si()].map(|x| first + growth * x);
        Some([ends[0].min(ends[1]), ends[0].max(ends[1])])
    }

    /// The trace over the common length under its name in memory.
    fn input(&self, name: PathBuf, case: &LoadedCase, dx: Length) -> TraceInput {
        let gears = &case.case.gears;
        let base = gears.base_radius[self.flank as usize].si().abs();
        let first = (self.found.start.si() / dx.si()).ceil() * dx.si();
        let at = self.place.map(|[arc, growth]| FlankPlaceInput {
            roll_length: Some(Length::from_si(
                (2.0 * base * (arc + growth * first).max(0.0)).sqrt(),
            )),
            ..FlankPlaceInput::default()
        });
        let from = self.place.map(|[_, growth]| {
            if growth == gears.arc_towards_tip(self.flank.gear()) {
                TraceStart::Root
            } else {
                TraceStart::Tip
            }
        });
        let (tooth, y) = self.site;
        TraceInput {
            file: name,
            tooth,
            y,
            from,
            at,
            ..TraceInput::default()
        }
    }
}

/// The case with the traces of the pairs over their common lengths, before the test or after it.
fn with_traces(
    case: &LoadedCase,
    pairs: &[OnFlank<'_>],
    measured: &[[Profile; 2]],
    after: usize,
) -> Result<LoadedCase, Error> {
    let mut held: Vec<(PathBuf, Profile)> = Vec::new();
    let mut traces: [Vec<TraceInput>; 2] = Default::default();
    for (k, (on, both)) in pairs.iter().zip(measured).enumerate() {
        let name = format!("{} (pair {}, common length)", on.pair.names[after], k + 1);
        let trace = &both[after];
        let input = on.input(name.clone().into(), case, trace.spacing());
        traces[on.flank as usize].push(input);
        held.push((name.into(), trace.clone()));
    }
    let torque = case.case.torque;
    case.holding(&held).with(|input| {
        for (flank, traces) in WornFlank::BOTH.into_iter().zip(traces) {
            if !traces.is_empty() {
                input.surface.put_measured(flank.gear(), torque, traces);
            }
        }
    })
}

/// Least concordance of the heights of the `changed` flanks.
fn concordance_of(
    cases: [&LoadedCase; 2],
    changed: impl Iterator<Item = WornFlank>,
) -> Result<f64, Fault> {
    let mut least = 1.0_f64;
    for flank in changed {
        let [before, after] = cases.map(|case| heights_about_means(case, flank));
        least = least.min(concordance(&before?, &after?));
    }
    Ok(least)
}

/// Heights of the prepared traces of a flank, each about its mean \[m\].
fn heights_about_means(case: &LoadedCase, flank: WornFlank) -> Result<Vec<f64>, Fault> {
    let mut all = Vec::new();
    for met in case.surfaces.each() {
        let heights = met.traces().map_err(Fault::from)?[flank as usize].heights();
        let middle = mean(heights.iter().copied());
        all.extend(heights.iter().map(|z| z - middle));
    }
    Ok(all)
}

/// Concordance of heights before and after a test, each about its mean: 1 of equal heights, and less where they are in proportion,
/// which a correlation does not see. Source: Lin 1989.
///
/// ```text
/// ρ_c = 1 − Σ (b_i − a_i)²/(Σ b_i² + Σ a_i²)                                          [Concordance-1]
/// ```
///
/// b, a: heights before and after \[m\]. 0 of traces of other lengths.
fn concordance(before: &[f64], after: &[f64]) -> f64 {
    cite!("Concordance-1");
    let square = |values: &[f64]| values.iter().map(|z| z * z).sum::<f64>();
    let change: Vec<f64> = before.iter().zip(after).map(|(a, b)| a - b).collect();
    match square(before) + square(after) {
        both if both > 0.0 && before.len() == after.len() => 1.0 - square(&change) / both,
        both if both > 0.0 => 0.0,
        _ => 1.0,
    }
}

/// Rq and Rpk of the prepared traces of a flank, as running-in has them \[µm\].
fn heights_of(case: &LoadedCase, flank: WornFlank) -> Result<[f64; 2], Fault> {
    let of = |met: &Surfaces| -> Result<[f64; 2], Fault> {
        let heights = met.traces().map_err(Fault::from)?[flank as usize].heights();
        let rq = section_heights(heights)?.rq;
        let rpk = rk_parameters(heights)?.rpk;
        Ok([rq, rpk].map(|length| MICRO * length.si()))
    };
    let each = case
        .surfaces
        .each()
        .map(of)
        .collect::<Result<Vec<_>, Fault>>()?;
    Ok([0, 1].map(|k| mean(each.iter().map(|one| one[k]))))
}

/// Change of a flank by the test; `None` without pairs on it.
fn flank_change(
    mesh: &Mesh,
    flank: WornFlank,
    engagements: Option<f64>,
    pairs: &[OnFlank<'_>],
    states: [&LoadedCase; 2],
    run_in: Option<&MeshOutcome>,
) -> Result<Option<FlankChange>, Fault> {
    let own: Vec<&OnFlank<'_>> = pairs.iter().filter(|on| on.flank == flank).collect();
    if own.is_empty() {
        return Ok(None);
    }
    let case = &states[0].case;
    let gears = &case.gears;
    let severity = Severity::new(mesh, gears, flank.gear());
    let places: Vec<Vec<AtPlace>> = own
        .iter()
        .map(|on| severity.at_places(on.arcs(), on.found.before.length().si()))
        .collect();
    let sliding = |k: usize| MICRO * mean(places.iter().map(|of_pair| of_pair[k].sliding));
    let sliding: Vec<f64> = (0..places[0].len()).map(sliding).collect();
    let sliding_um = asperity::uncertainty::median_with_ends(&sliding);
    let removed: Vec<Estimate> = own
        .iter()
        .map(|on| on.found.removed.map(Length::si))
        .collect();
    let of_gear = engagements.map(|count| {
        let teeth = gears.teeth.map(f64::from);
        count * teeth[0] / teeth[flank as usize]
    });
    let wear = of_gear.map(|count| coefficient(&removed, &places, count));
    let wear = wear.transpose()?;
    let (found, most) = match wear {
        Some(WearCoefficient::Found(k)) => (Some(k.map(|k| MM3_PER_N_M * k)), None),
        Some(WearCoefficient::AtMost(k)) => (None, Some(MM3_PER_N_M * k)),
        Some(WearCoefficient::Gained) | None => (None, None),
    };
    let hardness = case.flow_pressure[flank as usize].si();
    let times_hardness = |k: f64| k / MM3_PER_N_M * hardness;
    let [before, after] = states.map(|case| heights_of(case, flank));
    let (before, after) = (before?, after?);
    let predicted = run_in.and_then(|run| {
        let run_in = &run.result.run_in.as_ref()?.run_in;
        Some([run_in.rq_um, run_in.rpk_um].map(|both| both[flank as usize]))
    });
    let of = |end: fn(&Estimate) -> f64| MICRO * 1e3 * mean(removed.iter().map(end));
    Ok(Some(FlankChange {
        flank,
        pairs: own.len(),
        is_placed: own.iter().all(|on| on.place.is_some()),
        removed_nm: Estimate::new(of(|one| one.value), [of(|one| one.low), of(|one| one.high)]),
        sliding_um,
        engagements: of_gear,
        sliding_m: of_gear.map(|count| count * sliding_um.value / MICRO),
        k_mm3_per_n_m: found,
        k_at_most_mm3_per_n_m: most,
        k_times_hardness: found
            .map(|k| times_hardness(k.value))
            .or(most.map(times_hardness)),
        before_rq_um: before[0],
        after_rq_um: after[0],
        run_in_rq_um: predicted.map(|of| of[0]),
        before_rpk_um: before[1],
        after_rpk_um: after[1],
        run_in_rpk_um: predicted.map(|of| of[1]),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_in_proportion_are_less_than_concordant() {
        let before = [0.3, -0.1, -0.4, 0.2];
        let of = |scale: f64| concordance(&before, &before.map(|z| scale * z));
        for (scale, expected) in [(1.0, 1.0), (0.1, 0.2 / 1.01), (0.0, 0.0), (-1.0, -1.0)] {
            assert!((of(scale) - expected).abs() < 1e-15, "{scale}");
        }
        assert!(concordance(&before, &before[1..]) == 0.0);
    }
}
