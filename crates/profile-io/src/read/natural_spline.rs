//! Natural cubic spline through the points of a trace.
//!
//! Source: de Boor 1978, chapter IV.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | x_i, z_i | points | m, any |
//! | h_i | x_(i+1) − x_i | m |
//! | M_i | second derivative at x_i, zero at both ends | unit of z over m² |
//! | t | (x − x_i)/h_i | - |

/// S(x) = (1−t)·z_i + t·z_(i+1) + ((1−t)³ − (1−t))·M_i·h_i²/6 + (t³ − t)·M_(i+1)·h_i²/6     `[Spline-1]`
///
/// The spline through `z` at two or more ascending `x`, evaluated at ascending `positions`. Beyond the ends the
/// outermost cubic is extrapolated.
pub(super) fn at_rising(positions: impl Iterator<Item = f64>, x: &[f64], z: &[f64]) -> Vec<f64> {
    asperity_core::cite!("Spline-1");
    let bends = second_derivatives(x, z);
    let mut at = 0;
    let value = |position: f64| {
        while at + 2 < x.len() && x[at + 1] <= position {
            at += 1;
        }
        let step = x[at + 1] - x[at];
        let right = (position - x[at]) / step;
        let left = 1.0 - right;
        let bend = (left.powi(3) - left) * bends[at] + (right.powi(3) - right) * bends[at + 1];
        left * z[at] + right * z[at + 1] + bend * step * step / 6.0
    };
    positions.map(value).collect()
}

/// M_i of h_(i−1)·M_(i−1) + 2·(h_(i−1) + h_i)·M_i + h_i·M_(i+1) = 6·(z_(i+1) − z_i)/h_i − 6·(z_i − z_(i−1))/h_(i−1),
/// a system dominated by its diagonal, by elimination.
fn second_derivatives(x: &[f64], z: &[f64]) -> Vec<f64> {
    let last = x.len() - 1;
    let mut above = vec![0.0; x.len()];
    let mut bends = vec![0.0; x.len()];
    for i in 1..last {
        let (before, after) = (x[i] - x[i - 1], x[i + 1] - x[i]);
        let slopes = (z[i + 1] - z[i]) / after - (z[i] - z[i - 1]) / before;
        let pivot = 2.0 * (before + after) - before * above[i - 1];
        above[i] = after / pivot;
        bends[i] = (6.0 * slopes - before * bends[i - 1]) / pivot;
    }
    for i in (1..last).rev() {
        bends[i] -= above[i] * bends[i + 1];
    }
    bends
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_natural_spline_through_three_points_is_that_of_the_closed_form() {
        // M = (0, −3, 0) through (0, 0), (1, 1), (2, 0); (0, −1.5, 0) at steps 1 and 2 through (0, 0), (1, 1), (3, 0).
        let even = at_rising(
            [0.5, 1.0, 1.5].into_iter(),
            &[0.0, 1.0, 2.0],
            &[0.0, 1.0, 0.0],
        );
        for (found, exact) in even.iter().zip([0.6875, 1.0, 0.6875]) {
            assert!((found - exact).abs() < 1e-15, "{found}");
        }
        let uneven = at_rising([0.5, 2.0].into_iter(), &[0.0, 1.0, 3.0], &[0.0, 1.0, 0.0]);
        let bend = -1.5;
        let exact = [0.5 - 0.375 * bend / 6.0, 0.5 - 0.375 * bend * 4.0 / 6.0];
        for (found, exact) in uneven.iter().zip(exact) {
            assert!((found - exact).abs() < 1e-15, "{found} {exact}");
        }
    }

    #[test]
    fn a_straight_line_stays_one() {
        let x: Vec<f64> = (0..20).map(|i| f64::from(i * i)).collect();
        let z: Vec<f64> = x.iter().map(|x| 3.0 - 0.5 * x).collect();
        for (i, found) in at_rising((0..361).map(f64::from), &x, &z)
            .iter()
            .enumerate()
        {
            assert!((found - (3.0 - 0.5 * i as f64)).abs() < 1e-12, "{i}");
        }
    }
}
