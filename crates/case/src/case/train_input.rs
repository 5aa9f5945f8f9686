//! Keys of a gear train, and the case of each mesh that they state.

use asperity_core::Code;
use std::collections::BTreeMap;
use std::sync::Arc;

use asperity_core::quantity::{Angle, AngularSpeed, Length, Torque};
use asperity_gear::gear_train::{GearTrain, TrainShaft, TrainStage};
use asperity_oil::LubricantInput;
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::bulk_input::BulkInput;
use super::calibration::CalibrationInput;
use super::defaults::DefaultUsed;
use super::error::CaseError;
use super::files::Reader;
use super::finish::FinishName;
use super::input::{
    BodyInput, CaseInput, CoastInput, FlankInput, GearsInput, MapInput, MaterialInput,
    OperationInput, SurfaceInput, VehicleInput,
};
use super::model::{Formulation, ModelInput};
use super::planetary::{self, PlanetaryInput, SetOfCase};
use super::ranges::{Judged, refuse_impossible, unusual};
use super::rows::{Judge, KeyPath, Ranged, limits};
use super::section::domain;
use super::source::{MeshKeys, Source};
use super::train_flow::StageKind;
use super::train_gearbox::{Hand, MeshPlace, TrainGearboxInput, train_gearbox};
use super::train_heat_input::HeatInput;
use super::train_parts::{MeshParts, StageParts, TrainParts, conflict, mesh_folder, refused};
use asperity_core::message::Warning;

/// A case of several meshes as the user writes it, on named shafts or of a single planetary set. Torque and speed of the
/// operation are those of the input shaft, or of the sun.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TrainCaseInput {
    /// Title of the case, shown in every output.
    pub title: Option<String>,
    /// Reading of the model: `corrected` (default) or `paper`.
    pub formulation: Option<Formulation>,
    /// Input and output shaft of the meshes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub train: Option<TrainInput>,
    /// The meshes by their names, each a table `[mesh.NAME]`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub mesh: BTreeMap<String, MeshInput>,
    /// The set of a case that is a single planetary set, in place of `train` and `mesh`; its shafts are `sun`, `ring` and
    /// `carrier`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub planetary: Option<PlanetaryInput>,
    /// Steel of all meshes that have no own.
    #[serde(default)]
    pub material: TrainMaterialInput,
    /// Torque and speed of the input shaft, temperature.
    pub operation: OperationInput,
    /// The oil.
    pub lubricant: LubricantInput,
    /// Flanks of all meshes that have no own, and the preparation of their traces.
    #[serde(default)]
    pub surface: TrainSurfaceInput,
    /// Heat balance, from which the temperature of the oil follows; `operation.oil_temperature` is then its start.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heat: Option<HeatInput>,
    /// Losses besides the meshes; only the losses stated here are added.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gearbox: Option<TrainGearboxInput>,
    /// Choices of the model, for all meshes.
    #[serde(default)]
    pub model: ModelInput,
    /// Parameters calibrated on a rig, for all meshes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub calibration: Option<CalibrationInput>,
    /// Ranges of the default axes of `asperity map`; a run ignores them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub map: Option<MapInput>,
    /// The vehicle of a cycle stated by its speed, for `asperity cycle`; a run ignores it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vehicle: Option<VehicleInput>,
}

/// Name of a mesh in the paths of rows.
pub(super) const MESH: &str = "NAME";

impl Judged for TrainCaseInput {}

/// The tables that are not of a single mesh: what a mesh has is judged with its case.
impl Ranged for TrainCaseInput {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        let set = stated.map(|case| &case.planetary);
        Ranged::visit(set, at.below(planetary::TABLE), judge);
        let meshes = at.below("mesh");
        match stated {
            None => MeshInput::visit(None, meshes.below(MESH), judge),
            Some(case) => {
                for (name, mesh) in &case.mesh {
                    MeshInput::visit(Some(mesh), meshes.below(name), judge);
                }
            }
        }
        Ranged::visit(stated.map(|case| &case.heat), at.below("heat"), judge);
        Ranged::visit(stated.map(|case| &case.gearbox), at.below("gearbox"), judge);
        Ranged::visit(stated.map(|case| &case.map), at.below("map"), judge);
        Ranged::visit(stated.map(|case| &case.vehicle), at.below("vehicle"), judge);
    }
}

limits! {
    MeshInput;
    at = "mm" usual [-5000.0, 5000.0] possible [-100_000.0, 100_000.0];
    angle = "deg" usual [-360.0, 360.0] possible [-3600.0, 3600.0];
    planetary => table;
}

/// Shafts at which the power enters and leaves a gear train.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TrainInput {
    /// Shaft with torque and speed of the operation.
    pub input: String,
    /// Shaft at which the power leaves; default: the only other end of the train.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<String>,
    /// Shafts that do not turn; a ring without a shaft is held.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub held: Vec<String>,
    /// Torques of the meshes: `not-passed-on` (default), by the tooth numbers, or `passed-on`, lowered by the losses
    /// of the meshes before.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub losses: Option<PassedLosses>,
}

/// Whether losses lower the torques of the following meshes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum PassedLosses {
    /// Torques by the tooth numbers.
    #[default]
    NotPassedOn,
    /// Torques lowered by the losses.
    PassedOn,
}

/// A mesh of a gear train: a pair of gears, or a planetary set.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MeshInput {
    /// Shafts of pinion and wheel; of a planetary set sun and carrier, or sun, carrier and ring.
    pub shafts: Vec<String>,
    /// A pair of gears; the number of teeth of a ring is negative.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gears: Option<GearsInput>,
    /// A planetary set.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub planetary: Option<PlanetaryInput>,
    /// Middle of the teeth along the shafts, for the loads of the bearings.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<Length>,
    /// Angle of the centre line from the pinion to the wheel about the axes, for the loads of the bearings of a shaft with
    /// several meshes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<Angle>,
    /// Direction of the helix of the pinion or sun, for the loads of the bearings: `left` or `right`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hand: Option<Hand>,
    /// Law of the bulk temperature of this mesh, such as the conductances of its gears to the oil; default
    /// `operation.bulk`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bulk: Option<BulkInput>,
    /// Steel of this mesh.
    #[serde(default, skip_serializing_if = "is_default")]
    pub material: TrainMaterialInput,
    /// Flanks of this mesh, and the preparation of their traces.
    #[serde(default, skip_serializing_if = "is_default")]
    pub surface: TrainSurfaceInput,
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// Steel of pinion and wheel, or of sun, planets and ring.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TrainMaterialInput {
    /// The pinion; also the wheel unless given, and the sun if the steel is that of all meshes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pinion: Option<BodyInput>,
    /// The wheel, where it differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wheel: Option<BodyInput>,
    /// The sun; also planets and ring unless given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sun: Option<BodyInput>,
    /// The planets, where they differ.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub planet: Option<BodyInput>,
    /// The ring, where it differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ring: Option<BodyInput>,
}

/// Flanks of pinion and wheel, or of sun, planets and ring, and the preparation of their traces.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct TrainSurfaceInput {
    /// Trace of the pinion's flank; of the sun's, if the flanks are those of all meshes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pinion: Option<FlankInput>,
    /// Trace of the wheel's flank; default: the pinion's trace, mirrored.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wheel: Option<FlankInput>,
    /// Trace of the sun's flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sun: Option<FlankInput>,
    /// Trace of a planet's flank, for both of its meshes; default: the sun's trace, mirrored.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub planet: Option<FlankInput>,
    /// Trace of the ring's flank; default: the planet's trace, mirrored.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ring: Option<FlankInput>,
    /// Finish of flanks without a file; default by Ra.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub finish: Option<FinishName>,
    /// Form removed from each trace; default `level` (a straight line).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub form: Option<Form>,
    /// Cut-off λc; default as the file states, else 0.25 mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cutoff: Option<Length>,
    /// Cut-off λs; default as the file states, else 2.5 um.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub noise_cutoff: Option<Length>,
    /// Treatment of the ends of a trace in filtering; default `cut`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ends: Option<Ends>,
    /// Robust standard deviations from the running median beyond which spikes are replaced; default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outliers: Option<f64>,
    /// Flanks of a pair at a negative torque, if they differ.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coast: Option<CoastInput>,
}

impl TrainCaseInput {
    /// Tables that describe the gears.
    pub(super) const TABLES: [&'static str; 2] = ["mesh", planetary::TABLE];

    /// The train and the case of each mesh.
    pub(super) fn parts(
        &self,
        source: &Source,
        files: Reader<'_>,
    ) -> Result<TrainParts, CaseError> {
        refuse_impossible(self, source)?;
        let (shafts, stages) = match &self.planetary {
            Some(set) => self.single_set(set, source)?,
            None => self.on_shafts(source)?,
        };
        let train = self.train.as_ref();
        let passes_losses = train.and_then(|train| train.losses) == Some(PassedLosses::PassedOn);
        let places = stages.iter().map(|stage| self.place_of(stage));
        let places: Vec<MeshPlace> = places.collect();
        let gearbox = self.gearbox.as_ref();
        let gearbox =
            gearbox.map(|stated| train_gearbox(stated, places, &shafts, (source, &files)));
        let gearbox = gearbox.transpose()?;
        let [meshes, set] = Self::TABLES;
        let table = if self.planetary.is_some() {
            set
        } else {
            meshes
        };
        let mut parts = TrainParts::new(self.title.clone(), shafts, passes_losses, stages)
            .map_err(refused(source, table))?;
        parts.heat = self.checked_heat(source)?;
        parts.gearbox = gearbox;
        parts.warnings = unusual(self, source);
        parts
            .warnings
            .extend(parts.stages.iter().filter_map(uneven_planets));
        parts.sums = files.into_sums();
        Ok(parts)
    }

    /// The set of a case `[planetary]`.
    fn single_set(
        &self,
        set: &PlanetaryInput,
        source: &Source,
    ) -> Result<(GearTrain, Vec<StageParts>), CaseError> {
        let others = [
            ("train", self.train.is_some()),
            ("mesh", !self.mesh.is_empty()),
        ];
        if let Some((key, _)) = others.into_iter().find(|(_, is_stated)| *is_stated) {
            let rule = "is of a gear train, this case is a single planetary set: make it a mesh, mesh.NAME.planetary";
            return Err(conflict(source, key.to_owned(), rule));
        }
        let stage = self.set(None, &MeshInput::default(), set, source)?;
        let shafts = planetary::shafts(set, &self.operation, stage.teeth);
        Ok((shafts, vec![stage]))
    }

    fn checked_heat(&self, source: &Source) -> Result<Option<HeatInput>, CaseError> {
        let Some(heat) = &self.heat else {
            return Ok(None);
        };
        if self.operation.oil_temperature.is_none() {
            let rule = "needs operation.oil_temperature, where the search begins, with operation.bulk or mesh.NAME.bulk, by which the loss heats the flanks above the oil";
            return Err(conflict(source, "heat".to_owned(), rule));
        }
        heat.check()
            .map_err(|(key, error)| domain(source, format!("heat.{key}"))(error))?;
        Ok(Some(heat.clone()))
    }

    /// The stages in the order of the power, on their shafts.
    fn on_shafts(&self, source: &Source) -> Result<(GearTrain, Vec<StageParts>), CaseError> {
        let Some(stated) = &self.train else {
            let rule = "is needed: the shaft with torque and speed of the operation";
            return Err(conflict(source, "train.input".to_owned(), rule));
        };
        /// Largest number of meshes of a gear train, far above that of a gearbox with many speeds.
        const MOST_MESHES: usize = 100;
        if self.mesh.len() > MOST_MESHES {
            return Err(CaseError::impossible(
                source.place_of("mesh"),
                "mesh",
                None,
                format!("a train of {} meshes", self.mesh.len()),
                &format!("1 to 20, at most {MOST_MESHES}"),
            ));
        }
        let mut stages = BTreeMap::new();
        for (name, mesh) in &self.mesh {
            stages.insert(name.as_str(), self.stage(name, mesh, source)?);
        }
        let mut train = GearTrain::default();
        let mut ordered = Vec::new();
        let mut shafts = vec![stated.input.as_str()];
        while let Some(name) = {
            let is_next = |name: &&&str| {
                let on = &self.mesh[**name].shafts;
                on.iter().any(|shaft| shafts.contains(&shaft.as_str()))
            };
            stages.keys().find(is_next).copied()
        } {
            let Some(stage) = stages.remove(name) else {
                break;
            };
            let on = &self.mesh[name].shafts;
            for shaft in on {
                if !shafts.contains(&shaft.as_str()) {
                    shafts.push(shaft);
                }
            }
            ordered.push((name, stage));
        }
        if let Some(name) = stages.keys().next() {
            let rule = "has no shaft in common with the train from the input shaft on";
            return Err(conflict(source, format!("mesh.{name}.shafts"), rule));
        }
        let names = [
            ("train.input", Some(&stated.input)),
            ("train.output", stated.output.as_ref()),
        ];
        let held = stated.held.iter().map(|name| ("train.held", Some(name)));
        for (key, name) in names.into_iter().chain(held) {
            let is_used = |name: &String| self.mesh.values().any(|mesh| mesh.shafts.contains(name));
            if name.is_some_and(|name| !is_used(name)) {
                let rule = "is not a shaft of any mesh";
                return Err(conflict(source, key.to_owned(), rule));
            }
        }
        let operation = &self.operation;
        let ends = |shaft: &str| {
            let all = self.mesh.values().flat_map(|mesh| &mesh.shafts);
            all.filter(|name| *name == shaft).count() == 1
        };
        let is_held = |shaft: &str| stated.held.iter().any(|held| held == shaft);
        let input = stated.input.as_str();
        let mut outputs = shafts
            .iter()
            .filter(|shaft| ends(shaft) && !is_held(shaft) && **shaft != input);
        let output = match (&stated.output, outputs.next(), outputs.next()) {
            (Some(output), _, _) => output,
            (None, Some(output), None) => *output,
            _ => {
                let rule = "is needed: the shaft at which the power leaves is not the only other end of the train";
                return Err(conflict(source, "train.output".to_owned(), rule));
            }
        };
        for shaft in &shafts {
            let is_input = *shaft == input;
            let zero = Torque::from_si(0.0);
            train.shafts.push(TrainShaft {
                name: (*shaft).to_owned(),
                speed: match is_held(shaft) {
                    true => Some(AngularSpeed::from_si(0.0)),
                    false => is_input.then_some(operation.speed),
                },
                torque: match *shaft == output || is_held(shaft) {
                    true => None,
                    false => Some(if is_input { operation.torque } else { zero }),
                },
                drag: zero,
            });
        }
        let mut folders = Vec::new();
        for (name, stage) in &ordered {
            for mesh in &stage.meshes {
                // Some file systems take capitals for small letters.
                let folder = mesh_folder(&mesh.name).to_lowercase();
                if folders.contains(&folder) {
                    let rule =
                        "would have the result folder of another mesh; change one of the names";
                    return Err(conflict(source, format!("mesh.{name}"), rule));
                }
                folders.push(folder);
            }
        }
        let place = |name: &String| shafts.iter().position(|shaft| shaft == name).unwrap_or(0);
        for (name, stage) in &ordered {
            let on: Vec<usize> = self.mesh[*name].shafts.iter().map(place).collect();
            let (gears, carrier) = match on[..] {
                [sun, carrier, ring] => ([sun, ring], Some(carrier)),
                [sun, carrier] if matches!(stage.kind, StageKind::Planetary { .. }) => {
                    let set = self.mesh[*name].planetary.as_ref();
                    let ring_speed = set.and_then(|set| set.ring_speed);
                    train.shafts.push(TrainShaft {
                        name: format!("{name} ring"),
                        speed: Some(ring_speed.unwrap_or(AngularSpeed::from_si(0.0))),
                        torque: None,
                        drag: Torque::from_si(0.0),
                    });
                    ([sun, train.shafts.len() - 1], Some(carrier))
                }
                [pinion, wheel] => ([pinion, wheel], None),
                _ => continue,
            };
            train.stages.push(TrainStage {
                gears,
                carrier,
                teeth: stage.teeth,
            });
        }
        Ok((train, ordered.into_iter().map(|(_, stage)| stage).collect()))
    }

    fn stage(
        &self,
        name: &str,
        mesh: &MeshInput,
        source: &Source,
    ) -> Result<StageParts, CaseError> {
        let is_plain = |c: char| c.is_alphanumeric() || c == '-' || c == '_';
        if name.is_empty() || !name.chars().all(is_plain) {
            let rule = "must be a name of letters, digits, - and _";
            return Err(conflict(source, format!("mesh.{name}"), rule));
        }
        let named = mesh.shafts.len();
        let are_shafts = named == 2 || (named == 3 && mesh.planetary.is_some());
        match (&mesh.gears, &mesh.planetary) {
            _ if !are_shafts => {
                let rule = "must name the shafts of pinion and wheel, or of sun, carrier and, if it turns, ring";
                Err(conflict(source, format!("mesh.{name}.shafts"), rule))
            }
            (Some(gears), None) => self.pair(name, mesh, gears, source),
            (None, Some(set)) => self.set(Some(name), mesh, set, source),
            _ => {
                let rule = "must have one of the tables gears and planetary";
                Err(conflict(source, format!("mesh.{name}"), rule))
            }
        }
    }

    fn pair(
        &self,
        name: &str,
        mesh: &MeshInput,
        gears: &GearsInput,
        source: &Source,
    ) -> Result<StageParts, CaseError> {
        let (own, shared) = (&mesh.surface, &self.surface);
        let has_own = own.pinion.is_some();
        let Some(pinion) = own.pinion.clone().or_else(|| shared.pinion.clone()) else {
            return Err(self.no_flank(Some(name), mesh, "pinion", source));
        };
        let of_all = |flank: &Option<FlankInput>| flank.clone().filter(|_| !has_own);
        let common = self.common(mesh, pinion);
        let (steel, steels) = (&mesh.material, &self.material);
        let keys = MeshKeys {
            name: format!("mesh \"{name}\""),
            tables: [("gears".to_owned(), format!("mesh.{name}.gears"))]
                .into_iter()
                .chain(own_bulk(name, mesh))
                .chain(own_tables(name, mesh))
                .collect(),
        };
        Ok(StageParts {
            name: Some(name.to_owned()),
            kind: StageKind::Pair,
            teeth: gears.teeth.map(f64::from),
            meshes: vec![MeshParts {
                name: name.to_owned(),
                keys: keys.into(),
                case: CaseInput {
                    gears: gears.clone(),
                    material: MaterialInput {
                        pinion: (steel.pinion.clone())
                            .or_else(|| steels.pinion.clone())
                            .unwrap_or_default(),
                        wheel: (steel.wheel.clone())
                            .or_else(|| steels.wheel.clone().filter(|_| steel.pinion.is_none())),
                    },
                    surface: SurfaceInput {
                        wheel: own.wheel.clone().or_else(|| of_all(&shared.wheel)),
                        coast: own
                            .coast
                            .clone()
                            .or_else(|| shared.coast.clone().filter(|_| !has_own)),
                        ..common.surface
                    },
                    ..common
                },
            }],
            defaults: Vec::new(),
        })
    }

    fn set(
        &self,
        name: Option<&str>,
        mesh: &MeshInput,
        set: &PlanetaryInput,
        source: &Source,
    ) -> Result<StageParts, CaseError> {
        let (own, shared) = (&mesh.surface, &self.surface);
        let of_all = shared.sun.clone().or_else(|| shared.pinion.clone());
        let Some(sun) = own.sun.clone().or(of_all) else {
            return Err(self.no_flank(name, mesh, "sun", source));
        };
        let shared_unless_own = |flank: Option<FlankInput>| flank.filter(|_| own.sun.is_none());
        let (steel, steels) = (&mesh.material, &self.material);
        let input = SetOfCase {
            set,
            steels: [
                (steel.sun.clone())
                    .or_else(|| steels.sun.clone())
                    .or_else(|| steels.pinion.clone()),
                steel.planet.clone().or_else(|| steels.planet.clone()),
                steel.ring.clone().or_else(|| steels.ring.clone()),
            ],
            flanks: [
                (own.planet.clone()).or_else(|| {
                    shared_unless_own(shared.planet.clone().or_else(|| shared.wheel.clone()))
                }),
                (own.ring.clone()).or_else(|| shared_unless_own(shared.ring.clone())),
            ],
            common: self.common(mesh, sun),
        };
        let Some(name) = name else {
            return planetary::stage(&input, source, None, &str::to_owned);
        };
        if mesh.shafts.len() == 3 && set.ring_speed.is_some() {
            let rule = "follows from the shaft of the ring; leave one of the two out";
            return Err(conflict(
                source,
                format!("mesh.{name}.planetary.ring_speed"),
                rule,
            ));
        }
        let own_tables = own_tables(name, mesh);
        let in_train = |key: &str| {
            let own = own_tables
                .iter()
                .find(|(table, _)| key.starts_with(table.as_str()));
            match own {
                Some(_) => format!("mesh.{name}.{key}"),
                None if key.starts_with(planetary::TABLE) => format!("mesh.{name}.{key}"),
                None => key.to_owned(),
            }
        };
        let mut stage = planetary::stage(&input, source, Some(name), &in_train)?;
        if mesh.shafts.len() == 3 {
            let is_of_ring = |default: &DefaultUsed| default.key.ends_with(".ring_speed");
            stage.defaults.retain(|default| !is_of_ring(default));
        }
        for of_set in &mut stage.meshes {
            let keys = Arc::make_mut(&mut of_set.keys);
            keys.tables.extend(own_bulk(name, mesh));
        }
        Ok(stage)
    }

    /// Place of a stage in the gearbox.
    fn place_of(&self, stage: &StageParts) -> MeshPlace {
        let stated = stage.name.as_ref().and_then(|name| self.mesh.get(name));
        let helix = stage.meshes.first().and_then(|mesh| mesh.case.gears.helix);
        MeshPlace {
            name: stage.name.clone().unwrap_or_default(),
            at: stated.and_then(|mesh| mesh.at),
            angle: stated.and_then(|mesh| mesh.angle),
            hand: stated.and_then(|mesh| mesh.hand),
            is_helical: helix.is_some_and(|helix| helix.si() != 0.0),
            is_set: stage.kind != StageKind::Pair,
        }
    }

    /// No flank of `gear` in a mesh and none for all meshes.
    fn no_flank(
        &self,
        name: Option<&str>,
        mesh: &MeshInput,
        gear: &str,
        source: &Source,
    ) -> CaseError {
        const NO_HEIGHT: &str = "does not determine the height of the roughness: state Ra as well, for all meshes as surface.pinion.ra, such as \"0.4 um\"";
        const NO_FLANK: &str = "needs a flank, here or, for all meshes, as surface.pinion: a trace, or surface.finish with surface.pinion.ra";
        let of_mesh = name.map_or(String::new(), |name| format!("mesh.{name}."));
        let (key, rule) = match (mesh.surface.finish, self.surface.finish) {
            (Some(_), _) => (format!("{of_mesh}surface.finish"), NO_HEIGHT),
            (None, Some(_)) => ("surface.finish".to_owned(), NO_HEIGHT),
            (None, None) => (format!("{of_mesh}surface.{gear}"), NO_FLANK),
        };
        conflict(source, key, rule)
    }

    /// Case of `mesh` without gears, steel and flank of the wheel.
    fn common(&self, mesh: &MeshInput, pinion: FlankInput) -> CaseInput {
        let (own, shared) = (&mesh.surface, &self.surface);
        CaseInput {
            formulation: self.formulation,
            operation: OperationInput {
                bulk: mesh.bulk.or(self.operation.bulk),
                ..self.operation
            },
            lubricant: self.lubricant.clone(),
            surface: SurfaceInput {
                pinion,
                finish: own.finish.or(shared.finish),
                form: own.form.or(shared.form),
                cutoff: own.cutoff.or(shared.cutoff),
                noise_cutoff: own.noise_cutoff.or(shared.noise_cutoff),
                ends: own.ends.or(shared.ends),
                outliers: own.outliers.or(shared.outliers),
                ..SurfaceInput::default()
            },
            model: self.model.clone(),
            calibration: self.calibration.clone(),
            ..CaseInput::default()
        }
    }
}

/// W204: planets that do not fit between sun and ring at equal spaces.
fn uneven_planets(stage: &StageParts) -> Option<Warning> {
    let StageKind::Planetary { set, .. } = &stage.kind else {
        return None;
    };
    let [sun, ring] = stage.teeth;
    let text = || {
        let of_mesh = stage.name.as_ref().map(|name| format!("mesh.{name}."));
        format!(
            "{}planetary.planets: {} equally spaced planets cannot be assembled: the {} teeth of sun and ring together are not a multiple of their number",
            of_mesh.unwrap_or_default(),
            set.planets,
            sun + ring
        )
    };
    (!set.can_be_equally_spaced()).then(|| Warning::new(Code::W204, text()))
}

/// Key of the bulk temperature that mesh `name` states itself, with its key in the train.
fn own_bulk(name: &str, mesh: &MeshInput) -> Option<(String, String)> {
    let keys = || ("operation.bulk".to_owned(), format!("mesh.{name}.bulk"));
    mesh.bulk.map(|_| keys())
}

/// Keys of steel and flanks that mesh `name` states itself, with their keys in the train.
fn own_tables(name: &str, mesh: &MeshInput) -> Vec<(String, String)> {
    let keys = |table: &str, stated: Option<Value>| -> Vec<_> {
        let stated = stated.iter().filter_map(Value::as_object).flatten();
        let stated = stated.filter(|(_, value)| !value.is_null());
        let key = |(key, _)| {
            (
                format!("{table}.{key}"),
                format!("mesh.{name}.{table}.{key}"),
            )
        };
        stated.map(key).collect()
    };
    let mut tables = keys("material", serde_json::to_value(&mesh.material).ok());
    tables.extend(keys("surface", serde_json::to_value(&mesh.surface).ok()));
    tables
}
