//! Line load of a user-defined law, tabulated along the path of contact.

use asperity_core::numerics::interpolate;

use super::rigid::LinePoint;
use crate::pair::GearPair;

/// Line loads at ascending coordinates, with linear interpolation, constant beyond the first and the last.
#[derive(Debug, Clone)]
pub(crate) struct LineLoadTable(pub(crate) Vec<(f64, f64)>);

impl LineLoadTable {
    /// Points on the lines of contact at a phase.
    pub(crate) fn points(&self, pair: &GearPair, phase: f64, marks: &[f64]) -> Vec<LinePoint> {
        let mut points = super::rigid::lines(pair, phase, marks);
        for point in &mut points {
            point.load = interpolate(&self.0, point.xi);
        }
        points
    }
}
