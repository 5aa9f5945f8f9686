//! Studies: JSON, summary, folder.

use std::path::{Path, PathBuf};

use asperity::message::Fault;
use asperity_report::StudyResult;
use pyo3::prelude::*;

use crate::failure::{self, Failure};
use crate::work::alone;

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
