//! One mesh position without roughness: motion, load, Hertz contact, smooth film.

use asperity_contact::hertz_line::HertzLine;
use asperity_core::OutOfRange;
use asperity_core::quantity::{Length, LineLoad};
use asperity_ehl_regime::{FilmConditions, FilmThickness};
use asperity_gear::Kinematics;

/// A mesh position: everything that does not depend on the roughness.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Station {
    /// Number of the position from A.
    pub number: usize,
    /// Coordinate along the line of action from T₁.
    pub s: Length,
    /// Weight in the cycle mean \[m of contact line\].
    pub weight: f64,
    /// Radii and speeds.
    pub motion: Kinematics,
    /// Load per length of contact line.
    pub load: LineLoad,
    /// Smooth dry contact.
    pub hertz: HertzLine,
    /// What the film laws see.
    pub film_conditions: FilmConditions,
    /// Thermal reduction φ of film and rolling.
    pub thermal_reduction: f64,
    /// Smooth film with thermal reduction.
    pub film: FilmThickness,
    /// What left its fitted range.
    pub outside: Vec<OutOfRange>,
}
