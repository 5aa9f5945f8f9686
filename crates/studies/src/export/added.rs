//! Loss torque of bearings, seals and churning, from a user's table.

use asperity::efficiency::EfficiencyError;
use asperity::efficiency::loss_table::LossTable;
use asperity::loss_table::{LossTableError, read};

use crate::map::Axes;

/// Loss torque in addition to the mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct AddedLoss {
    /// Name of the table.
    pub name: String,
    table: LossTable,
}

/// Error of an added loss.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AddedLossError {
    /// The file is not a valid table.
    #[error(transparent)]
    Table(#[from] LossTableError),
    /// The table does not cover the map.
    #[error("{name}: {source}")]
    NotCovered {
        /// Name of the table.
        name: String,
        /// The point that is not covered.
        source: EfficiencyError,
    },
    /// The case states losses of its gearbox as well.
    #[error(
        "{name}: the case of the map already has losses besides the mesh; put the table there, as gearbox.loss_table, or omit one"
    )]
    Twice {
        /// Name of the table.
        name: String,
    },
}

impl AddedLoss {
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
    pub fn read(name: &str, text: &str) -> Result<Self, AddedLossError> {
        Ok(Self {
            name: name.to_owned(),
            table: read(name, text)?,
        })
    }

    /// Loss torque at the nodes of a map at one temperature, by torque \[N m\].
    pub(super) fn at_nodes(
        &self,
        axes: &Axes,
        temperature_c: f64,
    ) -> Result<Vec<f64>, AddedLossError> {
        let speeds = &axes.speed_rpm;
        let nodes = axes.torque_nm.iter().flat_map(|torque| {
            let along = speeds.iter();
            along.map(move |speed| (*torque, *speed))
        });
        let values = nodes.map(|(torque, speed)| {
            let loss = self.table.loss_torque(torque, speed, temperature_c);
            loss.map_err(|source| AddedLossError::NotCovered {
                name: self.name.clone(),
                source,
            })
        });
        values.collect()
    }
}
