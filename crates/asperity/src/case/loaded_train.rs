//! A gear train with the loaded case of each of its meshes.

use asperity_core::quantity::Power;

use super::any_input::AnyInput;
use super::defaults::DefaultUsed;
use super::input::CaseInput;
use super::known_keys::first_unknown;
use super::loaded::LoadedCase;
use super::resolve::Case;
use super::source::MeshKeys;
use super::train_flow::{StageKind, Train};
use super::train_gearbox::TrainGearbox;
use super::train_heat_input::HeatInput;
use super::train_parts::{TrainFile, TrainParts};
use crate::error::Error;
use crate::flanks::Surfaces;

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
    /// Seals and bearings, if the case states some.
    pub gearbox: Option<TrainGearbox>,
    /// The case as read.
    pub input: AnyInput,
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

impl From<LoadedCase> for LoadedTrain {
    /// A train of one mesh.
    fn from(case: LoadedCase) -> Self {
        Self {
            title: case.case.title.clone(),
            train: Train::of_pair(&case.case),
            heat: None,
            gearbox: None,
            input: case.case.input.clone().into(),
            defaults: case.case.defaults.clone(),
            stages: vec![LoadedStage {
                name: None,
                meshes: vec![LoadedMesh {
                    name: String::new(),
                    case,
                }],
            }],
        }
    }
}

impl LoadedTrain {
    /// The train of `parts` with the loaded case of each mesh, as `input` states it.
    pub(super) fn of<T: TrainFile + Into<AnyInput>>(
        parts: TrainParts,
        cases: Vec<LoadedCase>,
        input: T,
    ) -> Self {
        let mut defaults: Vec<DefaultUsed> = Vec::new();
        for stage in &parts.stages {
            defaults.extend(stage.defaults.iter().cloned());
        }
        for (mesh, case) in parts.meshes().zip(&cases) {
            add_defaults(&mut defaults, case, &mesh.keys, T::schema());
        }
        let mut cases = cases.into_iter();
        let stages = parts.stages.into_iter().map(|stage| LoadedStage {
            name: stage.name,
            meshes: (stage.meshes.into_iter().zip(cases.by_ref()))
                .map(|(mesh, case)| LoadedMesh {
                    name: mesh.name,
                    case,
                })
                .collect(),
        });
        Self {
            heat: parts.heat,
            gearbox: parts.gearbox,
            title: parts.title,
            train: parts.train,
            stages: stages.collect(),
            input: input.into(),
            defaults,
        }
    }

    /// The case of a single pair of gears.
    #[must_use]
    pub fn pair(&self) -> Option<&LoadedCase> {
        match (&self.input, &self.stages[..]) {
            (AnyInput::Mesh(_), [stage]) => stage.meshes.first().map(|mesh| &mesh.case),
            _ => None,
        }
    }

    /// The train with a change of the case of every mesh.
    ///
    /// # Errors
    /// When a changed case cannot be completed.
    pub fn with(&self, change: &dyn Fn(&mut CaseInput)) -> Result<Self, Error> {
        let mut other = self.clone();
        for mesh in other.stages.iter_mut().flat_map(|stage| &mut stage.meshes) {
            mesh.case = mesh.case.with(|input| change(input))?;
        }
        Ok(other)
    }

    /// The train with user-defined laws in the case of every mesh, as `laws` puts them into a case.
    #[must_use]
    pub fn with_laws(mut self, laws: &dyn Fn(Case) -> Case) -> Self {
        for mesh in self.stages.iter_mut().flat_map(|stage| &mut stage.meshes) {
            mesh.case.case = laws(mesh.case.case.clone());
        }
        let first = self.meshes().next();
        let named: Vec<DefaultUsed> = (first.into_iter())
            .flat_map(|mesh| mesh.case.case.own_laws().cloned())
            .collect();
        let is_replaced = |row: &DefaultUsed| named.iter().any(|law| law.key == row.key);
        self.defaults.retain(|row| !is_replaced(row));
        self.defaults.extend(named);
        self
    }

    /// Turns of the input shaft for one turn of the output shaft, the only one that turns and whose torque follows.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        if let Some(pair) = self.pair() {
            return Some(pair.case.gears.ratio);
        }
        let shafts = &self.train.shafts;
        let speeds = shafts.speeds().ok()?;
        let ends = shafts.shafts.iter().zip(&speeds);
        let mut outputs = ends.filter(|(shaft, speed)| shaft.torque.is_none() && speed.si() != 0.0);
        let (_, output) = outputs.next()?;
        let ratio = (speeds[Train::INPUT].si() / output.si()).abs();
        outputs.next().is_none().then_some(ratio)
    }

    /// Number of the first mesh with the flanks of each mesh: errors of model and sampling are drawn once for equal flanks.
    #[must_use]
    pub fn first_with_flanks(&self) -> Vec<usize> {
        let flanks: Vec<&Surfaces> = self.meshes().map(|mesh| &mesh.case.surfaces).collect();
        let first = |(k, own): (usize, &&Surfaces)| {
            let same = flanks.iter().position(|other| other.has_flanks_of(own));
            same.unwrap_or(k)
        };
        flanks.iter().enumerate().map(first).collect()
    }

    /// Loss of the train with the loss of one of the equal meshes of each kind.
    #[must_use]
    pub fn loss(&self, of_meshes: &[Power]) -> Power {
        let stages = self.train.kinds.iter().zip(self.by_stage(of_meshes));
        stages.fold(Power::from_si(0.0), |sum, (kind, losses)| {
            sum + kind.loss(&losses)
        })
    }

    /// Number of equal meshes of each mesh.
    #[must_use]
    pub fn counts(&self) -> Vec<u32> {
        let stages = self.stages.iter().zip(&self.train.kinds);
        let of_stage =
            |(stage, kind): (&LoadedStage, &StageKind)| vec![kind.count(); stage.meshes.len()];
        stages.flat_map(of_stage).collect()
    }

    /// `values` of all meshes by stage.
    #[must_use]
    pub fn by_stage<T: Copy>(&self, values: &[T]) -> Vec<Vec<T>> {
        let mut rest = values.iter().copied();
        let of_stage = |stage: &LoadedStage| rest.by_ref().take(stage.meshes.len()).collect();
        self.stages.iter().map(of_stage).collect()
    }

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
