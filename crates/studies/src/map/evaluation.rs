//! Losses of one torque at every speed and temperature of a map.

use std::collections::BTreeMap;

use asperity::Reversed;
use asperity::case::gear_train::LoadedTrain;
use asperity::case::{Formulation, LoadedCase, MeshLoad};
use asperity::flanks::LEAST_POINTS_PER_HALF_WIDTH;
use asperity::flanks::Texture;
use asperity::mesh::Mesh;
use asperity::mesh::Resolution;
use asperity::pipeline::{contacts_beside, losses, losses_with};
use asperity::result::Losses;
use asperity::result::gearbox::{self, OperatingPoint};
use asperity::train_gearbox;
use asperity::uncertainty::{Predictive, predictive};
use asperity::{Contacts, Error, PositionError};
use asperity_core::quantity::{AngularSpeed, Temperature, Torque};
use rayon::prelude::*;

use super::axes::Axes;
use super::point::MapGearbox;

/// Losses of all meshes at one operating point of the input shaft.
#[derive(Debug, Clone)]
pub(super) struct Evaluated {
    pub meshes: Vec<EvaluatedMesh>,
    /// Speed of the input shaft \[rad/s\].
    pub omega: f64,
}

/// Losses of a mesh at one operating point, also for the other direction of power.
#[derive(Debug, Clone)]
pub(super) struct EvaluatedMesh {
    pub losses: Losses,
    pub reversed: Option<Reversed>,
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

/// Evaluates all speeds and temperatures at one torque of the input shaft, by temperature, with draws at the nodes.
pub(super) fn evaluate(
    train: &LoadedTrain,
    torque: Torque,
    (speeds, temperatures): (&[f64], &[f64]),
    is_node: &(dyn Fn(f64, f64) -> bool + Sync),
    progress: &(dyn Fn() + Sync),
) -> Vec<Result<Evaluated, String>> {
    let code = |error: &Error| error.code().to_owned();
    let prepared = Prepared::of(train, torque, speeds);
    let nodes = temperatures.iter().flat_map(|temperature| {
        let at = |(column, speed): (usize, &f64)| (column, *speed, *temperature);
        speeds.iter().enumerate().map(at)
    });
    let nodes: Vec<(usize, f64, f64)> = nodes.collect();
    let prepared = match &prepared {
        Ok(prepared) => prepared,
        Err(error) => return nodes.iter().map(|_| Err(code(error))).collect(),
    };
    nodes
        .into_par_iter()
        .map(|(column, speed, temperature)| {
            let losses = prepared.at((column, speed), temperature, is_node(speed, temperature));
            progress();
            losses.map_err(|error| code(&error))
        })
        .collect()
}

/// The meshes of a train at one torque of its input shaft.
struct Prepared {
    /// Loads of all meshes at each speed.
    loads: Vec<Vec<MeshLoad>>,
    /// Each mesh with its contacts, by the bits of its torque: only a stated speed of a ring changes the direction of the
    /// power with the speed.
    meshes: Vec<BTreeMap<u64, (LoadedCase, Option<Contacts>)>>,
}

impl Prepared {
    fn of(train: &LoadedTrain, torque: Torque, speeds: &[f64]) -> Result<Self, Error> {
        let loads = speeds.iter().map(|speed| {
            let speed = speed_of(*speed);
            loads(train, MeshLoad { torque, speed })
        });
        let loads: Vec<Vec<MeshLoad>> = loads.collect::<Result<_, Error>>()?;
        let mut known: Vec<Contacts> = Vec::new();
        let mut meshes = Vec::new();
        for (k, mesh) in train.meshes().enumerate() {
            let mut at_torques = BTreeMap::new();
            for torque in loads.iter().map(|loads| loads[k].torque) {
                let bits = torque.si().to_bits();
                if at_torques.contains_key(&bits) {
                    continue;
                }
                let case = at_torque(&mesh.case, torque)?;
                let tables = match case.case.formulation {
                    Formulation::Corrected => Some(contacts_beside(&case, &known)?),
                    Formulation::Paper => None,
                };
                known.extend(tables.clone());
                at_torques.insert(bits, (case, tables));
            }
            meshes.push(at_torques);
        }
        Ok(Self { loads, meshes })
    }

    fn at(
        &self,
        (column, speed): (usize, f64),
        temperature: f64,
        is_node: bool,
    ) -> Result<Evaluated, Error> {
        let of_mesh = |(mesh, load): (&BTreeMap<u64, _>, &MeshLoad)| {
            let prepared: Option<&(LoadedCase, Option<Contacts>)> =
                mesh.get(&load.torque.si().to_bits());
            let (case, tables) = prepared.ok_or(PositionError::NoProfile).map_err(Box::new)?;
            at(case, tables.as_ref(), (load.speed, temperature), is_node)
        };
        let meshes = self.meshes.iter().zip(&self.loads[column]).map(of_mesh);
        Ok(Evaluated {
            meshes: meshes.collect::<Result<_, Error>>()?,
            omega: speed_of(speed).si(),
        })
    }
}

/// Loads of all meshes at an operating point of the input shaft.
fn loads(train: &LoadedTrain, at: MeshLoad) -> Result<Vec<MeshLoad>, Error> {
    let flow = train.train.at(at).flow(&[]);
    let flow = flow.map_err(|error| Error::Whole(Box::new(PositionError::Gear(error))))?;
    Ok(flow.loads.into_iter().flatten().collect())
}

fn at(
    case: &LoadedCase,
    tables: Option<&Contacts>,
    (speed, temperature): (AngularSpeed, f64),
    is_node: bool,
) -> Result<EvaluatedMesh, Error> {
    let temperature = temperature_of(temperature);
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
    Ok(EvaluatedMesh {
        predictive,
        reversed: losses.reversed(&case.case).ok(),
        losses,
    })
}

/// The torque, identical to the one read from a case file.
pub(super) fn torque_of(torque_nm: f64) -> Torque {
    Torque::from_si(torque_nm)
}

/// Losses of the gearbox besides the meshes at every node; `None` if the case states none.
pub(super) fn gearbox_of(train: &LoadedTrain, axes: &Axes) -> Result<Option<MapGearbox>, Error> {
    let of_pair = train.pair().map(|pair| &pair.case);
    let names: Vec<String> = match (
        of_pair.and_then(|case| case.gearbox.as_ref()),
        &train.gearbox,
    ) {
        (Some(gearbox), _) => gearbox.parts.iter().map(|part| part.name.clone()).collect(),
        (_, Some(gearbox)) => gearbox.parts.iter().map(|part| part.name.clone()).collect(),
        (None, None) => return Ok(None),
    };
    let mut loss_torque_nm = Vec::with_capacity(axes.points());
    for &temperature in &axes.temperature_c {
        for &torque in &axes.torque_nm {
            for &speed in &axes.speed_rpm {
                let (torque, temperature) = (torque_of(torque), temperature_of(temperature));
                let speed = speed_of(computed_speed(speed));
                let at = OperatingPoint {
                    torque,
                    speed,
                    temperature,
                };
                let parts = match of_pair {
                    Some(case) => gearbox::parts(case, &at),
                    None => train_gearbox::parts(train, MeshLoad { torque, speed }, temperature),
                };
                let parts = parts.map_err(|error| Error::Whole(Box::new(error)))?;
                let loss: f64 = parts.iter().map(|part| part.loss_w).sum();
                loss_torque_nm.push(loss / speed.si());
            }
        }
    }
    Ok(Some(MapGearbox {
        parts: names,
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use asperity::case::Source;
    use asperity::case::gear_train::load_set;

    use super::*;

    const SMALL: &str = r#"{ teeth = [25, 25], module = "2 mm", face_width = "30 mm" }"#;
    const LARGE: &str = r#"{ teeth = [31, 31], module = "2 mm", face_width = "40 mm" }"#;
    const OTHER: &str = r#"{ teeth = [40, 40], module = "2 mm", face_width = "35 mm" }"#;

    /// Number of distinct contacts that a point of the map of stages with these gears solves.
    fn solved(gears: &[&str]) -> usize {
        let stages: String = (gears.iter().enumerate())
            .map(|(k, gears)| {
                format!(
                    "mesh.m{k} = {{ shafts = [\"s{k}\", \"s{}\"], gears = {gears} }}\n",
                    k + 1
                )
            })
            .collect();
        let text = format!(
            r#"train.input = "s0"
            {stages}
            operation = {{ torque = "80 N m", speed = "1500 1/min", bulk_temperature = "90 °C" }}
            lubricant.oil = "m100"
            surface.pinion.file = "ground_pinion.csv"
            surface.cutoff = "0.25 mm"
            model = {{ positions = 4, offsets = 2 }}"#
        );
        let source = Source::from_bytes("train.toml", text.as_bytes()).unwrap();
        let folder = Path::new("../../fixtures/profiles");
        let train = load_set(source, folder, &[], None).unwrap();
        let prepared = Prepared::of(&train, Torque::from_si(80.0), &[1500.0]).unwrap();
        prepared.at((0, 1500.0), 90.0, false).unwrap();
        let meshes = prepared.meshes.iter().flat_map(BTreeMap::values);
        let contacts = meshes.filter_map(|(_, contacts)| contacts.as_ref());
        contacts
            .flat_map(Contacts::solved)
            .collect::<BTreeSet<usize>>()
            .len()
    }

    #[test]
    fn three_identical_stages_cost_one_and_different_ones_the_sum() {
        let of_each = [SMALL, LARGE, OTHER].map(|gears| solved(&[gears]));
        assert!(of_each.iter().all(|count| *count > 0), "{of_each:?}");
        assert_eq!(solved(&[SMALL, SMALL, SMALL]), of_each[0]);
        assert_eq!(
            solved(&[SMALL, LARGE, OTHER]),
            of_each.iter().sum::<usize>()
        );
    }
}
