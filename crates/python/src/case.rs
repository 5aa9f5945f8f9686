//! Cases: loaded, changed, run.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity::Remedy;
use asperity::Run;
use asperity::case::{
    self, Content, FileContents, HeldTrace, LoadedCase, Source, Train, open_source,
};
use asperity::contacts::dry_contact::dry_contact;
use asperity::core::PROGRAM;
use asperity::core::Profile;
use asperity::core::number;
use asperity::formulation::FormulationChoice;
use asperity::laws::Laws;
use asperity::message::{Code, Fault};
use asperity::pipeline::Kept;
use asperity::pipeline::{self, RegimeRow};
use asperity::quantity::Length;
use asperity::result::gear_report;
use asperity_calibration::evidence::standard_plan;
use asperity_report::schema_of_settings;
use asperity_studies::compare::varied;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::json;

use crate::choices::{Detail, named};
use crate::contact::{ContactNumbers, found};
use crate::failure::{self, Failure};
use crate::outcome::{Found, Outcome};
use crate::own_laws::PythonLaw;
use crate::study::studies_described;
use crate::trace::Trace;
use crate::work::{alone, in_parallel};

/// Traces in memory by the names that a case gives them.
pub type Traces<'py> = Vec<(PathBuf, PyRef<'py, Trace>)>;

fn held_traces(traces: &Traces<'_>) -> Vec<(PathBuf, HeldTrace)> {
    let held = traces.iter();
    held.map(|(name, trace)| (name.clone(), trace.held()))
        .collect()
}

/// A case as content, which is pickled.
#[derive(FromPyObject, IntoPyObject)]
#[pyo3(from_item_all)]
struct CaseContent {
    /// Path of the case file as the user gave it.
    name: String,
    /// Text with every key.
    text: String,
    /// Absolute folder that names of files are relative to.
    folder: PathBuf,
    /// Every file that was read.
    files: Vec<(PathBuf, Vec<u8>)>,
    /// Traces in memory: spacing in m, heights in m as little-endian bytes, what is stated of them as JSON.
    traces: Vec<(PathBuf, f64, Vec<u8>, String)>,
}

impl CaseContent {
    fn contents(
        files: Vec<(PathBuf, Vec<u8>)>,
        traces: Vec<(PathBuf, f64, Vec<u8>, String)>,
    ) -> Result<FileContents, Failure> {
        let files = files.into_iter();
        let mut contents: FileContents = files
            .map(|(name, bytes)| (name, Content::Bytes(bytes.into())))
            .collect();
        for (name, spacing, bytes, stated) in traces {
            let (numbers, _) = bytes.as_chunks();
            let heights = numbers.iter().map(|number| f64::from_le_bytes(*number));
            let profile = Profile::new(Length::from_si(spacing), heights.collect())?;
            let held = HeldTrace {
                profile,
                statements: failure::asked(&stated)?,
            };
            contents.insert(name, Content::Heights(held.into()));
        }
        Ok(contents)
    }
}

/// A case, checked, with its traces.
#[pyclass(frozen, module = "asperity._asperity")]
#[derive(Clone)]
pub struct Case(Arc<Train>);

/// JSON schema of a case file with the tables `kind`: `gears`, or `planetary` and `mesh` of a gear train; or of the `settings`
/// of the studies.
#[pyfunction]
pub fn schema(kind: &str) -> PyResult<String> {
    let schema = match kind {
        "settings" => schema_of_settings(&studies_described()),
        "planetary" | "mesh" => case::schema_of_named_meshes(),
        _ => case::schema(),
    };
    Ok(failure::json(&schema)?)
}

/// The key of the formulation, if one is given.
fn formulation_key(name: Option<&str>) -> Result<Option<(String, String)>, Failure> {
    let Some(name) = name else { return Ok(None) };
    named::<FormulationChoice>("formulation", name)?;
    Ok(Some(("formulation".to_owned(), name.to_owned())))
}

/// Film and regime of a mesh.
#[derive(serde::Serialize)]
struct MeshRegime {
    title: String,
    rows: Vec<RegimeRow>,
}

impl Case {
    fn of(
        source: Source,
        folder: &Path,
        traces: &[(PathBuf, HeldTrace)],
        keys: &[(String, String)],
    ) -> Result<Self, Failure> {
        let held = traces.iter().map(|(name, trace)| {
            let content = Content::Heights(trace.clone().into());
            (name.clone(), content)
        });
        let loaded = Train::load_holding(source, Some(folder), held.collect(), keys, &|_| {})?;
        Ok(Self(loaded.into()))
    }

    /// The case.
    pub fn train(&self) -> &Train {
        &self.0
    }

    /// The case of its only mesh.
    pub fn only(&self) -> Result<&LoadedCase, Failure> {
        self.0.only_mesh().map_err(|error| {
            let first = self.meshes().into_iter().next().unwrap_or_default();
            let advice = format!("take one of them, as case.mesh(\"{first}\")");
            Failure::from(error).advising(Remedy::act(advice))
        })
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
        let mut keys = keys;
        keys.extend(formulation_key(formulation)?);
        alone(py, || {
            let source = open_source(&path)?;
            let folder = path.parent().unwrap_or(Path::new("."));
            Self::of(source, folder, &[], &keys)
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
        let keys: Vec<_> = formulation_key(formulation)?.into_iter().collect();
        let held = held_traces(&traces);
        alone(py, || {
            let source = Source::new(name, text).map_err(asperity::Error::from)?;
            Self::of(source, &folder, &held, &keys)
        })
    }

    /// The content of the case without its laws in Python.
    fn content(&self, py: Python<'_>) -> PyResult<CaseContent> {
        alone(py, || {
            let contents = self.0.contents()?;
            let first = self.0.cases().next();
            let folder = first.and_then(LoadedCase::folder).unwrap_or(Path::new(""));
            let folder = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
            let (mut files, mut traces) = (Vec::new(), Vec::new());
            for (name, content) in contents {
                match content {
                    Content::Bytes(bytes) => files.push((name, bytes.to_vec())),
                    Content::Heights(held) => {
                        let profile = &held.profile;
                        let heights = profile.heights().iter();
                        let bytes = heights.flat_map(|height| height.to_le_bytes());
                        let stated = failure::json(&held.statements)?;
                        traces.push((name, profile.spacing().si(), bytes.collect(), stated));
                    }
                    other => {
                        let message = format!("{}: {other:?} cannot be pickled", name.display());
                        return Err(Failure::new(Code::E501, message));
                    }
                }
            }
            Ok(CaseContent {
                name: first.map_or("", LoadedCase::name).to_owned(),
                text: self.0.input.to_toml()?,
                folder,
                files,
                traces,
            })
        })
    }

    /// The case of a content.
    #[staticmethod]
    fn from_content(py: Python<'_>, content: CaseContent) -> PyResult<Self> {
        alone(py, || {
            let held = CaseContent::contents(content.files, content.traces)?;
            let loaded = Train::from_contents(&content.name, &content.text, held)?;
            Ok(Self(loaded.in_folder(&content.folder).into()))
        })
    }

    /// SHA-256 of everything that the result follows from, without laws in Python.
    #[getter]
    fn fingerprint(&self) -> String {
        let train = Train::clone(&self.0);
        train
            .with_laws(&|laws| *laws = Laws::default())
            .fingerprint()
    }

    /// The case with keys set, or taken away where the value is none.
    fn replace(
        &self,
        py: Python<'_>,
        keys: Vec<(String, Option<String>)>,
        traces: Traces<'_>,
    ) -> PyResult<Self> {
        let held = held_traces(&traces);
        alone(py, || {
            let mut input = self.0.input.clone();
            let set = keys.iter().filter(|(_, value)| value.is_some());
            input.make_way_for(set.map(|(key, _)| key.as_str()));
            for (key, value) in &keys {
                match value {
                    Some(value) => input.set(key, value)?,
                    None => input.unset(key)?,
                }
            }
            let changed = Train::clone(&self.0).holding(&held).with_input(input)?;
            Ok(Self(changed.into()))
        })
    }

    /// The case as its variant with these keys, called `name`.
    fn varied(
        &self,
        py: Python<'_>,
        name: &str,
        keys: Vec<(String, Option<String>)>,
        traces: Traces<'_>,
    ) -> PyResult<Self> {
        let held = held_traces(&traces);
        alone(py, || {
            let base = Train::clone(&self.0).holding(&held);
            let (set, unset): (Vec<_>, Vec<_>) =
                keys.into_iter().partition(|(_, value)| value.is_some());
            let set: Vec<(String, String)> = set
                .into_iter()
                .filter_map(|(key, value)| Some((key, value?)))
                .collect();
            let named = |fault: Fault| fault.about(format!("variant {name}"));
            let unset: Vec<String> = unset.into_iter().map(|(key, _)| key).collect();
            let found = varied(&base, &set, &unset).map_err(|fault| Failure::from(named(fault)))?;
            Ok(Self(found.into()))
        })
    }

    /// The case on the traces of another finish, by their files or names in memory; a single one serves both flanks.
    fn on_finish(
        &self,
        py: Python<'_>,
        pinion: PathBuf,
        wheel: Option<PathBuf>,
        traces: Traces<'_>,
    ) -> PyResult<Self> {
        let held = held_traces(&traces);
        let loaded = self.only()?;
        alone(py, || {
            let changed = loaded.holding(&held).with(|input| {
                input.surface.put_traces(&pinion, wheel.as_deref());
            })?;
            Ok(Self(Arc::new(changed.into())))
        })
    }

    /// The case with a law in Python, called `name`, that takes a dictionary of arrays and returns another.
    fn with_law(&self, law: &str, name: String, exponent: f64, call: Py<PyAny>) -> PyResult<Self> {
        let law_of = named("law", law)?;
        let law = Arc::new(PythonLaw::new(name, exponent, call));
        let train = Train::clone(&self.0);
        Ok(Self(
            train.with_laws(&|laws| law.put_into(laws, law_of)).into(),
        ))
    }

    /// The case of a mesh of a gear train or planetary set, at its torque and speed.
    fn mesh(&self, name: &str) -> PyResult<Self> {
        Ok(Self(Arc::new(self.0.of_mesh(name).map_err(Failure::from)?)))
    }

    /// Names of the meshes of a gear train or planetary set; empty for a pair of gears.
    #[getter]
    fn meshes(&self) -> Vec<String> {
        let meshes = self.0.meshes().map(|mesh| mesh.name.clone());
        meshes.filter(|name| !name.is_empty()).collect()
    }

    /// Table of the gears: `gears`, `planetary`, or `mesh` of a gear train.
    #[getter]
    fn gears_table(&self) -> &'static str {
        match (self.0.only(), self.0.only_set()) {
            (Some(_), _) => "gears",
            (None, Some(_)) => "planetary",
            (None, None) => "mesh",
        }
    }

    /// Title, inputs, defaults and warnings as JSON.
    #[getter]
    fn about(&self) -> PyResult<String> {
        let inputs = self.0.input.store(serde_json::value::Serializer);
        let about = json!({
            "title": self.0.title,
            "inputs": inputs.map_err(Fault::internal).map_err(Failure::from)?,
            "defaults": self.0.defaults,
            "warnings": self.0.all_warnings(),
        });
        Ok(failure::json(&about)?)
    }

    /// All warnings that need no run as JSON: those about the files, if a run cannot begin.
    #[getter]
    fn checked(&self, py: Python<'_>) -> PyResult<String> {
        alone(py, || match Run::new(&*self.0).check() {
            Ok(found) => failure::json(&found),
            // The error of a run.
            Err(_) => failure::json(&self.0.all_warnings()),
        })
    }

    /// Warnings about the files as JSON.
    #[getter]
    fn warnings(&self) -> PyResult<String> {
        Ok(failure::json(&self.0.all_warnings())?)
    }

    /// The case as the text of a case file.
    fn to_toml(&self) -> PyResult<String> {
        Ok(self.0.input.to_toml().map_err(Failure::from)?)
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
            let found = match (detail, self.only()) {
                (Detail::Losses, Ok(loaded)) => {
                    let losses = Run::new(loaded).progress(&shown).losses()?.into_only()?;
                    Found::Losses(PROGRAM, loaded.case.title.clone(), losses.into())
                }
                // The losses of several meshes are of their contacts.
                _ => {
                    let run = Run::new(&*self.0).interval(band).evidence(&standard_plan);
                    let run = match detail {
                        Detail::Fields => run,
                        _ => run.pictures(Kept::NoPictures),
                    };
                    Found::Run(run.progress(&shown).execute()?.into())
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
            let meshes = self
                .0
                .cases()
                .map(rows)
                .collect::<Result<Vec<_>, Failure>>()?;
            failure::json(&meshes)
        })
    }

    /// Pressure across films from thin to thick at a place of the path, as JSON.
    fn film(&self, py: Python<'_>, position: Option<f64>) -> PyResult<String> {
        let loaded = self.only()?;
        alone(py, || {
            failure::json(&asperity_paper_2022::film(loaded, on_the_path(position)?)?)
        })
    }

    /// Geometry, stiffness and loss factors of the gears as JSON.
    fn gear(&self, py: Python<'_>) -> PyResult<String> {
        let loaded = self.only()?;
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
        let loaded = self.only()?;
        let dry = alone(py, || {
            let place = on_the_path(position)?.unwrap_or(loaded.case.paper.position);
            Ok(dry_contact(loaded, place)?)
        })?;
        let spacing = dry
            .x
            .get(1)
            .zip(dry.x.first())
            .map_or(0.0, |(second, first)| second - first);
        let mut numbers = ContactNumbers::of(&dry.solution, spacing);
        numbers.path_fraction = Some(dry.path_fraction);
        numbers.hertz_p_max_pa = Some(dry.hertz.max_pressure.si());
        numbers.hertz_half_width_m = Some(dry.hertz.half_width.si());
        found(py, dry.solution, dry.undeformed, &numbers)
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
