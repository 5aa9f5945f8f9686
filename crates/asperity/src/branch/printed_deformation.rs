//! Deformation loss in the paper's reading.

use asperity_core::quantity::{Length, Pressure, Time};
use asperity_efficiency::deformation::printed_deformation_power;

use super::bodies::Bodies;
use super::carried::Carried;
use crate::case::Case;
use crate::encounter::Encounter;
use crate::error::PositionError;
use crate::station::Station;

/// Deformation loss as the paper prints it, per surface [W]: stress times displacement times the
/// square of a cell over the time of a revolution, summed over the cells. In contact the elastic and
/// plastic displacement counts, after contact the plastic one again.
pub(crate) fn printed_deformation(
    case: &Case,
    station: &Station,
    encounter: &Encounter,
    carried: &Carried,
) -> Result<[f64; 2], PositionError> {
    let revolution = Time::from_si(2.0 * std::f64::consts::PI / case.speed.si());
    let n = encounter.x.len();
    let bodies = match &carried.solids {
        Some(solids) => Bodies::new(case, solids)?.measured_from_edge(&solids.pressure),
        None => Bodies::hertz(case, station, &encounter.x)?,
    };
    let mut powers = [0.0; 2];
    for (body, power) in powers.iter_mut().enumerate() {
        for i in 0..n {
            let solid = carried.solids.as_ref().map_or(0.0, |s| s.pressure[i]);
            let stress = Pressure::from_si(solid + carried.fluid[i].max(0.0));
            let (elastic, plastic) = (bodies.elastic[body][i], bodies.plastic[body][i]);
            for displacement in [elastic + plastic, plastic] {
                *power += printed_deformation_power(
                    stress,
                    Length::from_si(displacement),
                    encounter.spacing,
                    revolution,
                )?
                .si();
            }
        }
    }
    Ok(powers)
}
