//! Rolling friction at a mesh position.

use asperity_tribo_friction::rolling_force;

use super::friction::hysteresis_force;
use crate::mesh::MeshPosition;
use asperity_case::case::OperatingCase;
use asperity_case::error::PositionError;
use asperity_case::formula_film::FormulaFilm;

/// Rolling friction force per metre of contact line on one surface \[N/m\], hysteresis of the steel included.
pub(crate) fn rolling(
    case: &OperatingCase,
    position: &MeshPosition,
    film: &FormulaFilm,
) -> Result<f64, PositionError> {
    let resistance = rolling_force(
        &position.line_contact(case.modulus, case.materials),
        case.oil().dynamic_viscosity,
        case.oil().pressure_viscosity,
        film.thermal_reduction,
    )?;
    let surfaces = case.formulation.rolling_surfaces();
    Ok(resistance.si() + hysteresis_force(case, position) / surfaces.count())
}
