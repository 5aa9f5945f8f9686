//! The sampling error of ln loss, whatever it follows from.

use serde::{Deserialize, Serialize};

/// Error of ln loss by the sampling of the flanks: Student's t with a standard error, and a shift of placed traces.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SamplingError {
    /// Standard error; 0 if it is not known.
    pub standard_error: f64,
    /// Its degrees of freedom.
    pub freedom: f64,
    /// Standard deviation by the form of surrogates, which roughness values do not determine.
    pub form: f64,
    /// Changes of ln loss where placed traces are misplaced to either side.
    pub shifts: Option<[f64; 2]>,
}

impl SamplingError {
    /// No error.
    pub const NONE: Self = Self {
        standard_error: 0.0,
        freedom: 4.0,
        form: 0.0,
        shifts: None,
    };

    /// The shift drawn by `place`, 0 to 1: misplaced to one side, to the other, or not, each a third.
    pub fn shift(&self, place: f64) -> f64 {
        match self.shifts {
            Some([down, _]) if place < 1.0 / 3.0 => down,
            Some([_, up]) if place > 2.0 / 3.0 => up,
            _ => 0.0,
        }
    }
}
