//! Displacement of a half-space by uniform pressure on a rectangle and its images along the lead.
//!
//! Source: Love 1929; Johnson 1985, eq. 3.25.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | x, y | distance from the middle of the rectangle along rolling and along the lead | m |
//! | a, b | half sides of the rectangle along x and y | m |
//! | C | kernel: u = C·p/(π·E*) is the displacement of both bodies together | m |
//! | Λ | period along the lead | m |
//! | Ĉ_k | transform of C over a period along the lead at its wave k | m |
//! | N, H | nearest images on either side that are summed, (N + ½)·Λ | -, m |
//!
//! The sum over all images is infinite by a number that does not depend on y: it enters Ĉ₀ only. A pressure that is
//! constant along the lead is a line, so Ĉ₀ is the kernel of the strip, and all images enter the other waves.

use asperity_core::cite;
use asperity_core::numerics::FourierNumber;
use rustfft::num_complex::Complex;

/// N: farther images act as points, and their sum as an integral with its end corrections; the waves are then exact to 1e-6 of a.
const NEAR_IMAGES: usize = 4;

/// F(X, Y) = X·asinh(Y/|X|) + Y·asinh(X/|Y|)
fn corner(x: f64, y: f64) -> f64 {
    let term = |s: f64, t: f64| {
        if s == 0.0 {
            0.0
        } else {
            s * (t / s.abs()).asinh()
        }
    };
    term(x, y) + term(y, x)
}

/// C(x, y) = F(x+a, y+b) − F(x+a, y−b) − F(x−a, y+b) + F(x−a, y−b)                       `[Love-1]`
///
/// with F(X, Y) = X·asinh(Y/|X|) + Y·asinh(X/|Y|), in units of a, for the lags of `columns` cells along x and `rows` cells
/// along y with the sides 2a and 2b = `aspect`·2a; row after row.
fn rectangles([columns, rows]: [usize; 2], aspect: f64) -> Vec<f64> {
    cite!("Love-1");
    // The corners of the cells lie at odd multiples of the half sides, and F is odd in both.
    let steps = |row: usize| -> Vec<f64> {
        let y = aspect * (2 * row + 1) as f64;
        let mut before = -corner(1.0, y);
        let step = |column: usize| {
            let next = corner((2 * column + 1) as f64, y);
            next - std::mem::replace(&mut before, next)
        };
        (0..columns).map(step).collect()
    };
    let mut values = Vec::with_capacity(columns * rows);
    let mut before: Vec<f64> = steps(0).iter().map(|step| -step).collect();
    for row in 0..rows {
        let next = steps(row);
        values.extend(next.iter().zip(&before).map(|(next, before)| next - before));
        before = next;
    }
    values
}

/// (1/Λ)·∫ g ds + (Λ/24)·g′(s) − (7·Λ³/5760)·g‴(s) from s to infinity, g = 1/√(x² + s²), without a term that depends on x
/// only: the images of a point from s + Λ/2 on, Λ apart, by the midpoint rule with its corrections at the end.
fn far_points(x: f64, s: f64, period: f64) -> f64 {
    let (square, r) = (s * s, x.hypot(s));
    let (r2, r3) = (r * r, r * r * r);
    let (first, third) = (-s / r3, s * (9.0 * r2 - 15.0 * square) / (r3 * r2 * r2));
    -(s + r).ln() / period + period / 24.0 * first - 7.0 * period.powi(3) / 5760.0 * third
}

/// Ĉ_k = Σⱼ cos(2π·k·j/rows)·Σₙ C(x, y_j + n·Λ),  k ≥ 1;  Ĉ₀ of the strip                  `[Love-2]`
///
/// The transform over the rows of a period at each lag of `columns` cells along x, in units of a; wave after wave, from the
/// first to half of the rows. Images to |n| = 4 are summed one by one.
pub(crate) fn lead_waves([columns, rows]: [usize; 2], aspect: f64) -> Vec<f64> {
    cite!("Love-2");
    let near = rectangles([columns, (NEAR_IMAGES * rows) + rows / 2 + 1], aspect);
    let period = 2.0 * aspect * rows as f64;
    let end = (NEAR_IMAGES as f64 + 0.5) * period;
    let images = NEAR_IMAGES as isize;
    let transform = f64::forward(&mut f64::planner(), rows);
    let mut waves = vec![0.0; rows / 2 * columns];
    let mut lead = vec![Complex::from(0.0); rows];
    for column in 0..columns {
        let x = 2.0 * column as f64;
        for row in 0..=rows / 2 {
            let y = 2.0 * aspect * row as f64;
            let image = |n: isize| {
                let away = (row as isize + n * rows as isize).unsigned_abs();
                near[away * columns + column]
            };
            let far = [end + y, end - y].map(|s| far_points(x, s, period));
            let all = (-images..=images).map(image).sum::<f64>() + 4.0 * aspect * (far[0] + far[1]);
            lead[row] = all.into();
            lead[(rows - row) % rows] = all.into();
        }
        transform.process(&mut lead);
        for (k, wave) in lead[1..=rows / 2].iter().enumerate() {
            waves[k * columns + column] = wave.re;
        }
    }
    waves
}

/// u_q = 2·p_q/(E*·|q|), |q|² = q_x² + q_y², in units of a/(π·E*) at the wave numbers `waves` of the periods of both      `[Periodic-3]`
/// directions; no mean
pub(crate) fn plane_symbol(waves: [usize; 2], cells: [usize; 2], aspect: f64) -> f64 {
    cite!("Periodic-3");
    let [along, across] = [0, 1].map(|i| waves[i] as f64 / cells[i] as f64);
    match waves {
        [0, 0] => 0.0,
        _ => 2.0 / along.hypot(across / aspect),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strip_kernel::strip;

    #[test]
    fn rectangles_along_the_lead_are_a_strip() {
        let (columns, rows, aspect) = (40, 40_000, 0.7);
        let values = rectangles([columns, rows], aspect);
        let sum = |column: usize| -> f64 {
            let lead = values[column..].iter().step_by(columns);
            2.0 * lead.sum::<f64>() - values[column]
        };
        for column in [1, 2, 7, 39] {
            let x = 2.0 * column as f64;
            // Beyond both ends, at a distance s, 2·2·∫ (1/√(x² + t²) − 1/t) dt = −x²/s² is missing.
            let missing = (x / (aspect * (2 * rows - 1) as f64)).powi(2);
            let difference = sum(column) - sum(0) - missing;
            assert!(
                (difference - strip(x)).abs() < 1e-8,
                "{column}: {difference} {}",
                strip(x)
            );
        }
        // Far away a rectangle is a point with its area.
        let (far, point) = (values[30 * columns + 30], 4.0 * aspect / 60f64.hypot(42.0));
        assert!((far / point - 1.0).abs() < 1e-4);
    }

    #[test]
    fn waves_along_the_lead_have_all_their_images() {
        for (rows, aspect) in [(16, 1.0), (24, 0.5), (9, 3.0)] {
            let columns = 30;
            let waves = lead_waves([columns, rows], aspect);
            let images = 1_000;
            let direct = rectangles([columns, (images + 1) * rows], aspect);
            for column in [0, 1, 5, 29] {
                let sum = |row: usize| -> f64 {
                    let image = |n: isize| {
                        let away = row as isize + n * rows as isize;
                        direct[away.unsigned_abs() * columns + column]
                    };
                    (-(images as isize)..=images as isize).map(image).sum()
                };
                for k in 1..=rows / 2 {
                    let turn = std::f64::consts::TAU * k as f64 / rows as f64;
                    let wave: f64 = (0..rows)
                        .map(|row| sum(row) * (turn * row as f64).cos())
                        .sum();
                    let found = waves[(k - 1) * columns + column];
                    assert!(
                        (found - wave).abs() < 1e-6,
                        "{rows} {column} {k}: {found} {wave}"
                    );
                }
            }
        }
    }
}
