//! Rolling friction at a mesh position.

use asperity_tribo_friction::{RollingConditions, rolling_force};

use crate::case::Case;
use crate::error::PositionError;
use crate::formulation;
use crate::friction::hysteresis_force;
use crate::station::Station;

/// Rolling friction force per metre of contact line on one surface \[N/m\], hysteresis of the steel included.
pub(crate) fn rolling(case: &Case, station: &Station) -> Result<f64, PositionError> {
    let film = rolling_force(&RollingConditions {
        entrainment: station.motion.entrainment,
        radius: station.motion.radius,
        load: station.load,
        modulus: case.modulus,
        viscosity: case.oil.dynamic_viscosity,
        pressure_viscosity: case.oil.pressure_viscosity,
        thermal_factor: station.thermal_reduction,
    })?;
    let surfaces = formulation::of(case.formulation).rolling_surfaces();
    Ok(film.si() + hysteresis_force(case, station) / surfaces.count())
}
