//! `lossTable` of `Modelica.Mechanics.Rotational.Components.LossyGear`: efficiency and friction over the speed.

use asperity_core::Fault;
use asperity_core::numerics::Cholesky;

use super::error;
use super::field::Field;
use super::given::With;
use super::mat5::Mat5;

const FORMAT: &str = "LossyGear";

/// Lines of the loss torque over the torque, at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lines {
    /// Loss torque without torque \[N m\].
    pub friction_nm: f64,
    /// Share of the torque that is lost: the input drives, the output drives.
    pub slopes: [f64; 2],
}

impl Lines {
    /// Loss torque \[N m\].
    #[must_use]
    pub fn loss_nm(&self, torque_nm: f64) -> f64 {
        let [driving, driven] = self.slopes;
        let slope = if torque_nm < 0.0 { driven } else { driving };
        self.friction_nm + slope * torque_nm.abs()
    }

    /// Least squares over the torques, each weighted by the range that it represents, without negative numbers.
    ///
    /// ```text
    /// L = f + s |T|, s of the direction of T:  min Σ w (L − f − s |T|)²,  f, s >= 0
    /// ```
    fn fitted(torques: &[f64], losses: &[f64]) -> Self {
        let largest = torques
            .iter()
            .fold(f64::MIN_POSITIVE, |m, t| m.max(t.abs()));
        // Columns of order one: constant, driving, driven. A direction without torques has the losses of the other.
        let row = |torque: f64| {
            let share = torque.abs() / largest;
            if torque < 0.0 {
                [1.0, 0.0, share]
            } else {
                [1.0, share, 0.0]
            }
        };
        let mut normal = [[0.0; 4]; 3];
        for ((torque, loss), width) in torques.iter().zip(losses).zip(widths(torques)) {
            let row = row(*torque);
            for i in 0..3 {
                for j in 0..3 {
                    normal[i][j] += width * row[i] * row[j];
                }
                normal[i][3] += width * row[i] * loss;
            }
        }
        // Of all choices of numbers that are zero, the one that fits best without a negative one.
        let feasible = (0..8).filter_map(|free| solved(&normal, free));
        let feasible = feasible.filter(|x| x.iter().all(|value| *value >= 0.0));
        let [friction_nm, driving, driven] = feasible
            .min_by(|a, b| misfit(&normal, a).total_cmp(&misfit(&normal, b)))
            .unwrap_or_default();
        let mut slopes = [driving / largest, driven / largest];
        if torques.iter().all(|torque| *torque >= 0.0) {
            slopes[1] = slopes[0];
        } else if torques.iter().all(|torque| *torque <= 0.0) {
            slopes[0] = slopes[1];
        }
        Self {
            friction_nm,
            slopes,
        }
    }
}

/// Lines at each speed of a field.
#[must_use]
pub fn lines(field: &Field) -> Vec<Lines> {
    let (total, across) = (field.total_nm(), field.speed_rpm.len());
    let at = |speed: usize| {
        let losses: Vec<f64> = total.iter().skip(speed).step_by(across).copied().collect();
        Lines::fitted(&field.torque_nm, &losses)
    };
    (0..across).map(at).collect()
}

/// Sum of squares without Σ w L², for the search of its minimum.
fn misfit(normal: &[[f64; 4]; 3], x: &[f64; 3]) -> f64 {
    let product = |row: &[f64; 4]| row.iter().zip(x).map(|(a, b)| a * b).sum::<f64>();
    let parts = normal.iter().zip(x);
    parts
        .map(|(row, x)| x * (product(row) - 2.0 * row[3]))
        .sum()
}

/// Half of both adjacent intervals of each node.
fn widths(nodes: &[f64]) -> Vec<f64> {
    let last = nodes.len().saturating_sub(1);
    let width = |k: usize| 0.5 * (nodes[(k + 1).min(last)] - nodes[k.saturating_sub(1)]);
    (0..nodes.len()).map(width).collect()
}

/// The unknowns whose bit in `free` is set, the others zero; `None` if the rows do not determine them.
fn solved(normal: &[[f64; 4]; 3], free: usize) -> Option<[f64; 3]> {
    /// Least square of a pivot over the largest element.
    const DEPENDENT: f64 = 1e-12;
    let free: Vec<usize> = (0..3).filter(|k| free & (1 << k) != 0).collect();
    let largest = normal.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    let matrix = |i: usize, j: usize| normal[free[i]][free[j]];
    let factor = Cholesky::new(free.len(), matrix, DEPENDENT * largest)?;
    let mut found: Vec<f64> = free.iter().map(|k| normal[*k][3]).collect();
    factor.solve(&mut found);
    let mut all = [0.0; 3];
    for (k, value) in free.iter().zip(found) {
        all[*k] = value;
    }
    Some(all)
}

/// Columns |w|, `eta_mf1`, `eta_mf2`, `tau_bf1`, `tau_bf2`: without torque both directions have the same friction, so that
/// the driving side changes with the sign of the torque, as in the map.
///
/// ```text
/// T >= 0:  L = (1 − eta_mf1) T + tau_bf1        T < 0:  L = (1/eta_mf2 − 1) |T| + tau_bf2
/// ```
pub(super) fn bytes(field: &Field, _: &With<'_>) -> Result<Vec<u8>, Fault> {
    field.check_size(FORMAT)?;
    field.check_slope(FORMAT)?;
    let ratio = field.ratio.ok_or_else(|| error::no_ratio(FORMAT))?;
    let lines = lines(field);
    let row = |(omega, of): (f64, &Lines)| {
        let [driving, driven] = of.slopes;
        let friction = of.friction_nm;
        [
            omega,
            1.0 - driving,
            1.0 / (1.0 + driven),
            friction,
            friction,
        ]
    };
    let omega = field.omega();
    let table: Vec<f64> = omega.into_iter().zip(&lines).flat_map(row).collect();
    let (total, across) = (field.total_nm(), lines.len());
    let residual = |(index, loss): (usize, &f64)| {
        lines[index % across].loss_nm(field.torque_nm[index / across]) - loss
    };
    let residuals: Vec<f64> = total.iter().enumerate().map(residual).collect();
    let count = total.len() as f64;
    let rms = (residuals.iter().map(|r| r * r).sum::<f64>() / count).sqrt();
    let most = residuals.iter().fold(0.0_f64, |m, r| m.max(r.abs()));
    let mean = total.iter().sum::<f64>() / count;
    let fit = format!(
        "residual at the nodes {rms} N m rms, {most} N m at most; mean loss torque {mean} N m"
    );
    Ok(Mat5::new(&field.head())
        .with("lossTable", &[across, 5], &by_columns(&table, across))
        .with("ratio", &[1, 1], &[ratio])
        .with("fit_rms_nm", &[1, 1], &[rms])
        .with("fit_max_nm", &[1, 1], &[most])
        .with_text("fit", &fit)
        .with_text("scope", &field.scope)
        .with_text("head", &field.head())
        .bytes())
}

/// Values row by row as values column by column.
fn by_columns(values: &[f64], rows: usize) -> Vec<f64> {
    let columns = values.len() / rows.max(1);
    let of = |column: usize| (0..rows).map(move |row| values[row * columns + column]);
    (0..columns).flat_map(of).collect()
}
