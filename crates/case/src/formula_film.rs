//! The film of a mesh position by the formulas, without roughness.

use asperity_core::OutOfRange;
use asperity_ehl_regime::{FilmConditions, FilmThickness};

/// Film of smooth flanks at a mesh position, by the film law of a case with its thermal reduction.
#[derive(Debug, Clone)]
pub struct FormulaFilm {
    /// Inputs of the film laws.
    pub conditions: FilmConditions,
    /// Thermal reduction φ of film and rolling.
    pub thermal_reduction: f64,
    /// Film with thermal reduction, as the formulas give it: their central film is one of mass flow.
    pub film: FilmThickness,
    /// The film with the central thickness that Λ* and the tables take.
    pub shown: FilmThickness,
    /// Inputs that left their fitted range.
    pub outside: Vec<OutOfRange>,
}
