//! Cases: loaded, changed, run.

use asperity::core::number;
use asperity::message::Code;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity::Run;
use asperity::case::gear_train::{self, LoadedMesh, LoadedTrain};
use asperity::case::{
    self, Content, FileContents, Formulation, LoadedCase, Source, from_contents, load_holding,
    open_source,
};
use asperity::contacts::dry_contact::dry_contact;
use asperity::core::Profile;
use asperity::message::Warning;
use asperity::pipeline::KeptFields;
use asperity::pipeline::{self, RegimeRow};
use asperity::quantity::Length;
use asperity::result::gear_report;
use asperity_calibration::evidence::{execute, execute_train};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::json;

use crate::choices::{Detail, LawOf, named};
use crate::contact::found;
use crate::failure::{self, Failure};
use crate::outcome::{Found, Outcome};
use crate::own_laws::PythonLaw;
use crate::trace::Trace;
use crate::work::{alone, in_parallel};

/// Traces in memory by the names that a case gives them.
pub type Traces<'py> = Vec<(PathBuf, PyRef<'py, Trace>)>;

fn profiles(traces: &Traces<'_>) -> Vec<(PathBuf, Profile)> {
    let held = traces.iter();
    held.map(|(name, trace)| (name.clone(), trace.profile.clone()))
        .collect()
}

/// A gear train or planetary set with the text that it is made from, which is read again with other keys.
#[derive(Clone)]
pub struct Train {
    loaded: Arc<LoadedTrain>,
    source: Source,
    folder: PathBuf,
    keys: Vec<(String, String)>,
    formulation: Option<Formulation>,
    laws: Vec<(LawOf, Arc<PythonLaw>)>,
    /// Files in memory, of a case from its content.
    held: FileContents,
}

/// A case as content, which is pickled.
#[derive(FromPyObject, IntoPyObject)]
#[pyo3(from_item_all)]
struct CaseContent {
    /// Path of the case file as the user gave it.
    name: String,
    /// Text with every key of a pair of gears, or the text of a gear train.
    text: String,
    /// Keys of a gear train set past its text; `None` for a pair of gears.
    keys: Option<Vec<(String, String)>>,
    /// Formulation of a gear train, over that of its text.
    formulation: Option<String>,
    /// Absolute folder that names of files are relative to.
    folder: PathBuf,
    /// Every file that was read.
    files: Vec<(PathBuf, Vec<u8>)>,
    /// Traces in memory: spacing in m, and heights in m as little-endian bytes.
    traces: Vec<(PathBuf, f64, Vec<u8>)>,
}

impl CaseContent {
    fn contents(
        files: Vec<(PathBuf, Vec<u8>)>,
        traces: Vec<(PathBuf, f64, Vec<u8>)>,
    ) -> Result<FileContents, Failure> {
        let files = files.into_iter();
        let mut contents: FileContents = files
            .map(|(name, bytes)| (name, Content::Bytes(bytes.into())))
            .collect();
        for (name, spacing, bytes) in traces {
            let (numbers, _) = bytes.as_chunks();
            let heights = numbers.iter().map(|number| f64::from_le_bytes(*number));
            let profile = Profile::new(Length::from_si(spacing), heights.collect())?;
            contents.insert(name, Content::Heights(profile.into()));
        }
        Ok(contents)
    }
}

/// A case of either kind.
#[derive(Clone)]
enum Kind {
    Pair(Arc<LoadedCase>),
    Train(Box<Train>),
}

/// A case, checked, with its traces.
#[pyclass(frozen, module = "asperity._asperity")]
#[derive(Clone)]
pub struct Case {
    kind: Kind,
}

/// JSON schema of a case file with the tables `kind`: `gears`, or `planetary` and `mesh` of a gear train.
#[pyfunction]
pub fn schema(kind: &str) -> PyResult<String> {
    let schema = match kind {
        "planetary" | "mesh" => gear_train::schema(),
        _ => case::schema(),
    };
    Ok(failure::json(&schema)?)
}

fn formulation_of(name: Option<&str>) -> Result<Option<Formulation>, Failure> {
    name.map(|name| named("formulation", name)).transpose()
}

fn name_of(formulation: Formulation) -> String {
    let name = json!(formulation);
    name.as_str().unwrap_or_default().to_owned()
}

/// Film and regime of a mesh.
#[derive(serde::Serialize)]
struct MeshRegime {
    title: String,
    rows: Vec<RegimeRow>,
}

fn traces_of_train() -> Failure {
    let message =
        "a case of several meshes takes its traces from files; write them with Profile.write";
    Failure::new(Code::E205, message)
}

impl Train {
    /// The train read again, files in memory before those in `folder`.
    fn read(self, folder: Option<&Path>) -> Result<Self, Failure> {
        let loaded = gear_train::load_holding(
            self.source.clone(),
            folder,
            self.held.clone(),
            &self.keys,
            self.formulation,
        )?;
        Ok(Self {
            loaded: loaded.in_folder(&self.folder).into(),
            ..self
        })
    }
}

/// Warnings of all meshes.
fn of_meshes(train: &Train) -> Vec<&Warning> {
    let each = train.loaded.meshes();
    each.flat_map(|mesh| &mesh.case.warnings).collect()
}

impl Case {
    fn of(
        source: Source,
        folder: &Path,
        traces: &[(PathBuf, Profile)],
        keys: Vec<(String, String)>,
        formulation: Option<Formulation>,
    ) -> Result<Self, Failure> {
        if gear_train::is_train(&source) {
            if !traces.is_empty() {
                return Err(traces_of_train());
            }
            let loaded = gear_train::load_set(source.clone(), folder, &keys, formulation)?;
            let train = Train {
                loaded: loaded.into(),
                source,
                folder: folder.to_owned(),
                keys,
                formulation,
                laws: Vec::new(),
                held: FileContents::new(),
            };
            return Ok(Self {
                kind: Kind::Train(train.into()),
            });
        }
        let loaded = load_holding(source, folder, traces, &keys, &|input| {
            if formulation.is_some() {
                input.formulation = formulation;
            }
        })?;
        Ok(Self {
            kind: Kind::Pair(loaded.into()),
        })
    }

    /// The case with a law in Python, in each of its meshes.
    fn with(&self, law_of: LawOf, law: &Arc<PythonLaw>) -> Self {
        let kind = match &self.kind {
            Kind::Pair(loaded) => {
                let mut loaded = loaded.as_ref().clone();
                loaded.case = law.applied(loaded.case, law_of);
                Kind::Pair(loaded.into())
            }
            Kind::Train(train) => {
                let mut train = train.clone();
                let loaded = train.loaded.as_ref().clone();
                train.loaded = loaded.with_laws(&|case| law.applied(case, law_of)).into();
                train.laws.push((law_of, Arc::clone(law)));
                Kind::Train(train)
            }
        };
        Self { kind }
    }

    /// The case as a gear train, also of a single mesh.
    pub fn train(&self) -> LoadedTrain {
        match &self.kind {
            Kind::Pair(loaded) => LoadedTrain::from(loaded.as_ref().clone()),
            Kind::Train(train) => train.loaded.as_ref().clone(),
        }
    }

    /// The case, where it is one of two gears.
    pub fn pair(&self) -> Result<&Arc<LoadedCase>, Failure> {
        match &self.kind {
            Kind::Pair(loaded) => Ok(loaded),
            Kind::Train(_) => {
                let message = "the case has several meshes; this takes a pair of gears";
                Err(Failure::new(Code::E205, message))
            }
        }
    }
}

#[pymethods]
impl Case {
    /// The case in a file, keys set past its text.
    #[staticmethod]
    fn load(
        py: Python<'_>,
        path: PathBuf,
        keys: Vec<(String, String)>,
        formulation: Option<&str>,
    ) -> PyResult<Self> {
        let formulation = formulation_of(formulation)?;
        alone(py, || {
            let source = open_source(&path)?;
            let folder = path.parent().unwrap_or(Path::new("."));
            Self::of(source, folder, &[], keys, formulation)
        })
    }

    /// The case in the text of a file called `name`, with traces in memory.
    #[staticmethod]
    fn from_text(
        py: Python<'_>,
        name: &str,
        text: &str,
        folder: PathBuf,
        traces: Traces<'_>,
        formulation: Option<&str>,
    ) -> PyResult<Self> {
        let formulation = formulation_of(formulation)?;
        let held = profiles(&traces);
        alone(py, || {
            let source = Source::new(name, text).map_err(asperity::Error::from)?;
            Self::of(source, &folder, &held, Vec::new(), formulation)
        })
    }

    /// The content of the case without its laws in Python.
    fn content(&self, py: Python<'_>) -> PyResult<CaseContent> {
        alone(py, || {
            let (contents, folder) = match &self.kind {
                Kind::Pair(loaded) => (loaded.contents()?, loaded.folder()),
                Kind::Train(train) => (train.loaded.contents()?, Some(train.folder.as_path())),
            };
            let folder = folder.unwrap_or(Path::new(""));
            let folder = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
            let (mut files, mut traces) = (Vec::new(), Vec::new());
            for (name, content) in contents {
                match content {
                    Content::Bytes(bytes) => files.push((name, bytes.to_vec())),
                    Content::Heights(profile) => {
                        let heights = profile.heights().iter();
                        let bytes = heights.flat_map(|height| height.to_le_bytes());
                        traces.push((name, profile.spacing().si(), bytes.collect()));
                    }
                    other => {
                        let message = format!("{}: {other:?} cannot be pickled", name.display());
                        return Err(Failure::new(Code::E501, message));
                    }
                }
            }
            Ok(match &self.kind {
                Kind::Pair(loaded) => CaseContent {
                    name: loaded.name().to_owned(),
                    text: loaded.case.input.to_toml()?,
                    keys: None,
                    formulation: None,
                    folder,
                    files,
                    traces,
                },
                Kind::Train(train) => CaseContent {
                    name: train.source.name().to_owned(),
                    text: train.source.text().to_owned(),
                    keys: Some(train.keys.clone()),
                    formulation: train.formulation.map(name_of),
                    folder,
                    files,
                    traces,
                },
            })
        })
    }

    /// The case of a content.
    #[staticmethod]
    fn from_content(py: Python<'_>, content: CaseContent) -> PyResult<Self> {
        let formulation = formulation_of(content.formulation.as_deref())?;
        alone(py, || {
            let held = CaseContent::contents(content.files, content.traces)?;
            let kind = match content.keys {
                None => {
                    let loaded = from_contents(&content.name, &content.text, held)?;
                    Kind::Pair(loaded.in_folder(&content.folder).into())
                }
                Some(keys) => {
                    let source =
                        Source::new(&content.name, &content.text).map_err(asperity::Error::from)?;
                    let loaded = gear_train::load_holding(
                        source.clone(),
                        None,
                        held.clone(),
                        &keys,
                        formulation,
                    )?;
                    Kind::Train(Box::new(Train {
                        loaded: loaded.in_folder(&content.folder).into(),
                        source,
                        folder: content.folder,
                        keys,
                        formulation,
                        laws: Vec::new(),
                        held,
                    }))
                }
            };
            Ok(Self { kind })
        })
    }

    /// SHA-256 of everything that the result follows from, without laws in Python.
    #[getter]
    fn fingerprint(&self) -> String {
        self.train()
            .with_laws(&|mut case| {
                case.laws = Default::default();
                case
            })
            .fingerprint()
    }

    /// The case with keys set, or taken away where the value is none.
    fn replace(
        &self,
        py: Python<'_>,
        keys: Vec<(String, Option<String>)>,
        traces: Traces<'_>,
    ) -> PyResult<Self> {
        let held = profiles(&traces);
        alone(py, || match &self.kind {
            Kind::Pair(loaded) => {
                let mut input = loaded.case.input.clone();
                for (key, value) in &keys {
                    match value {
                        Some(value) => input.set(key, value)?,
                        None => input.unset(key)?,
                    }
                }
                let changed = loaded.holding(&held).with(|now| *now = input)?;
                Ok(Self {
                    kind: Kind::Pair(changed.into()),
                })
            }
            Kind::Train(train) => {
                let mut all = train.keys.clone();
                for (key, value) in keys {
                    let value = value.ok_or_else(|| {
                        Failure::new(
                            Code::E205,
                            format!(
                                "{key}: a key of a case with several meshes cannot be taken away"
                            ),
                        )
                    })?;
                    all.retain(|(before, _)| *before != key);
                    all.push((key, value));
                }
                if !held.is_empty() {
                    return Err(traces_of_train());
                }
                let changed = Train {
                    keys: all,
                    laws: Vec::new(),
                    ..train.as_ref().clone()
                };
                let changed = changed.read(Some(&train.folder))?;
                let changed = Self {
                    kind: Kind::Train(changed.into()),
                };
                let laws = train.laws.iter();
                Ok(laws.fold(changed, |case, (kind, law)| case.with(*kind, law)))
            }
        })
    }

    /// The case on the traces of another finish, by their files or names in memory; a single one serves both flanks.
    fn on_finish(
        &self,
        py: Python<'_>,
        pinion: PathBuf,
        wheel: Option<PathBuf>,
        traces: Traces<'_>,
        offsets: Option<usize>,
    ) -> PyResult<Self> {
        let held = profiles(&traces);
        let loaded = self.pair()?;
        alone(py, || {
            let changed = loaded.holding(&held).with(|input| {
                input.surface.put_traces(&pinion, wheel.as_deref());
                if offsets.is_some() {
                    input.model.offsets = offsets;
                }
            })?;
            Ok(Self {
                kind: Kind::Pair(changed.into()),
            })
        })
    }

    /// The case with a law in Python, called `name`, that takes a dictionary of arrays and returns another.
    fn with_law(&self, law: &str, name: String, exponent: f64, call: Py<PyAny>) -> PyResult<Self> {
        let law_of = named("law", law)?;
        Ok(self.with(law_of, &Arc::new(PythonLaw::new(name, exponent, call))))
    }

    /// The case of a mesh of a gear train or planetary set, at its torque and speed.
    fn mesh(&self, name: &str) -> PyResult<Self> {
        let found = match &self.kind {
            Kind::Pair(_) => None,
            Kind::Train(train) => train.loaded.mesh(name),
        };
        let mesh = found.ok_or_else(|| {
            Failure::new(
                Code::E205,
                format!("the case has no mesh {name:?}; meshes names them"),
            )
        })?;
        Ok(Self {
            kind: Kind::Pair(mesh.case.clone().into()),
        })
    }

    /// Names of the meshes of a gear train or planetary set; empty for a pair of gears.
    #[getter]
    fn meshes(&self) -> Vec<String> {
        match &self.kind {
            Kind::Pair(_) => Vec::new(),
            Kind::Train(train) => train
                .loaded
                .meshes()
                .map(|mesh| mesh.name.clone())
                .collect(),
        }
    }

    /// Table of the gears: `gears`, `planetary`, or `mesh` of a gear train.
    #[getter]
    fn gears_table(&self) -> &'static str {
        match &self.kind {
            Kind::Pair(_) => "gears",
            Kind::Train(train) if train.loaded.only_set().is_some() => "planetary",
            Kind::Train(_) => "mesh",
        }
    }

    /// Title, inputs, defaults and warnings as JSON.
    #[getter]
    fn about(&self) -> PyResult<String> {
        let about = match &self.kind {
            Kind::Pair(loaded) => json!({
                "title": loaded.case.title,
                "inputs": loaded.case.input,
                "defaults": loaded.case.defaults,
                "warnings": loaded.warnings,
            }),
            Kind::Train(train) => json!({
                "title": train.loaded.title,
                "inputs": train.loaded.input,
                "defaults": train.loaded.defaults,
                "warnings": of_meshes(train),
            }),
        };
        Ok(failure::json(&about)?)
    }

    /// Warnings about the files as JSON.
    #[getter]
    fn warnings(&self) -> PyResult<String> {
        Ok(match &self.kind {
            Kind::Pair(loaded) => failure::json(&loaded.warnings)?,
            Kind::Train(train) => failure::json(&of_meshes(train))?,
        })
    }

    /// The case as the text of a case file.
    fn to_toml(&self) -> PyResult<String> {
        Ok(self.pair()?.case.input.to_toml().map_err(Failure::from)?)
    }

    /// Runs the case.
    fn run(
        &self,
        py: Python<'_>,
        detail: &str,
        band: Option<bool>,
        threads: Option<isize>,
        progress: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Outcome> {
        let detail: Detail = named("detail", detail)?;
        if (detail, band) == (Detail::Losses, Some(true)) {
            let message = "detail = \"losses\" has no interval of the loss; leave band out, or run with detail = \"contacts\"";
            return Err(Failure::new(Code::E205, message).into());
        }
        let band = band.unwrap_or(detail == Detail::Fields);
        in_parallel(py, threads, progress.as_ref(), |told| {
            let shown = |done, total| told.tell(done, total);
            let found = match (&self.kind, detail) {
                (Kind::Train(train), Detail::Fields) => {
                    let train = &train.loaded;
                    Found::Train(execute_train(train, &KeptFields::All, band, &shown)?.into())
                }
                (Kind::Train(_), _) => {
                    let message = "a case of several meshes is run only with detail = \"fields\"";
                    return Err(Failure::new(Code::E205, message));
                }
                (Kind::Pair(loaded), Detail::Losses) => {
                    let program = concat!("asperity ", env!("CARGO_PKG_VERSION"));
                    let losses = Run::new(loaded).progress(&shown).losses()?;
                    Found::Losses(program, loaded.case.title.clone(), losses.into())
                }
                (Kind::Pair(loaded), Detail::Contacts) => Found::Whole(
                    Run::new(loaded)
                        .band(band)
                        .progress(&shown)
                        .without_pictures()
                        .execute()?
                        .into(),
                ),
                (Kind::Pair(loaded), Detail::Fields) => {
                    let run = Run::new(loaded).band(band).progress(&shown);
                    Found::Whole(execute(loaded, run)?.into())
                }
            };
            Ok(Outcome(Arc::new(found)))
        })
    }

    /// Film and regime along the path as JSON: rows of each mesh with its title.
    fn regime(&self, py: Python<'_>, threads: Option<isize>) -> PyResult<String> {
        in_parallel(py, threads, None, |_| {
            let rows = |mesh: &LoadedCase| -> Result<MeshRegime, Failure> {
                Ok(MeshRegime {
                    title: mesh.case.title.clone(),
                    rows: pipeline::survey(mesh)?,
                })
            };
            let meshes = match &self.kind {
                Kind::Pair(loaded) => vec![rows(loaded)?],
                Kind::Train(train) => {
                    let of_mesh = |mesh: &LoadedMesh| rows(&mesh.case);
                    train
                        .loaded
                        .meshes()
                        .map(of_mesh)
                        .collect::<Result<_, _>>()?
                }
            };
            failure::json(&meshes)
        })
    }

    /// Pressure across films from thin to thick at a place of the path, as JSON.
    fn film(&self, py: Python<'_>, position: Option<f64>) -> PyResult<String> {
        let loaded = self.pair()?;
        alone(py, || {
            failure::json(&pipeline::film(loaded, on_the_path(position)?)?)
        })
    }

    /// Geometry, stiffness and loss factors of the gears as JSON.
    fn gear(&self, py: Python<'_>) -> PyResult<String> {
        let loaded = self.pair()?;
        alone(py, || {
            failure::json(&gear_report::gear_report(&loaded.case)?)
        })
    }

    /// The flanks pressed dry against each other at a place of the path.
    fn contact<'py>(
        &self,
        py: Python<'py>,
        position: Option<f64>,
    ) -> PyResult<(String, Bound<'py, PyDict>)> {
        let loaded = self.pair()?;
        let dry = alone(py, || {
            let place = on_the_path(position)?.unwrap_or(loaded.case.model.position);
            Ok(dry_contact(loaded, place)?)
        })?;
        let spacing = dry
            .x
            .get(1)
            .zip(dry.x.first())
            .map_or(0.0, |(second, first)| second - first);
        let more = json!({
            "path_fraction": dry.path_fraction,
            "hertz_p_max_pa": dry.hertz.max_pressure.si(),
            "hertz_half_width_m": dry.hertz.half_width.si(),
        });
        found(py, dry.solution, dry.undeformed, spacing, more)
    }
}

/// A place on the path, 0 at A and 1 at E, checked.
pub fn on_the_path(place: Option<f64>) -> Result<Option<f64>, Failure> {
    match place {
        Some(place) if !(0.0..=1.0).contains(&place) => {
            let message = format!("position {}: must be 0 (A) to 1 (E)", number(place));
            Err(Failure::new(Code::E209, message))
        }
        place => Ok(place),
    }
}
