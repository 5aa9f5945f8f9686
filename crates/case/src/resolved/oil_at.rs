//! The oil of a case at a temperature.

use asperity_core::OutOfRange;
use asperity_oil::{FilmRheology, LubricantState};

/// The oil of a case at a temperature.
#[derive(Debug, Clone)]
pub(crate) struct OilAtTemperature {
    pub state: LubricantState,
    /// The oil in the film, if film friction or load share use it.
    pub rheology: Option<FilmRheology>,
    /// Properties outside the range of their laws.
    pub notes: Vec<OutOfRange>,
}
