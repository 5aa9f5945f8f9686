//! A calibration from files.

use std::path::Path;

use asperity::case::CalibratedName;

use crate::calibrate::{Watch, calibrate};
use crate::error::CalibrationError;
use crate::result::Calibration;
use crate::rig::RigCase;
use crate::rig_table::RigTable;

/// Calibrates the parameters that are not `held` on the table in the file `rig`; `case` is that of rows which name
/// none. The file names in the table are relative to it.
///
/// # Errors
/// As [`calibrate`], and when a file cannot be read.
pub fn calibrate_files(
    rig: &Path,
    case: Option<&Path>,
    held: &[CalibratedName],
    watch: &Watch<'_>,
) -> Result<Calibration, CalibrationError> {
    let file = rig.display().to_string();
    let text = std::fs::read_to_string(rig).map_err(|reason| CalibrationError::Open {
        file: file.clone(),
        reason,
    })?;
    let table = RigTable::read(&file, &text)?;
    let cases = table.case_names().into_iter().map(|name| {
        let path = match (&name, case) {
            (Some(name), _) => rig.parent().unwrap_or(Path::new(".")).join(name),
            (None, Some(path)) => path.to_owned(),
            (None, None) => return Err(CalibrationError::NoCase { file: file.clone() }),
        };
        let case = asperity::case::load(&path, None).map_err(|source| CalibrationError::Model {
            place: path.display().to_string(),
            source: Box::new(source),
        })?;
        Ok(RigCase { name, case })
    });
    let cases = cases.collect::<Result<Vec<RigCase>, CalibrationError>>()?;
    calibrate(table, &text, &cases, held, watch)
}
