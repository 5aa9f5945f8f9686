//! Loss torque of bearings, seals and churning, from a table of the user's.

use asperity::efficiency::EfficiencyError;
use asperity::efficiency::loss_table::LossTable;
use asperity::loss_table::{LossTableError, read};

use crate::map::Axes;

/// Loss torque beside that of the mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct AddedLoss {
    /// Name of the table.
    pub name: String,
    table: LossTable,
}

/// Why a table is no added loss.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AddedLossError {
    /// The file is no table.
    #[error(transparent)]
    Table(#[from] LossTableError),
    /// The map reaches beyond the table.
    #[error("{name}: {source}")]
    NotCovered {
        /// Name of the table.
        name: String,
        /// The place that it does not have.
        source: EfficiencyError,
    },
    /// The case states losses of its gearbox as well.
    #[error(
        "{name}: the case of the map has losses beside the mesh already; put the table there, as gearbox.loss_table, or leave one out"
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
    /// When the table is none, or its rows form no grid.
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

    /// The loss torque at the nodes of a map at one temperature, torque by torque \[N m\].
    pub(super) fn at_nodes(
        &self,
        axes: &Axes,
        temperature_c: f64,
    ) -> Result<Vec<f64>, AddedLossError> {
        let speeds = &axes.speed_rpm;
        let places = axes.torque_nm.iter().flat_map(|torque| {
            let along = speeds.iter();
            along.map(move |speed| (*torque, *speed))
        });
        let values = places.map(|(torque, speed)| {
            let found = self.table.loss_torque(torque, speed, temperature_c);
            found.map_err(|source| AddedLossError::NotCovered {
                name: self.name.clone(),
                source,
            })
        });
        values.collect()
    }
}
