//! The cases of a study, some at a time.

use std::path::{Path, PathBuf};

use asperity_studies::sweep::{Cases as Listed, Study};
use pyo3::prelude::*;

use crate::case::Case;
use crate::failure::Failure;
use crate::work::{alone, in_parallel};

/// The cases of a study.
#[pyclass(frozen, module = "asperity._asperity")]
pub struct Cases(Listed);

#[pymethods]
impl Cases {
    /// Those of a study file.
    #[staticmethod]
    fn load(py: Python<'_>, file: PathBuf) -> PyResult<Self> {
        alone(py, || {
            Ok(Self(Listed::new(Study::load(Path::new(&file))?)?))
        })
    }

    /// Those of a case with the other keys of a study in JSON.
    #[staticmethod]
    fn of(py: Python<'_>, case: &Case, study: &str, folder: PathBuf) -> PyResult<Self> {
        let loaded = case.train().clone();
        alone(py, || {
            Ok(Self(Listed::new(Study::of_case(loaded, study, &folder)?)?))
        })
    }

    fn __len__(&self) -> usize {
        self.0.count()
    }

    /// SHA-256 of everything that the cases follow from.
    #[getter]
    fn study(&self) -> &str {
        self.0.study()
    }

    /// Names and texts of the nodes of the crossed axes, the outermost first.
    #[getter]
    fn axes(&self) -> Vec<(String, Vec<String>)> {
        self.0.axes()
    }

    /// Sampled keys.
    #[getter]
    fn sampled(&self) -> Vec<String> {
        self.0.sampled()
    }

    /// Reads every value of the axes and every file that they name, without running a case.
    fn check_values(&self, py: Python<'_>) -> PyResult<()> {
        alone(py, || Ok(self.0.check_values()?))
    }

    /// Names of the columns of a row.
    #[getter]
    fn header(&self) -> Vec<String> {
        self.0.header()
    }

    /// Rows of the cases from `first` to before `end`, as text.
    fn rows(
        &self,
        py: Python<'_>,
        first: usize,
        end: usize,
        threads: Option<isize>,
    ) -> PyResult<Vec<Vec<String>>> {
        let end = end.min(self.0.count());
        in_parallel(py, threads, None, |_| {
            self.0.rows(first.min(end)..end).map_err(Failure::from)
        })
    }
}
