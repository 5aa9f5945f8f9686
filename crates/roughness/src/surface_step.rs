//! Steps across a prepared surface: places where the heights of all lines rise or fall at once, as where two fields of an instrument
//! are joined.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | m(x) | mean of the heights over all lines | m |
//! | w | length of a side, a twelfth of the usual cut-off | m |
//! | S(x) | mean of m over the side behind x less the mean over the side before it | m |
//! | s | robust standard deviation of S: its median magnitude over the 75 % quantile of a normal distribution | m |

use asperity_core::cite;
use asperity_core::numerics::{Z_75, median};
use asperity_core::quantity::Length;

use crate::preparation::LAMBDA_C;
use crate::surface_preparation::PreparedSurface;

/// Sides in the usual cut-off.
const SIDES: f64 = 12.0;
/// |S| over s of a step: normally distributed heights of 3 mm, some 75 sides, reach it in one scan of ten thousand.
const SCATTERS: f64 = 5.0;
/// Greatest S of the other sign next to a step, over the S of the step: a groove has both.
const OTHER_SIGN: f64 = 0.5;
/// Sides within which a groove has both.
const NEXT: usize = 3;

/// A step across a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Distance from the first point of the prepared rows, or from the first row.
    pub place: Length,
    /// Height from side to side.
    pub height: Length,
    /// Whether it runs across the rows, at one place of all of them, and not along them.
    pub is_across_rows: bool,
}

/// The highest step across the rows or along them.
///
/// ```text
/// |S(x)| > 5 s,  −S within 3 w at most |S(x)|/2                                                   [Surface-step]
/// ```
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::preparation::Preparation;
/// use asperity_roughness::surface_preparation::prepare_surface;
/// use asperity_roughness::surface_step::step;
/// let height = |k: usize, step: f64| {
///     let (x, y) = ((k % 1200) as f64, (k / 1200) as f64);
///     1e-7 * (0.3 * x + y).sin() * (0.11 * x - 0.7 * y).cos() + if x > 500.0 { step } else { 0.0 }
/// };
/// let of = |step: f64| {
///     let z: Vec<f64> = (0..1200 * 60).map(|k| height(k, step)).collect();
///     prepare_surface(&z, 1200, [Length::from_si(1e-6); 2], &Preparation::default())
/// };
/// assert_eq!(step(&of(0.0)?), None);
/// let found = step(&of(0.5e-6)?).map(|step| step.place.si() * 1e6 + 125.0);
/// assert!(found.is_some_and(|place| (place - 500.0).abs() < 3.0));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
#[must_use]
pub fn step(surface: &PreparedSurface) -> Option<Step> {
    cite!("Surface-step");
    let [across, along] = means(surface);
    let [dx, dy] = surface.spacings;
    let of = |means: &[f64], spacing: Length, is_across_rows: bool| {
        let (at, height) = highest(means, spacing)?;
        Some(Step {
            place: spacing * at as f64,
            height: Length::from_si(height),
            is_across_rows,
        })
    };
    let found = [of(&across, dx, true), of(&along, dy, false)];
    let found = found.into_iter().flatten();
    found.max_by(|a, b| a.height.si().total_cmp(&b.height.si()))
}

/// Means over all rows, and over the points of each row.
fn means(surface: &PreparedSurface) -> [Vec<f64>; 2] {
    let (columns, rows) = (surface.columns, surface.rows());
    let mut across = vec![0.0; columns];
    let mut along = vec![0.0; rows];
    for (row, sum) in surface.heights.chunks_exact(columns).zip(&mut along) {
        *sum = row.iter().sum::<f64>() / columns as f64;
        for (sum, z) in across.iter_mut().zip(row) {
            *sum += z / rows as f64;
        }
    }
    [across, along]
}

/// Points w of a side and S of a line, the first of the point w; `None` where the line is shorter than eight sides.
fn steps(means: &[f64], spacing: Length) -> Option<(usize, Vec<f64>)> {
    const LEAST_SIDES: usize = 8;
    let side = (LAMBDA_C.si() / SIDES / spacing.si()).round() as usize;
    if side < 2 || means.len() < LEAST_SIDES * side {
        return None;
    }
    let mut sums = vec![0.0];
    for mean in means {
        sums.push(sums[sums.len() - 1] + mean);
    }
    let of_side = |from: usize| (sums[from + side] - sums[from]) / side as f64;
    // S between the points side + k - 1 and side + k.
    let steps = (0..=means.len() - 2 * side).map(|k| of_side(k + side) - of_side(k));
    Some((side, steps.collect()))
}

/// Place and height of the highest step of a line; `None` without one.
fn highest(means: &[f64], spacing: Length) -> Option<(usize, f64)> {
    let (side, steps) = steps(means, spacing)?;
    let scatter = median(steps.iter().map(|step| step.abs()))? / Z_75;
    let (at, most) = steps
        .iter()
        .enumerate()
        .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    let near = &steps[at.saturating_sub(NEXT * side)..(at + NEXT * side + 1).min(steps.len())];
    let other = near.iter().map(|step| -step * most.signum());
    let other = other.fold(0.0, f64::max);
    let is_step = most.abs() > SCATTERS * scatter && other <= OTHER_SIGN * most.abs();
    is_step.then(|| (at + side, most.abs()))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_2_PI, PI, TAU};

    use super::*;
    use crate::preparation::Preparation;
    use crate::surface_preparation::prepare_surface;

    const SIZE: [usize; 2] = [2400, 240];

    /// Waves of 6 to 60 um, `ratio` times as long along the lead, with a standard deviation of 0.2 um, and what `feature` adds.
    fn surface(ratio: f64, seed: u32, feature: impl Fn(f64, f64) -> f64) -> PreparedSurface {
        let wave = |k: u32| {
            let part = |by: f64| (f64::from(k + 100 * seed) * by).fract();
            let length = 6.0 * 10.0_f64.powf(part(0.618_034));
            let (sine, cosine) = (TAU * part(0.754_878)).sin_cos();
            [cosine / length, sine / length / ratio, part(0.569_84)].map(|of| TAU * of)
        };
        let waves: Vec<[f64; 3]> = (0..80).map(wave).collect();
        let mut z = vec![0.0; SIZE[0] * SIZE[1]];
        for [x, y, phase] in waves {
            // The cosine of a sum of two angles: a table for each direction instead of half a million cosines.
            let across: Vec<(f64, f64)> = (0..SIZE[0]).map(|i| (x * i as f64).sin_cos()).collect();
            for (j, row) in z.chunks_exact_mut(SIZE[0]).enumerate() {
                let (sine, cosine) = (y * j as f64 + phase).sin_cos();
                for (z, of) in row.iter_mut().zip(&across) {
                    *z += 0.2e-6 / 40.0_f64.sqrt() * (of.1 * cosine - of.0 * sine);
                }
            }
        }
        for (k, z) in z.iter_mut().enumerate() {
            *z += feature((k % SIZE[0]) as f64, (k / SIZE[0]) as f64);
        }
        let spacings = [Length::from_si(1e-6); 2];
        prepare_surface(&z, SIZE[0], spacings, &Preparation::default()).unwrap()
    }

    #[test]
    fn steps_of_a_surface_are_found_and_textures_are_none() {
        for (ratio, seed) in [(1.0, 1), (1.0, 2), (3.0, 3), (40.0, 4), (40.0, 5)] {
            let none = surface(ratio, seed, |_, _| 0.0);
            assert_eq!(step(&none), None, "{ratio} {seed}");
            // A groove and a pit are no steps.
            let groove = surface(ratio, seed, |x, _| {
                if (x - 900.0).abs() < 15.0 { -3e-6 } else { 0.0 }
            });
            assert_eq!(step(&groove), None, "{ratio} {seed}");
        }
        // Without a lay a step of somewhat more than Rq is found in 240 rows, of ridges one of some times that. The filter takes of both
        // sides of a step h the mean of erf(x/(σ√2)) over a side, to the third order, with σ = α λc/√(2π), and the noise filter 1 % of h.
        // The rest of its height is roughness at its place, and a side that is d points from the step has d points of the other side.
        let dx = Length::from_si(1e-6);
        let side = TAU.sqrt() / SIDES / (2.0_f64.ln() / PI).sqrt();
        let share = 1.0 - FRAC_2_PI.sqrt() * (side / 2.0 - side.powi(3) / 24.0);
        for (ratio, height) in [(1.0, 0.25e-6), (40.0, 1.5e-6)] {
            let of = |height: f64| surface(ratio, 1, |x, _| if x > 1500.0 { height } else { 0.0 });
            let found = step(&of(height)).unwrap();
            assert!(found.is_across_rows);
            let at = (found.place / dx).round();
            let away = (at + 125.0 - 1501.0).abs();
            assert!(away < 10.0, "{found:?}");
            let [across, _] = means(&of(0.0));
            let (points, rough) = steps(&across, dx).unwrap();
            let bare = found.height.si() - rough[at as usize - points];
            let expected = share - away / points as f64;
            assert!(
                (bare / height - expected).abs() < 0.015,
                "{ratio}: {} {expected} {away}",
                bare / height
            );
        }
        // Along the rows of a wide surface.
        let means: Vec<f64> = (0..1000)
            .map(|k| 2e-8 * (0.3 * f64::from(k)).sin() + if k > 499 { 4e-7 } else { 0.0 })
            .collect();
        let (at, height) = highest(&means, Length::from_si(1e-6)).unwrap();
        assert!(
            at.abs_diff(500) < 4 && (height / 4e-7 - 1.0).abs() < 0.1,
            "{at} {height}"
        );
    }
}
