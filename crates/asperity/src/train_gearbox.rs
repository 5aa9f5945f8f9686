//! Losses of seals, bearings, oil jets and tables on the shafts of a gear train.
//!
//! The bearings carry the forces of all teeth on their shaft, without friction of the teeth and without weights.

use asperity_core::quantity::{AngularSpeed, Force, Power, Temperature, Torque};
use asperity_efficiency::shaft_seal::seal_torque;
use asperity_gear::gear_train::TrainTorques;
use asperity_gear::planetary::{PlanetaryOperation, PlanetarySet, PlanetarySpeeds};
use asperity_gear::shaft_statics::{BearingLoad, ShaftForce, bearing_loads};

use crate::result::gearbox::{
    GearboxPart, GearboxReport, JET_LAW, OperatingPoint, TABLE_LAW, jet_torque, table_torque,
};
use asperity_case::case::gear_train::LoadedTrain;
use asperity_case::case::{
    Hand, MeshLoad, MeshPlace, StageKind, TrainFlow, TrainGearbox, TrainPartKind,
};
use asperity_case::error::PositionError;

/// The losses of all parts at an operating point of the input shaft and a temperature of the operation, with the loss of one
/// mesh of each kind in each stage, which matter if the train passes them on; none without parts.
///
/// # Errors
/// When a speed or torque does not follow, or the oil has no state at the temperature.
pub fn parts(
    train: &LoadedTrain,
    at: MeshLoad,
    temperature: Temperature,
    losses: &[Vec<Power>],
) -> Result<Vec<GearboxPart>, PositionError> {
    let Some(gearbox) = &train.gearbox else {
        return Ok(Vec::new());
    };
    let there = train.train.at(at);
    let speeds = there.shafts.speeds()?;
    let torques = there.loading_torques(&speeds, losses)?;
    let found = of_parts(
        train,
        gearbox,
        (&speeds, &torques),
        (at.torque, temperature),
    )?;
    Ok(found.into_iter().map(|(_, part)| part).collect())
}

/// Shafts from which a part takes its torque, each with its share of the torque.
type Drags = Vec<(usize, f64)>;

/// The parts, at a torque and a temperature of the operation, with the shafts of each.
fn of_parts(
    train: &LoadedTrain,
    gearbox: &TrainGearbox,
    (speeds, torques): (&[AngularSpeed], &TrainTorques),
    (torque, temperature): (Torque, Temperature),
) -> Result<Vec<(Drags, GearboxPart)>, PositionError> {
    let temperature = gearbox.temperature.unwrap_or(temperature);
    let mut found = Vec::with_capacity(gearbox.parts.len());
    for part in &gearbox.parts {
        let named = |source: PositionError| PositionError::GearboxPart {
            part: part.name.clone(),
            source: Box::new(source),
        };
        let speed_of = |shaft: usize| speeds[shaft].si();
        // The torque of a part acts between two shafts, or a shaft and the housing.
        let (relative, shafts) = match part.kind {
            TrainPartKind::Table {
                against: Some(other),
                ..
            } => (
                speed_of(part.shaft) - speed_of(other),
                vec![(part.shaft, 1.0), (other, -1.0)],
            ),
            TrainPartKind::PlanetBearing { stage, .. } => {
                let turns = planet(train, stage, (speeds, torques))?.1;
                // ω_p − ω_c = −(ω_s − ω_c) z_s/z_p.
                (turns.planet_relative.si(), planet_shafts(train, stage))
            }
            _ => (speed_of(part.shaft), vec![(part.shaft, 1.0)]),
        };
        let speed = AngularSpeed::from_si(relative.abs());
        let at = OperatingPoint {
            torque,
            speed,
            temperature,
        };
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
                let first = train
                    .meshes()
                    .next()
                    .ok_or_else(PositionError::no_profile)?;
                let oil = first.case.case.lubricant.at(temperature)?.value;
                let torque = bearing.torque([radial, axial], speed, oil.kinematic_viscosity)?;
                (torque.value.total(), torque.outside)
            }
            TrainPartKind::PlanetBearing {
                stage,
                bearing,
                mass,
                per_planet,
            } => {
                let (set, _, operation) = planet(train, *stage, (speeds, torques))?;
                let load = set.planet_load(&operation, *mass)? / f64::from(*per_planet);
                let first = train
                    .meshes()
                    .next()
                    .ok_or_else(PositionError::no_profile)?;
                let oil = first.case.case.lubricant.at(temperature)?.value;
                let none = Force::from_si(0.0);
                let torque = bearing.torque([load, none], speed, oil.kinematic_viscosity)?;
                let count = f64::from(set.planets * per_planet);
                (torque.value.total() * count, torque.outside)
            }
            TrainPartKind::Jet { stage, flow, speed } => {
                let gears = train.stages[*stage].meshes.first();
                let case = &gears.ok_or_else(PositionError::no_profile)?.case.case;
                let torque = jet_torque(case, (*flow, *speed), &at).map_err(named)?;
                (torque, Vec::new())
            }
            TrainPartKind::Table { table, .. } => {
                (table_torque(table, &at).map_err(named)?, Vec::new())
            }
        };
        let (kind, law) = match part.kind {
            TrainPartKind::Seal(_) => ("seal", "ISO/TR 14179-2, as quoted"),
            TrainPartKind::Bearing { .. } | TrainPartKind::PlanetBearing { .. } => {
                ("bearing", "SKF's form")
            }
            TrainPartKind::Jet { .. } => ("jet", JET_LAW),
            TrainPartKind::Table { .. } => ("table", TABLE_LAW),
        };
        let (torque, outside) = loss;
        let of_part = GearboxPart::new(&part.name, (kind, law), (torque, speed), &outside);
        let against = shafts
            .into_iter()
            .map(|(shaft, share)| (shaft, share * relative.signum()));
        found.push((against.collect(), of_part));
    }
    Ok(found)
}

/// Set of a stage, its speeds, and its operating point.
fn planet<'a>(
    train: &'a LoadedTrain,
    stage: usize,
    (speeds, torques): (&[AngularSpeed], &TrainTorques),
) -> Result<(&'a PlanetarySet, PlanetarySpeeds, PlanetaryOperation), PositionError> {
    let StageKind::Planetary {
        set,
        load_share_factor,
    } = &train.train.kinds[stage]
    else {
        return Err(PositionError::no_profile());
    };
    let [sun_speed, ring_speed] = train.train.shafts.stages[stage]
        .gears
        .map(|shaft| speeds[shaft]);
    let [sun_torque, _, _] = torques.stages[stage];
    let operation = PlanetaryOperation {
        sun_torque,
        sun_speed,
        ring_speed,
        load_share_factor: *load_share_factor,
    };
    Ok((set, set.speeds(sun_speed, ring_speed)?, operation))
}

/// Sun and carrier of a set, with their shares of a torque between planets and carrier.
fn planet_shafts(train: &LoadedTrain, stage: usize) -> Drags {
    let shafts = &train.train.shafts.stages[stage];
    let StageKind::Planetary { set, .. } = &train.train.kinds[stage] else {
        return Vec::new();
    };
    let [sun, planet] = set.sun_planet.teeth.map(f64::from);
    let carrier = shafts.carrier.map(|carrier| (carrier, sun / planet));
    std::iter::once((shafts.gears[0], -sun / planet))
        .chain(carrier)
        .collect()
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
        let gears = &mesh.ok_or_else(PositionError::no_profile)?.case.case.gears;
        let MeshPlace {
            at,
            angle,
            hand,
            is_set,
            ..
        } = &gearbox.places[stage];
        // Without need of a place it does not matter.
        let at = (at.unwrap_or_default(), angle.unwrap_or_default());
        let [torque, _, _] = torques.stages[stage];
        let of_gears = gears.shaft_forces(torque, at, *hand == Some(Hand::Left))?;
        let balanced = |on: ShaftForce| ShaftForce {
            force: [0.0, 0.0, on.force[2]],
            arm: [0.0; 2],
            ..on
        };
        match (place, *is_set) {
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
    let first = train
        .meshes()
        .next()
        .ok_or_else(PositionError::no_profile)?;
    let temperature = crate::result::gearbox::oil_temperature(&first.case.case);
    let torques = train.train.loading_torques(&flow.speeds, losses)?;
    let operation = (train.train.operation().torque, temperature);
    let found = of_parts(train, gearbox, (&flow.speeds, &torques), operation)?;
    let mut drags = vec![Torque::from_si(0.0); flow.speeds.len()];
    for (of_part, part) in &found {
        for (shaft, sign) in of_part {
            drags[*shaft] = drags[*shaft] + Torque::from_si(sign * part.torque_nm);
        }
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
