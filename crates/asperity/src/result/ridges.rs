//! The ridges of both flanks that cost most.

use asperity_core::Profile;
pub use asperity_mixed_film::Kinks;
use serde::{Deserialize, Serialize};

/// Cells of a whole trace.
const CELLS: usize = 350;
/// Cells of a close-up of a ridge: about 1.5 µm each.
const NEAR_CELLS: usize = 60;

/// The ridges of both flanks that cost most.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Ridges {
    /// Title of the case.
    pub title: String,
    /// Operating point, and numbers of positions and offsets, in words.
    pub conditions: String,
    /// Loss of the mesh with every constant at its median \[W\].
    pub loss_at_medians_w: f64,
    /// The same with the listed ridges pressed to the mean line, by a run \[W\].
    pub pressed_at_medians_w: f64,
    /// 5 % and 95 % quantiles of the change, by the sampling of the flanks.
    pub sampling_quantiles_w: Option<[f64; 2]>,
    /// 5 % and 95 % quantiles of the saving, by the uncertainty of the constants and of the model and by the sampling of the
    /// flanks; `None` if the model has no uncertainty.
    pub saving_quantiles_w: Option<[f64; 2]>,
    /// d(loss)/d ln(height) of both flanks: the sum over the octaves \[W\].
    pub by_log_height_w: f64,
    /// Change of the loss with the equilibrium bulk temperature over its change at a held one; 1 with a stated temperature.
    pub heat_balance: f64,
    /// Sliding loss where the traces do not resolve the contact, which is left out of the gradient \[W\].
    pub unresolved_w: f64,
    /// Whether the case states losses of a gearbox, which are left out.
    pub without_gearbox: bool,
    /// Number of pairs of teeth of a case with several traces for each flank: all numbers are of its first pair.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first_of_pairs: Option<usize>,
    /// Windows at or next to a kink of the loss.
    pub kinks: Kinks,
    /// The costliest ridges, the costliest first.
    pub rows: Vec<RidgeRow>,
    /// Loss by octave of wavelength, shortest first.
    pub octaves: Vec<OctaveRow>,
    /// Loss along both whole traces.
    pub along: [WattsStrip; 2],
    /// Loss along the traces about the costliest ridges, in the order of their rows.
    pub near: Vec<WattsStrip>,
}

/// A part of a trace above its mean line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RidgeRow {
    /// Flank: pinion or wheel.
    pub flank: String,
    /// Place of its highest point from the first point of the prepared trace, as it is in the mesh: mirrored where the case says so \[mm\].
    pub place_mm: f64,
    /// Width at the mean line \[µm\].
    pub width_um: f64,
    /// Height above the mean line \[µm\].
    pub height_um: f64,
    /// Saving by pressing it to the mean line, according to the gradient before \[W\].
    pub first_order_w: f64,
    /// Saving by taking the same heights off the measured trace, whose filters then move the mean line too, according to the
    /// gradient before; `None` if the preparation is not linear \[W\].
    pub measured_first_order_w: Option<f64>,
    /// Saving by pressing it together with all other listed ridges, according to the mean of the gradients before, half-way
    /// and after ([`mean_along`](crate::pipeline::mean_along)) \[W\].
    pub mean_gradient_w: f64,
    /// 5 % quantile of it by the uncertainty of the constants and of the model and by the sampling of the flanks \[W\].
    pub low_w: Option<f64>,
    /// 95 % quantile of it by the same \[W\].
    pub high_w: Option<f64>,
    /// First of its points in the prepared trace, counted from 0; of a mirrored trace from its last point.
    pub first_point: usize,
    /// Last of its points.
    pub last_point: usize,
}

/// Loss by wavelength: how it changes with the logarithm of the heights of these waves.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
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
pub struct FlankWatts {
    /// The trace.
    pub trace: Profile,
    /// d(loss)/d(height) at each point \[W/m\].
    pub by_height: Vec<f64>,
}

/// Loss along a part of a trace, in cells of equal length.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WattsStrip {
    /// Begin of the first cell \[mm\].
    pub begin_mm: f64,
    /// Length of a cell \[mm\].
    pub cell_mm: f64,
    /// Lowest and highest height of each cell with the mean line included \[µm\], and mean of
    /// [`FlankWatts::watts_per_length`] \[W/mm\].
    pub cells: Vec<[f64; 3]>,
}

/// Height of the mean line of a trace, from which the heights of its ridges count \[m\].
#[must_use]
pub fn height_of_mean_line(trace: &Profile) -> f64 {
    trace.heights().iter().sum::<f64>() / trace.len() as f64
}

impl FlankWatts {
    /// Height above the mean line times gradient, per length of the trace, at each point \[W/m\]: its integral over a ridge is
    /// [`RidgeRow::first_order_w`].
    #[must_use]
    pub fn watts_per_length(&self) -> Vec<f64> {
        let (line, dx) = (height_of_mean_line(&self.trace), self.trace.spacing().si());
        let both = self.trace.heights().iter().zip(&self.by_height);
        both.map(|(z, by_height)| (z - line) * by_height / dx)
            .collect()
    }

    /// Loss along the whole trace.
    #[must_use]
    pub fn along(&self) -> WattsStrip {
        self.strip([0, self.trace.len() - 1], CELLS)
    }

    /// Loss along the trace about a ridge, to its width on both sides.
    #[must_use]
    pub fn near(&self, row: &RidgeRow) -> WattsStrip {
        let wide = row.last_point + 1 - row.first_point;
        let last = (row.last_point + wide).min(self.trace.len() - 1);
        self.strip([row.first_point.saturating_sub(wide), last], NEAR_CELLS)
    }

    /// The points `first..=last` in at most `cells` cells, heights rounded to 1 nm and watts to three digits.
    fn strip(&self, [first, last]: [usize; 2], cells: usize) -> WattsStrip {
        let (line, dx) = (height_of_mean_line(&self.trace), self.trace.spacing().si());
        let points = (last + 1 - first).div_ceil(cells);
        let heights = self.trace.heights()[first..=last].chunks(points);
        let watts = self.watts_per_length();
        let cell = |(heights, watts): (&[f64], &[f64])| {
            let low = heights.iter().fold(line, |low, z| low.min(*z));
            let high = heights.iter().fold(line, |high, z| high.max(*z));
            let [low, high] = [low, high].map(|z| (1e9 * z).round() / 1e3);
            let mean = 1e-3 * watts.iter().sum::<f64>() / watts.len() as f64;
            [low, high, format!("{mean:.2e}").parse().unwrap_or(mean)]
        };
        WattsStrip {
            begin_mm: 1e3 * dx * first as f64,
            cell_mm: 1e3 * dx * points as f64,
            cells: heights
                .zip(watts[first..=last].chunks(points))
                .map(cell)
                .collect(),
        }
    }
}
