//! One mesh position without roughness: motion, load, Hertz contact, smooth film.

use asperity_contact::hertz_line::HertzLine;
use asperity_core::OutOfRange;
use asperity_core::quantity::{Length, LineLoad};
use asperity_ehl_regime::{FilmConditions, FilmThickness, thermal_loading};
use asperity_gear::Kinematics;

use crate::case::Case;
use crate::error::PositionError;

/// A mesh position: everything that does not depend on the roughness.
#[derive(Debug, Clone)]
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

impl Station {
    /// The position at `s` with its weight in the cycle mean.
    ///
    /// # Errors
    /// When an equation refuses the numbers at this position.
    pub fn new(case: &Case, number: usize, s: Length, weight: f64) -> Result<Self, PositionError> {
        let motion = case.gears.kinematics(s, case.speed)?;
        let load = case
            .gears
            .line_load(s, case.torque, &case.model.load_sharing)?;
        let hertz = HertzLine::new(load, motion.radius, case.modulus)?;
        let film_conditions = FilmConditions {
            entrainment: motion.entrainment,
            radius: motion.radius,
            load,
            modulus: case.modulus,
            viscosity: case.oil.dynamic_viscosity,
            pressure_viscosity: case.oil.pressure_viscosity,
            contact_length: Some(case.gears.face_width),
        };
        let smooth = case.model.film.film(&film_conditions)?;
        let loading = thermal_loading(
            case.oil.dynamic_viscosity,
            case.oil.temperature_coefficient,
            motion.entrainment,
            case.oil.thermal_conductivity,
        )?;
        let reduction = case.model.thermal.reduction(
            hertz.max_pressure,
            case.modulus,
            loading,
            motion.slide_to_roll,
        )?;
        let mut outside = smooth.outside;
        outside.extend(reduction.outside);
        Ok(Self {
            number,
            s,
            weight,
            motion,
            load,
            hertz,
            film_conditions,
            thermal_reduction: reduction.value,
            film: smooth.value.reduced(reduction.value),
            outside,
        })
    }
}
