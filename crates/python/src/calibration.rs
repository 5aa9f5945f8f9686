//! Calibrations from the losses of a rig.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity::LoadedCase;
use asperity::case::{self, CalibratedName};
use asperity_calibration as calibrating;
use asperity_calibration::{CalibrationError, RigFiles, Watch};
use asperity_report::StudyResult;
use pyo3::prelude::*;

use crate::case::Case;
use crate::choices::named;
use crate::failure::{self, Failure};
use crate::work::{alone, in_parallel};

/// Parameters fitted to the losses of a rig.
#[pyclass(frozen, module = "asperity._asperity")]
pub struct Calibration(calibrating::Calibration);

/// Calibrates on the table in `text`, called `name`, or in the file `name` where there is none. A row without a case
/// takes `beside`; one with the name of a case takes that of `cases`, or the file of that name in `folder`.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "those of the function in Python")]
pub fn calibrate(
    py: Python<'_>,
    name: String,
    text: Option<String>,
    folder: PathBuf,
    beside: Option<PyRef<'_, Case>>,
    cases: Vec<(String, PyRef<'_, Case>)>,
    hold: Vec<String>,
    threads: Option<usize>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Calibration> {
    let held = hold.iter().map(|key| named("hold", key));
    let held = held.collect::<Result<Vec<CalibratedName>, Failure>>()?;
    let beside = beside.map(|case| case.pair().cloned()).transpose()?;
    let given = cases
        .into_iter()
        .map(|(name, case)| Ok((name, Arc::clone(case.pair()?))));
    let given = given.collect::<Result<Vec<(String, Arc<LoadedCase>)>, Failure>>()?;
    in_parallel(py, threads, progress.as_ref(), |told| {
        let text = match text {
            Some(text) => text,
            None => calibrating::table_text(Path::new(&name))?,
        };
        let case = |wanted: Option<&str>| {
            let held = match wanted {
                None => beside.as_ref(),
                Some(wanted) => given
                    .iter()
                    .find(|(name, _)| name == wanted)
                    .map(|(_, case)| case),
            };
            match (held, wanted) {
                (Some(case), _) => Ok(case.as_ref().clone()),
                (None, Some(file)) => Ok(case::load(&folder.join(file), None)?),
                (None, None) => {
                    let file = name.clone();
                    Err(Failure::from(CalibrationError::NoCase { file }))
                }
            }
        };
        let watch = Watch {
            progress: &|done, total| told.tell(done, total),
            ..Watch::SILENT
        };
        let files = RigFiles::of_text(&name, text, case)?;
        Ok(Calibration(files.calibrate(&held, &watch)?))
    })
}

#[pymethods]
impl Calibration {
    /// The calibration as the command prints it with --json.
    fn json(&self) -> PyResult<String> {
        Ok(failure::json(&self.0)?)
    }

    /// The table `calibration` of a case as JSON.
    fn keys(&self) -> PyResult<String> {
        let table: toml::Table = toml::from_str(&self.0.block)
            .map_err(|error| Failure::new("E501", error.to_string()))?;
        Ok(failure::json(&table)?)
    }

    /// The summary as text.
    fn summary(&self) -> String {
        self.0.summary(())
    }

    /// Writes the folder of the calibration.
    fn write(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        alone(py, || Ok(self.0.write((), &folder)?))
    }
}
