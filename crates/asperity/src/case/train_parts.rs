//! A gear train from the inputs of its meshes: loads from the operating point, then the loaded cases.

use std::sync::Arc;

use asperity_core::quantity::Length;
use asperity_gear::GearError;
use asperity_gear::gear_train::GearTrain;

use super::case_file::CaseFile;
use super::defaults::DefaultUsed;
use super::error::CaseError;
use super::input::CaseInput;
use super::known_keys::first_unknown;
use super::loaded::LoadedCase;
use super::resolve::title_by_gears;
use super::source::{MeshKeys, Source};
use super::train_flow::{StageKind, Train};
use super::train_heat_input::HeatInput;

/// A gear train, ready to run.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct LoadedTrain {
    /// Title.
    pub title: String,
    /// Shafts and stages with the operating point.
    pub train: Train,
    /// Meshes of each stage, in the order of the power.
    pub stages: Vec<LoadedStage>,
    /// Heat balance, if the case states one.
    pub heat: Option<HeatInput>,
    /// The case as read.
    pub input: serde_json::Value,
    /// Every default in use, by the keys of the train.
    pub defaults: Vec<DefaultUsed>,
}

/// A pair of gears or a planetary set of a gear train.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct LoadedStage {
    /// Name in the case; `None` for the set of a case `[planetary]`.
    pub name: Option<String>,
    /// Its kinds of meshes: one, or sun and planet, planet and ring.
    pub meshes: Vec<LoadedMesh>,
}

/// A mesh of a gear train, or one of the equal ones of a planetary set.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct LoadedMesh {
    /// Name.
    pub name: String,
    /// The case at its torque and speed.
    pub case: LoadedCase,
}

impl LoadedTrain {
    /// All meshes, in the order of the power.
    pub fn meshes(&self) -> impl Iterator<Item = &LoadedMesh> {
        self.stages.iter().flat_map(|stage| &stage.meshes)
    }

    /// The mesh called `name`.
    #[must_use]
    pub fn mesh(&self, name: &str) -> Option<&LoadedMesh> {
        self.meshes().find(|mesh| mesh.name == name)
    }

    /// Names of all meshes, separated by commas.
    #[must_use]
    pub fn names(&self) -> String {
        let names = self.meshes().map(|mesh| format!("\"{}\"", mesh.name));
        names.collect::<Vec<_>>().join(", ")
    }

    /// The planetary set of a case `[planetary]`, which is the whole train.
    #[must_use]
    pub fn only_set(&self) -> Option<&StageKind> {
        match (&self.stages[..], &self.train.kinds[..]) {
            ([LoadedStage { name: None, .. }], [kind]) => Some(kind),
            _ => None,
        }
    }
}

/// A case file of a gear train.
pub(super) trait TrainFile: CaseFile {
    /// Table that describes the gears.
    const TABLE: &'static str;

    /// The train and the case of each mesh.
    fn parts(&self, source: &Source) -> Result<TrainParts, CaseError>;
}

/// A gear train with the inputs of its meshes, before their traces are read.
pub(super) struct TrainParts {
    pub heat: Option<HeatInput>,
    title: String,
    train: Train,
    stages: Vec<StageParts>,
}

/// Input of the meshes of a stage.
pub(super) struct StageParts {
    pub name: Option<String>,
    pub kind: StageKind,
    /// Tooth numbers of the gears on shafts, the second negative if it turns in the direction of the first.
    pub teeth: [f64; 2],
    pub meshes: Vec<MeshParts>,
    pub defaults: Vec<DefaultUsed>,
}

/// Input of a mesh.
pub(super) struct MeshParts {
    pub name: String,
    pub keys: Arc<MeshKeys>,
    pub case: CaseInput,
}

impl TrainParts {
    /// The meshes of `stages` on `shafts`, with the loads that follow from the operating point.
    pub fn new(
        title: Option<String>,
        shafts: GearTrain,
        passes_losses: bool,
        stages: Vec<StageParts>,
    ) -> Result<Self, GearError> {
        let train = Train {
            shafts,
            kinds: stages.iter().map(|stage| stage.kind.clone()).collect(),
            passes_losses,
        };
        let gears = || {
            stages
                .iter()
                .flat_map(|stage| &stage.meshes)
                .map(|mesh| &mesh.case.gears)
        };
        let module = gears().map(|gears| gears.module).next();
        let title = title.unwrap_or_else(|| {
            let mut teeth: Vec<u32> = Vec::new();
            for pair in gears().map(|gears| gears.teeth.map(i32::unsigned_abs)) {
                // A planet is in two meshes.
                let is_planet = teeth.last() == pair.first() && stages.len() == 1;
                teeth.extend(&pair[usize::from(is_planet)..]);
            }
            title_by_gears(&teeth, module.unwrap_or(Length::from_si(0.0)))
        });
        let mut stages = stages;
        let flow = train.flow(&[])?;
        for (stage, loads) in stages.iter_mut().zip(&flow.loads) {
            for (mesh, load) in stage.meshes.iter_mut().zip(loads) {
                mesh.case.operation.torque = load.torque;
                mesh.case.operation.speed = load.speed;
                mesh.case.title = Some(format!("{title}: {}", mesh.name));
            }
        }
        Ok(Self {
            heat: None,
            title,
            train,
            stages,
        })
    }

    pub fn meshes(&self) -> impl Iterator<Item = &MeshParts> {
        self.stages.iter().flat_map(|stage| &stage.meshes)
    }

    /// The train with the loaded case of each mesh.
    pub fn loaded<T: TrainFile>(self, cases: Vec<LoadedCase>, input: &T) -> LoadedTrain {
        let mut defaults: Vec<DefaultUsed> = Vec::new();
        for stage in &self.stages {
            defaults.extend(stage.defaults.iter().cloned());
        }
        for (mesh, case) in self.meshes().zip(&cases) {
            add_defaults(&mut defaults, case, &mesh.keys, T::schema());
        }
        let mut cases = cases.into_iter();
        let stages = self.stages.into_iter().map(|stage| LoadedStage {
            name: stage.name,
            meshes: (stage.meshes.into_iter().zip(cases.by_ref()))
                .map(|(mesh, case)| LoadedMesh {
                    name: mesh.name,
                    case,
                })
                .collect(),
        });
        LoadedTrain {
            heat: self.heat,
            title: self.title,
            train: self.train,
            stages: stages.collect(),
            // The input was read from text, so that it is text again.
            input: serde_json::to_value(input).unwrap_or_default(),
            defaults,
        }
    }
}

/// Adds the defaults of a mesh that are keys of the train.
fn add_defaults(
    defaults: &mut Vec<DefaultUsed>,
    mesh: &LoadedCase,
    keys: &MeshKeys,
    schema: &serde_json::Value,
) {
    for default in &mesh.case.defaults {
        let key = match keys.in_train(&default.key) {
            Some(in_train) => in_train.into(),
            None => default.key.clone(),
        };
        let is_known = first_unknown(schema, std::iter::once(&*key)).is_none();
        if is_known && defaults.iter().all(|before| before.key != key) {
            defaults.push(DefaultUsed {
                key,
                ..default.clone()
            });
        }
    }
}

/// A train that does not turn, or gears that cannot mesh, at `key`.
pub(super) fn refused<'a>(
    source: &'a Source,
    key: &str,
) -> impl Fn(GearError) -> CaseError + use<'a> {
    let place = source.place_of_key(key);
    move |error| CaseError::Gears {
        place: place.clone(),
        source: error,
    }
}

/// Keys of a train that exclude or need each other, at `key`.
pub(super) fn conflict(source: &Source, key: String, rule: &'static str) -> CaseError {
    CaseError::Conflict {
        place: source.place_of(&key),
        key: key.into(),
        rule,
    }
}
