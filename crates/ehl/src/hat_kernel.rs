//! Displacement of the half-planes by a pressure that is linear between the nodes.
//!
//! u(X) = −(1/π)·∫ P(X′)·ln|X − X′| dX′, in units of a²/R. A pressure that is linear between the nodes
//! is a sum of hats; F below is the second integral of ln|u|.

use std::f64::consts::PI;

use asperity_core::cite;

#[cfg(any(test, feature = "oracle"))]
use crate::grid::FilmGrid;

/// Images of the spectrum summed on either side for the inverse of the kernel.
const ALIASES: usize = 30;

/// F(u) = u²/2·ln|u| − 3u²/4.
fn second_integral(u: f64) -> f64 {
    let square = u * u;
    if square == 0.0 {
        0.0
    } else {
        square * (0.25 * square.ln() - 0.75)
    }
}

/// Displacement by a unit hat `lag` nodes away on an even grid of spacing h, for lags below `count`.
///
/// c_k = −(1/(π·h))·[F((k+1)·h) − 2·F(k·h) + F((k−1)·h)]                     `[Hat-kernel]`
pub(crate) fn hat_column(spacing: f64, count: usize) -> Vec<f64> {
    cite!("Hat-kernel");
    let h = spacing;
    (0..count)
        .map(|lag| {
            let u = lag as f64 * h;
            let bracket =
                second_integral(u + h) - 2.0 * second_integral(u) + second_integral(u - h);
            -bracket / (PI * h)
        })
        .collect()
}

/// Dense kernel of a graded grid, row by row; the end nodes carry no pressure.
#[cfg(any(test, feature = "oracle"))]
pub(crate) fn hat_matrix(grid: &FilmGrid) -> Vec<f64> {
    let n = grid.nodes();
    let mut matrix = vec![0.0; n * n];
    for (row, &x) in matrix.chunks_exact_mut(n).zip(&grid.x) {
        let f: Vec<f64> = grid
            .x
            .iter()
            .map(|&node| second_integral(x - node))
            .collect();
        for j in 1..n - 1 {
            let before = (f[j - 1] - f[j]) / grid.spacing[j - 1];
            let after = (f[j + 1] - f[j]) / grid.spacing[j];
            row[j] = -(before + after) / PI;
        }
    }
    matrix
}

/// First column of the periodic inverse of the kernel, `period` nodes of distance `spacing`.
///
/// The symbol of the continuum is 1/|q|; the symbol of the hats is its aliased sum with the square of the
/// cardinal sine. The constant, which the kernel leaves free, gets half of the first wave's value.
pub(crate) fn inverse_column(spacing: f64, period: usize, count: usize) -> Vec<f64> {
    let step = 2.0 * PI / (period as f64 * spacing);
    let waves = period / 2;
    let mut symbol: Vec<f64> = (0..=waves)
        .map(|k| 1.0 / hat_symbol(k as f64 * step, spacing))
        .collect();
    symbol[0] = 0.5 * symbol[1];
    let cosines: Vec<f64> = (0..period)
        .map(|k| (2.0 * PI * k as f64 / period as f64).cos())
        .collect();
    (0..count)
        .map(|lag| {
            let sum: f64 = (1..period)
                .map(|k| symbol[k.min(period - k)] * cosines[k * lag % period])
                .sum();
            (symbol[0] + sum) / period as f64
        })
        .collect()
}

/// Symbol of the hat kernel at the wave number q > 0.
fn hat_symbol(q: f64, spacing: f64) -> f64 {
    let one = |q: f64| {
        let t = 0.5 * q * spacing;
        let sinc = if t == 0.0 { 1.0 } else { t.sin() / t };
        sinc * sinc / q
    };
    let turn = 2.0 * PI / spacing;
    let images: f64 = (1..ALIASES)
        .flat_map(|k| [k as f64 * turn, -(k as f64) * turn])
        .map(|shift| one((q + shift).abs()))
        .sum();
    one(q) + images
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hats_of_a_hertz_pressure_flatten_the_parabola() {
        // u + X²/2 is constant inside; the square-root ends leave an error of h^1.5.
        let grid = FilmGrid::uniform(-1.0, 1.0, 400);
        let p: Vec<f64> = grid
            .x
            .iter()
            .map(|x| (1.0 - x * x).max(0.0).sqrt())
            .collect();
        let column = hat_column(0.005, 401);
        let gap = |i: usize| {
            let u: f64 = (0..=400).map(|j| column[i.abs_diff(j)] * p[j]).sum();
            u + 0.5 * grid.x[i] * grid.x[i]
        };
        for i in [100, 150, 250, 300] {
            assert!((gap(i) - gap(200)).abs() < 2e-4);
        }
    }

    #[test]
    fn the_graded_matrix_has_the_even_column_on_an_even_grid() {
        let grid = FilmGrid::uniform(-1.0, 1.0, 20);
        let (matrix, column) = (hat_matrix(&grid), hat_column(0.1, 21));
        for i in 0..=20 {
            for j in 1..20usize {
                assert!((matrix[21 * i + j] - column[j.abs_diff(i)]).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn the_periodic_inverse_undoes_the_kernel_on_waves() {
        let (h, n) = (0.02, 64);
        let inverse = inverse_column(h, n, n);
        for wave in [1, 5, 20, 32] {
            let angle = 2.0 * PI * wave as f64 / n as f64;
            let symbol: f64 = (0..n).map(|k| inverse[k] * (angle * k as f64).cos()).sum();
            let expected = 1.0 / hat_symbol(angle / h, h);
            assert!((symbol / expected - 1.0).abs() < 1e-10);
        }
    }
}
