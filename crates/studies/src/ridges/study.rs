//! Computation of a study of ridges.

use asperity::case::LoadedCase;
use asperity::core::cancel::checkpoint;
use asperity::flanks::Texture;
use asperity::mixed_film::TraceChange;
use asperity::pipeline::{
    LossGradient, Progress, check_gradient, gradient, gradient_with, mean_along,
};
use asperity::result::RunResult;
use asperity::result::ridges::{FlankWatts, OctaveRow, RidgeRow, Ridges, height_of_mean_line};
use asperity::uncertainty::{ChangeDraws, UncertainParameter, few_offsets_of, sampling_interval};
use asperity::{Error, PositionError, Run};
use asperity_core::quantity::Length;
use asperity_core::{Fault, Profile};
use asperity_report::tables::BODIES;
use asperity_report::{StudySettings, Watch, Work, settings};
use asperity_roughness::composite::spaced;
use asperity_roughness::gaussian_filter::{Ends, mean_line};
use serde::Serialize;

/// Ridges listed and pressed.
const COSTLIEST: usize = 20;
/// Ridges with a close-up.
const NEAR: usize = 3;
/// Shortest cut-off between two octaves \[m\].
const SHORTEST: f64 = 2.5e-6;
/// Least part of the watts of a ridge in the offsets of the lay at which they show how it depends on the lay.
const COVERED: f64 = 0.25;
/// Steps of a study: the gradients before, half-way and after pressing, the draws, and the gradients at both ends of the lay.
const STEPS: usize = 5;

/// Runs whose time a study takes: three with exact contacts, the gradient of each, draws of two, and two gradients at the ends of
/// the lay.
pub const RUNS: usize = 10;

/// The costliest ridges, with the whole traces.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RidgeStudy {
    /// The ridges.
    #[serde(flatten)]
    pub found: Ridges,
    /// Both traces with the gradient.
    #[serde(skip)]
    pub flanks: [FlankWatts; 2],
    /// Both traces as they were read, with the gradient; `None` of a trace whose preparation is not linear.
    #[serde(skip)]
    pub measured: [Option<FlankWatts>; 2],
}

/// Computes the costliest ridges of `case`, of the first pair of traces if several teeth were measured; `progress` is called with
/// the number of completed steps.
///
/// # Errors
/// As [`gradient`].
pub fn ridges(case: &LoadedCase, progress: Progress<'_>) -> Result<RidgeStudy, Error> {
    study(case, true, progress)
}

settings! {
    /// Settings of a study of ridges: none.
    pub struct RidgeSettings {}
}

impl StudySettings for RidgeSettings {
    type Input = LoadedCase;
    type Found = RidgeStudy;
    const COMMAND: &'static str = "ridges";
    const ABOUT: &'static str = "Ridges of both flanks that cost most, and the loss by wavelength";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] =
        &[&[("case", "demo/case.toml")]];
    const METHOD: &'static str = "The gradient of the loss over every height of both traces, by ridge and by octave of wavelength, and \
        a run with the twenty costliest ridges removed down to the mean line.";
    const STEPS: &'static str = "gradients";

    fn work(&self, case: &LoadedCase) -> Result<Option<Work>, Fault> {
        Ok(Some(Work::new(vec![case.clone()], RUNS)))
    }

    fn run(&self, case: LoadedCase, watch: &Watch<'_>) -> Result<RidgeStudy, Fault> {
        Ok(ridges(&case, watch.progress)?)
    }
}

/// The study, with intervals if `band` is set.
fn study(case: &LoadedCase, band: bool, progress: Progress<'_>) -> Result<RidgeStudy, Error> {
    let mesh = one_pair(case).without_gearbox();
    let before = gradient(&mesh)?;
    progress(1, STEPS);
    checkpoint()?;
    let traces = traces(&mesh)?;
    let mut rows = costliest(&traces, &before);
    let falls = falls(&traces, &rows).map_err(Box::new)?;
    let along_before = before.along(&falls)?;
    let pressed = |part: f64| {
        let flanks = before
            .case
            .surfaces
            .with_traces(pressed(&traces, &rows, part));
        let found = gradient(&before.case.with_surfaces(flanks))?;
        let along = found.along(&falls)?;
        Ok::<_, Error>((found, along))
    };
    // Only one gradient beside the first is held at a time.
    let (_, along_half) = pressed(0.5)?;
    progress(2, STEPS);
    checkpoint()?;
    let (after, along_after) = pressed(1.0)?;
    progress(3, STEPS);
    checkpoint()?;
    let cases = [&before, &after].map(|found| (&found.case, &found.contacts));
    let draws = if band { ChangeDraws::new(cases)? } else { None };
    progress(4, STEPS);
    checkpoint()?;
    let along = [along_before, along_half, along_after];
    let by_lay = match draws.as_ref().and_then(ChangeDraws::ends_of_lay) {
        Some(ends) => by_lay(&before, &along[0], ends, &traces, &rows)?,
        None => vec![[1.0; 2]; rows.len()],
    };
    progress(STEPS, STEPS);
    let base = (&before.case, &before.losses);
    let sampled = |by_window: &[f64]| {
        if band {
            sampling_interval(base.0, base.1, by_window)
        } else {
            None
        }
    };
    let quantiles = |by_window: &[f64], by_lay: [f64; 2]| match &draws {
        Some(draws) => Some(draws.quantiles(base.0, base.1, by_window, by_lay)),
        None => sampled(by_window),
    };
    let mean = mean_along(along.each_ref().map(Vec::as_slice));
    for ((row, by_lay), by_window) in rows.iter_mut().zip(by_lay).zip(mean) {
        row.mean_gradient_w = by_window.iter().sum::<f64>() / by_window.len() as f64;
        let found = quantiles(&by_window, by_lay);
        [row.low_w, row.high_w] = [0, 1].map(|k: usize| found.map(|both| both[k]));
    }
    let pairs = before.losses.offsets.iter().zip(&after.losses.offsets);
    let savings: Vec<f64> = pairs.map(|(a, b)| a.loss_w - b.loss_w).collect();
    let of_change = sampled(&savings).map(|[low, high]| [-high, -low]);
    let octaves = octaves(&traces, &before)?;
    let flanks = [0, 1].map(|body: usize| FlankWatts {
        trace: traces[body].clone(),
        by_height: before.by_height[body].clone(),
    });
    let measured = measured(&before)?;
    for row in &mut rows {
        row.measured_first_order_w = match &measured[body_of(row)] {
            Some(flank) => measured_saving(row, &traces, flank, &before)?,
            None => None,
        };
    }
    let near = rows.iter().take(NEAR);
    let near = near.map(|row| flanks[body_of(row)].near(row));
    let found = Ridges {
        title: case.case.title.clone(),
        conditions: case.case.conditions(),
        loss_at_medians_w: before.losses.summary.loss_w,
        pressed_at_medians_w: after.losses.summary.loss_w,
        sampling_quantiles_w: of_change,
        saving_quantiles_w: draws
            .as_ref()
            .map(|draws| draws.quantiles(base.0, base.1, &savings, [1.0; 2])),
        by_log_height_w: octaves
            .iter()
            .map(|octave| octave.pinion_w + octave.wheel_w)
            .sum(),
        heat_balance: before.heat_balance,
        unresolved_w: before.unresolved_w,
        without_gearbox: case.case.gearbox.is_some(),
        first_of_pairs: case.surfaces.teeth().map(|_| case.surfaces.pairs()),
        kinks: before.kinks,
        near: near.collect(),
        along: flanks.each_ref().map(FlankWatts::along),
        rows,
        octaves,
    };
    Ok(RidgeStudy {
        found,
        flanks,
        measured,
    })
}

/// Adds the costliest ridges of `case` to its `result`, or why there are none; without intervals if the result has no
/// uncertainty.
///
/// # Errors
/// As [`ridges`], except where the model has no gradient or a flank no trace.
pub fn add_ridges(
    result: &mut RunResult,
    case: &LoadedCase,
    progress: Progress<'_>,
) -> Result<(), Error> {
    match check_gradient(&one_pair(case)) {
        Ok(()) => {
            let band = result.uncertainty.is_some();
            result.ridges = Some(study(case, band, progress)?.found);
        }
        Err(error) => result.no_ridges = Some(error.to_string()),
    }
    Ok(())
}

/// The case, with several measured teeth the first pair of traces in the first zone of the face.
fn one_pair(case: &LoadedCase) -> LoadedCase {
    match case.surfaces.teeth() {
        Some(_) => case.first_pair(),
        None => case.clone(),
    }
}

fn traces(case: &LoadedCase) -> Result<[Profile; 2], Error> {
    match case.surfaces.textures() {
        [Texture::Trace(pinion), Texture::Trace(wheel)] => Ok([pinion.clone(), wheel.clone()]),
        _ => Err(Box::new(PositionError::no_profile()).into()),
    }
}

fn body_of(row: &RidgeRow) -> usize {
    usize::from(row.flank == BODIES[1])
}

/// Saving by pressing a ridge to the mean line according to a gradient \[W\].
fn saving(row: &RidgeRow, traces: &[Profile; 2], by_height: &[Vec<f64>; 2]) -> f64 {
    let body = body_of(row);
    let (z, line) = (traces[body].heights(), height_of_mean_line(&traces[body]));
    let points = row.first_point..=row.last_point;
    points.map(|i| by_height[body][i] * (z[i] - line)).sum()
}

/// The heights of each ridge above the mean line.
fn falls(traces: &[Profile; 2], rows: &[RidgeRow]) -> Result<Vec<TraceChange>, PositionError> {
    let of = |row: &RidgeRow| {
        let body = body_of(row);
        let trace = &traces[body];
        let change = TraceChange::new(body, fall(row, trace), trace.spacing());
        change.map_err(PositionError::from)
    };
    rows.iter().map(of).collect()
}

/// Heights of a ridge above the mean line at all points of its trace.
fn fall(row: &RidgeRow, trace: &Profile) -> Vec<f64> {
    let (z, line) = (trace.heights(), height_of_mean_line(trace));
    let mut fall = vec![0.0; z.len()];
    for i in row.first_point..=row.last_point {
        fall[i] = z[i] - line;
    }
    fall
}

/// Both traces as they were read, with the gradient of the loss.
fn measured(gradient: &LossGradient) -> Result<[Option<FlankWatts>; 2], Error> {
    let [pinion, wheel] = gradient.by_measured_height()?;
    let of = |body: usize, by_height: Option<Vec<f64>>| {
        let trace = gradient.case.flanks[body].trace.clone();
        let both = trace.zip(by_height);
        both.map(|(trace, by_height)| FlankWatts { trace, by_height })
    };
    Ok([of(0, pinion), of(1, wheel)])
}

/// Saving by taking the heights of a ridge above the mean line off the measured trace \[W\]; `None` if the trace was not prepared.
fn measured_saving(
    row: &RidgeRow,
    traces: &[Profile; 2],
    measured: &FlankWatts,
    gradient: &LossGradient,
) -> Result<Option<f64>, Error> {
    let body = body_of(row);
    let flank = &gradient.case.flanks[body];
    let Some(record) = &flank.preparation else {
        return Ok(None);
    };
    let fall = Profile::new(traces[body].spacing(), fall(row, &traces[body]))
        .and_then(|fall| spaced(&fall, record.spacing))
        .map_err(|error| Box::new(PositionError::from(error)))?;
    let mut by_height = measured.by_height.clone();
    if flank.mirrored {
        by_height.reverse();
    }
    let kept = by_height.iter().skip(record.dropped_each_end);
    let products = kept.zip(fall.heights()).map(|(g, fall)| g * fall);
    Ok(Some(products.sum()))
}

/// First-order watts of each ridge at both `ends` of the lay over those `before`, which are known at each offset, over the same
/// ratio of all ridges together.
fn by_lay(
    before: &LossGradient,
    along: &[Vec<f64>],
    ends: [f64; 2],
    traces: &[Profile; 2],
    rows: &[RidgeRow],
) -> Result<Vec<[f64; 2]>, Error> {
    let (case, contacts) = few_offsets_of(&before.case, &before.contacts)?;
    // A ratio of watts does not depend on the heat balance.
    let bulk = Run::new(&case).known([&contacts]).operating_case()?;
    let bulk = bulk.temperature();
    let case = case.with(|input| input.operation.set_bulk_temperature(bulk))?;
    let offsets = contacts.offsets();
    let at = |lay: f64| -> Result<Vec<f64>, Error> {
        let other = case.overridden(|over| over.set(UncertainParameter::Lay, lay))?;
        let by_height = gradient_with(&contacts, &other)?.by_height;
        let of = |row: &RidgeRow| offsets as f64 * saving(row, traces, &by_height);
        Ok(rows.iter().map(of).collect())
    };
    let ends = [at(ends[0])?, at(ends[1])?];
    let middle: Vec<f64> = along
        .iter()
        .map(|row| row[..offsets].iter().sum())
        .collect();
    let all = |watts: &[f64]| watts.iter().sum::<f64>();
    let ratio = |k: usize, end: &[f64]| {
        let whole = offsets as f64 * rows[k].first_order_w;
        if middle[k] > COVERED * whole {
            end[k] / middle[k] / (all(end) / all(&middle))
        } else {
            1.0
        }
    };
    let both = |k: usize| ends.each_ref().map(|end| ratio(k, end));
    Ok((0..rows.len()).map(both).collect())
}

/// The parts of both traces above their mean line that cost most by the gradient.
fn costliest(traces: &[Profile; 2], gradient: &LossGradient) -> Vec<RidgeRow> {
    let mut rows = Vec::new();
    for (body, trace) in traces.iter().enumerate() {
        let (z, by_height) = (trace.heights(), &gradient.by_height[body]);
        let line = height_of_mean_line(trace);
        let mut begin = 0;
        for cells in z.chunk_by(|a, b| (*a > line) == (*b > line)) {
            let [first, last] = [begin, begin + cells.len() - 1];
            begin += cells.len();
            if cells[0] <= line {
                continue;
            }
            let highest = (first..=last)
                .max_by(|i, j| z[*i].total_cmp(&z[*j]))
                .unwrap_or(first);
            let dx = trace.spacing().si();
            rows.push(RidgeRow {
                flank: BODIES[body].to_owned(),
                place_mm: 1e3 * dx * highest as f64,
                width_um: 1e6 * dx * cells.len() as f64,
                height_um: 1e6 * (z[highest] - line),
                first_order_w: (first..=last).map(|i| by_height[i] * (z[i] - line)).sum(),
                measured_first_order_w: None,
                mean_gradient_w: 0.0,
                low_w: None,
                high_w: None,
                first_point: first,
                last_point: last,
            });
        }
    }
    rows.sort_by(|a, b| b.first_order_w.total_cmp(&a.first_order_w));
    rows.truncate(COSTLIEST);
    rows.retain(|row| row.first_order_w > 0.0);
    rows
}

/// The traces with `part` of the height of these ridges above the mean line taken off.
fn pressed(traces: &[Profile; 2], rows: &[RidgeRow], part: f64) -> [Profile; 2] {
    let mut heights = traces.each_ref().map(|trace| trace.heights().to_vec());
    for (body, z) in heights.iter_mut().enumerate() {
        let line = height_of_mean_line(&traces[body]);
        for row in rows.iter().filter(|row| row.flank == BODIES[body]) {
            for z in &mut z[row.first_point..=row.last_point] {
                *z = line + (1.0 - part) * (*z - line);
            }
        }
    }
    [0, 1].map(|body: usize| {
        let z = std::mem::take(&mut heights[body]);
        Profile::new(traces[body].spacing(), z).unwrap_or_else(|_| traces[body].clone())
    })
}

/// Sum over the points of both traces of height times gradient, by octave of wavelength.
///
/// The waves of an octave are the difference of the mean lines of two Gaussian filters; the octaves add up to the trace.
fn octaves(traces: &[Profile; 2], gradient: &LossGradient) -> Result<Vec<OctaveRow>, Error> {
    let shortest_trace = traces
        .iter()
        .map(|trace| trace.length().si())
        .fold(f64::INFINITY, f64::min);
    let coarsest = traces
        .iter()
        .map(|trace| trace.spacing().si())
        .fold(SHORTEST, f64::max);
    let mut edges = vec![coarsest];
    while 2.0 * edges[edges.len() - 1] < 0.5 * shortest_trace {
        edges.push(2.0 * edges[edges.len() - 1]);
    }
    let mut watts = [Vec::new(), Vec::new()];
    for (body, trace) in traces.iter().enumerate() {
        let line = height_of_mean_line(trace);
        let mut rest: Vec<f64> = trace.heights().iter().map(|z| z - line).collect();
        let of = |wave: &[f64]| {
            let pairs = wave.iter().zip(&gradient.by_height[body]);
            pairs.map(|(z, by_height)| z * by_height).sum::<f64>()
        };
        for edge in &edges {
            let smooth = mean_line(trace, Length::from_si(*edge), Ends::Reflect)
                .map_err(|error| Box::new(PositionError::from(error)))?;
            let longer: Vec<f64> = smooth.iter().map(|z| z - line).collect();
            let wave: Vec<f64> = rest.iter().zip(&longer).map(|(a, b)| a - b).collect();
            watts[body].push(of(&wave));
            rest = longer;
        }
        watts[body].push(of(&rest));
    }
    let row = |k: usize| OctaveRow {
        from_um: k.checked_sub(1).map_or(0.0, |k| 1e6 * edges[k]),
        to_um: edges.get(k).map(|edge| 1e6 * edge),
        pinion_w: watts[0][k],
        wheel_w: watts[1][k],
    };
    Ok((0..=edges.len()).map(row).collect())
}
