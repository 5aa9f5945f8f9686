//! Calibrations from the losses of a rig.

use std::path::{Path, PathBuf};

use asperity::LoadedCase;
use asperity::case::{self, CalibratedName};
use asperity::message::Fault;
use asperity_calibration as calibrating;
use asperity_calibration::{Limits, Reach, RigFiles, Watch, error, plan};
use asperity_report::StudyResult;
use pyo3::prelude::*;

use crate::case::Case;
use crate::choices::named;
use crate::failure::{self, Failure};
use crate::study::Study;
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
    threads: Option<isize>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Calibration> {
    let held = hold.iter().map(|key| named("hold", key));
    let held = held.collect::<Result<Vec<CalibratedName>, Failure>>()?;
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

/// Plans measurements on a rig that narrow the calibrated constants. Limits that are not stated are the usual ones.
#[pyfunction]
pub fn design(
    py: Python<'_>,
    case: PyRef<'_, Case>,
    limits: &str,
    hold: Vec<String>,
    threads: Option<isize>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Study> {
    let held = hold.iter().map(|key| named("hold", key));
    let held = held.collect::<Result<Vec<CalibratedName>, Failure>>()?;
    let case = case.only()?;
    let stated: StatedLimits = failure::asked(limits)?;
    in_parallel(py, threads, progress.as_ref(), |told| {
        let usual = Limits::usual(
            &case.case,
            Reach {
                torque_max_nm: stated.torque_max_nm,
                speed_max_rpm: stated.speed_max_rpm,
                temperatures_c: stated.temperature_c,
            },
        );
        let limits = Limits {
            torques_nm: stated.torque_nm.unwrap_or(usual.torques_nm),
            speeds_rpm: stated.speed_rpm.unwrap_or(usual.speeds_rpm),
            hours: stated.hours.unwrap_or(usual.hours),
            minutes_per_point: stated.minutes_per_point.unwrap_or(usual.minutes_per_point),
            sigma: stated.sigma.unwrap_or(usual.sigma),
            assemblies: stated.assemblies.unwrap_or(usual.assemblies),
            ..usual
        };
        let found = plan(case, &limits, &held, &|done| told.tell(done, done.max(1)))?;
        let (json, summary) = (failure::json(&found)?, found.summary(None));
        Ok(Study::new(json, summary, move |folder| {
            found.write(None, folder)
        }))
    })
}

/// Limits of a rig, as JSON from Python.
#[derive(serde::Deserialize)]
struct StatedLimits {
    torque_max_nm: Option<f64>,
    speed_max_rpm: Option<f64>,
    torque_nm: Option<Vec<f64>>,
    speed_rpm: Option<Vec<f64>>,
    temperature_c: Option<Vec<f64>>,
    hours: Option<f64>,
    minutes_per_point: Option<f64>,
    sigma: Option<f64>,
    assemblies: Option<usize>,
}
