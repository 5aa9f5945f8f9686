//! Output of a study of ridges: `ridges.json`, tables, page and summary.

use std::path::Path;

use asperity::result::ridges::FlankWatts;
use asperity_core::Fault;
use asperity_report::StudyResult;
use asperity_report::tables::{BODIES, write as write_table};
use serde::Serialize;

use super::page;
use super::study::RidgeStudy;
use super::summary::summary;

impl StudyResult for RidgeStudy {
    const KIND: &'static str = "study of ridges";
    const NAME: &'static str = "ridges";
    type Context<'a> = ();

    fn summary(&self, (): ()) -> String {
        summary(&self.found)
    }

    fn page(&self, (): ()) -> String {
        page::render(&self.found)
    }

    fn write_tables(&self, (): (), folder: &Path) -> Result<(), Fault> {
        write_table(&folder.join("ridges.csv"), &self.found.rows)?;
        write_table(&folder.join("octaves.csv"), &self.found.octaves)?;
        for (name, flank) in BODIES.iter().zip(&self.flanks) {
            write_table(&folder.join(format!("{name}.csv")), points(flank))?;
        }
        for (name, flank) in BODIES.iter().zip(&self.measured) {
            if let Some(flank) = flank {
                let file = folder.join(format!("{name}_measured.csv"));
                write_table(&file, measured_points(flank))?;
            }
        }
        Ok(())
    }
}

/// A point of a measured trace.
#[derive(Serialize)]
struct MeasuredRow {
    x_mm: f64,
    height_um: f64,
    /// d(loss)/d(height) per length of the trace.
    loss_w_per_um_mm: f64,
}

fn measured_points(flank: &FlankWatts) -> impl Iterator<Item = MeasuredRow> {
    let dx = flank.trace.spacing().si();
    let both = flank.trace.heights().iter().zip(&flank.by_height);
    both.enumerate()
        .map(move |(i, (z, by_height))| MeasuredRow {
            x_mm: 1e3 * dx * i as f64,
            height_um: 1e6 * z,
            loss_w_per_um_mm: 1e-9 * by_height / dx,
        })
}

/// A point of a prepared trace.
#[derive(Serialize)]
struct PointRow {
    x_mm: f64,
    height_um: f64,
    /// d(loss)/d(height) per length of the trace.
    loss_w_per_um_mm: f64,
    /// Height above the mean line times it.
    loss_w_per_mm: f64,
}

fn points(flank: &FlankWatts) -> impl Iterator<Item = PointRow> {
    let dx = flank.trace.spacing().si();
    let both = flank.trace.heights().iter().zip(&flank.by_height);
    let both = both.zip(flank.watts_per_length()).enumerate();
    both.map(move |(i, ((z, by_height), watts))| PointRow {
        x_mm: 1e3 * dx * i as f64,
        height_um: 1e6 * z,
        loss_w_per_um_mm: 1e-9 * by_height / dx,
        loss_w_per_mm: 1e-3 * watts,
    })
}
