//! Folder of a cycle: `cycle.json`, `cycle.csv`, `cycle.html`.

use std::borrow::Cow;
use std::path::Path;

use asperity_report::{ReportError, tables, write_json, write_text};
use asperity_storage::{cell, check_folder, replace_folder};
use serde::Serialize;

use super::energy::CycleResult;
use super::page;
use crate::map::Map;

/// Kind of the folder in messages.
const KIND: &str = "cycle";

/// Checks that a result may be written as folder `target`.
///
/// # Errors
/// When `target` holds something else than an older result.
pub fn check_place(target: &Path) -> Result<(), ReportError> {
    Ok(check_folder(target, KIND)?)
}

/// Writes `result`, computed on `map`, as folder `target`, completely or not at all.
///
/// # Errors
/// When a file cannot be written, or `target` holds something else.
pub fn write(result: &CycleResult, map: &Map, target: &Path) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct CyclePointRow<'a> {
        time_s: f64,
        torque_nm: f64,
        speed_rpm: f64,
        loss_w: f64,
        finish: Cow<'a, str>,
    }
    let rows = result.finishes.iter().flat_map(|finish| {
        let points = result.points.iter().zip(&finish.loss_w);
        points.map(move |(point, loss_w)| CyclePointRow {
            time_s: point.time_s,
            torque_nm: point.torque_nm,
            speed_rpm: point.speed_rpm,
            loss_w: *loss_w,
            finish: cell(&finish.name),
        })
    });
    replace_folder(target, KIND, |folder| {
        write_json(&folder.join("cycle.json"), result)?;
        tables::write(&folder.join("cycle.csv"), rows)?;
        write_text(&folder.join("cycle.html"), &page::render(result, map))
    })
}
