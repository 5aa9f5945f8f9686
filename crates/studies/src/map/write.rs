//! The folder of a map: `map.json`, `map.csv`, `map.html`, and its exports in `export`.

use std::path::{Path, PathBuf};

use asperity_report::{ReportError, make_folder, write_bytes, write_json, write_text};
use asperity_storage::{check_folder, replace_folder};

use super::page;
use super::point::Map;
use super::table;

/// Folder of the exports within the folder of a map.
pub const EXPORTS: &str = "export";

/// Kind of the folder in messages.
const KIND: &str = "map";

/// Checks that a map may be written as folder `target`.
///
/// # Errors
/// When `target` holds something else than an older map.
pub fn check_place(target: &Path) -> Result<(), ReportError> {
    Ok(check_folder(target, KIND)?)
}

/// Writes `map` as folder `target`, completely or not at all, and replaces an older map. `visited` are torques
/// \[N m\] and speeds \[1/min\] of a cycle, drawn over the fields; `exports` are files by name.
///
/// # Errors
/// When a file cannot be written, or `target` holds something else.
pub fn write(
    map: &Map,
    visited: &[[f64; 2]],
    exports: &[(PathBuf, Vec<u8>)],
    target: &Path,
) -> Result<(), ReportError> {
    replace_folder(target, KIND, |folder| {
        if !exports.is_empty() {
            let exports_folder = folder.join(EXPORTS);
            make_folder(&exports_folder)?;
            for (name, bytes) in exports {
                write_bytes(&exports_folder.join(name), bytes)?;
            }
        }
        write_json(&folder.join("map.json"), map)?;
        table::write(map, &folder.join("map.csv"))?;
        write_text(&folder.join("map.html"), &page::render(map, visited))
    })
}
