//! Studies: their settings as JSON, their run, and their JSON, summary and folder.

use std::any::Any;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity::LoadedCase;
use asperity::case::{self, Train};
use asperity::message::{Code, Fault};
use asperity::profile_io::read::read_table;
use asperity_calibration::RigFiles;
use asperity_report::{Described, Input, StudyResult, StudySettings, Watch};
use asperity_studies::change::{TracePair, TracePairs};
use asperity_studies::compare::{Comparison, Finish, Finishes};
use asperity_studies::cycle::{CycleOnMap, LARGEST_TABLE};
use asperity_studies::every_study;
use asperity_studies::map::{CaseOrFinishes, MapStudy};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use serde_json::Value;

use crate::case::Case;
use crate::failure::{self, Failure};
use crate::trace::Trace;
use crate::work::{alone, in_parallel};

/// Subject of a study, as arguments of its function in Python.
pub trait Given: Input + Send + 'static {
    /// Reads the arguments.
    fn read(given: &Bound<'_, PyTuple>) -> PyResult<Self>;
}

impl Given for Train {
    fn read(given: &Bound<'_, PyTuple>) -> PyResult<Self> {
        let (case,): (PyRef<'_, Case>,) = given.extract()?;
        Ok(case.train().clone())
    }
}

impl Given for LoadedCase {
    fn read(given: &Bound<'_, PyTuple>) -> PyResult<Self> {
        let (case,): (PyRef<'_, Case>,) = given.extract()?;
        Ok(case.only()?.clone())
    }
}

/// Cases by name.
type Named<'py> = Vec<(String, PyRef<'py, Case>)>;

impl Given for Finishes {
    fn read(given: &Bound<'_, PyTuple>) -> PyResult<Self> {
        let (named,): (Named<'_>,) = given.extract()?;
        let finish = |(name, case): (String, PyRef<'_, Case>)| Finish {
            name,
            case: case.train().clone(),
        };
        Ok(Self(named.into_iter().map(finish).collect()))
    }
}

impl Given for CaseOrFinishes {
    fn read(given: &Bound<'_, PyTuple>) -> PyResult<Self> {
        Ok(Self(Finishes::read(given)?))
    }
}

/// Traces by name.
type NamedTraces<'py> = Vec<(String, PyRef<'py, Trace>)>;

impl Given for TracePairs {
    fn read(given: &Bound<'_, PyTuple>) -> PyResult<Self> {
        type Arguments<'py> = (NamedTraces<'py>, NamedTraces<'py>, Option<PyRef<'py, Case>>);
        let (before, after, case): Arguments<'_> = given.extract()?;
        if before.len() != after.len() || before.is_empty() {
            let [before, after] = [before.len(), after.len()];
            let text =
                format!("{before} traces before a test and {after} after it: each needs the other");
            return Err(Failure::new(Code::E205, text).into());
        }
        let pair = |((first, before), (second, after)): (
            (String, PyRef<'_, Trace>),
            (String, PyRef<'_, Trace>),
        )| {
            TracePair::new(
                [&first, &second],
                [before.profile.clone(), after.profile.clone()],
            )
        };
        let given = Self::new(before.into_iter().zip(after).map(pair).collect());
        Ok(match case {
            Some(case) => given.on(case.only()?.clone()),
            None => given,
        })
    }
}

/// A table by its name, with its text, or the file of that name where there is none.
type Table = (String, Option<String>);

/// Keys of a case by their paths, with the text of their values.
type Keys = Vec<(String, Option<String>)>;

impl Given for CycleOnMap {
    fn read(given: &Bound<'_, PyTuple>) -> PyResult<Self> {
        let (study, (file, text), keys): (PyRef<'_, Study>, Table, Keys) = given.extract()?;
        let mut map = study.held::<MapStudy>()?.map.clone();
        for (key, value) in &keys {
            let set = map.input.set(key, value.as_deref().unwrap_or_default());
            set.map_err(Failure::from)?;
        }
        let file = Path::new(&file);
        let stem = file.file_stem().unwrap_or_default();
        Ok(Self {
            map: map.into(),
            name: stem.to_string_lossy().into_owned(),
            text: match text {
                Some(text) => text,
                None => read_table(file, LARGEST_TABLE).map_err(Failure::from)?,
            },
        })
    }
}

impl Given for RigFiles {
    fn read(given: &Bound<'_, PyTuple>) -> PyResult<Self> {
        type Cases<'py> = (Table, Option<PyRef<'py, Case>>, Named<'py>);
        let ((name, text), beside, cases): Cases<'_> = given.extract()?;
        let file = Path::new(&name);
        let (folder, text) = match text {
            Some(text) => (Path::new(""), text),
            None => {
                let text = asperity_calibration::table_text(file).map_err(Failure::from)?;
                (file.parent().unwrap_or(Path::new("")), text)
            }
        };
        let case = |wanted: Option<&str>| {
            let held = match wanted {
                None => beside.as_ref(),
                Some(wanted) => {
                    let mut named = cases.iter();
                    named.find_map(|(name, case)| (name == wanted).then_some(case))
                }
            };
            match (held, wanted) {
                (Some(case), _) => case.only().cloned(),
                (None, Some(file)) => Ok(case::load(&folder.join(file), None)?),
                (None, None) => Err(asperity_calibration::error::no_case(&name).into()),
            }
        };
        Ok(Self::of_text(&name, text, case)?)
    }
}

/// A study by its settings: runs it.
type Run = Box<dyn FnOnce(Value, &Watch<'_>) -> Result<Study, Failure> + Send>;

/// A study with the arguments of its function.
struct Registered {
    function: &'static str,
    given: fn(&Bound<'_, PyTuple>) -> PyResult<Run>,
}

fn registered<S: StudySettings<Input: Given>>() -> Registered {
    Registered {
        function: S::FUNCTION,
        given: |given| {
            let input = S::Input::read(given)?;
            Ok(Box::new(|settings, watch| {
                let settings = S::of_json(settings)?;
                Ok(Study::of(settings.run(input, watch)?))
            }))
        },
    }
}

fn unknown(function: &str) -> Failure {
    Failure::new(Code::E204, format!("no study is called {function}"))
}

fn described<S: StudySettings>() -> Described {
    Described::new::<S>()
}

/// The studies with their settings.
pub fn studies_described() -> Vec<Described> {
    every_study!(described).into()
}

/// The studies with their settings, as JSON.
#[pyfunction]
pub fn studies() -> PyResult<String> {
    Ok(failure::json(&studies_described())?)
}

/// Steps that the progress of the study `name` counts.
#[pyfunction]
pub fn steps(name: &str) -> PyResult<&'static str> {
    let mut all = studies_described().into_iter();
    let study = all.find(|study| study.function == name);
    Ok(study.ok_or_else(|| unknown(name))?.steps)
}

/// Runs the study `name` of the subject `given` with `settings`, an object of JSON.
#[pyfunction]
pub fn study(
    py: Python<'_>,
    name: &str,
    given: Bound<'_, PyTuple>,
    settings: &str,
    threads: Option<isize>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Study> {
    let settings: Value = failure::asked(settings)?;
    let mut all = every_study!(registered).into_iter();
    let study = all.find(|study| study.function == name);
    let run = (study.ok_or_else(|| unknown(name))?.given)(&given)?;
    in_parallel(py, threads, progress.as_ref(), |told| {
        let watch = Watch {
            progress: &|done, total| told.tell(done, total.max(done)),
            ..Watch::SILENT
        };
        run(settings, &watch)
    })
}

/// Result of a study, of any type.
trait Found: Any + Send + Sync {
    fn json(&self) -> Result<String, Failure>;
    fn summary(&self) -> String;
    fn write(&self, folder: &Path) -> Result<(), Fault>;
}

impl<S: StudyResult + Send + Sync + 'static> Found for S {
    fn json(&self) -> Result<String, Failure> {
        failure::json(self)
    }

    fn summary(&self) -> String {
        StudyResult::summary(self)
    }

    fn write(&self, folder: &Path) -> Result<(), Fault> {
        StudyResult::write(self, folder)
    }
}

/// A study.
#[pyclass(frozen, module = "asperity._asperity")]
pub struct Study(Arc<dyn Found>);

impl Study {
    /// A study with its result.
    pub fn of(found: impl StudyResult + Send + Sync + 'static) -> Self {
        Self(Arc::new(found))
    }

    /// The result, which is of type `S`.
    pub fn held<S: Send + Sync + 'static>(&self) -> Result<Arc<S>, Failure> {
        let held: Arc<dyn Any + Send + Sync> = Arc::<dyn Found>::clone(&self.0);
        held.downcast()
            .map_err(|_| Failure::new(Code::E204, "the study is another one"))
    }
}

#[pymethods]
impl Study {
    /// The study as the command prints it with --json.
    fn json(&self) -> PyResult<String> {
        Ok(self.0.json()?)
    }

    /// The summary as text.
    fn summary(&self) -> String {
        self.0.summary()
    }

    /// Writes the folder of the study.
    fn write(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        alone(py, || Ok(self.0.write(&folder)?))
    }

    /// Of a comparison the rows of the offsets of every finish as JSON, and each difference from the first finish in words.
    fn compared(&self) -> PyResult<(String, Vec<String>)> {
        let found = self.held::<Comparison>()?;
        let offsets: Vec<_> = found.finishes.iter().map(|of| &of.offsets).collect();
        Ok((failure::json(&offsets)?, found.verdicts()))
    }
}

/// The keys in the text of a case file, as JSON.
#[pyfunction]
pub fn keys_of(text: &str) -> PyResult<String> {
    let table: toml::Table = toml::from_str(text)
        .map_err(Fault::internal)
        .map_err(Failure::from)?;
    Ok(failure::json(&table)?)
}
