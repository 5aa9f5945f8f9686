//! Tables of gearbox losses, as files.

use asperity_efficiency::EfficiencyError;
use asperity_efficiency::loss_table::{LossRow, LossTable};
use serde::Deserialize;

/// Reasons why a file is not a table of losses.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LossTableError {
    /// The table cannot be read.
    #[error("{name}: {source}")]
    Csv {
        /// Name of the table.
        name: String,
        /// Reason given by the reader.
        source: csv::Error,
    },
    /// The rows form no table.
    #[error("{name}: {source}")]
    Rows {
        /// Name of the table.
        name: String,
        /// Reason.
        source: EfficiencyError,
    },
}

#[derive(Deserialize)]
struct Row {
    /// `None` if the loss depends on the speed only.
    torque_nm: Option<f64>,
    speed_rpm: f64,
    temperature_c: Option<f64>,
    loss_torque_nm: Option<f64>,
    /// In place of the torque.
    loss_w: Option<f64>,
}

impl Row {
    /// Loss torque \[N m\]; NaN, which no table has, unless one of torque and power is stated, at a speed above 0.
    fn loss_torque_nm(&self) -> f64 {
        match (self.loss_torque_nm, self.loss_w) {
            (Some(torque), None) => torque,
            (None, Some(power)) if self.speed_rpm > 0.0 => {
                power / (self.speed_rpm * std::f64::consts::PI / 30.0)
            }
            _ => f64::NAN,
        }
    }
}

/// Reads a table with the columns `speed_rpm`, `loss_torque_nm` or `loss_w` (with speeds above 0) and, where the loss depends
/// on them, `torque_nm` and `temperature_c`: a grid of nodes, in any order. Lines that begin with # are comments.
///
/// # Errors
/// When the text is no such table, or its rows form no grid.
///
/// ```
/// use asperity_case::loss_table::read;
/// let table = read("bearings.csv", "speed_rpm,loss_torque_nm\n0,0.1\n1000,0.3\n")?;
/// assert!((table.loss_torque(145.0, 500.0, 90.0)? - 0.2).abs() < 1e-15);
/// assert!(read("bearings.csv", "speed_rpm,loss_torque_nm\n0,-1\n").is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read(name: &str, text: &str) -> Result<LossTable, LossTableError> {
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(text.trim_start_matches('\u{feff}').as_bytes());
    let mut rows = Vec::new();
    for row in reader.deserialize() {
        let row: Row = row.map_err(|source| LossTableError::Csv {
            name: name.to_owned(),
            source,
        })?;
        rows.push(LossRow {
            torque_nm: row.torque_nm,
            speed_rpm: row.speed_rpm,
            temperature_c: row.temperature_c,
            loss_torque_nm: row.loss_torque_nm(),
        });
    }
    LossTable::new(&rows).map_err(|source| LossTableError::Rows {
        name: name.to_owned(),
        source,
    })
}
