//! Keys of a gear train, and the case of each mesh that they state.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use asperity_core::Code;
use asperity_core::quantity::{AngularSpeed, Torque};
use asperity_gear::gear_train::{GearTrain, Shaft, Stage};
use serde_json::Value;

use super::planetary::{self, SetOfCase};
use super::train_parts::{MeshParts, StageParts, TrainParts, conflict, mesh_folder, refused};
use crate::input::case_input::{
    CaseInput, FlankInput, GearsInput, MaterialInput, OperationInput, SurfaceInput, is_unstated,
    stated,
};
use crate::input::files::Reader;
use crate::input::mesh_input::{MeshInput, PassedLosses, PlanetaryInput, ShaftsInput};
use crate::input::ranges::{JudgedValue, refuse_impossible, unusual};
use crate::input::rows::{Judge, KeyPath, RangedKey};
use crate::input::train_heat_input::HeatInput;
use crate::resolved::gearbox::MeshPlace;
use crate::resolved::shafting::StageKind;
use crate::source::case_error::CaseError;
use crate::source::defaults::DefaultUsed;
use crate::source::section::domain;
use crate::source::source_text::{MeshKeys, Source};
use asperity_core::message::Warning;

/// The case of a mesh, with its keys in a case whose meshes have names.
pub(crate) type CaseOfMesh = (CaseInput, Option<Arc<MeshKeys>>);

/// The tables of a case with named meshes that are not of a single mesh: what a mesh has is checked with its case.
pub(crate) struct OfAllMeshes<'a>(pub &'a CaseInput);

impl JudgedValue for OfAllMeshes<'_> {}

impl RangedKey for OfAllMeshes<'_> {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        let case = stated.map(|of| of.0);
        let set = case.map(|case| &case.planetary);
        RangedKey::visit(set, at.below(planetary::TABLE), judge);
        RangedKey::visit(case.map(|case| &case.mesh), at.below("mesh"), judge);
        RangedKey::visit(case.map(|case| &case.heat), at.below("heat"), judge);
        RangedKey::visit(case.map(|case| &case.gearbox), at.below("gearbox"), judge);
        RangedKey::visit(case.map(|case| &case.map), at.below("map"), judge);
        RangedKey::visit(case.map(|case| &case.vehicle), at.below("vehicle"), judge);
    }
}

impl CaseInput {
    /// Tables that describe gears with names.
    pub(crate) const NAMED: [&'static str; 2] = ["mesh", planetary::TABLE];

    /// Whether the meshes have names: they are stated as `mesh.NAME` or `planetary`.
    #[must_use]
    pub fn names_meshes(&self) -> bool {
        !self.mesh.is_empty() || self.planetary.is_some()
    }

    /// Tables of losses of the gearbox of a case with named meshes.
    pub(crate) fn own_tables(&self) -> impl Iterator<Item = &Path> {
        let gearbox = self.gearbox.as_ref().filter(|_| self.names_meshes());
        let tables = gearbox.into_iter().flat_map(|gearbox| &gearbox.tables);
        tables.map(|table| table.file.as_path())
    }

    /// Largest torque and speed of the default axes of a map.
    #[must_use]
    pub fn map_limits(&self) -> (Torque, AngularSpeed) {
        let map = self.map.unwrap_or_default();
        (
            map.torque_max.unwrap_or(self.operation.torque),
            map.speed_max.unwrap_or(self.operation.speed),
        )
    }

    /// The case of each mesh; with its keys where meshes have names.
    pub(crate) fn of_meshes(
        &self,
        source: &Source,
        files: Reader<'_>,
    ) -> Result<Vec<CaseOfMesh>, CaseError> {
        if !self.names_meshes() {
            return Ok(vec![(self.clone(), None)]);
        }
        let parts = self.parts(source, files)?;
        let meshes = parts.stages.into_iter().flat_map(|stage| stage.meshes);
        Ok(meshes.map(|mesh| (mesh.case, Some(mesh.keys))).collect())
    }

    /// The train and the case of each mesh, where meshes have names.
    pub(crate) fn parts(
        &self,
        source: &Source,
        files: Reader<'_>,
    ) -> Result<TrainParts, CaseError> {
        refuse_impossible(&OfAllMeshes(self), source)?;
        let (shafts, stages) = match &self.planetary {
            Some(set) => self.single_set(set, source)?,
            None => self.on_shafts(source)?,
        };
        let train = self.train.as_ref();
        let passes_losses = train.and_then(|train| train.losses) == Some(PassedLosses::PassedOn);
        let places = stages.iter().map(|stage| self.place_of(stage));
        let places: Vec<MeshPlace> = places.collect();
        let gearbox = self.gearbox.as_ref();
        let gearbox = gearbox.map(|stated| stated.gearbox(places, &shafts, source, &files));
        let gearbox = gearbox.transpose()?;
        let [meshes, set] = Self::NAMED;
        let table = if self.planetary.is_some() {
            set
        } else {
            meshes
        };
        let mut parts = TrainParts::new(self.title.clone(), shafts, passes_losses, stages)
            .map_err(refused(source, table))?;
        parts.heat = self.checked_heat(source)?;
        parts.warnings = unusual(&OfAllMeshes(self), source);
        let of_tables = gearbox.iter().flat_map(|gearbox| &gearbox.warnings);
        parts.warnings.extend(of_tables.cloned());
        parts.gearbox = gearbox;
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
        let stage = self.planetary_stage(None, &MeshInput::default(), set, source)?;
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

    /// The meshes in the order of the power from the input shaft on, and the shafts.
    fn in_order<'a>(
        &'a self,
        mut stages: BTreeMap<&'a str, StageParts>,
        input: &'a str,
        source: &Source,
    ) -> Result<Ordered<'a>, CaseError> {
        let mut ordered = Vec::new();
        let mut shafts = vec![input];
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
        Ok((ordered, shafts))
    }

    /// Refuses ends of the train that are on no mesh.
    fn check_ends(&self, stated: &ShaftsInput, source: &Source) -> Result<(), CaseError> {
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
        Ok(())
    }

    /// The shaft at which the power leaves.
    fn output<'a>(
        &self,
        stated: &'a ShaftsInput,
        shafts: &[&'a str],
        source: &Source,
    ) -> Result<&'a str, CaseError> {
        let ends = |shaft: &str| {
            let all = self.mesh.values().flat_map(|mesh| &mesh.shafts);
            all.filter(|name| *name == shaft).count() == 1
        };
        let is_held = |shaft: &str| stated.held.iter().any(|held| held == shaft);
        let input = stated.input.as_str();
        let mut outputs = shafts
            .iter()
            .filter(|shaft| ends(shaft) && !is_held(shaft) && **shaft != input);
        match (&stated.output, outputs.next(), outputs.next()) {
            (Some(output), _, _) => Ok(output),
            (None, Some(output), None) => Ok(*output),
            _ => {
                let rule = "is needed: the shaft at which the power leaves is not the only other end of the train";
                Err(conflict(source, "train.output".to_owned(), rule))
            }
        }
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
        let (ordered, shafts) = self.in_order(stages, &stated.input, source)?;
        self.check_ends(stated, source)?;
        let operation = &self.operation;
        let output = self.output(stated, &shafts, source)?;
        let is_held = |shaft: &str| stated.held.iter().any(|held| held == shaft);
        let input = stated.input.as_str();
        for shaft in &shafts {
            let is_input = *shaft == input;
            let zero = Torque::from_si(0.0);
            train.shafts.push(Shaft {
                name: (*shaft).to_owned(),
                speed: if is_held(shaft) {
                    Some(AngularSpeed::from_si(0.0))
                } else {
                    is_input.then_some(operation.speed)
                },
                torque: if *shaft == output || is_held(shaft) {
                    None
                } else {
                    Some(if is_input { operation.torque } else { zero })
                },
                drag: zero,
            });
        }
        check_folders(&ordered, source)?;
        let place = |name: &String| shafts.iter().position(|shaft| shaft == name).unwrap_or(0);
        for (name, stage) in &ordered {
            let on: Vec<usize> = self.mesh[*name].shafts.iter().map(place).collect();
            let (gears, carrier) = match on[..] {
                [sun, carrier, ring] => ([sun, ring], Some(carrier)),
                [sun, carrier] if matches!(stage.kind, StageKind::Planetary { .. }) => {
                    let set = self.mesh[*name].planetary.as_ref();
                    let ring_speed = set.and_then(|set| set.ring_speed);
                    train.shafts.push(Shaft {
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
            train.stages.push(Stage {
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
            (Some(gears), None) => self.pair_stage(name, mesh, gears, source),
            (None, Some(set)) => self.planetary_stage(Some(name), mesh, set, source),
            _ => {
                let rule = "must have one of the tables gears and planetary";
                Err(conflict(source, format!("mesh.{name}"), rule))
            }
        }
    }

    fn pair_stage(
        &self,
        name: &str,
        mesh: &MeshInput,
        gears: &GearsInput,
        source: &Source,
    ) -> Result<StageParts, CaseError> {
        let (own, shared) = (&mesh.surface, &self.surface);
        let has_own = !is_unstated(&own.pinion);
        let Some(pinion) = stated(&own.pinion).or_else(|| stated(&shared.pinion)) else {
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
                .chain(keys_of_own(name, mesh))
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
                        pinion: stated(&steel.pinion).unwrap_or_else(|| steels.pinion.clone()),
                        wheel: (steel.wheel.clone()).or_else(|| {
                            steels.wheel.clone().filter(|_| is_unstated(&steel.pinion))
                        }),
                        ..MaterialInput::default()
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

    fn planetary_stage(
        &self,
        name: Option<&str>,
        mesh: &MeshInput,
        set: &PlanetaryInput,
        source: &Source,
    ) -> Result<StageParts, CaseError> {
        let (own, shared) = (&mesh.surface, &self.surface);
        let of_all = shared.sun.clone().or_else(|| stated(&shared.pinion));
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
                    .or_else(|| stated(&steels.pinion)),
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
        let own_tables = keys_of_own(name, mesh);
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

/// Steel or flanks without the keys that are not stated.
pub(crate) fn without_nulls(mut table: Value) -> Value {
    if let Some(keys) = table.as_object_mut() {
        let is_empty = |body: &Value| {
            let keys = body.as_object();
            keys.is_some_and(|keys| keys.values().all(Value::is_null))
        };
        keys.retain(|key, value| !value.is_null() && (key != "pinion" || !is_empty(value)));
    }
    table
}

/// Key of the bulk temperature that mesh `name` states itself, with its key in the train.
fn own_bulk(name: &str, mesh: &MeshInput) -> Option<(String, String)> {
    let keys = || ("operation.bulk".to_owned(), format!("mesh.{name}.bulk"));
    mesh.bulk.map(|_| keys())
}

/// Keys of steel and flanks that mesh `name` states itself, with their keys in the train.
fn keys_of_own(name: &str, mesh: &MeshInput) -> Vec<(String, String)> {
    let keys = |table: &str, stated: Option<Value>| -> Vec<_> {
        let stated = stated.map(without_nulls).unwrap_or_default();
        let stated = stated.as_object().into_iter().flatten();
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

/// Meshes in the order of the power, and shafts.
type Ordered<'a> = (Vec<(&'a str, StageParts)>, Vec<&'a str>);

/// Refuses meshes that would share a result folder.
fn check_folders(ordered: &[(&str, StageParts)], source: &Source) -> Result<(), CaseError> {
    let mut folders = Vec::new();
    for (name, stage) in ordered {
        for mesh in &stage.meshes {
            // Some file systems take capitals for small letters.
            let folder = mesh_folder(&mesh.name).to_lowercase();
            if folders.contains(&folder) {
                let rule = "would have the result folder of another mesh; change one of the names";
                return Err(conflict(source, format!("mesh.{name}"), rule));
            }
            folders.push(folder);
        }
    }
    Ok(())
}
