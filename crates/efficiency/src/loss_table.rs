//! Loss torque from a user's table, over torque, speed and temperature.
//!
//! A table is one grid of nodes, or one grid per temperature. The loss torque is interpolated linearly along each axis and
//! not extrapolated. The rows of a speed may have torques of their own, as in loss maps of VECTO: between them the loss is
//! linear as well.

use asperity_core::cite;
use asperity_core::numerics::{NodeInterval, distinct};

use crate::error::EfficiencyError;

/// A row of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LossRow {
    /// Torque \[N m\]; `None` if the loss does not depend on it.
    pub torque_nm: Option<f64>,
    /// Speed \[1/min\].
    pub speed_rpm: f64,
    /// Temperature \[°C\]; `None` if the loss does not depend on it.
    pub temperature_c: Option<f64>,
    /// Loss torque \[N m\].
    pub loss_torque_nm: f64,
}

/// Loss torque over torque, speed and temperature.
#[derive(Debug, Clone, PartialEq)]
pub struct LossTable {
    /// Temperatures \[°C\], rising; empty if the loss does not depend on them.
    temperatures: Vec<f64>,
    /// One grid per temperature, or a single grid.
    grids: Vec<TableGrid>,
}

/// Loss torques of one temperature.
#[derive(Debug, Clone, PartialEq)]
struct TableGrid {
    /// Torques \[N m\], rising; empty if the loss does not depend on them.
    torques: Vec<f64>,
    /// Speeds \[1/min\], rising.
    speeds: Vec<f64>,
    /// Loss torques \[N m\], torque by torque.
    values: Vec<f64>,
}

impl LossTable {
    /// Makes the table from rows in any order.
    ///
    /// # Errors
    /// When a number is not finite, a loss is negative, only some rows have a torque or a temperature, or the rows of a
    /// temperature do not form a grid.
    ///
    /// ```
    /// use asperity_efficiency::loss_table::{LossRow, LossTable};
    /// let row = |speed_rpm, loss_torque_nm| LossRow {
    ///     torque_nm: None, speed_rpm, temperature_c: None, loss_torque_nm,
    /// };
    /// let table = LossTable::new(&[row(0.0, 0.1), row(1000.0, 0.3)])?;
    /// assert!((table.loss_torque(145.0, 500.0, 90.0)? - 0.2).abs() < 1e-15);
    /// assert!(table.loss_torque(145.0, 1001.0, 90.0).is_err());
    /// # Ok::<(), asperity_efficiency::EfficiencyError>(())
    /// ```
    pub fn new(rows: &[LossRow]) -> Result<Self, EfficiencyError> {
        for row in rows {
            let coordinates = [row.torque_nm, Some(row.speed_rpm), row.temperature_c];
            if !coordinates.into_iter().flatten().all(f64::is_finite) {
                return Err(EfficiencyError::table_row(
                    "torque_nm, speed_rpm and temperature_c must be finite",
                    row.speed_rpm,
                ));
            }
            if !(row.loss_torque_nm.is_finite() && row.loss_torque_nm >= 0.0) {
                return Err(EfficiencyError::table_row(
                    "loss_torque_nm, or loss_w at a speed above 0, must be stated and zero or more",
                    row.loss_torque_nm,
                ));
            }
        }
        let temperatures = distinct(rows.iter().filter_map(|row| row.temperature_c));
        let grids = match temperatures.as_slice() {
            [] => vec![TableGrid::new(rows)?],
            given => {
                let at = |temperature: &f64| {
                    let of = rows
                        .iter()
                        .filter(|row| row.temperature_c == Some(*temperature));
                    TableGrid::new(&of.copied().collect::<Vec<_>>())
                };
                if rows.iter().any(|row| row.temperature_c.is_none()) {
                    return Err(no_grid(rows, &[], &[]));
                }
                given.iter().map(at).collect::<Result<_, _>>()?
            }
        };
        Ok(Self {
            temperatures,
            grids,
        })
    }

    /// Loss torque \[N m\] at a torque \[N m\], a speed \[1/min\] of either sign, and a temperature \[°C\].
    ///
    /// ```text
    /// M = Σ_k Π_i w_ik M_k over the corners k of the cell,  w_i = (1 − a_i, a_i) along axis i     [Loss-table]
    /// ```
    ///
    /// # Errors
    /// When the point is beyond the nodes of an axis.
    pub fn loss_torque(
        &self,
        torque_nm: f64,
        speed_rpm: f64,
        temperature_c: f64,
    ) -> Result<f64, EfficiencyError> {
        cite!("Loss-table");
        let missing = || EfficiencyError::not_in_table(torque_nm, speed_rpm, temperature_c);
        let at = |grid: &TableGrid| grid.at(torque_nm, speed_rpm.abs());
        if self.temperatures.is_empty() {
            return self.grids.first().and_then(at).ok_or_else(missing);
        }
        let interval = interval(&self.temperatures, temperature_c).ok_or_else(missing)?;
        // A node needs no value of its neighbour.
        let weights = [
            (interval.low, 1.0 - interval.part),
            (interval.high, interval.part),
        ];
        let parts = weights.into_iter().filter(|(_, weight)| *weight > 0.0);
        parts
            .map(|(k, weight)| Ok(weight * at(&self.grids[k]).ok_or_else(missing)?))
            .sum()
    }
}

impl TableGrid {
    fn new(rows: &[LossRow]) -> Result<Self, EfficiencyError> {
        let torques = distinct(rows.iter().filter_map(|row| row.torque_nm));
        let speeds = distinct(rows.iter().map(|row| row.speed_rpm));
        let nodes = torques.len().max(1) * speeds.len();
        let mut values = vec![f64::NAN; nodes];
        let mut is_single = true;
        for row in rows {
            let i = match row.torque_nm {
                Some(torque) => torques.iter().position(|node| *node == torque),
                None => torques.is_empty().then_some(0),
            };
            let j = speeds.iter().position(|node| *node == row.speed_rpm);
            if let (Some(i), Some(j)) = (i, j) {
                let value = &mut values[i * speeds.len() + j];
                is_single &= value.is_nan() || *value == row.loss_torque_nm;
                *value = row.loss_torque_nm;
            }
        }
        let has_torques = torques.is_empty() || rows.iter().all(|row| row.torque_nm.is_some());
        for j in 0..speeds.len() {
            fill(&mut values, &torques, speeds.len(), j);
        }
        let is_whole = nodes > 0 && is_single && has_torques;
        let missing = values.iter().position(|value| !value.is_finite());
        match missing {
            None if is_whole => Ok(Self {
                torques,
                speeds,
                values,
            }),
            Some(at) if is_whole && !torques.is_empty() => Err(EfficiencyError::hole_in_table(
                torques[at / speeds.len()],
                speeds[at % speeds.len()],
            )),
            _ => Err(no_grid(rows, &torques, &speeds)),
        }
    }

    fn at(&self, torque_nm: f64, speed_rpm: f64) -> Option<f64> {
        let between_speeds = interval(&self.speeds, speed_rpm)?;
        let along = |i: usize| between_speeds.mean(|j| self.values[i * self.speeds.len() + j]);
        if self.torques.is_empty() {
            return Some(along(0));
        }
        Some(interval(&self.torques, torque_nm)?.mean(along))
    }
}

/// Fills nodes without a row at speed `j` of `speeds`, linearly between their neighbours at that speed.
fn fill(values: &mut [f64], torques: &[f64], speeds: usize, j: usize) {
    let stated: Vec<(f64, f64)> = torques
        .iter()
        .enumerate()
        .map(|(i, torque)| (*torque, values[i * speeds + j]))
        .filter(|(_, value)| value.is_finite())
        .collect();
    let own: Vec<f64> = stated.iter().map(|(torque, _)| *torque).collect();
    for (i, torque) in torques.iter().enumerate() {
        let value = &mut values[i * speeds + j];
        if value.is_nan()
            && let Some(between) = interval(&own, *torque)
        {
            *value = between.mean(|k| stated[k].1);
        }
    }
}

fn no_grid(rows: &[LossRow], torques: &[f64], speeds: &[f64]) -> EfficiencyError {
    EfficiencyError::no_grid(rows.len(), torques.len(), speeds.len())
}

/// Interval of the nodes that holds `value`; `None` beyond the nodes.
fn interval(nodes: &[f64], value: f64) -> Option<NodeInterval> {
    NodeInterval::from_nodes(nodes, |node| *node, value).inside()
}
