//! Powers of deformation swept over the flanks: elastic work cycled, hysteresis, plastic work of running-in.

use asperity_core::quantity::{Length, LineEnergy, Power};
use asperity_efficiency::LossKind;
use asperity_efficiency::swept::{SweptDeformation, SweptPosition, swept_deformation};

use crate::lubrication::{LubricatedPosition, LubricatedWindow};
use asperity_case::case::Case;
use asperity_case::error::PositionError;
use asperity_case::window_pressures::DeformationPower;

/// Losses by deformation of the mesh at one offset: what is left after contact if the pressures of the windows gave it, as the
/// elastic part in contact is given back, otherwise none.
pub(super) fn deformation_losses(
    positions: &[LubricatedPosition],
    offset: usize,
) -> Vec<(LossKind, Power)> {
    let windows = positions.iter().map(|position| &position.offsets[offset]);
    let powers: Option<Vec<DeformationPower>> = windows.map(|window| window.deformation).collect();
    let Some(powers) = powers else {
        return Vec::new();
    };
    let kinds = [LossKind::DeformationPinion, LossKind::DeformationWheel];
    let of = |body: usize| {
        let powers = powers.iter().map(|power| power.after_contact[body]);
        Power::from_si(powers.sum())
    };
    kinds.into_iter().zip([of(0), of(1)]).collect()
}

/// Powers of deformation with the plastic work of all offsets.
pub(crate) fn of_all_offsets(
    case: &Case,
    positions: &[LubricatedPosition],
) -> Result<SweptDeformation, PositionError> {
    swept(case, positions, |position| {
        let sum: f64 = position.offsets.iter().map(plastic_work).sum();
        sum / position.offsets.len() as f64
    })
}

fn plastic_work(offset: &LubricatedWindow) -> f64 {
    offset.contact.map_or(0.0, |contact| contact.plastic_work)
}

fn swept(
    case: &Case,
    positions: &[LubricatedPosition],
    plastic_work: impl Fn(&LubricatedPosition) -> f64,
) -> Result<SweptDeformation, PositionError> {
    let places: Vec<SweptPosition> = positions
        .iter()
        .map(|position| SweptPosition {
            weight: Length::from_si(position.at.weight),
            load: position.at.load,
            radius: position.at.motion.radius,
            half_width: position.at.hertz.half_width,
            entrainment: position.at.motion.entrainment,
            plastic_work: LineEnergy::from_si(plastic_work(position)),
        })
        .collect();
    Ok(swept_deformation(&places, case.model.hysteresis)?)
}
