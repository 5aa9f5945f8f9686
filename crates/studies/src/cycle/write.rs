//! The folder of a cycle: `cycle.json`, `cycle.csv`, `cycle.html`.

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

/// Whether a result may be written as folder `target`.
///
/// # Errors
/// When something else than an older one is there.
pub fn check_place(target: &Path) -> Result<(), ReportError> {
    Ok(check_folder(target, KIND)?)
}

/// Writes `found`, which is of `map`, as folder `target`, whole or not at all.
///
/// # Errors
/// When the system refuses, or `target` holds something else.
pub fn write(found: &CycleResult, map: &Map, target: &Path) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct Row<'a> {
        time_s: f64,
        torque_nm: f64,
        speed_rpm: f64,
        loss_w: f64,
        finish: Cow<'a, str>,
    }
    let rows = found.finishes.iter().flat_map(|finish| {
        let points = found.points.iter().zip(&finish.loss_w);
        points.map(move |(point, loss_w)| Row {
            time_s: point.time_s,
            torque_nm: point.torque_nm,
            speed_rpm: point.speed_rpm,
            loss_w: *loss_w,
            finish: cell(&finish.name),
        })
    });
    replace_folder(target, KIND, |folder| {
        write_json(&folder.join("cycle.json"), found)?;
        tables::write(&folder.join("cycle.csv"), rows)?;
        write_text(&folder.join("cycle.html"), &page::render(found, map))
    })
}
