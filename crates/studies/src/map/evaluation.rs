//! Losses of one torque at every speed and temperature of a map.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use asperity::Reversed;
use asperity::case::train::Train;
use asperity::case::{LoadedCase, MeshLoad, RunningInEntry, RunningInInput, RunningInPlan};
use asperity::flanks::LEAST_POINTS_PER_HALF_WIDTH;
use asperity::flanks::{Surfaces, Texture};
use asperity::gearbox;
use asperity::mesh::Mesh;
use asperity::mesh::Resolution;
use asperity::result::Losses;
use asperity::running_in::run_in;
use asperity::uncertainty::{Predictive, predictive};
use asperity::{Contacts, Error, PositionError, Run};
use asperity_core::Code;
use asperity_core::numerics::distinct;
use asperity_core::quantity::{AngularSpeed, Power, Temperature, Torque};
use asperity_core::task::par_map;

use super::axes::Axes;
use super::point::{MapGearbox, MeshPart};

/// Losses of all meshes at one operating point of the input shaft.
#[derive(Debug, Clone)]
pub(super) struct EvaluatedPoint {
    pub meshes: Vec<EvaluatedMesh>,
    /// Speed of the input shaft \[rad/s\].
    pub omega: f64,
}

/// Losses of a mesh at one operating point, at the torque by the tooth numbers; linear between two torques where the losses of
/// the meshes lower its torque.
#[derive(Debug, Clone)]
pub(super) struct EvaluatedMesh {
    pub losses: Losses,
    /// Efficiency for the other direction of power.
    pub reversed: Option<Reversed>,
    /// Draws of the loss, at a node.
    pub predictive: Option<Predictive>,
    /// The mesh at another torque, and the share of the way to it.
    pub lowered: Option<(f64, Box<EvaluatedMesh>)>,
}

impl EvaluatedMesh {
    /// Loss of one mesh.
    fn loss(&self) -> Power {
        let of = |losses: &Losses| losses.summary.loss_w;
        let here = of(&self.losses);
        let lowered = self.lowered.as_ref();
        Power::from_si(lowered.map_or(here, |(share, other)| {
            here + share * (of(&other.losses) - here)
        }))
    }
}

/// Speed at which standstill is computed \[1/min\].
pub(super) const CRAWL: f64 = 1.0;

/// Speeds at which a map is computed \[1/min\].
pub(super) fn computed_speeds(axes: &Axes) -> Vec<f64> {
    distinct(axes.speed_rpm.iter().map(|speed| computed_speed(*speed)))
}

/// Speed at which `speed` is computed.
pub(super) fn computed_speed(speed: f64) -> f64 {
    if speed == 0.0 { CRAWL } else { speed }
}

/// The case at `torque`, reduced to its mesh losses, on its flanks as measured.
pub(super) fn at_torque(case: &LoadedCase, torque: Torque) -> Result<LoadedCase, Error> {
    let plan = case.case.running_in;
    let stated = |plan: RunningInPlan| {
        RunningInEntry::Stated(RunningInInput {
            torque: Some(plan.torque),
            engagements: plan.engagements,
        })
    };
    let other = case.with(|input| {
        input.operation.torque = torque;
        // Flanks that run in are rows of scans at every torque, and run in at the one that is stated.
        input.operation.running_in = plan.map(stated);
        // The gearbox is the same for every finish and is added to the map once.
        input.gearbox = None;
    })?;
    match plan {
        Some(_) => other.overridden(|over| over.as_measured = true),
        None => Ok(other),
    }
}

/// Flanks run in, by the number of their mesh and whether its torque is negative.
pub(super) type FlanksOfTorques = BTreeMap<(usize, bool), Surfaces>;

/// The case on its flanks run in, once for all torques of one sign.
fn on_run_in(
    case: LoadedCase,
    plan: Option<RunningInPlan>,
    mesh: usize,
    known: &mut FlanksOfTorques,
) -> Result<LoadedCase, Error> {
    let Some(plan) = plan else {
        return Ok(case);
    };
    let torque = case.case.torque.si();
    let surfaces = match known.entry((mesh, torque < 0.0)) {
        Entry::Occupied(known) => known.into_mut(),
        Entry::Vacant(place) => {
            let torque = Torque::from_si(plan.torque.si().copysign(torque));
            let plan = RunningInPlan { torque, ..plan };
            let found = run_in(&case.case, &case.surfaces, &plan, &|_| {}).map_err(Box::new)?;
            place.insert(found.surfaces)
        }
    };
    Ok(case.with_surfaces(surfaces.clone()))
}

/// Evaluates all speeds and temperatures at one torque of the input shaft, by temperature, with draws at the nodes.
pub(super) fn evaluate(
    train: &Train,
    (torque, run_in): (Torque, &mut FlanksOfTorques),
    (speeds, temperatures): (&[f64], &[f64]),
    is_node: &(dyn Fn(f64, f64) -> bool + Sync),
    progress: &(dyn Fn() + Sync),
) -> Vec<Result<EvaluatedPoint, Code>> {
    let code = |error: &Error| error.code().to_owned();
    let prepared = PreparedTorque::new(train, (torque, run_in), speeds);
    let nodes = temperatures.iter().flat_map(|temperature| {
        let at = |(column, speed): (usize, &f64)| (column, *speed, *temperature);
        speeds.iter().enumerate().map(at)
    });
    let nodes: Vec<(usize, f64, f64)> = nodes.collect();
    let prepared = match &prepared {
        Ok(prepared) => prepared,
        Err(error) => return nodes.iter().map(|_| Err(code(error))).collect(),
    };
    let evaluated = par_map(&nodes, |&(column, speed, temperature)| {
        let losses = prepared.at(column, speed, temperature, is_node(speed, temperature));
        progress();
        losses.map_err(|error| code(&error))
    });
    if train.shafting.passes_losses {
        prepared.with_passed_losses(train, torque, &nodes, evaluated)
    } else {
        evaluated
    }
}

/// The meshes of a train at one torque of its input shaft.
struct PreparedTorque {
    /// Loads of all meshes at each speed.
    loads: Vec<Vec<MeshLoad>>,
    /// Each mesh with its contacts, by the bits of its torque: only a stated speed of a ring changes the direction of the
    /// power with the speed.
    meshes: Vec<BTreeMap<u64, (LoadedCase, Vec<Contacts>)>>,
}

impl PreparedTorque {
    fn new(
        train: &Train,
        (torque, run_in): (Torque, &mut FlanksOfTorques),
        speeds: &[f64],
    ) -> Result<Self, Error> {
        let loads = speeds.iter().map(|speed| {
            let speed = speed_of(*speed);
            loads(train, MeshLoad { torque, speed }, &[])
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
                let case = on_run_in(case, mesh.case.case.running_in, k, run_in)?;
                let tables = match case.case.formulation.pressures() {
                    None => Run::new(&case).known(&known).contacts()?,
                    Some(_) => Vec::new(),
                };
                known.extend_from_slice(&tables);
                at_torques.insert(bits, (case, tables));
            }
            meshes.push(at_torques);
        }
        Ok(Self { loads, meshes })
    }

    fn at(
        &self,
        column: usize,
        speed: f64,
        temperature: f64,
        is_node: bool,
    ) -> Result<EvaluatedPoint, Error> {
        let of_mesh = |(mesh, load): (&BTreeMap<u64, _>, &MeshLoad)| {
            let prepared: Option<&(LoadedCase, Vec<Contacts>)> =
                mesh.get(&load.torque.si().to_bits());
            let (case, tables) = prepared
                .ok_or_else(PositionError::no_profile)
                .map_err(Box::new)?;
            at(case, tables, load.speed, temperature, is_node)
        };
        let meshes = self.meshes.iter().zip(&self.loads[column]).map(of_mesh);
        Ok(EvaluatedPoint {
            meshes: meshes.collect::<Result<_, Error>>()?,
            omega: speed_of(speed).si(),
        })
    }

    /// The points of one torque of the input shaft with the torques that the losses of the meshes leave.
    ///
    /// Every mesh is computed at a second torque, the farthest one that the losses of any point leave at first. Its losses are
    /// linear between both torques, with which the torques of each point are iterated. Draws remain at the first torque.
    fn with_passed_losses(
        &self,
        train: &Train,
        torque: Torque,
        nodes: &[(usize, f64, f64)],
        evaluated: Vec<Result<EvaluatedPoint, Code>>,
    ) -> Vec<Result<EvaluatedPoint, Code>> {
        let code = |error: Error| error.code().to_owned();
        let farthest = match self.farthest(train, torque, nodes, &evaluated) {
            Ok(farthest) => farthest,
            Err(error) => {
                let code = code(error);
                return evaluated.into_iter().map(|_| Err(code)).collect();
            }
        };
        let points = (nodes, evaluated);
        par_map(points, |(&(column, _, temperature), evaluated)| {
            let mut evaluated = evaluated?;
            let loads = &self.loads[column];
            for ((mesh, load), farthest) in evaluated.meshes.iter_mut().zip(loads).zip(&farthest) {
                if let Some((_, case, tables)) = farthest.get(&load.torque.si().to_bits()) {
                    let other = at(case, tables, load.speed, temperature, false);
                    mesh.lowered = Some((0.0, Box::new(other.map_err(code)?)));
                }
            }
            settle(train, torque, loads, &farthest, &mut evaluated).map_err(code)?;
            Ok(evaluated)
        })
    }

    /// The farthest torque of each mesh that the losses of any point leave, with its contacts, by the bits of the torque that it
    /// has without losses.
    fn farthest(
        &self,
        train: &Train,
        torque: Torque,
        nodes: &[(usize, f64, f64)],
        evaluated: &[Result<EvaluatedPoint, Code>],
    ) -> Result<Vec<BTreeMap<u64, Lowered>>, Error> {
        let mut ratios: Vec<BTreeMap<u64, f64>> = vec![BTreeMap::new(); self.meshes.len()];
        for ((column, ..), evaluated) in nodes.iter().zip(evaluated) {
            let Ok(evaluated) = evaluated else { continue };
            let left = left(train, torque, evaluated)?;
            for ((load, left), ratios) in self.loads[*column].iter().zip(left).zip(&mut ratios) {
                let ratio = left.torque.si() / load.torque.si();
                let most = ratios.entry(load.torque.si().to_bits()).or_insert(1.0);
                if (ratio - 1.0).abs() > (*most - 1.0).abs()
                    && (ratio - 1.0).abs() <= LARGEST_CHANGE
                {
                    *most = ratio;
                }
            }
        }
        let mut known: Vec<Contacts> = Vec::new();
        let lowered = |(mesh, ratios): (&BTreeMap<u64, _>, BTreeMap<u64, f64>)| {
            let mut found = BTreeMap::new();
            for (bits, ratio) in ratios.into_iter().filter(|(_, ratio)| *ratio != 1.0) {
                let prepared: Option<&(LoadedCase, Vec<Contacts>)> = mesh.get(&bits);
                let (case, tables) = prepared
                    .ok_or_else(PositionError::no_profile)
                    .map_err(Box::new)?;
                let at_ratio = |ratio: f64| {
                    case.with(|input| {
                        input.operation.torque = input.operation.torque * ratio;
                        // Both torques have the same samples of the traces.
                        if let Some(tables) = tables.first() {
                            input.model.offsets = Some(tables.offsets());
                        }
                    })
                };
                let mut other = at_ratio(ratio)?;
                if !resolves(&other).map_err(Box::new)? {
                    other = at_ratio(2.0 - ratio)?;
                }
                let tables = if tables.is_empty() {
                    Vec::new()
                } else {
                    Run::new(&other).known(&known).contacts()?
                };
                known.extend_from_slice(&tables);
                found.insert(bits, (other.case.torque.si(), other, tables));
            }
            Ok(found)
        };
        self.meshes.iter().zip(ratios).map(lowered).collect()
    }
}

/// Largest change of the torque of a mesh by the losses before it, relative to the torque, that a map computes.
const LARGEST_CHANGE: f64 = 0.5;

/// Loads of all meshes that the losses of a point leave.
fn left(train: &Train, torque: Torque, evaluated: &EvaluatedPoint) -> Result<Vec<MeshLoad>, Error> {
    let losses: Vec<Power> = evaluated.meshes.iter().map(EvaluatedMesh::loss).collect();
    let speed = AngularSpeed::from_si(evaluated.omega);
    loads(train, MeshLoad { torque, speed }, &train.by_stage(&losses))
}

/// Iterates the torques of a point, each mesh between the torque without losses and its farthest.
fn settle(
    train: &Train,
    torque: Torque,
    loads: &[MeshLoad],
    farthest: &[BTreeMap<u64, Lowered>],
    evaluated: &mut EvaluatedPoint,
) -> Result<(), Error> {
    /// Change of the share at which it has settled.
    const SETTLED: f64 = 1e-9;
    const MOST: usize = 50;
    let mut change = f64::INFINITY;
    for _ in 0..MOST {
        let left = left(train, torque, evaluated)?;
        change = 0.0;
        let meshes = evaluated
            .meshes
            .iter_mut()
            .zip(loads)
            .zip(left)
            .zip(farthest);
        for (((mesh, load), left), farthest) in meshes {
            let of_mesh = farthest.get(&load.torque.si().to_bits());
            let (Some((share, _)), Some((far, ..))) = (&mut mesh.lowered, of_mesh) else {
                continue;
            };
            let here = load.torque.si();
            let now = (left.torque.si() - here) / (far - here);
            change = f64::max(change, (now - *share).abs());
            *share = now;
            if (left.torque.si() / here - 1.0).abs() > LARGEST_CHANGE {
                change = f64::INFINITY;
            }
        }
        if change < SETTLED {
            return Ok(());
        }
    }
    Err(Error::Whole(Box::new(PositionError::torques_not_settled(
        change,
    ))))
}

/// A mesh at a lower torque: torque \[N m\], case and contacts.
type Lowered = (f64, LoadedCase, Vec<Contacts>);

/// Loads of all meshes at an operating point of the input shaft, with the loss of one mesh of each kind in each stage.
fn loads(train: &Train, at: MeshLoad, losses: &[Vec<Power>]) -> Result<Vec<MeshLoad>, Error> {
    let flow = train.shafting.at(at).flow(losses);
    let flow = flow.map_err(|error| Error::Whole(Box::new(PositionError::from(error))))?;
    Ok(flow.loads.into_iter().flatten().collect())
}

fn at(
    case: &LoadedCase,
    tables: &[Contacts],
    speed: AngularSpeed,
    temperature: f64,
    is_node: bool,
) -> Result<EvaluatedMesh, Error> {
    let temperature = temperature_of(temperature);
    let case = case.with(|input| {
        input.operation.speed = speed;
        input.operation.set_temperature(temperature);
    })?;
    let losses = Run::new(&case).known(tables).losses()?.into_only()?;
    let predictive = if is_node {
        predictive(&case, &losses, tables.first())?
    } else {
        None
    };
    Ok(EvaluatedMesh {
        predictive,
        reversed: losses.reversed(&case.case).ok(),
        losses,
        lowered: None,
    })
}

/// The torque, identical to the one read from a case file.
pub(super) fn torque_of(torque_nm: f64) -> Torque {
    Torque::from_si(torque_nm)
}

/// Losses of the gearbox in addition to the meshes at every node, with the losses of the meshes there, which load the bearings if the
/// train passes them on; `None` if the case states none.
pub(super) fn gearbox_of(
    train: &Train,
    axes: &Axes,
    of_meshes: &[MeshPart],
) -> Result<Option<MapGearbox>, Error> {
    let Some(stated) = &train.gearbox else {
        return Ok(None);
    };
    let names = stated.parts.iter().map(|part| part.name.clone()).collect();
    let mut loss_torque_nm = Vec::with_capacity(axes.points());
    for &temperature in &axes.temperature_c {
        for &torque in &axes.torque_nm {
            for &speed in &axes.speed_rpm {
                let (torque, temperature) = (torque_of(torque), temperature_of(temperature));
                let speed = speed_of(computed_speed(speed));
                let lost = |mesh: &MeshPart| {
                    let all = mesh.loss_torque_nm[loss_torque_nm.len()].unwrap_or(0.0) * speed.si();
                    Power::from_si(all / f64::from(mesh.count))
                };
                let losses = train.by_stage(&of_meshes.iter().map(lost).collect::<Vec<_>>());
                let at = MeshLoad { torque, speed };
                let parts = gearbox::parts(train, at, temperature, &losses);
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
        if is_resolved(middle).unwrap_or(false) {
            high = middle
        } else {
            low = middle
        }
    }
    Ok(high)
}

/// Whether the traces resolve all contacts.
fn resolves(case: &LoadedCase) -> Result<bool, asperity::PositionError> {
    let [Texture::Trace(first), Texture::Trace(_)] = case.surfaces.textures() else {
        return Ok(true);
    };
    let mesh = Mesh::new(&case.case)?;
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
        let train = Train::load_set(source, folder, &[], &|_| {}).unwrap();
        let prepared = PreparedTorque::new(
            &train,
            (Torque::from_si(80.0), &mut FlanksOfTorques::new()),
            &[1500.0],
        )
        .unwrap();
        prepared.at(0, 1500.0, 90.0, false).unwrap();
        let meshes = prepared.meshes.iter().flat_map(BTreeMap::values);
        let contacts = meshes.flat_map(|(_, contacts)| contacts);
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
