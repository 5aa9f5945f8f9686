//! Loss torque of bearings, seals and churning, from a user's table.

use std::fmt::Display;
use std::path::Path;

use crate::cycle::LARGEST_TABLE;
use crate::map::Axes;
use asperity::efficiency::EfficiencyError;
use asperity::efficiency::loss_table::LossTable;
use asperity::loss_table::read;
use asperity::profile_io::read::read_table;
use asperity_core::message::Warning;
use asperity_core::{Code, Fault};

/// Loss torque in addition to the mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct AddedLoss {
    /// Name of the table.
    pub name: String,
    /// A doubt about its columns.
    pub warning: Option<Warning>,
    table: LossTable,
}

/// The file is not a valid table.
fn unreadable(error: Fault) -> Fault {
    Fault::from_cause(Code::E101, error).helping(
        "The table has the columns speed_rpm, loss_torque_nm or loss_w and, where the loss depends on them, torque_nm and temperature_c, as a grid; a loss map of VECTO (vtlm) is one.",
    )
}

/// The table does not cover the map.
fn not_covered(name: impl Display, source: EfficiencyError) -> Fault {
    Fault::new(Code::E205, format!("{name}: {source}"))
}

/// The case states losses of its gearbox as well.
pub(crate) fn twice(name: impl Display) -> Fault {
    Fault::new(
        Code::E205,
        format!(
            "{name}: the case of the map already has losses in addition to the mesh; put the table there, as gearbox.loss_table, or omit one"
        ),
    )
}

impl AddedLoss {
    /// Reads the table in a file, as [`AddedLoss::read`].
    ///
    /// # Errors
    /// As [`AddedLoss::read`], and when the file cannot be read.
    pub fn open(file: &Path) -> Result<Self, Fault> {
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        Self::read(&name, &read_table(file, LARGEST_TABLE)?)
    }

    /// Reads a table as [`read`] does.
    ///
    /// # Errors
    /// When the table is not valid, or its rows do not form a grid.
    ///
    /// ```
    /// use asperity_studies::export::AddedLoss;
    /// let text = "speed_rpm,loss_torque_nm\n0,0.1\n1000,0.3\n";
    /// assert!(AddedLoss::read("bearings.csv", text).is_ok());
    /// assert!(AddedLoss::read("bearings.csv", "speed_rpm,loss_torque_nm\n0,-1\n").is_err());
    /// ```
    pub fn read(name: &str, text: &str) -> Result<Self, Fault> {
        let (table, warning) = read(name, text).map_err(unreadable)?;
        Ok(Self {
            name: name.to_owned(),
            warning,
            table,
        })
    }

    /// Loss torque at the nodes of a map at one temperature, by torque \[N m\].
    pub(super) fn at_nodes(&self, axes: &Axes, temperature_c: f64) -> Result<Vec<f64>, Fault> {
        let speeds = &axes.speed_rpm;
        let nodes = axes.torque_nm.iter().flat_map(|torque| {
            let along = speeds.iter();
            along.map(move |speed| (*torque, *speed))
        });
        let values = nodes.map(|(torque, speed)| {
            let loss = self.table.loss_torque(torque, speed, temperature_c);
            loss.map_err(|source| not_covered(&self.name, source))
        });
        values.collect()
    }
}
