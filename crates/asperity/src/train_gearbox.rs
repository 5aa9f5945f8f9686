//! Losses of seals and bearings on the shafts of a gear train.
//!
//! The bearings carry the forces of all teeth on their shaft, without friction of the teeth and without weights.

use asperity_core::quantity::{AngularSpeed, Power, Temperature, Torque};
use asperity_efficiency::shaft_seal::seal_torque;
use asperity_gear::gear_train::TrainTorques;
use asperity_gear::shaft_statics::{BearingLoad, ShaftForce, bearing_loads};

use crate::case::gear_train::LoadedTrain;
use crate::case::{Hand, MeshLoad, MeshPlace, TrainFlow, TrainGearbox, TrainPartKind};
use crate::error::PositionError;
use crate::result::gearbox::{GearboxPart, GearboxReport};

/// The losses of all parts at an operating point of the input shaft, at the torques by the tooth numbers and a temperature of
/// the operation; none without parts.
///
/// # Errors
/// When a speed or torque does not follow, or the oil has no state at the temperature.
pub fn parts(
    train: &LoadedTrain,
    at: MeshLoad,
    temperature: Temperature,
) -> Result<Vec<GearboxPart>, PositionError> {
    let Some(gearbox) = &train.gearbox else {
        return Ok(Vec::new());
    };
    let shafts = train.train.at(at).shafts;
    let speeds = shafts.speeds()?;
    let torques = shafts.torques(&speeds, &[])?;
    let found = of_parts(train, gearbox, (&speeds, &torques), temperature)?;
    Ok(found.into_iter().map(|(_, part)| part).collect())
}

/// The parts with the shaft of each.
fn of_parts(
    train: &LoadedTrain,
    gearbox: &TrainGearbox,
    (speeds, torques): (&[AngularSpeed], &TrainTorques),
    temperature: Temperature,
) -> Result<Vec<(usize, GearboxPart)>, PositionError> {
    let temperature = gearbox.temperature.unwrap_or(temperature);
    let mut found = Vec::with_capacity(gearbox.parts.len());
    for part in &gearbox.parts {
        let speed = AngularSpeed::from_si(speeds[part.shaft].si().abs());
        let loss = match &part.kind {
            // A shaft that does not turn loses nothing.
            _ if speed.si() == 0.0 => (Torque::from_si(0.0), Vec::new()),
            TrainPartKind::Seal(diameter) => (seal_torque(*diameter)?, Vec::new()),
            TrainPartKind::Bearing {
                bearing,
                places,
                number,
                locating,
            } => {
                let forces = forces(train, gearbox, part.shaft, torques)?;
                let BearingLoad { radial, axial } =
                    bearing_loads(*places, *locating, &forces)?[*number];
                let first = train.meshes().next().ok_or(PositionError::NoProfile)?;
                let oil = first.case.case.lubricant.at(temperature)?.value;
                let torque = bearing.torque([radial, axial], speed, oil.kinematic_viscosity)?;
                (torque.value.total(), torque.outside)
            }
        };
        let (kind, law) = match part.kind {
            TrainPartKind::Seal(_) => ("seal", "ISO/TR 14179-2, as quoted"),
            TrainPartKind::Bearing { .. } => ("bearing", "SKF's form"),
        };
        let (torque, outside) = loss;
        let of_part = GearboxPart::new(&part.name, (kind, law), (torque, speed), &outside);
        found.push((part.shaft, of_part));
    }
    Ok(found)
}

/// Forces of all teeth on a shaft.
fn forces(
    train: &LoadedTrain,
    gearbox: &TrainGearbox,
    shaft: usize,
    torques: &TrainTorques,
) -> Result<Vec<ShaftForce>, PositionError> {
    let mut forces = Vec::new();
    for (stage, place) in train.train.shafts.places_of(shaft) {
        let mesh = train.stages[stage].meshes.first();
        let gears = &mesh.ok_or(PositionError::NoProfile)?.case.case.gears;
        let MeshPlace {
            at,
            angle,
            hand,
            is_set,
            ..
        } = gearbox.places[stage];
        // Without need of a place it does not matter.
        let at = (at.unwrap_or_default(), angle.unwrap_or_default());
        let [torque, _, _] = torques.stages[stage];
        let of_gears = gears.shaft_forces(torque, at, hand == Some(Hand::Left))?;
        let balanced = |on: ShaftForce| ShaftForce {
            force: [0.0, 0.0, on.force[2]],
            arm: [0.0; 2],
            ..on
        };
        match (place, is_set) {
            (0 | 1, false) => forces.push(of_gears[place]),
            // The planets hold the radial forces of sun and ring in balance, and none of theirs reaches the carrier.
            (0 | 1, true) => forces.push(balanced(of_gears[place])),
            _ => {}
        }
    }
    Ok(forces)
}

/// The gearbox of a train with its meshes, and the flow of its powers.
pub(crate) fn report(
    train: &LoadedTrain,
    flow: &TrainFlow,
    losses: &[Vec<Power>],
    meshes_w: f64,
) -> Result<Option<(GearboxReport, TrainFlow)>, PositionError> {
    let Some(gearbox) = &train.gearbox else {
        return Ok(None);
    };
    let first = train.meshes().next().ok_or(PositionError::NoProfile)?;
    let temperature = crate::result::gearbox::oil_temperature(&first.case.case);
    let by_teeth;
    let torques = match train.train.passes_losses {
        true => &flow.torques,
        false => {
            by_teeth = train.train.shafts.torques(&flow.speeds, &[])?;
            &by_teeth
        }
    };
    let found = of_parts(train, gearbox, (&flow.speeds, torques), temperature)?;
    let mut drags = vec![Torque::from_si(0.0); flow.speeds.len()];
    for (shaft, part) in &found {
        let against = part.torque_nm * flow.speeds[*shaft].si().signum();
        drags[*shaft] = drags[*shaft] + Torque::from_si(against);
    }
    let flow = train.train.with_drags(&drags).flow(losses)?;
    let parts: Vec<GearboxPart> = found.into_iter().map(|(_, part)| part).collect();
    let parts_w: f64 = parts.iter().map(|part| part.loss_w).sum();
    let power_in_w = flow.power_in().si();
    let report = GearboxReport {
        efficiency: 1.0 - (meshes_w + parts_w) / power_in_w,
        loss_w: meshes_w + parts_w,
        parts_w,
        power_in_w,
        temperature_c: gearbox.temperature.unwrap_or(temperature).celsius(),
        parts,
    };
    Ok(Some((report, flow)))
}
