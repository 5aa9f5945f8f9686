//! Formats with a few numbers instead of a map: fits with their residuals.

use asperity_core::Fault;
use serde::Serialize;
use serde_json::json;

use super::error;
use super::field::Field;
use crate::cycle::{Coverage, Cycle};

/// Gear box of CO2MPAS: T_in = (T_out/i + gbp00 + gbp10 n)/gbp01, n the speed of the input shaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GearBoxFit {
    /// Constant loss torque \[N m\].
    pub gbp00: f64,
    /// Loss torque per speed \[N m min\].
    pub gbp10: f64,
    /// Share of the input torque that is not lost.
    pub gbp01: f64,
    /// Root mean square residual over the area of the map \[N m\].
    #[serde(skip)]
    pub residual_rms_nm: f64,
    /// Largest residual at a node \[N m\].
    #[serde(skip)]
    pub residual_max_nm: f64,
    /// Mean loss torque over the area of the map \[N m\].
    #[serde(skip)]
    pub mean_loss_nm: f64,
}

/// Least squares of T_in − L = gbp01 T_in − gbp00 − gbp10 n over the nodes at which the input drives and turns, each
/// weighted by the area of the map that it represents.
///
/// ```text
/// min Σ A (T_in − L − gbp01 T_in + gbp00 + gbp10 n)²
/// ```
#[must_use]
pub fn gear_box_fit(field: &Field) -> GearBoxFit {
    let (total, across) = (field.total_nm(), field.speed_rpm.len());
    let (widths, heights) = (widths(&field.torque_nm), widths(&field.speed_rpm));
    let nodes: Vec<[f64; 4]> = total
        .iter()
        .enumerate()
        .map(|(index, loss)| {
            let (i, j) = (index / across, index % across);
            let area = widths[i] * heights[j];
            [field.torque_nm[i], field.speed_rpm[j], *loss, area]
        })
        .filter(|[torque, speed, ..]| *torque > 0.0 && *speed > 0.0)
        .collect();
    // Scaled to columns of order one, with the loss itself on the left: L = (1 − gbp01) T + gbp00 + gbp10 n.
    let most = |k: usize| {
        nodes
            .iter()
            .map(|node| node[k])
            .fold(f64::MIN_POSITIVE, f64::max)
    };
    let (scales, whole) = (
        [most(0), most(1)],
        nodes.iter().map(|node| node[3]).sum::<f64>(),
    );
    let mut normal = [[0.0; 4]; 3];
    for [torque, speed, loss, area] in &nodes {
        let row = [torque / scales[0], 1.0, speed / scales[1], *loss];
        for i in 0..3 {
            for (j, value) in row.iter().enumerate() {
                normal[i][j] += area / whole * row[i] * value;
            }
        }
    }
    let [slope, constant, over_speed] = solved(normal);
    let (slope, over_speed) = (slope / scales[0], over_speed / scales[1]);
    let residual =
        |[torque, speed, loss, _]: &[f64; 4]| loss - slope * torque - constant - over_speed * speed;
    let mean = |of: &dyn Fn(&[f64; 4]) -> f64| {
        let parts = nodes.iter().map(|node| node[3] * of(node));
        parts.sum::<f64>() / whole
    };
    GearBoxFit {
        gbp00: constant,
        gbp10: over_speed,
        gbp01: 1.0 - slope,
        residual_rms_nm: mean(&|node| residual(node).powi(2)).sqrt(),
        residual_max_nm: nodes
            .iter()
            .map(|node| residual(node).abs())
            .fold(0.0, f64::max),
        mean_loss_nm: mean(&|node| node[2]),
    }
}

/// Half of both adjacent intervals of each node.
fn widths(nodes: &[f64]) -> Vec<f64> {
    let last = nodes.len().saturating_sub(1);
    let width = |k: usize| 0.5 * (nodes[(k + 1).min(last)] - nodes[k.saturating_sub(1)]);
    (0..nodes.len()).map(width).collect()
}

/// Gaussian elimination with the largest pivot; an unknown without a pivot is zero.
fn solved(mut m: [[f64; 4]; 3]) -> [f64; 3] {
    /// Pivot of a linearly dependent column; other pivots are of order one.
    const NONE: f64 = 1e-12;
    for k in 0..3 {
        let largest = (k..3).max_by(|&a, &b| m[a][k].abs().total_cmp(&m[b][k].abs()));
        m.swap(k, largest.unwrap_or(k));
        if m[k][k].abs() < NONE {
            m[k] = [0.0; 4];
            m[k][k] = 1.0;
            continue;
        }
        for i in (0..3).filter(|i| *i != k) {
            let factor = m[i][k] / m[k][k];
            let pivot = m[k];
            for (value, from) in m[i].iter_mut().zip(pivot) {
                *value -= factor * from;
            }
        }
    }
    [0, 1, 2].map(|k| m[k][3] / m[k][k])
}

/// Parameters of CO2MPAS: hot from the highest temperature of the map, cold from the lowest.
pub(super) fn co2mpas(fields: &[Field]) -> Result<Vec<u8>, Fault> {
    let (Some(cold), Some(hot)) = (fields.first(), fields.last()) else {
        return Ok(Vec::new());
    };
    let fit = |field: &Field| {
        let fit = gear_box_fit(field);
        let residual = json!({
            "temperature_c": field.temperature_c,
            "residual_rms_nm": fit.residual_rms_nm,
            "residual_max_nm": fit.residual_max_nm,
            "mean_loss_nm": fit.mean_loss_nm,
        });
        (fit, residual)
    };
    let ((hot_fit, hot_left), (cold_fit, cold_left)) = (fit(hot), fit(cold));
    let value = json!({
        "scope": hot.scope,
        "head": hot.head(),
        "equation": "T_in = (T_out/i + gbp00 + gbp10 n_in)/gbp01; N m and 1/min",
        "gear_box_efficiency_parameters_cold_hot": { "hot": hot_fit, "cold": cold_fit },
        "fit": { "hot": hot_left, "cold": cold_left },
    });
    serde_json::to_vec_pretty(&value).map_err(error::unwritten)
}

/// Efficiency for fastsim: output energy relative to input energy over the time in which the input drives.
pub(super) fn fastsim(field: &Field, cycle: &Cycle) -> Result<Vec<u8>, Fault> {
    let surface = field.surface();
    let coverage = Coverage::of(&surface, cycle);
    coverage
        .check()
        .map_err(|source| error::uncovered("fastsim", source))?;
    let (mut entered, mut lost, mut outside) = (0.0, 0.0, 0);
    for point in &cycle.points {
        let [torque_nm, speed_rpm] = point.forwards();
        if torque_nm <= 0.0 {
            continue;
        }
        let loss = surface.loss_torque(torque_nm, speed_rpm);
        let angle = speed_rpm * point.weight_s;
        entered += torque_nm * angle;
        lost += loss.value * angle;
        outside += usize::from(loss.is_outside);
    }
    let value = json!({
        "scope": field.scope,
        "head": field.head(),
        "eff_interp": { "Interp0D": if entered > 0.0 { Some(1.0 - lost / entered) } else { None } },
        "points_outside_the_map": outside,
        "note": "efficiency of the scope only, weighted by the cycle; multiply it by the efficiencies of the rest of the driveline",
    });
    serde_json::to_vec_pretty(&value).map_err(error::unwritten)
}
