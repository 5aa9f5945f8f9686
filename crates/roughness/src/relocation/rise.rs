//! Rise of the valleys that were matched, by the height lost near them.

use asperity_core::quantity::Length;
use asperity_core::{Profile, cite};

use super::fit::RelocationFit;
use crate::error::RoughnessError;
use crate::gaussian_filter::{Ends, mean_line};

/// Material moves by about a grain, to either side \[m\].
pub(super) const MOVED: f64 = 20e-6;

/// Mean square of the rise of the matched valleys: the square of its mean and its variance \[m²\].
///
/// ```text
/// min over c, h, t of Σ_valleys w (z_b − z_a − h − t x + c m)²,   rise = c ⟨m⟩                   [Relocation-7]
/// ```
///
/// m is the height lost above the valleys, as a Gaussian mean that reaches as far as material moves. Where valleys near a loss are
/// higher than valleys far from it, material moved, and the mean valley rose.
pub(super) fn square(fit: &RelocationFit, spacing: Length) -> Result<f64, RoughnessError> {
    cite!("Relocation-7");
    let level = fit.highest_valley();
    let above = fit.lost.iter().zip(&fit.level);
    let above = above.map(|(lost, z)| if *z > level { *lost } else { 0.0 });
    let reach = Length::from_si((2.0 * MOVED).max(2.0 * spacing.si()));
    let near = mean_line(&Profile::new(spacing, above.collect())?, reach, Ends::Reg0)?;
    let sum = |of: &dyn Fn(usize) -> f64| -> f64 {
        let each = fit.weights.iter().enumerate();
        each.map(|(i, weight)| weight * of(i)).sum()
    };
    let all = sum(&|_| 1.0);
    let [place, mean] = [&fit.along, &near].map(|values| sum(&|i| values[i]) / all);
    let along = |i: usize| fit.along[i] - place;
    let tilt = sum(&|i| along(i) * (near[i] - mean)) / sum(&|i| along(i).powi(2));
    let apart = |i: usize| near[i] - mean - tilt * along(i);
    let square = sum(&|i| apart(i).powi(2));
    if square <= 0.0 {
        return Ok(0.0);
    }
    let part = |i: usize| -fit.weights[i] * apart(i) / square;
    let a: Vec<f64> = (0..fit.lost.len()).map(part).collect();
    let share: f64 = a.iter().zip(&fit.lost).map(|(a, lost)| a * lost).sum();
    let rise = (share * mean).max(0.0);
    Ok(rise.powi(2) + fit.noise.variance(&a) * mean.powi(2))
}
