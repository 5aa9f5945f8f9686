//! Output of a map: `map.json`, `map.csv`, `map.html`, and its exports in `export`.

use std::path::{Path, PathBuf};

use asperity_core::Fault;
use asperity_report::{StudyResult, make_folder, write_bytes};

use super::page;
use super::point::Map;
use super::summary::summary;
use super::table;

/// Folder of the exports within the folder of a map.
pub const EXPORTS: &str = "export";

/// Data besides a map in its folder.
#[derive(Debug, Clone, Copy, Default)]
pub struct MapExtras<'a> {
    /// Torques \[N m\] and speeds \[1/min\] of a cycle, drawn over the fields.
    pub visited: &'a [[f64; 2]],
    /// Exported files by name.
    pub exports: &'a [(PathBuf, Vec<u8>)],
}

impl StudyResult for Map {
    const KIND: &'static str = "map";
    const NAME: &'static str = "map";
    type Context<'a> = MapExtras<'a>;

    fn summary(&self, _: MapExtras<'_>) -> String {
        summary(self)
    }

    fn page(&self, extras: MapExtras<'_>) -> String {
        page::render(self, extras.visited)
    }

    fn write_tables(&self, extras: MapExtras<'_>, folder: &Path) -> Result<(), Fault> {
        if !extras.exports.is_empty() {
            let exports_folder = folder.join(EXPORTS);
            make_folder(&exports_folder)?;
            for (name, bytes) in extras.exports {
                write_bytes(&exports_folder.join(name), bytes)?;
            }
        }
        table::write(self, &folder.join("map.csv"))
    }
}
