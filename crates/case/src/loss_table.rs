//! Tables of gearbox losses, as files.

use std::fmt::Display;

use asperity_core::message::Warning;
use asperity_core::{Code, Fault};
use asperity_efficiency::loss_table::{LossRow, LossTable};
use asperity_table::{Row, RowFault, Table};

/// The error of the table `name`.
fn refused(name: &str, reason: impl Display) -> Fault {
    Fault::new(Code::E138, format!("{name}: {reason}"))
}

/// The error of a cell of the table `name`, which is missing or no number.
fn of_cell(name: &str, cell: &RowFault) -> Fault {
    Fault::new(Code::E138, format!("{name}:{cell}"))
}

/// Names of the columns in VECTO's transmission loss maps.
const NAMES: [(&str, &str); 3] = [
    ("speed_rpm", "input_speed_rpm"),
    ("torque_nm", "input_torque_nm"),
    ("loss_torque_nm", "torque_loss_nm"),
];

/// The number of a column, under its own name or its name in [`NAMES`].
fn optional(row: Row<'_>, column: &str) -> Result<Option<f64>, RowFault> {
    let other = NAMES.iter().find(|(name, _)| *name == column);
    match other {
        Some((_, other)) if !row.has(column) => row.optional(other),
        _ => row.optional(column),
    }
}

/// A node of the table. Its loss torque \[N m\] is NaN, which no table has, unless one of torque and power is stated, at a speed
/// above 0.
fn node(row: Row<'_>) -> Result<LossRow, RowFault> {
    let speed_rpm = optional(row, "speed_rpm")?;
    let speed_rpm = speed_rpm.ok_or_else(|| row.fault("speed_rpm", "is missing"))?;
    let loss_torque_nm = match (optional(row, "loss_torque_nm")?, row.optional("loss_w")?) {
        (Some(torque), None) => torque,
        (None, Some(power)) if speed_rpm > 0.0 => power / (speed_rpm * std::f64::consts::PI / 30.0),
        _ => f64::NAN,
    };
    Ok(LossRow {
        torque_nm: optional(row, "torque_nm")?,
        speed_rpm,
        temperature_c: row.optional("temperature_c")?,
        loss_torque_nm,
    })
}

/// Reads a table with the columns `speed_rpm`, `loss_torque_nm` or `loss_w` (with speeds above 0) and, where the loss depends
/// on them, `torque_nm` and `temperature_c`: a grid of nodes, in any order. A transmission loss map of VECTO is such a table.
/// A warning names the columns that were not read.
///
/// # Errors
/// When the text is no such table, or its rows form no grid.
///
/// ```
/// use asperity_case::loss_table::read;
/// let (table, warning) = read("bearings.csv", "speed_rpm,loss_torque_nm\n0,0.1\n1000,0.3\n")?;
/// assert_eq!(warning, None);
/// assert!((table.loss_torque(145.0, 500.0, 90.0)? - 0.2).abs() < 1e-15);
/// assert!(read("bearings.csv", "speed_rpm,loss_torque_nm\n0,-1\n").is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read(name: &str, text: &str) -> Result<(LossTable, Option<Warning>), Fault> {
    let table = Table::read(text).map_err(|ragged| refused(name, ragged))?;
    let there = |column: &str| {
        table.has(column)
            || NAMES
                .iter()
                .any(|(own, other)| *own == column && table.has(other))
    };
    let needed = [["speed_rpm"; 2], ["loss_torque_nm", "loss_w"]];
    let is_lacking = |either: &&[&'static str; 2]| !either.iter().any(|name| there(name));
    if let Some(lacking) = needed.iter().find(is_lacking)
        && table.rows().len() > 0
    {
        let heads: Vec<&str> = table.heads().collect();
        let rule = format!(
            "is missing in the columns {}; write the names speed_rpm, loss_torque_nm or loss_w, and torque_nm and temperature_c if the loss depends on them",
            heads.join(", ")
        );
        let (line, column) = (1, lacking[0].into());
        return Err(of_cell(name, &RowFault { line, column, rule }));
    }
    let rows = table.values(node).map_err(|cell| of_cell(name, &cell))?;
    let losses = LossTable::new(&rows).map_err(|error| refused(name, error))?;
    Ok((losses, table.unread(name)))
}
