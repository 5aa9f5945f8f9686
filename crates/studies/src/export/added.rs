//! Loss torque of bearings, seals and churning, from a table of the user's.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::map::{Axes, Surface};

/// Loss torque beside that of the mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct AddedLoss {
    /// Name of the table.
    pub name: String,
    /// Surfaces by temperature \[°C\]; one alone holds for every temperature.
    by_temperature: Vec<(f64, Surface)>,
}

/// Why a table is no added loss.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AddedLossError {
    /// The table cannot be read.
    #[error("{name}: {source}")]
    Csv {
        /// Name of the table.
        name: String,
        /// Reason given by the reader.
        source: csv::Error,
    },
    /// Rows that do not form a grid of torques and speeds.
    #[error("{name}: {rows} rows are no grid of {torques} torques and {speeds} speeds")]
    NoGrid {
        /// Name of the table.
        name: String,
        /// Rows at one temperature.
        rows: usize,
        /// Different torques among them.
        torques: usize,
        /// Different speeds among them.
        speeds: usize,
    },
    /// A loss that is negative or no number.
    #[error("{name}: loss_torque_nm {value} must be zero or more")]
    Negative {
        /// Name of the table.
        name: String,
        /// The value.
        value: f64,
    },
    /// The map reaches beyond the table.
    #[error(
        "{name}: has no loss at {torque_nm} N m, {speed_rpm} 1/min, {temperature_c} °C, which the map has"
    )]
    NotCovered {
        /// Name of the table.
        name: String,
        /// Torque \[N m\].
        torque_nm: f64,
        /// Speed \[1/min\].
        speed_rpm: f64,
        /// Temperature \[°C\].
        temperature_c: f64,
    },
}

#[derive(Deserialize)]
struct Row {
    /// None where the loss depends on the speed alone.
    torque_nm: Option<f64>,
    speed_rpm: f64,
    temperature_c: Option<f64>,
    loss_torque_nm: f64,
}

impl AddedLoss {
    /// Reads a table with the columns `speed_rpm`, `loss_torque_nm` and, where the loss depends on them,
    /// `torque_nm` and `temperature_c`: a grid of nodes, in any order.
    ///
    /// # Errors
    /// When the table is none, or its rows form no grid.
    ///
    /// ```
    /// use asperity_studies::export::AddedLoss;
    /// let text = "speed_rpm,loss_torque_nm\n0,0.1\n1000,0.3\n";
    /// assert!(AddedLoss::read("bearings.csv", text).is_ok());
    /// assert!(AddedLoss::read("bearings.csv", "speed_rpm,loss_torque_nm\n0,-1\n").is_err());
    /// ```
    pub fn read(name: &str, text: &str) -> Result<Self, AddedLossError> {
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(text.trim_start_matches('\u{feff}').as_bytes());
        let mut rows: BTreeMap<u64, (f64, Vec<Row>)> = BTreeMap::new();
        for row in reader.deserialize() {
            let row: Row = row.map_err(|source| AddedLossError::Csv {
                name: name.to_owned(),
                source,
            })?;
            if !(row.loss_torque_nm.is_finite() && row.loss_torque_nm >= 0.0) {
                return Err(AddedLossError::Negative {
                    name: name.to_owned(),
                    value: row.loss_torque_nm,
                });
            }
            let temperature = row.temperature_c.unwrap_or(f64::NAN);
            let key = temperature.to_bits();
            rows.entry(key)
                .or_insert((temperature, Vec::new()))
                .1
                .push(row);
        }
        let surfaces = rows
            .into_values()
            .map(|(temperature, rows)| Ok((temperature, surface(name, &rows)?)));
        let mut by_temperature = surfaces.collect::<Result<Vec<_>, AddedLossError>>()?;
        by_temperature.sort_by(|a, b| a.0.total_cmp(&b.0));
        Ok(Self {
            name: name.to_owned(),
            by_temperature,
        })
    }

    /// The loss torque at the nodes of a map at one temperature, torque by torque \[N m\].
    pub(super) fn at_nodes(
        &self,
        axes: &Axes,
        temperature_c: f64,
    ) -> Result<Vec<f64>, AddedLossError> {
        let missing = |torque_nm: f64, speed_rpm: f64| AddedLossError::NotCovered {
            name: self.name.clone(),
            torque_nm,
            speed_rpm,
            temperature_c,
        };
        let origin = || missing(axes.torque_nm[0], axes.speed_rpm[0]);
        let (low, high, share) = self.between(temperature_c).ok_or_else(origin)?;
        let mut values = Vec::with_capacity(axes.torque_nm.len() * axes.speed_rpm.len());
        for &torque in &axes.torque_nm {
            for &speed in &axes.speed_rpm {
                let of = |surface: &Surface| {
                    let found = surface.loss_torque(torque, speed);
                    (!found.is_outside).then_some(found.value)
                };
                let (a, b) = of(low)
                    .zip(of(high))
                    .ok_or_else(|| missing(torque, speed))?;
                values.push(a + share * (b - a));
            }
        }
        Ok(values)
    }

    /// The surfaces beside a temperature, and how far it is from the first to the second.
    fn between(&self, temperature_c: f64) -> Option<(&Surface, &Surface, f64)> {
        if let [(only, surface)] = self.by_temperature.as_slice() {
            let holds = only.is_nan() || *only == temperature_c;
            return holds.then_some((surface, surface, 0.0));
        }
        let pairs = self.by_temperature.windows(2);
        for pair in pairs {
            let [(low, first), (high, second)] = pair else {
                continue;
            };
            if (*low..=*high).contains(&temperature_c) {
                return Some((first, second, (temperature_c - low) / (high - low)));
            }
        }
        None
    }
}

/// The rows of one temperature as a grid. Without torques the loss holds for all of them.
fn surface(name: &str, rows: &[Row]) -> Result<Surface, AddedLossError> {
    let rising = |values: &mut dyn Iterator<Item = f64>| {
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    };
    let torques = rising(&mut rows.iter().filter_map(|row| row.torque_nm));
    let speeds = rising(&mut rows.iter().map(|row| row.speed_rpm));
    let mut grid: BTreeMap<(usize, usize), f64> = BTreeMap::new();
    for row in rows {
        let i = row.torque_nm.map_or(Some(0), |torque| {
            torques.iter().position(|node| *node == torque)
        });
        let j = speeds.iter().position(|node| *node == row.speed_rpm);
        if let (Some(i), Some(j)) = (i, j) {
            grid.insert((i, j), row.loss_torque_nm);
        }
    }
    let nodes = torques.len().max(1) * speeds.len();
    if grid.len() != nodes || rows.len() != nodes || speeds.is_empty() {
        return Err(AddedLossError::NoGrid {
            name: name.to_owned(),
            rows: rows.len(),
            torques: torques.len(),
            speeds: speeds.len(),
        });
    }
    let mut values: Vec<f64> = grid.into_values().collect();
    let mut torque_nm = torques;
    if torque_nm.is_empty() {
        /// Beyond every torque \[N m\].
        const BEYOND: f64 = 1e12;
        torque_nm = vec![-BEYOND, BEYOND];
        values.extend_from_within(..);
    }
    Ok(Surface {
        torque_nm,
        speed_rpm: speeds,
        deviation_nm: vec![0.0; values.len()],
        loss_torque_nm: values,
    })
}
