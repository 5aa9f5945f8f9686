//! Load of a law that gives it along the path of contact alone.

use super::rigid::Point;
use crate::pair::GearPair;

/// Line loads at rising coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Along(pub(crate) Vec<(f64, f64)>);

impl Along {
    /// Linear between the places, constant beyond the first and the last.
    fn at(&self, xi: f64) -> f64 {
        let above = self.0.partition_point(|(place, _)| *place <= xi);
        match (
            above.checked_sub(1).and_then(|k| self.0.get(k)),
            self.0.get(above),
        ) {
            (Some(low), Some(high)) => low.1 + (high.1 - low.1) * (xi - low.0) / (high.0 - low.0),
            (Some(end), None) | (None, Some(end)) => end.1,
            (None, None) => 0.0,
        }
    }

    /// Points on the lines of contact at a phase.
    pub(crate) fn points(&self, pair: &GearPair, phase: f64, marks: &[f64]) -> Vec<Point> {
        let mut points = super::rigid::lines(pair, phase, marks);
        for point in &mut points {
            point.load = self.at(point.xi);
        }
        points
    }
}
