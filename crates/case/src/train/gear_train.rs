//! A case as a train: pairs of gears and planetary sets on common shafts, each mesh an ordinary case of its own.
//!
//! A case with `[gears]` is a train of one mesh, which has no name. A case with `[mesh.NAME]` tables has several meshes; a case
//! with `[planetary]` is a train of one planetary set. Oil, operating point and model are common to all meshes. Torque and
//! speed of the operation are at the input shaft.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use asperity_core::quantity::Power;

use super::train_parts::{MeshParts, TrainParts};
use crate::error::{Error, PositionError};
use crate::fingerprint::Fingerprint;
use crate::input::case_input::CaseInput;
use crate::input::files::{FileContents, FileSums, HeldTrace, Reader};
use crate::laws::Laws;
use crate::loaded::loaded_case::LoadedCase;
use crate::resolved::gearbox::Gearbox;
use crate::resolved::shafting::{Shafting, StageKind};
use crate::source::case_error::CaseError;
use crate::source::defaults::DefaultUsed;
use crate::source::source_text::{MeshKeys, Source};
use crate::text::is_key_of_named_meshes;
use asperity_core::message::Warning;
use asperity_flanks::Surfaces;

pub use super::train_parts::mesh_folder;
pub use crate::input::mesh_input::{MeshInput, PassedLosses, ShaftsInput};
pub use crate::input::train_heat_input::HeatInput;

/// A case, ready to run: one or several meshes on shafts.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Train {
    /// Title.
    pub title: String,
    /// Shafts and stages with the operating point.
    pub shafting: Shafting,
    /// Meshes of each stage, in the order of the power.
    pub stages: Vec<LoadedStage>,
    /// Heat balance, if the case states one.
    pub heat: Option<HeatInput>,
    /// Seals and bearings, if the case states some.
    pub gearbox: Option<Gearbox>,
    /// The case as read.
    pub input: CaseInput,
    /// Every default in use, by the keys of the train.
    pub defaults: Vec<DefaultUsed>,
    /// Warnings about the train as a whole.
    pub warnings: Vec<Warning>,
    /// Sums of the tables of its gearbox.
    sums: FileSums,
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

/// Completion of the case of a mesh, which has parts if it has a name.
type Completion<'a> = &'a dyn Fn(&CaseInput, Option<&MeshParts>) -> Result<LoadedCase, CaseError>;

impl From<LoadedCase> for Train {
    /// A train of one mesh.
    fn from(case: LoadedCase) -> Self {
        Self {
            title: case.case.title.clone(),
            shafting: Shafting::of_one_mesh(&case.case),
            heat: None,
            gearbox: case.case.gearbox.clone(),
            input: case.case.input.clone(),
            defaults: case.case.defaults.clone(),
            warnings: Vec::new(),
            sums: FileSums::new(),
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

impl<'a> From<&'a Train> for Cow<'a, Train> {
    fn from(train: &'a Train) -> Self {
        Self::Borrowed(train)
    }
}

impl From<Train> for Cow<'_, Train> {
    fn from(train: Train) -> Self {
        Self::Owned(train)
    }
}

impl From<&LoadedCase> for Cow<'_, Train> {
    /// A train of one mesh.
    fn from(case: &LoadedCase) -> Self {
        Self::Owned(case.clone().into())
    }
}

impl Train {
    /// The train of `parts` with the loaded case of each mesh, as `input` states it.
    pub(crate) fn from_parts(parts: TrainParts, cases: Vec<LoadedCase>, input: CaseInput) -> Self {
        let mut defaults: Vec<DefaultUsed> = Vec::new();
        for stage in &parts.stages {
            defaults.extend(stage.defaults.iter().cloned());
        }
        for (mesh, case) in parts.meshes().zip(&cases) {
            add_defaults(&mut defaults, case, &mesh.keys);
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
            sums: parts.sums,
            title: parts.title,
            shafting: parts.train,
            stages: stages.collect(),
            input,
            defaults,
            warnings: parts.warnings,
        }
    }

    /// The case of the only mesh, which has no name: a pair of gears, or one mesh of a train.
    #[must_use]
    pub fn only(&self) -> Option<&LoadedCase> {
        match &self.stages[..] {
            [LoadedStage { meshes, .. }] => match &meshes[..] {
                [LoadedMesh { name, case }] if name.is_empty() => Some(case),
                _ => None,
            },
            _ => None,
        }
    }

    /// The case of the only mesh, for what takes one mesh.
    ///
    /// # Errors
    /// When the case has several meshes.
    pub fn only_mesh(&self) -> Result<&LoadedCase, Error> {
        let file = self.cases().next().map_or("", LoadedCase::name);
        let several = || CaseError::several_meshes(file, self.names());
        Ok(self.only().ok_or_else(several)?)
    }

    /// As [`only_mesh`](Self::only_mesh).
    #[cfg(feature = "case-files")]
    pub(crate) fn into_only_mesh(mut self) -> Result<LoadedCase, Error> {
        self.only_mesh()?;
        let only = self.stages.pop().and_then(|mut stage| stage.meshes.pop());
        let none = || Error::Whole(Box::new(PositionError::no_profile()));
        Ok(only.ok_or_else(none)?.case)
    }

    /// The case of the mesh called `name` only.
    ///
    /// # Errors
    /// When the case has no such mesh, or a single one.
    pub fn of_mesh(&self, name: &str) -> Result<Self, Error> {
        if let Some(mesh) = self.mesh(name).filter(|_| self.only().is_none()) {
            return Ok(mesh.case.clone().into());
        }
        let file = self.cases().next().map_or("", LoadedCase::name);
        let meshes = self.only().is_none().then(|| self.names());
        Err(CaseError::no_mesh(file, name, meshes.as_deref()))?
    }

    /// The case of every mesh, in the order of the power.
    pub fn cases(&self) -> impl Iterator<Item = &LoadedCase> {
        self.meshes().map(|mesh| &mesh.case)
    }

    /// The train with a change of the case of every mesh.
    ///
    /// # Errors
    /// When a changed case cannot be completed.
    pub fn with(&self, change: &dyn Fn(&mut CaseInput)) -> Result<Self, Error> {
        self.with_each(&|_, _, input| change(input))
    }

    /// The train with a change of the case of every mesh, which may depend on the name of the stage, if it has one, and the
    /// name of the mesh.
    ///
    /// # Errors
    /// When a changed case cannot be completed.
    pub fn with_each(
        &self,
        change: &dyn Fn(Option<&str>, &str, &mut CaseInput),
    ) -> Result<Self, Error> {
        let mut other = self.clone();
        for stage in &mut other.stages {
            for mesh in &mut stage.meshes {
                let (stage, name) = (stage.name.as_deref(), &mesh.name);
                mesh.case = mesh.case.with(|input| change(stage, name, input))?;
            }
        }
        Ok(other)
    }

    /// The train of the meshes that `input` states, each completed by `case`, which takes the case of the mesh, and the mesh if it
    /// has a name.
    pub(crate) fn made_of(
        input: CaseInput,
        source: &Source,
        files: Reader<'_>,
        case: Completion<'_>,
    ) -> Result<Self, CaseError> {
        if !input.names_meshes() {
            return case(&input, None).map(Self::from);
        }
        let parts = input.parts(source, files)?;
        let cases = parts.meshes().map(|mesh| case(&mesh.case, Some(mesh)));
        let cases = cases.collect::<Result<_, _>>()?;
        Ok(Self::from_parts(parts, cases, input))
    }

    /// The train with another input, checked again; traces are read again only if the input affects them.
    ///
    /// # Errors
    /// When the changed train cannot be run.
    pub fn with_input(&self, input: CaseInput) -> Result<Self, Error> {
        let Some(first) = self.cases().next() else {
            return Err(Error::Whole(Box::new(PositionError::no_profile())));
        };
        let changed = Self::made_of(input, &first.source(), first.reader(), &|case, mesh| {
            let before = mesh.and_then(|mesh| self.mesh(&mesh.name));
            let before = before.map_or(first, |before| &before.case);
            before.changed_to(case.clone(), mesh.map(|mesh| &mesh.keys))
        });
        Ok(changed?)
    }

    /// The inputs of the meshes that `input` states; none if it cannot be completed.
    fn inputs_of(&self, input: &CaseInput) -> Vec<CaseInput> {
        let first = self.cases().next();
        let cases = first.and_then(|first| input.of_meshes(&first.source(), first.reader()).ok());
        let cases = cases.into_iter().flatten();
        cases.map(|(case, _)| case).collect()
    }

    /// Files that the train would read with any of `inputs`, and their SHA-256; unreadable files are left out.
    #[must_use]
    pub fn files_of(&self, inputs: &[CaseInput]) -> FileSums {
        let Some(first) = self.meshes().next() else {
            return FileSums::new();
        };
        let of_meshes = inputs.iter().flat_map(|input| self.inputs_of(input));
        let mut sums = first.case.files_of(&of_meshes.collect::<Vec<_>>());
        sums.extend(
            first
                .case
                .sums_of_files(inputs.iter().flat_map(CaseInput::own_tables)),
        );
        sums
    }

    /// Files that were read for the train, and their SHA-256.
    #[must_use]
    pub fn files_read(&self) -> FileSums {
        let of_meshes = self.meshes().flat_map(|mesh| mesh.case.files_read());
        of_meshes.chain(self.sums.clone()).collect()
    }

    /// Content of every file that was read for the train.
    ///
    /// # Errors
    /// As [`LoadedCase::contents`].
    pub fn contents(&self) -> Result<FileContents, Error> {
        let mut contents = FileContents::new();
        for mesh in self.meshes() {
            contents.extend(mesh.case.contents()?);
            contents.extend(mesh.case.contents_of(&self.sums)?);
        }
        Ok(contents)
    }

    /// The train with `folder` as the folder of files that a change names, as [`LoadedCase::in_folder`].
    #[must_use]
    pub fn in_folder(mut self, folder: &Path) -> Self {
        for mesh in self.stages.iter_mut().flat_map(|stage| &mut stage.meshes) {
            mesh.case = mesh.case.clone().in_folder(folder);
        }
        self
    }

    /// The train with further traces in memory, under names that a change can state as files.
    #[must_use]
    pub fn holding<T: Clone + Into<HeldTrace>>(mut self, traces: &[(PathBuf, T)]) -> Self {
        for mesh in self.stages.iter_mut().flat_map(|stage| &mut stage.meshes) {
            mesh.case = mesh.case.holding(traces);
        }
        self
    }

    /// SHA-256 of everything that determines the result, as [`LoadedCase::fingerprint`].
    #[must_use]
    pub fn fingerprint(&self) -> String {
        if let Some(only) = self.only() {
            return only.fingerprint();
        }
        let mut sum = Fingerprint::default().with(format!("{:?}", self.input));
        for mesh in self.meshes() {
            sum = sum.with(mesh.case.fingerprint());
        }
        for (name, of_file) in &self.sums {
            sum = sum.with(name.as_os_str().as_encoded_bytes()).with(of_file);
        }
        sum.hex()
    }

    /// The train with user-defined laws in the case of every mesh, as `change` states them.
    #[must_use]
    pub fn with_laws(mut self, change: &dyn Fn(&mut Laws)) -> Self {
        for mesh in self.stages.iter_mut().flat_map(|stage| &mut stage.meshes) {
            mesh.case = mesh.case.with_laws(change);
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

    /// Warnings about the train as a whole and about its files.
    #[must_use]
    pub fn all_warnings(&self) -> Vec<&Warning> {
        let of_meshes = self.cases().flat_map(|case| &case.warnings);
        self.warnings.iter().chain(of_meshes).collect()
    }

    /// Turns of the input shaft for one turn of the output shaft, the only one that turns and whose torque follows.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        let shafts = &self.shafting.shafts;
        let speeds = shafts.speeds().ok()?;
        let ends = shafts.shafts.iter().zip(&speeds);
        let mut outputs = ends.filter(|(shaft, speed)| shaft.torque.is_none() && speed.si() != 0.0);
        let (_, output) = outputs.next()?;
        let ratio = (speeds[Shafting::INPUT].si() / output.si()).abs();
        outputs.next().is_none().then_some(ratio)
    }

    /// Number of the first mesh with the flanks of each mesh: errors of model and sampling are drawn once for equal flanks.
    #[must_use]
    pub fn first_with_flanks(&self) -> Vec<usize> {
        let flanks: Vec<&Surfaces> = self.meshes().map(|mesh| &mesh.case.surfaces).collect();
        Surfaces::first_equal(&flanks)
    }

    /// Loss of the train with the loss of one of the equal meshes of each kind.
    #[must_use]
    pub fn loss(&self, of_meshes: &[Power]) -> Power {
        self.shafting.loss(&self.by_stage(of_meshes))
    }

    /// Number of equal meshes of each mesh.
    #[must_use]
    pub fn counts(&self) -> Vec<u32> {
        let stages = self.stages.iter().zip(&self.shafting.kinds);
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
        match (&self.stages[..], &self.shafting.kinds[..]) {
            ([LoadedStage { name: None, .. }], [kind]) => Some(kind),
            _ => None,
        }
    }
}

/// Adds the defaults of a mesh that are keys of the train.
fn add_defaults(defaults: &mut Vec<DefaultUsed>, mesh: &LoadedCase, keys: &MeshKeys) {
    for default in &mesh.case.defaults {
        let key = match keys.in_train(&default.key) {
            Some(in_train) => in_train.into(),
            None => default.key.clone(),
        };
        if is_key_of_named_meshes(&key) && defaults.iter().all(|before| before.key != key) {
            defaults.push(DefaultUsed {
                key,
                ..default.clone()
            });
        }
    }
}
