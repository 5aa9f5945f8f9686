//! Calibrations from the losses of a rig.

use std::path::{Path, PathBuf};

use asperity::LoadedCase;
use asperity::case;
use asperity::message::Fault;
use asperity_calibration as calibrating;
use asperity_calibration::design::simulated;
use asperity_calibration::{CalibrationSettings, DesignSettings, RigFiles, Watch, error, plan};
use asperity_report::StudyResult;
use pyo3::prelude::*;

use crate::case::Case;
use crate::failure::{self, Failure};
use crate::study::{Study, stated};
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
    settings: &str,
    threads: Option<isize>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Calibration> {
    let settings: CalibrationSettings = stated(settings)?;
    let beside = beside.map(|case| case.only().cloned()).transpose()?;
    let given = cases
        .into_iter()
        .map(|(name, case)| Ok((name, case.only()?.clone())));
    let given = given.collect::<Result<Vec<(String, LoadedCase)>, Failure>>()?;
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
                (Some(case), _) => Ok(case.clone()),
                (None, Some(file)) => Ok(case::load(&folder.join(file), None)?),
                (None, None) => {
                    let file = name.clone();
                    Err(Failure::from(error::no_case(file)))
                }
            }
        };
        let watch = Watch {
            progress: &|done, total| told.tell(done, total),
            ..Watch::SILENT
        };
        let mut files = RigFiles::of_text(&name, text, case)?;
        files.table.reach = settings.reach()?;
        Ok(Calibration(files.calibrate(&settings.hold, &watch)?))
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
            .map_err(Fault::internal)
            .map_err(Failure::from)?;
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

/// Plans measurements on a rig that narrow the calibrated constants.
#[pyfunction]
pub fn design(
    py: Python<'_>,
    case: PyRef<'_, Case>,
    settings: &str,
    threads: Option<isize>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Study> {
    let settings: DesignSettings = stated(settings)?;
    let case = case.only()?;
    in_parallel(py, threads, progress.as_ref(), |told| {
        let limits = settings.limits(&case.case)?;
        let held = &settings.rig.hold;
        let found = plan(case, &limits, held, &|done| told.tell(done, done.max(1)))?;
        let losses = settings
            .simulate
            .map(|seed| simulated(case, &found, seed))
            .transpose()?;
        let (json, summary) = (failure::json(&found)?, found.summary(losses.as_deref()));
        Ok(Study::new(json, summary, move |folder| {
            found.write(losses.as_deref(), folder)
        }))
    })
}
