//! A map read back from its folder.

use std::fs;
use std::path::{Path, PathBuf};

use super::point::{Map, Point};
use super::table::Row;

/// Why a folder is no map.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MapError {
    /// A file cannot be opened.
    #[error("{path}: not a map: {source}")]
    Open {
        /// The file.
        path: PathBuf,
        /// Reason given by the system.
        source: std::io::Error,
    },
    /// `map.json` is damaged.
    #[error("{path}: not a map: {source}")]
    Json {
        /// The file.
        path: PathBuf,
        /// Reason given by the reader.
        source: serde_json::Error,
    },
    /// `map.csv` is damaged.
    #[error("{path}: not a map: {source}")]
    Csv {
        /// The file.
        path: PathBuf,
        /// Reason given by the reader.
        source: csv::Error,
    },
    /// The table is not that of the axes.
    #[error("{path}: not a map: row {row} is not the point that map.json has there")]
    Row {
        /// The file.
        path: PathBuf,
        /// Number of the row from 1.
        row: usize,
    },
}

/// Reads the map in `folder`.
///
/// # Errors
/// When a file is missing, damaged, or the table is not that of the axes.
pub fn read(folder: &Path) -> Result<Map, MapError> {
    let file = folder.join("map.json");
    let bytes = fs::read(&file).map_err(|source| MapError::Open {
        path: file.clone(),
        source,
    })?;
    let mut map: Map = serde_json::from_slice(&bytes).map_err(|source| MapError::Json {
        path: file.clone(),
        source,
    })?;
    let path = folder.join("map.csv");
    let refused = |source| MapError::Csv {
        path: path.clone(),
        source,
    };
    let mut reader = csv::Reader::from_path(&path).map_err(refused)?;
    let mut rows = reader.deserialize::<Row<'_>>().enumerate();
    let count = map.axes.points();
    for finish in &mut map.finishes {
        let mut points = Vec::with_capacity(count.min(1_000_000));
        for index in 0..count {
            let (number, row) = rows.next().ok_or(MapError::Row {
                path: path.clone(),
                row: points.len() + 1,
            })?;
            let point = row.map_err(refused)?.point();
            let is_there = |point: &Point| {
                let axes = &map.axes;
                let (speeds, torques) = (axes.speed_rpm.len(), axes.torque_nm.len());
                let place = [
                    axes.torque_nm[index / speeds % torques],
                    axes.speed_rpm[index % speeds],
                    axes.temperature_c[index / speeds / torques],
                ];
                place == [point.torque_nm, point.speed_rpm, point.temperature_c]
            };
            match point.filter(is_there) {
                Some(point) => points.push(point),
                None => {
                    return Err(MapError::Row {
                        path: path.clone(),
                        row: number + 1,
                    });
                }
            }
        }
        finish.points = points;
    }
    match rows.next() {
        None => Ok(map),
        Some((number, _)) => Err(MapError::Row {
            path: path.clone(),
            row: number + 1,
        }),
    }
}
