//! Load of a law that gives it along the path of contact alone.

use super::rigid::Point;
use crate::pair::GearPair;
use crate::straight;

/// Line loads at rising coordinates; linear between them, constant beyond the first and the last.
#[derive(Debug, Clone)]
pub(crate) struct Along(pub(crate) Vec<(f64, f64)>);

impl Along {
    /// Points on the lines of contact at a phase.
    pub(crate) fn points(&self, pair: &GearPair, phase: f64, marks: &[f64]) -> Vec<Point> {
        let mut points = super::rigid::lines(pair, phase, marks);
        for point in &mut points {
            point.load = straight::along(&self.0, point.xi);
        }
        points
    }
}
