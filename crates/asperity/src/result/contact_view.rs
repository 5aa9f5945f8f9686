//! The two flanks of a contact facing each other, as plain data for a picture.

use serde::{Deserialize, Serialize};

/// Both flanks of one contact under load in one frame, with the pressures between them, near the contact.
///
/// Heights count from the mean of the pinion's flank within the half-width, along the common normal towards the
/// wheel; the curvature of each flank is in its heights.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ContactView {
    /// Number of the position from A.
    pub position: usize,
    /// Distance from the middle of the contact, towards the pinion's tip \[µm\].
    pub x_um: Vec<f64>,
    /// Height of the pinion's flank \[µm\].
    pub pinion_um: Vec<f64>,
    /// Height of the wheel's flank \[µm\]; never below the pinion's.
    pub wheel_um: Vec<f64>,
    /// Pressure of touching asperities \[MPa\].
    pub pressure_solid_mpa: Vec<f64>,
    /// Pressure in the film \[MPa\].
    pub pressure_fluid_mpa: Vec<f64>,
}

impl ContactView {
    /// Half-widths of the contact that a view reaches to either side.
    pub const REACH: f64 = 1.5;

    /// Whether the columns have one length; in a damaged file they may not.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        let columns = [
            &self.pinion_um,
            &self.wheel_um,
            &self.pressure_solid_mpa,
            &self.pressure_fluid_mpa,
        ];
        columns.iter().all(|column| column.len() == self.x_um.len())
    }

    /// A view from its columns, of equal length.
    #[must_use]
    pub fn new(position: usize, x_um: Vec<f64>, columns: [Vec<f64>; 4]) -> Self {
        let [pinion_um, wheel_um, pressure_solid_mpa, pressure_fluid_mpa] = columns;
        Self {
            position,
            x_um,
            pinion_um,
            wheel_um,
            pressure_solid_mpa,
            pressure_fluid_mpa,
        }
    }
}
