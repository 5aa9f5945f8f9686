//! Losses of one torque at every speed and temperature of a map.

use asperity::Reversed;
use asperity::case::{Formulation, LoadedCase};
use asperity::flanks::LEAST_POINTS_PER_HALF_WIDTH;
use asperity::flanks::Texture;
use asperity::mesh::Mesh;
use asperity::mesh::Resolution;
use asperity::pipeline::{contacts, losses, losses_with};
use asperity::result::Losses;
use asperity::result::gearbox::{self, OperatingPoint};
use asperity::uncertainty::{Predictive, predictive};
use asperity::{Contacts, Error};
use asperity_core::quantity::{AngularSpeed, Temperature, Torque};
use rayon::prelude::*;

use super::axes::Axes;
use super::point::MapGearbox;

/// Losses at one operating point, also for the other direction of power.
#[derive(Debug, Clone)]
pub(super) struct Evaluated {
    pub losses: Losses,
    pub reversed: Option<Reversed>,
    /// Speed of the pinion \[rad/s\].
    pub omega: f64,
    /// Draws of the loss, at a node.
    pub predictive: Option<Predictive>,
}

/// Speed at which standstill is computed \[1/min\].
pub(super) const CRAWL: f64 = 1.0;

/// Speeds at which a map is computed \[1/min\].
pub(super) fn computed_speeds(axes: &Axes) -> Vec<f64> {
    let mut speeds: Vec<f64> = axes
        .speed_rpm
        .iter()
        .map(|speed| computed_speed(*speed))
        .collect();
    speeds.sort_by(f64::total_cmp);
    speeds.dedup();
    speeds
}

/// Speed at which `speed` is computed.
pub(super) fn computed_speed(speed: f64) -> f64 {
    if speed == 0.0 { CRAWL } else { speed }
}

/// Offsets of each pair of surrogates in a map, at most: their pairs are many, and each is a sample of its own.
const OFFSETS_OF_SURROGATES: usize = 4;

/// The case at `torque`, reduced to its mesh losses.
pub(super) fn at_torque(case: &LoadedCase, torque: Torque) -> Result<LoadedCase, Error> {
    let offsets = case.case.model.offsets;
    let is_surrogate = case.surfaces.is_surrogate();
    case.with(|input| {
        if is_surrogate {
            input.model.offsets = Some(offsets.min(OFFSETS_OF_SURROGATES));
        }
        input.operation.torque = torque;
        input.model.run_in = None;
        // The gearbox is the same for every finish and is added to the map once.
        input.gearbox = None;
    })
}

/// Evaluates all speeds and temperatures at one torque, by temperature, with draws at the nodes.
pub(super) fn evaluate(
    case: &LoadedCase,
    torque: Torque,
    (speeds, temperatures): (&[f64], &[f64]),
    is_node: &(dyn Fn(f64, f64) -> bool + Sync),
    progress: &(dyn Fn() + Sync),
) -> Vec<Result<Evaluated, String>> {
    let prepared = at_torque(case, torque).and_then(|case| {
        let tables = match case.case.formulation {
            Formulation::Corrected => Some(contacts(&case)?),
            Formulation::Paper => None,
        };
        Ok((case, tables))
    });
    let nodes: Vec<(f64, f64)> = temperatures
        .iter()
        .flat_map(|temperature| speeds.iter().map(move |speed| (*speed, *temperature)))
        .collect();
    let code = |error: &Error| error.code().to_owned();
    let (case, tables) = match &prepared {
        Ok(prepared) => prepared,
        Err(error) => return nodes.iter().map(|_| Err(code(error))).collect(),
    };
    nodes
        .into_par_iter()
        .map(|node| {
            let losses = at(case, tables.as_ref(), node, is_node(node.0, node.1));
            progress();
            losses.map_err(|error| code(&error))
        })
        .collect()
}

fn at(
    case: &LoadedCase,
    tables: Option<&Contacts>,
    (speed, temperature): (f64, f64),
    is_node: bool,
) -> Result<Evaluated, Error> {
    let (speed, temperature) = (speed_of(speed), temperature_of(temperature));
    let case = case.with(|input| {
        input.operation.speed = speed;
        input.operation.set_temperature(temperature);
    })?;
    let losses = match tables {
        Some(tables) => losses_with(tables, &case)?,
        None => losses(&case)?,
    };
    let predictive = match is_node {
        true => predictive(&case, &losses, tables)?,
        false => None,
    };
    Ok(Evaluated {
        predictive,
        reversed: losses.reversed(&case.case).ok(),
        losses,
        omega: speed.si(),
    })
}

/// The torque, identical to the one read from a case file.
pub(super) fn torque_of(torque_nm: f64) -> Torque {
    Torque::from_si(torque_nm)
}

/// Losses of the gearbox besides the mesh at every node; `None` if the case states none.
pub(super) fn gearbox_of(case: &LoadedCase, axes: &Axes) -> Result<Option<MapGearbox>, Error> {
    let case = &case.case;
    let Some(gearbox) = &case.gearbox else {
        return Ok(None);
    };
    let mut loss_torque_nm = Vec::with_capacity(axes.points());
    for &temperature in &axes.temperature_c {
        for &torque in &axes.torque_nm {
            for &speed in &axes.speed_rpm {
                let at = OperatingPoint {
                    torque: torque_of(torque),
                    speed: speed_of(computed_speed(speed)),
                    temperature: temperature_of(temperature),
                };
                let loss_torque = gearbox::loss_torque_nm(case, &at);
                loss_torque_nm.push(loss_torque.map_err(|error| Error::Whole(Box::new(error)))?);
            }
        }
    }
    Ok(Some(MapGearbox {
        parts: gearbox.parts.iter().map(|part| part.name.clone()).collect(),
        loss_torque_nm,
    }))
}

fn speed_of(speed_rpm: f64) -> AngularSpeed {
    let text = format!("{speed_rpm} 1/min");
    text.parse()
        .unwrap_or_else(|_| AngularSpeed::from_si(speed_rpm * std::f64::consts::PI / 30.0))
}

fn temperature_of(temperature_c: f64) -> Temperature {
    let text = format!("{temperature_c} °C");
    text.parse()
        .unwrap_or_else(|_| Temperature::from_celsius(temperature_c))
}

/// Smallest torque \[N m\] with the sign of `sign` whose contacts the traces resolve, to one part in 4000. For flanks
/// without traces, a thousandth of the torque of the case.
pub(super) fn resolved_from(case: &LoadedCase, sign: f64) -> Result<f64, Error> {
    /// Number of bisections of a factor of two.
    const HALVINGS: usize = 12;
    /// Number of factors of two that are tried in either direction.
    const REACH: usize = 24;
    let begin = case.case.torque.si().abs();
    let is_resolved = |torque: f64| -> Result<bool, Error> {
        let case = at_torque(case, Torque::from_si(torque.copysign(sign)))?;
        resolves(&case).map_err(|error| Error::Whole(Box::new(error)))
    };
    if !case.surfaces.are_measured() {
        return Ok(1e-3 * begin);
    }
    let (mut low, mut high) = (begin, begin);
    for _ in 0..REACH {
        if is_resolved(high)? {
            break;
        }
        high *= 2.0;
    }
    low = low.min(high);
    for _ in 0..REACH {
        if !is_resolved(low).unwrap_or(false) {
            break;
        }
        (low, high) = (0.5 * low, low);
    }
    for _ in 0..HALVINGS {
        let middle = (low * high).sqrt();
        match is_resolved(middle).unwrap_or(false) {
            true => high = middle,
            false => low = middle,
        }
    }
    Ok(high)
}

/// Whether the traces resolve all contacts.
fn resolves(case: &LoadedCase) -> Result<bool, asperity::PositionError> {
    let [Texture::Trace(first), Texture::Trace(_)] = case.surfaces.textures() else {
        return Ok(true);
    };
    let mesh = Mesh::of(&case.case)?;
    Ok(mesh.positions.iter().all(|at| {
        at.resolution != Resolution::Required
            || at.hertz.half_width / first.spacing() >= LEAST_POINTS_PER_HALF_WIDTH
    }))
}
