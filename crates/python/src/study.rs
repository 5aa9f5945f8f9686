//! Studies: their settings as JSON, their run, and their JSON, summary and folder.

use std::path::{Path, PathBuf};

use asperity::case::{LoadedCase, Train};
use asperity::message::{Code, Fault};
use asperity::pipeline::Progress;
use asperity_report::{Described, Input, Settings, StudyResult, StudySettings};
use asperity_studies::{every_description, every_study};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use serde_json::Value;

use crate::case::Case;
use crate::failure::{self, Failure};
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

/// A study by its settings: runs it.
type Run = Box<dyn FnOnce(Value, Progress<'_>) -> Result<Study, Failure> + Send>;

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
            Ok(Box::new(|settings, progress| {
                let settings = S::of_json(settings)?;
                Study::of(settings.run(input, progress)?)
            }))
        },
    }
}

fn named(function: &str) -> Result<Registered, Failure> {
    let mut all = every_study!(registered).into_iter();
    all.find(|study| study.function == function)
        .ok_or_else(|| unknown(function))
}

fn unknown(function: &str) -> Failure {
    Failure::new(Code::E204, format!("no study is called {function}"))
}

fn object(settings: &str) -> Result<Value, Failure> {
    serde_json::from_str(settings)
        .map_err(|error| Failure::new(Code::E204, format!("settings: {error}")))
}

/// Settings in an object of JSON.
pub fn stated<S: Settings>(settings: &str) -> Result<S, Failure> {
    Ok(S::of_json(object(settings)?)?)
}

fn described<S: StudySettings>() -> Described {
    Described::of::<S>()
}

/// The studies with their settings, as JSON.
#[pyfunction]
pub fn studies() -> PyResult<String> {
    let all: Vec<Described> = every_description!(described).collect();
    Ok(failure::json(&all)?)
}

/// Steps that the progress of the study `name` counts.
#[pyfunction]
pub fn steps(name: &str) -> PyResult<&'static str> {
    let steps = every_description!(described)
        .find_map(|study| (study.function == name).then_some(study.steps));
    Ok(steps.ok_or_else(|| unknown(name))?)
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
    let settings = object(settings)?;
    let run = (named(name)?.given)(&given)?;
    in_parallel(py, threads, progress.as_ref(), |told| {
        run(settings, &|done, total| told.tell(done, total))
    })
}

/// Writes a study as a folder.
type Write = Box<dyn Fn(&Path) -> Result<(), Fault> + Send + Sync>;

/// A study.
#[pyclass(frozen, module = "asperity._asperity")]
pub struct Study {
    json: String,
    summary: String,
    write: Write,
}

impl Study {
    /// A study that its folder and summary need nothing besides.
    pub fn of<S>(found: S) -> Result<Self, Failure>
    where
        S: for<'a> StudyResult<Context<'a> = ()> + Send + Sync + 'static,
    {
        let (json, summary) = (failure::json(&found)?, found.summary(()));
        Ok(Self::new(json, summary, move |folder| {
            found.write((), folder)
        }))
    }

    /// A study of this JSON and summary.
    pub fn new(
        json: String,
        summary: String,
        write: impl Fn(&Path) -> Result<(), Fault> + Send + Sync + 'static,
    ) -> Self {
        let write = Box::new(write);
        Self {
            json,
            summary,
            write,
        }
    }
}

#[pymethods]
impl Study {
    /// The study as the command prints it with --json.
    fn json(&self) -> &str {
        &self.json
    }

    /// The summary as text.
    fn summary(&self) -> &str {
        &self.summary
    }

    /// Writes the folder of the study.
    fn write(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        alone(py, || Ok((self.write)(&folder)?))
    }
}
