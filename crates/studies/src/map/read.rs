//! Reading of a map from its folder.

use std::fmt::Display;
use std::path::Path;

use asperity_core::{Code, Fault};
use asperity_storage::{check_written, whole_file};
use asperity_table::own::{self, OwnFault};

use super::axes::Axes;
use super::draws::DrawnNodes;
use super::point::{Map, Point};
use super::table::MapPointRow;
use asperity::result::SCHEMA_VERSION;

/// Largest size of a file in bytes.
const LARGEST: u64 = 1_000_000_000;

fn not_a_map(path: &Path, reason: impl Display) -> Fault {
    Fault::new(
        Code::E402,
        format!("{}: not a map: {reason}", path.display()),
    )
}

/// Reads the map in `folder`.
///
/// # Errors
/// When a file is missing or damaged, or the table does not match the axes.
pub fn read(folder: &Path) -> Result<Map, Fault> {
    let file = folder.join("map.json");
    let bytes = whole_file(&file, LARGEST).map_err(|source| not_a_map(&file, source))?;
    let mut map: Map = serde_json::from_slice(&bytes).map_err(|source| not_a_map(&file, source))?;
    check(&map).map_err(|reason| not_a_map(&file, reason))?;
    let path = folder.join("map.csv");
    let misplaced = |row| {
        not_a_map(
            &path,
            format!("row {row} is not the point that map.json has there"),
        )
    };
    let table = whole_file(&path, LARGEST).map_err(|source| not_a_map(&path, source))?;
    let rows = own::rows::<MapPointRow<'_>>(&table).map_err(|fault| match fault {
        OwnFault::NotFinite { row, .. } => misplaced(row),
        source => not_a_map(&path, source),
    })?;
    let count = map.axes.points();
    let expected = count * map.finishes.len();
    if rows.len() != expected {
        return Err(misplaced(rows.len().min(expected) + 1));
    }
    let (speeds, torques) = (map.axes.speed_rpm.len(), map.axes.torque_nm.len());
    let mut rows = rows.into_iter().enumerate();
    for finish in &mut map.finishes {
        let mut points = Vec::with_capacity(count);
        for (number, row) in rows.by_ref().take(count) {
            let index = points.len();
            let place = [
                map.axes.torque_nm[index / speeds % torques],
                map.axes.speed_rpm[index % speeds],
                map.axes.temperature_c[index / speeds / torques],
            ];
            let is_there =
                |point: &Point| place == [point.torque_nm, point.speed_rpm, point.temperature_c];
            let point = row.point().filter(is_there);
            points.push(point.ok_or_else(|| misplaced(number + 1))?);
        }
        finish.points = points;
    }
    check_written(folder, "map", &["map.json", "map.csv"])?;
    Ok(map)
}

/// Checks the axes and the sizes of the parts.
fn check(map: &Map) -> Result<(), String> {
    if map.schema_version != SCHEMA_VERSION {
        let other = map.schema_version;
        return Err(format!(
            "schema version {other}, and this program reads {SCHEMA_VERSION}; make the map again"
        ));
    }
    let axes = &map.axes;
    let rising = Axes::new(&axes.torque_nm, &axes.speed_rpm, &axes.temperature_c);
    if rising.map_err(|error| error.to_string())? != *axes {
        return Err("its axes do not rise, or lack the node at 0".to_owned());
    }
    if map.finishes.is_empty() {
        return Err("it has no finishes".to_owned());
    }
    let is_whole = |draws: &DrawnNodes| {
        let nodes = [&draws.torque_nm, &draws.speed_rpm, &draws.temperature_c];
        let rises = |values: &&Vec<f64>| !values.is_empty() && values.is_sorted_by(|a, b| a < b);
        nodes.iter().all(rises)
            && draws.predictive.len() == nodes.iter().map(|values| values.len()).product::<usize>()
    };
    if !map
        .finishes
        .iter()
        .flat_map(|finish| &finish.draws)
        .all(is_whole)
    {
        return Err("its samples do not fill their nodes".to_owned());
    }
    let is_whole = |loss: &[f64]| loss.len() == axes.points();
    match &map.gearbox {
        Some(gearbox) if !is_whole(&gearbox.loss_torque_nm) => {
            Err("its gearbox does not have a loss for every point".to_owned())
        }
        _ => Ok(()),
    }
}
