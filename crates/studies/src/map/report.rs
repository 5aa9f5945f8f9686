//! Report of a map, and its folder: `map.json`, `map.csv`, `map.html`, and its exports in `export`.

use std::path::{Path, PathBuf};

use asperity_core::Fault;
use asperity_report::{Report, StudyResult, make_folder, write_bytes};

use super::page;
use super::point::Map;
use super::summary::{bands, extremes, left_aside, notes, of_meshes, verdicts};
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

    fn report<'a>(&'a self, extras: MapExtras<'a>) -> Report<'a> {
        let axes = &self.axes;
        let names: Vec<&str> = self.finishes.iter().map(|f| f.name.as_str()).collect();
        let points = format!(
            "{} points: {} torques x {} speeds x {} temperatures; loss of the {} only.",
            axes.points(),
            axes.torque_nm.len(),
            axes.speed_rpm.len(),
            axes.temperature_c.len(),
            self.scope
        );
        let report = Report::new(
            &self.title,
            format!("{} · map of {}", self.program, names.join(", ")),
        )
        .section("Loss")
        .text([points])
        .verdict(verdicts(self))
        .table(extremes(self))
        .table(of_meshes(self))
        .warning(left_aside(self))
        .text(bands(self))
        .in_terminal()
        .text(notes(self))
        .in_terminal();
        page::sections(report, self, extras.visited)
            .file(move |folder| write_exports(extras.exports, folder))
            .file(|folder| table::write(self, &folder.join("map.csv")))
    }
}

fn write_exports(exports: &[(PathBuf, Vec<u8>)], folder: &Path) -> Result<(), Fault> {
    if exports.is_empty() {
        return Ok(());
    }
    let folder = folder.join(EXPORTS);
    make_folder(&folder)?;
    let mut exports = exports.iter();
    exports.try_for_each(|(name, bytes)| write_bytes(&folder.join(name), bytes))
}
