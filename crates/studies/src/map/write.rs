//! The folder of a map: `map.json`, `map.csv`, `map.html`, and its exports in `export`.

use std::path::{Path, PathBuf};

use asperity_report::{ReportError, make_folder, write_bytes, write_json, write_text};
use asperity_storage::{check_folder, replace_folder};

use super::page;
use super::point::Map;
use super::table;

/// Folder of the exports in that of the map.
pub const EXPORTS: &str = "export";

/// Kind of the folder in messages.
const KIND: &str = "map";

/// Whether a map may be written as folder `target`.
///
/// # Errors
/// When something else than an older map is there.
pub fn check_place(target: &Path) -> Result<(), ReportError> {
    Ok(check_folder(target, KIND)?)
}

/// Writes `map` as folder `target`, whole or not at all; an older map there is replaced. `visited` are torques
/// \[N m\] and speeds \[1/min\] of a cycle, drawn over the fields; `exports` are files by their names.
///
/// # Errors
/// When the system refuses, or `target` holds something else.
pub fn write(
    map: &Map,
    visited: &[[f64; 2]],
    exports: &[(PathBuf, Vec<u8>)],
    target: &Path,
) -> Result<(), ReportError> {
    replace_folder(target, KIND, |folder| {
        if !exports.is_empty() {
            let place = folder.join(EXPORTS);
            make_folder(&place)?;
            for (name, bytes) in exports {
                write_bytes(&place.join(name), bytes)?;
            }
        }
        write_json(&folder.join("map.json"), map)?;
        table::write(map, &folder.join("map.csv"))?;
        write_text(&folder.join("map.html"), &page::render(map, visited))
    })
}
