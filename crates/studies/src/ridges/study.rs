//! Computation of a study of ridges.

use asperity::case::LoadedCase;
use asperity::core::cancel::checkpoint;
use asperity::flanks::Texture;
use asperity::pipeline::{LossGradient, Progress, gradient};
use asperity::uncertainty::sampling_interval;
use asperity::{Error, PositionError};
use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::gaussian_filter::{Ends, mean_line};
use serde::Serialize;

/// Ridges listed and pressed.
const DEAREST: usize = 20;
/// Shortest cut-off between two octaves \[m\].
const SHORTEST: f64 = 2.5e-6;
/// Runs of a study: the gradient before and after pressing, each with its losses.
const RUNS: usize = 2;

/// The ridges of both flanks that cost most.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Ridges {
    /// Title of the case.
    pub title: String,
    /// Loss of the mesh \[W\].
    pub loss_w: f64,
    /// Loss with the listed ridges pressed to the mean line, by a run \[W\].
    pub pressed_loss_w: f64,
    /// 5 % and 95 % quantiles of the change, by the sampling of the flanks.
    pub sampling_quantiles_w: Option<[f64; 2]>,
    /// d(loss)/d ln(height) of both flanks: the sum over the octaves \[W\].
    pub by_log_height_w: f64,
    /// Change of the loss with the equilibrium bulk temperature over its change at a held one; 1 with a stated temperature.
    pub heat_balance: f64,
    /// Sliding loss where the traces do not resolve the contact, which is left out of the gradient \[W\].
    pub unresolved_w: f64,
    /// The dearest ridges, the dearest first.
    pub rows: Vec<RidgeRow>,
    /// Loss by octave of wavelength, shortest first.
    pub octaves: Vec<OctaveRow>,
    /// Both traces with the gradient.
    #[serde(skip)]
    pub flanks: [FlankWatts; 2],
}

/// A part of a trace above its mean line.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RidgeRow {
    /// Flank: pinion or wheel.
    pub flank: &'static str,
    /// Place of its highest point from the first point of the prepared trace \[mm\].
    pub place_mm: f64,
    /// Width at the mean line \[µm\].
    pub width_um: f64,
    /// Height above the mean line \[µm\].
    pub height_um: f64,
    /// Saving by pressing it to the mean line, according to the gradient before \[W\].
    pub first_order_w: f64,
    /// Saving by pressing it together with all other listed ridges, according to the mean of the gradients before and
    /// after \[W\].
    pub mean_gradient_w: f64,
    /// 5 % quantile of it by the sampling of the flanks \[W\].
    pub low_w: Option<f64>,
    /// 95 % quantile of it by the sampling of the flanks \[W\].
    pub high_w: Option<f64>,
    /// First and last point.
    #[serde(skip)]
    pub(super) points: [usize; 2],
}

/// Loss by wavelength: how it changes with the logarithm of the heights of these waves.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct OctaveRow {
    /// Shortest wavelength \[µm\]; 0 of the first octave, which includes all shorter ones.
    pub from_um: f64,
    /// Longest wavelength \[µm\]; `None` of the last octave, which includes all longer ones.
    pub to_um: Option<f64>,
    /// d(loss)/d ln(height) of these waves of the pinion \[W\].
    pub pinion_w: f64,
    /// d(loss)/d ln(height) of these waves of the wheel \[W\].
    pub wheel_w: f64,
}

/// A prepared trace with the gradient of the loss.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct FlankWatts {
    /// The trace.
    pub trace: Profile,
    /// d(loss)/d(height) at each point \[W/m\].
    pub by_height: Vec<f64>,
}

/// Computes the dearest ridges of `case`; `progress` is called with the number of completed runs.
///
/// # Errors
/// As [`gradient`].
pub fn ridges(case: &LoadedCase, progress: Progress<'_>) -> Result<Ridges, Error> {
    let mut mesh = case.clone();
    mesh.case.gearbox = None;
    let before = gradient(&mesh)?;
    progress(1, RUNS);
    checkpoint()?;
    let traces = traces(&mesh)?;
    let mut rows = dearest(&traces, &before);
    let pressed = pressed(&traces, &rows);
    let mut changed = before.case.clone();
    changed.surfaces = changed.surfaces.with_traces(pressed.clone());
    let after = gradient(&changed)?;
    progress(RUNS, RUNS);
    for row in &mut rows {
        let body = usize::from(row.flank == FLANKS[1]);
        let fall = |i: usize| traces[body].heights()[i] - pressed[body].heights()[i];
        let saving = |gradients: [&[Vec<f64>; 2]; 2]| {
            let mean = |i: usize| 0.5 * (gradients[0][body][i] + gradients[1][body][i]);
            let points = row.points[0]..=row.points[1];
            points.map(|i| mean(i) * fall(i)).sum::<f64>()
        };
        let offsets = before.by_offset.iter().zip(&after.by_offset);
        let by_window: Vec<f64> = offsets.map(|(a, b)| saving([a, b])).collect();
        let quantiles = sampling_interval(&before.case, &before.losses, &by_window);
        row.mean_gradient_w = saving([&before.by_height, &after.by_height]);
        [row.low_w, row.high_w] = [0, 1].map(|k: usize| quantiles.map(|both| both[k]));
    }
    let pairs = before.losses.offsets.iter().zip(&after.losses.offsets);
    let by_window: Vec<f64> = pairs.map(|(a, b)| b.loss_w - a.loss_w).collect();
    let octaves = octaves(&traces, &before)?;
    let flanks = [0, 1].map(|body: usize| FlankWatts {
        trace: traces[body].clone(),
        by_height: before.by_height[body].clone(),
    });
    Ok(Ridges {
        title: case.case.title.clone(),
        loss_w: before.losses.summary.loss_w,
        pressed_loss_w: after.losses.summary.loss_w,
        sampling_quantiles_w: sampling_interval(&before.case, &before.losses, &by_window),
        by_log_height_w: octaves
            .iter()
            .map(|octave| octave.pinion_w + octave.wheel_w)
            .sum(),
        heat_balance: before.heat_balance,
        unresolved_w: before.unresolved_w,
        rows,
        octaves,
        flanks,
    })
}

/// Names of the flanks.
pub(super) const FLANKS: [&str; 2] = ["pinion", "wheel"];

fn traces(case: &LoadedCase) -> Result<[Profile; 2], Error> {
    match case.surfaces.textures() {
        [Texture::Trace(pinion), Texture::Trace(wheel)] => Ok([pinion.clone(), wheel.clone()]),
        _ => Err(Box::new(PositionError::NoProfile).into()),
    }
}

fn mean(heights: &[f64]) -> f64 {
    heights.iter().sum::<f64>() / heights.len() as f64
}

/// The parts of both traces above their mean line that cost most by the gradient.
fn dearest(traces: &[Profile; 2], gradient: &LossGradient) -> Vec<RidgeRow> {
    let mut rows = Vec::new();
    for (body, trace) in traces.iter().enumerate() {
        let (z, by_height) = (trace.heights(), &gradient.by_height[body]);
        let line = mean(z);
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
                flank: FLANKS[body],
                place_mm: 1e3 * dx * highest as f64,
                width_um: 1e6 * dx * cells.len() as f64,
                height_um: 1e6 * (z[highest] - line),
                first_order_w: (first..=last).map(|i| by_height[i] * (z[i] - line)).sum(),
                mean_gradient_w: 0.0,
                low_w: None,
                high_w: None,
                points: [first, last],
            });
        }
    }
    rows.sort_by(|a, b| b.first_order_w.total_cmp(&a.first_order_w));
    rows.truncate(DEAREST);
    rows.retain(|row| row.first_order_w > 0.0);
    rows
}

/// The traces with these ridges at the mean line.
fn pressed(traces: &[Profile; 2], rows: &[RidgeRow]) -> [Profile; 2] {
    let mut heights = traces.each_ref().map(|trace| trace.heights().to_vec());
    for (body, z) in heights.iter_mut().enumerate() {
        let line = mean(traces[body].heights());
        for row in rows.iter().filter(|row| row.flank == FLANKS[body]) {
            z[row.points[0]..=row.points[1]].fill(line);
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
        let line = mean(trace.heights());
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
