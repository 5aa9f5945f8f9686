//! Folder of a calibration: `calibration.json`, `calibration.toml` (the block), `points.csv`, `calibration.html`. Folder of
//! a design: `design.json`, `design.csv` to fill in, `design.html`, and on request `simulated.csv`.

use std::fmt::Write as _;
use std::path::Path;

use asperity_report::{ReportError, tables, write_json, write_text};
use asperity_storage::{check_folder, replace_folder};

use crate::design::Design;
use crate::page;
use crate::result::Calibration;
use crate::rig_table::SIMULATED;

/// Kind of the folder in messages.
const KIND: &str = "calibration";

/// Checks that a calibration or a design may be written as folder `target`.
///
/// # Errors
/// When `target` holds something else than an older one.
pub fn check_place(target: &Path) -> Result<(), ReportError> {
    Ok(check_folder(target, KIND)?)
}

/// Writes `calibration` as folder `target`, completely or not at all, and replaces an older one.
///
/// # Errors
/// When a file cannot be written, or `target` holds something else.
pub fn write(calibration: &Calibration, target: &Path) -> Result<(), ReportError> {
    replace_folder(target, KIND, |folder| {
        write_json(&folder.join("calibration.json"), calibration)?;
        write_text(&folder.join("calibration.toml"), &calibration.block)?;
        tables::write(&folder.join("points.csv"), calibration.points.iter())?;
        write_text(&folder.join("calibration.html"), &page::render(calibration))
    })
}

/// Writes `design` as folder `target`, with a table of simulated losses if there are any.
///
/// # Errors
/// When a file cannot be written, or `target` holds something else.
pub fn write_design(
    design: &Design,
    simulated: Option<&[f64]>,
    target: &Path,
) -> Result<(), ReportError> {
    replace_folder(target, KIND, |folder| {
        write_json(&folder.join("design.json"), design)?;
        write_text(&folder.join("design.csv"), &table(design, None))?;
        if let Some(losses) = simulated {
            write_text(&folder.join("simulated.csv"), &table(design, Some(losses)))?;
        }
        write_text(&folder.join("design.html"), &page::render_design(design))
    })
}

/// Rig table for `design`, with empty or simulated losses.
fn table(design: &Design, simulated: Option<&[f64]>) -> String {
    let mut text = String::new();
    if simulated.is_some() {
        text.push_str(&format!(
            "# {SIMULATED} by {}: not measured\n",
            design.program
        ));
    }
    text.push_str(
        "torque_nm,speed_rpm,temperature_c,loss_w,sigma_w,assembly,order,includes,flank_state\n",
    );
    for (k, (number, assembly)) in design.rows().enumerate() {
        let point = &design.points[number];
        let loss = simulated.and_then(|losses| losses.get(k));
        let measured = loss.map_or(",".to_owned(), |loss| {
            format!("{loss:.3},{:.3}", design.limits.sigma * loss)
        });
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "{},{},{},{measured},{},{},mesh,",
            point.torque_nm,
            point.speed_rpm,
            point.temperature_c,
            assembly + 1,
            k + 1
        );
    }
    text
}
