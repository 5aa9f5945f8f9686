//! Subjects of the studies of oils, from Python.

use std::path::{Path, PathBuf};

use asperity::case::{LoadedCase, open_source};
use asperity_calibration::oil::{ConstantsOf, Curves, MeasuredOil, OfOil, OilBase, OilOfCase};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::case::Case;
use crate::failure::Failure;
use crate::study::Given;

/// Oil of the library or of a file, or of a case.
#[derive(FromPyObject)]
enum Oil<'py> {
    /// A name, or the path of an oil file or a data sheet.
    Name(String),
    /// A case.
    Case(PyRef<'py, Case>),
}

impl Oil<'_> {
    fn base(&self, constants: ConstantsOf) -> Result<(OilBase, Option<LoadedCase>), Failure> {
        match self {
            Self::Name(name) => match of_file(Path::new(name), constants)? {
                Some(oil) => Ok((oil, None)),
                None => Ok((OilBase::of_library(name)?, None)),
            },
            Self::Case(case) => {
                let case = case.only()?.clone();
                Ok((OilBase::of_case(&case, constants)?, Some(case)))
            }
        }
    }
}

/// The oil of an oil file or of a data sheet; `None` of anything else.
fn of_file(path: &Path, constants: ConstantsOf) -> Result<Option<OilBase>, Failure> {
    if !path.is_file() {
        return Ok(None);
    }
    let source = open_source(path).map_err(Failure::from)?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    Ok(OilBase::of_source(&name, &source, constants)?)
}

/// Whether a file holds an oil without a case.
#[pyfunction]
pub fn is_oil(path: PathBuf) -> PyResult<bool> {
    Ok(of_file(&path, ConstantsOf::Family)?.is_some())
}

impl Given for OfOil {
    fn read(given: &Bound<'_, PyTuple>) -> PyResult<Self> {
        let (oil,): (Oil<'_>,) = given.extract()?;
        let (oil, _) = oil.base(ConstantsOf::File)?;
        Ok(Self(oil))
    }
}

impl Given for OilOfCase {
    fn read(given: &Bound<'_, PyTuple>) -> PyResult<Self> {
        let (oil, case): (Oil<'_>, Option<PyRef<'_, Case>>) = given.extract()?;
        let (oil, own) = oil.base(ConstantsOf::Family)?;
        let case = case.map(|case| case.only().cloned()).transpose()?;
        Ok(Self::new(oil, own, case))
    }
}

/// Tables by name, each with its text, or a file of that name where there is none.
type Tables = Vec<(String, Option<String>)>;

impl Given for MeasuredOil {
    fn read(given: &Bound<'_, PyTuple>) -> PyResult<Self> {
        let (tables, oil): (Tables, Oil<'_>) = given.extract()?;
        let (oil, _) = oil.base(ConstantsOf::Family)?;
        let curves = |(name, text): (String, Option<String>)| match text {
            Some(text) => Ok(Curves { name, text }),
            None => Ok(Curves::open(Path::new(&name))?),
        };
        let curves = tables.into_iter().map(curves);
        let curves = curves.collect::<Result<Vec<Curves>, Failure>>()?;
        Ok(Self { curves, oil })
    }
}
