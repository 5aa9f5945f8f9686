//! Powers of deformation swept over the flanks: elastic work cycled, hysteresis, plastic work of running-in.

use asperity_core::quantity::{Length, LineEnergy, Power};
use asperity_efficiency::swept::{SweptDeformation, SweptPosition, swept_deformation};

use crate::case::Case;
use crate::error::PositionError;
use crate::position::{Offset, Position};

/// Plastic work of the first engagement at one offset, as a power.
pub(crate) fn running_in_power(
    case: &Case,
    positions: &[Position],
    offset: usize,
) -> Result<Power, PositionError> {
    let swept = swept(case, positions, |position| {
        position.offsets.get(offset).map_or(0.0, plastic_work)
    })?;
    Ok(swept.plastic)
}

/// Powers of deformation with the plastic work of all offsets.
pub(crate) fn of_all_offsets(
    case: &Case,
    positions: &[Position],
) -> Result<SweptDeformation, PositionError> {
    swept(case, positions, |position| {
        let sum: f64 = position.offsets.iter().map(plastic_work).sum();
        sum / position.offsets.len() as f64
    })
}

fn plastic_work(offset: &Offset) -> f64 {
    offset.contact.map_or(0.0, |contact| contact.plastic_work)
}

fn swept(
    case: &Case,
    positions: &[Position],
    plastic_work: impl Fn(&Position) -> f64,
) -> Result<SweptDeformation, PositionError> {
    let places: Vec<SweptPosition> = positions
        .iter()
        .map(|position| SweptPosition {
            weight: Length::from_si(position.station.weight),
            load: position.station.load,
            radius: position.station.motion.radius,
            half_width: position.station.hertz.half_width,
            entrainment: position.station.motion.entrainment,
            plastic_work: LineEnergy::from_si(plastic_work(position)),
        })
        .collect();
    Ok(swept_deformation(&places, case.model.hysteresis)?)
}
