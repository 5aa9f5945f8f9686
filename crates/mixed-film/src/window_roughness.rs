//! Roughness of a window as the inlet of its contact leaves it: how high it is, and where the film's pressure ripples.

use asperity_core::cite;
use asperity_core::quantity::{Length, Pressure};
use asperity_ehl_regime::Attenuation;
use serde::{Deserialize, Serialize};

/// Parts of equal length into which a window is sorted by the pressure that flattens it.
const PARTS: usize = 24;
/// Places of a window that are sorted at least, at even distances: twelve a part.
const PLACES: usize = 12 * PARTS;

/// Distance of the places of a window that are sorted.
const fn stride(points: usize) -> usize {
    match points / PLACES {
        0 => 1,
        stride => stride,
    }
}

/// Heights that count in the gap that the inlet of rough flanks supplies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum GapRoughness {
    /// Heights above the mean line: across the ridges the narrow places decide the flow.
    #[default]
    Peaks,
    /// All heights.
    Rms,
}

/// Pressure at which the film between rough flanks shears.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum FilmPressure {
    /// The pressure of the film's share of the load, higher where it flattens peaks and lower in valleys.
    #[default]
    Rippled,
    /// The pressure of the film's share of the load.
    Own,
    /// The Hertz pressure of the whole load.
    Hertz,
}

/// Flattening of the roughness by the inlet of a contact, with the choices for its windows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flattening {
    /// Flattening of the waves.
    pub attenuation: Attenuation,
    /// Weight of the heights above the mean line in σ_d².
    pub peak_weight: f64,
    /// Reduced modulus of the contact, if its film ripples.
    pub ripple_modulus: Option<Pressure>,
}

impl From<Attenuation> for Flattening {
    /// σ_d of all heights, and no ripple.
    fn from(attenuation: Attenuation) -> Self {
        Self {
            attenuation,
            peak_weight: 0.0,
            ripple_modulus: None,
        }
    }
}

/// A part of a window: its place in the roughness, with the pressure that flattens it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RipplePart {
    /// Share of the length.
    pub length: f64,
    /// Pressure p′ that flattens the roughness, over its mean \[Pa\].
    pub pressure: f64,
    /// Height in the contact over the mean line \[m\].
    pub height: f64,
}

/// Roughness of a window in the contact.
#[derive(Debug, Clone, PartialEq)]
pub struct WindowRoughness {
    /// σ_d
    pub deviation: Length,
    /// Parts from the lowest pressure to the highest; none where the film does not ripple.
    pub ripple: Vec<RipplePart>,
}

impl WindowRoughness {
    /// A window whose film does not ripple.
    #[must_use]
    pub const fn even(deviation: Length) -> Self {
        Self {
            deviation,
            ripple: Vec::new(),
        }
    }

    /// Whether pressure flattens it anywhere.
    pub(crate) fn is_rippled(&self) -> bool {
        self.ripple.iter().any(|part| part.pressure != 0.0)
    }

    /// The window of the sums of two flattened heights \[m\], and of the pressures \[Pa\] that flatten them.
    pub(crate) fn of(heights: &[f64], pressures: Option<&[f64]>, peak_weight: f64) -> Self {
        Self {
            deviation: deviation(heights, peak_weight),
            ripple: pressures.map_or_else(Vec::new, |pressures| ripple(heights, pressures)),
        }
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// σ_d of heights of which those above the mean line have the weight `weight`.
///
/// ```text
/// σ_d² = (w/n) Σ 2 max(y − ȳ, 0)² + ((1 − w)/n) Σ (y − ȳ)²                        [Gap-roughness]
/// ```
///
/// Across ridges the flow is the mean of h⁻³, in which what lies below the mean line hardly counts. Both sums are the same for
/// heights that are distributed evenly about their mean. w is 1 up to a lay of 1/3, 0 at 1, and between them linear in
/// the lay factor t.
fn deviation(heights: &[f64], weight: f64) -> Length {
    cite!("Gap-roughness");
    let n = heights.len() as f64;
    if weight == 0.0 {
        let (mut sum, mut squares) = (0.0, 0.0);
        for z in heights {
            sum += z;
            squares += z * z;
        }
        let mean = sum / n;
        return Length::from_si((squares / n - mean * mean).max(0.0).sqrt());
    }
    let line = mean(heights);
    let square = |z: &f64| {
        let y = z - line;
        let above = y.max(0.0);
        weight * 2.0 * above * above + (1.0 - weight) * y * y
    };
    Length::from_si((heights.iter().map(square).sum::<f64>() / n).sqrt())
}

/// Derivative of σ_d over each of `heights`; zero where σ_d is.
///
/// ```text
/// ∂σ_d/∂y_i = (w (2 max(y_i − ȳ, 0) − (2/n) Σ max(y − ȳ, 0)) + (1 − w)(y_i − ȳ))/(n σ_d)         [Rms-gradient]
/// ```
pub(crate) fn deviation_gradient(heights: &[f64], weight: f64) -> Vec<f64> {
    cite!("Rms-gradient");
    let n = heights.len() as f64;
    let deviation = deviation(heights, weight).si();
    if deviation == 0.0 {
        return vec![0.0; heights.len()];
    }
    let line = mean(heights);
    let peaks = heights.iter().map(|z| (z - line).max(0.0)).sum::<f64>() / n;
    let of = |z: &f64| {
        let y = z - line;
        let of_peaks = 2.0 * (y.max(0.0) - peaks);
        (weight * of_peaks + (1.0 - weight) * y) / (n * deviation)
    };
    heights.iter().map(of).collect()
}

/// Derivatives over pressure and height at each point, from those over the parts, which are means over their points without the mean
/// of the window.
pub(crate) fn part_gradient(pressures: &[f64], by_parts: &[[f64; 2]]) -> [Vec<f64>; 2] {
    let mut order: Vec<usize> = (0..pressures.len())
        .step_by(stride(pressures.len()))
        .collect();
    let n = order.len();
    order.sort_unstable_by(|&i, &j| pressures[i].total_cmp(&pressures[j]));
    let filled = (0..PARTS).map(|k| &order[k * n / PARTS..(k + 1) * n / PARTS]);
    let filled = filled.filter(|points| !points.is_empty());
    let total = [0, 1].map(|of: usize| by_parts.iter().map(|by| by[of]).sum::<f64>() / n as f64);
    let mut gradient = [0, 1].map(|_| vec![0.0; pressures.len()]);
    for &point in &order {
        for (of, mean) in gradient.iter_mut().zip(total) {
            of[point] -= mean;
        }
    }
    for (points, by_part) in filled.zip(by_parts) {
        for &point in points {
            for (of, by) in gradient.iter_mut().zip(by_part) {
                of[point] += by / points.len() as f64;
            }
        }
    }
    gradient
}

/// The parts of a window, sorted by pressure.
fn ripple(heights: &[f64], pressures: &[f64]) -> Vec<RipplePart> {
    let mut places: Vec<[f64; 2]> = (pressures.iter().zip(heights))
        .step_by(stride(heights.len()))
        .map(|(p, z)| [*p, *z])
        .collect();
    let n = places.len();
    let means = [0, 1].map(|of: usize| places.iter().map(|at| at[of]).sum::<f64>() / n as f64);
    places.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
    let part = |k: usize| {
        let of_part = &places[k * n / PARTS..(k + 1) * n / PARTS];
        let count = of_part.len() as f64;
        let sum = |i: usize| of_part.iter().map(|place| place[i]).sum::<f64>();
        RipplePart {
            length: count / n as f64,
            pressure: sum(0) / count - means[0],
            height: sum(1) / count - means[1],
        }
    };
    (0..PARTS)
        .map(part)
        .filter(|part| part.length > 0.0)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(points: usize) -> Vec<f64> {
        let turn = std::f64::consts::TAU / points as f64;
        (0..points)
            .map(|i| (turn * (i as f64 + 0.5)).sin())
            .collect()
    }

    #[test]
    fn peaks_of_even_heights_have_their_standard_deviation() {
        let heights = wave(1000);
        for weight in [0.0, 0.3, 1.0] {
            let found = deviation(&heights, weight).si();
            assert!((found - 0.5_f64.sqrt()).abs() < 1e-12, "{weight}: {found}");
        }
        // A plateau with one deep valley in ten: nine tenths a tenth above the mean line, a tenth nine tenths below it.
        let plateau: Vec<f64> = (0..1000).map(|i| f64::from(u8::from(i >= 100))).collect();
        let found = deviation(&plateau, 1.0).si();
        assert!(
            (found - (2.0_f64 * 0.9 * 0.01).sqrt()).abs() < 1e-12,
            "{found}"
        );
        let rms = deviation(&plateau, 0.0).si();
        assert!((rms - 0.3).abs() < 1e-12, "{rms}");
    }

    #[test]
    fn the_gradient_of_the_peaks_is_their_central_difference() {
        let heights: Vec<f64> = wave(40).iter().map(|z| z + 0.4 * z * z).collect();
        for weight in [0.0, 0.4, 1.0] {
            let gradient = deviation_gradient(&heights, weight);
            for i in 0..heights.len() {
                let at = |step: f64| {
                    let mut moved = heights.clone();
                    moved[i] += step;
                    deviation(&moved, weight).si()
                };
                let quotient = (at(1e-6) - at(-1e-6)) / 2e-6;
                assert!((gradient[i] - quotient).abs() < 1e-9, "{weight} {i}");
            }
        }
    }

    #[test]
    fn parts_of_a_window_keep_its_means_and_the_order_of_their_pressures() {
        let heights = wave(1003);
        let pressures: Vec<f64> = heights.iter().map(|z| 3.0 * z + 7.0).collect();
        let parts = ripple(&heights, &pressures);
        assert_eq!(parts.len(), PARTS);
        let total = |of: &dyn Fn(&RipplePart) -> f64| parts.iter().map(of).sum::<f64>();
        assert!((total(&|part| part.length) - 1.0).abs() < 1e-12);
        assert!(total(&|part| part.length * part.pressure).abs() < 1e-12);
        assert!(total(&|part| part.length * part.height).abs() < 1e-12);
        for pair in parts.windows(2) {
            assert!(pair[0].pressure < pair[1].pressure);
        }
        // The pressure follows the height.
        for part in &parts {
            assert!((part.pressure - 3.0 * part.height).abs() < 1e-12);
        }
        assert_eq!(ripple(&heights[..5], &pressures[..5]).len(), 5);
    }
}
