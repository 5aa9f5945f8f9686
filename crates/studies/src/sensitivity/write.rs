//! Folder of a sensitivity study: `sensitivity.json`, table and page.

use std::borrow::Cow;
use std::path::Path;

use asperity_report::tables::write as write_table;
use asperity_report::{ReportError, write_json, write_text};
use asperity_storage::{cell, check_folder, replace_folder};
use serde::Serialize;

use super::page;
use super::study::Sensitivity;

/// Kind of the folder in messages.
const KIND: &str = "sensitivity study";

/// Checks that a study may be written as folder `target`.
///
/// # Errors
/// When `target` holds something else than an older study.
pub fn check_place(target: &Path) -> Result<(), ReportError> {
    Ok(check_folder(target, KIND)?)
}

/// Writes `study` as folder `target`, completely or not at all, and replaces an older study.
///
/// # Errors
/// When a file cannot be written, or `target` holds something else.
pub fn write(study: &Sensitivity, target: &Path) -> Result<(), ReportError> {
    replace_folder(target, KIND, |folder| {
        write_json(&folder.join("sensitivity.json"), study)?;
        write_table(&folder.join("sensitivity.csv"), rows(study))?;
        write_text(&folder.join("sensitivity.html"), &page::render(study))
    })
}

#[derive(Serialize)]
struct ChangeRow<'a> {
    group: &'a str,
    change: Cow<'a, str>,
    to: Cow<'a, str>,
    difference_w: Option<f64>,
    change_percent: Option<f64>,
    sampling_half_width_w: Option<f64>,
    film_w: Option<f64>,
    lubricated_asperity_w: Option<f64>,
    boundary_w: Option<f64>,
    rolling_w: Option<f64>,
    code: &'a str,
}

fn rows(study: &Sensitivity) -> impl Iterator<Item = ChangeRow<'_>> {
    study.rows.iter().map(|row| {
        let effect = row.effect.as_ref();
        ChangeRow {
            group: row.group,
            change: cell(&row.what),
            to: cell(&row.to),
            difference_w: effect.map(|effect| effect.difference_w),
            change_percent: effect.map(|effect| 100.0 * effect.change),
            sampling_half_width_w: effect.and_then(|effect| effect.sampling_half_width_w),
            film_w: effect.map(|effect| effect.film_w),
            lubricated_asperity_w: effect.map(|effect| effect.lubricated_asperity_w),
            boundary_w: effect.map(|effect| effect.boundary_w),
            rolling_w: effect.map(|effect| effect.rolling_w),
            code: row.refused.as_ref().map_or("", |refused| &refused.code),
        }
    })
}
