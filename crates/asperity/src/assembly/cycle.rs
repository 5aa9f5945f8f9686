//! From positions to losses: cycle means at each offset, then mean and spread over the offsets.

use asperity_core::quantity::{Length, LineLoad};
use asperity_efficiency::{
    LossKind, MeshEfficiency, MeshOperation, PositionLoss, mesh_efficiency, mesh_loss,
};

use super::deformation_losses::deformation_losses;
use crate::lubrication::LubricatedPosition;
use asperity_case::case::Case;
use asperity_case::error::PositionError;

/// Efficiency of the mesh with all flanks at one offset.
pub(crate) fn efficiency_at(
    case: &Case,
    positions: &[LubricatedPosition],
    rolling: &[f64],
    offset: usize,
    force: impl Fn(&LubricatedPosition, usize) -> f64,
) -> Result<MeshEfficiency, PositionError> {
    let places: Vec<PositionLoss> = positions
        .iter()
        .zip(rolling)
        .map(|(position, &rolling)| PositionLoss {
            weight: Length::from_si(position.at.weight),
            // Scaled so that force times speed is the mean over the contact line of the position.
            sliding_force: LineLoad::from_si(force(position, offset) * position.at.sliding_factor),
            sliding_speed: position.at.motion.sliding,
            rolling_force: LineLoad::from_si(rolling),
            entrainment_speed: position.at.motion.entrainment,
        })
        .collect();
    let loss = mesh_loss(&places, case.formulation.rolling_surfaces())?;
    let mut losses = vec![
        (LossKind::Sliding, loss.sliding),
        (LossKind::Rolling, loss.rolling),
    ];
    losses.extend(deformation_losses(positions, offset));
    Ok(mesh_efficiency(&operation(case), &losses)?)
}

/// Operating point of the mesh.
pub(crate) fn operation(case: &Case) -> MeshOperation {
    MeshOperation {
        pinion_torque: case.torque,
        pinion_speed: case.speed,
        teeth: case.gears.teeth,
    }
}
