//! Losses by deformation: hysteresis of smooth contacts, plastic work of rough ones.

use asperity_core::quantity::{LineEnergy, Power};
use asperity_efficiency::deformation::{engagement_period, hysteresis_power, running_in};

use crate::case::Case;
use crate::error::PositionError;
use crate::position::Position;

/// Plastic work of the first engagement at one offset, as a power.
pub(crate) fn running_in_power(
    case: &Case,
    positions: &[Position],
    offset: usize,
) -> Result<Power, PositionError> {
    let work = mean(positions, |position| {
        position.offsets[offset]
            .contact
            .map_or(0.0, |contact| contact.plastic_work)
    });
    let period = engagement_period(case.gears.teeth[0], case.speed)?;
    let passes = [LineEnergy::from_si(work)];
    let run = running_in(&passes, case.gears.face_width, period)?;
    Ok(run.power.first().copied().unwrap_or_default())
}

/// The part of the elastic energy of smooth contacts that is not given back.
pub(crate) fn hysteresis(case: &Case, positions: &[Position]) -> Result<Power, PositionError> {
    if case.model.hysteresis == 0.0 {
        return Ok(Power::from_si(0.0));
    }
    let mut energies = Vec::with_capacity(positions.len());
    for position in positions {
        let (hertz, radius) = (position.station.hertz, position.station.motion.radius);
        energies.push(hertz.energy_from_edge(radius)?.si());
    }
    let mut energies = energies.into_iter();
    let energy = mean(positions, |_| energies.next().unwrap_or_default());
    let period = engagement_period(case.gears.teeth[0], case.speed)?;
    Ok(hysteresis_power(
        LineEnergy::from_si(energy),
        case.model.hysteresis,
        case.gears.face_width,
        period,
    )?)
}

/// Mean over the path of contact, by weight.
fn mean(positions: &[Position], mut value: impl FnMut(&Position) -> f64) -> f64 {
    let total: f64 = positions
        .iter()
        .map(|position| position.station.weight)
        .sum();
    let sum: f64 = positions
        .iter()
        .map(|position| position.station.weight * value(position))
        .sum();
    sum / total
}
