//! Subjects of the studies of oils, from Python.

use std::path::Path;

use asperity::case::LoadedCase;
use asperity_calibration::oil::{ConstantsOf, Curves, MeasuredOil, OfOil, OilBase, OilOfCase};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::case::Case;
use crate::failure::Failure;
use crate::study::Given;

/// Oil of the library, or of a case.
#[derive(FromPyObject)]
enum Oil<'py> {
    /// A name.
    Name(String),
    /// A case.
    Case(PyRef<'py, Case>),
}

impl Oil<'_> {
    fn base(&self, constants: ConstantsOf) -> Result<(OilBase, Option<LoadedCase>), Failure> {
        match self {
            Self::Name(name) => Ok((OilBase::of_library(name)?, None)),
            Self::Case(case) => {
                let case = case.only()?.clone();
                Ok((OilBase::of_case(&case.case, constants)?, Some(case)))
            }
        }
    }
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
        let case = match case {
            Some(case) => Some(case.only()?.clone()),
            None => own,
        };
        Ok(Self { oil, case })
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
