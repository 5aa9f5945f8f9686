//! From positions to losses: cycle means at each offset, then mean and spread over the offsets.

use asperity_core::quantity::{Length, LineEnergy, LineLoad, Power};
use asperity_efficiency::deformation::{
    elastic_energy, engagement_period, hysteresis_power, running_in,
};
use asperity_efficiency::{
    LossKind, MeshEfficiency, MeshOperation, PositionLoss, RollingSurfaces, mesh_efficiency,
    mesh_loss,
};

use crate::case::{Case, Formulation};
use crate::error::PositionError;
use crate::position::Position;

/// Efficiency of the mesh with all flanks at one offset.
pub(crate) fn efficiency_at(
    case: &Case,
    positions: &[Position],
    rolling: &[f64],
    offset: usize,
    force: impl Fn(&Position, usize) -> f64,
) -> Result<MeshEfficiency, PositionError> {
    let places: Vec<PositionLoss> = positions
        .iter()
        .zip(rolling)
        .map(|(position, &rolling)| PositionLoss {
            weight: Length::from_si(position.station.weight),
            sliding_force: LineLoad::from_si(force(position, offset)),
            sliding_speed: position.station.motion.sliding,
            rolling_force: LineLoad::from_si(rolling),
            entrainment_speed: position.station.motion.entrainment,
        })
        .collect();
    let paper = case.formulation == Formulation::Paper;
    let surfaces = if paper {
        RollingSurfaces::One
    } else {
        RollingSurfaces::Both
    };
    let loss = mesh_loss(&places, surfaces)?;
    let mut losses = vec![
        (LossKind::Sliding, loss.sliding),
        (LossKind::Rolling, loss.rolling),
    ];
    if paper {
        for (body, kind) in [LossKind::DeformationPinion, LossKind::DeformationWheel]
            .into_iter()
            .enumerate()
        {
            let power = positions
                .iter()
                .map(|position| position.offsets[offset].deformation[body])
                .sum();
            losses.push((kind, Power::from_si(power)));
        }
    } else {
        losses.push((LossKind::Hysteresis, hysteresis(case, positions)?));
        losses.push((
            LossKind::RunningIn,
            running_in_power(case, positions, offset)?,
        ));
    }
    Ok(mesh_efficiency(
        &operation(case),
        &losses,
        case.model.include_running_in,
    )?)
}

/// What the mesh runs at.
pub(crate) fn operation(case: &Case) -> MeshOperation {
    MeshOperation {
        pinion_torque: case.torque,
        pinion_speed: case.speed,
        teeth: case.gears.teeth,
    }
}

/// Plastic work of the first engagement at one offset, as a power.
fn running_in_power(
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
fn hysteresis(case: &Case, positions: &[Position]) -> Result<Power, PositionError> {
    /// Points across a Hertz contact for its energy; the sum is within 1e-4 of the integral.
    const POINTS: usize = 400;
    if case.model.hysteresis == 0.0 {
        return Ok(Power::from_si(0.0));
    }
    let mut energies = Vec::with_capacity(positions.len());
    for position in positions {
        let hertz = position.station.hertz;
        let (a, p0) = (hertz.half_width.si(), hertz.max_pressure.si());
        let r = position.station.motion.radius.si();
        let dx = 2.0 * a / POINTS as f64;
        let inside = (0..POINTS).map(|i| {
            let x = (i as f64 + 0.5) * dx - a;
            (a * a - x * x).max(0.0)
        });
        let pressure: Vec<f64> = inside.clone().map(|d| p0 * d.sqrt() / a).collect();
        let approach: Vec<f64> = inside.map(|d| d / (2.0 * r)).collect();
        energies.push(elastic_energy(&pressure, &approach, Length::from_si(dx))?.si());
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
