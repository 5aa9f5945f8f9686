//! Tables that a page shows beside the result.

use std::path::Path;

use asperity::result::{Outcome, PositionRow, RunResult};

use crate::error::ReportError;
use crate::tables::{ContactTables, FlankTables, LoadMapRow, load_map, read_load_map};

/// Tables of both flanks, of the load over them and of one mesh position.
#[derive(Debug, Clone, PartialEq)]
pub struct PageTables {
    /// Pinion and wheel; none for a flank without a trace.
    pub flanks: [Option<FlankTables>; 2],
    /// Load over path and face.
    pub load_map: Vec<LoadMapRow>,
    /// The mesh position shown; none where no fields were kept.
    pub contact: Option<ContactTables>,
}

impl PageTables {
    /// Tables of a run, with the fields of `position`, or of the highest pressure.
    ///
    /// # Errors
    /// When there is no such position or a trace cannot be prepared again.
    pub fn of(outcome: &Outcome, position: Option<usize>) -> Result<Self, ReportError> {
        let flank = |body: usize| {
            let record = &outcome.result.flanks[body];
            FlankTables::new(record, outcome.traces[body].as_ref())
        };
        let shown = shown_position(&outcome.result, position)?;
        let fields = |row: &PositionRow| {
            let mut all = outcome.fields.iter();
            all.find(|fields| fields.position == row.position)
        };
        Ok(Self {
            flanks: [flank(0)?, flank(1)?],
            load_map: load_map(&outcome.load_map),
            contact: shown.and_then(|row| Some(ContactTables::new(fields(row)?, row))),
        })
    }

    /// Reads the tables in a result folder, with the fields of `position`, or of the highest pressure.
    ///
    /// # Errors
    /// When there is no such position, or a table is missing or damaged.
    pub fn read(
        folder: &Path,
        result: &RunResult,
        position: Option<usize>,
    ) -> Result<Self, ReportError> {
        let contact = match shown_position(result, position)? {
            Some(row) => ContactTables::read(folder, row.position)?,
            None => None,
        };
        let flank = |body: usize| match result.flanks[body].preparation {
            Some(_) => FlankTables::read(folder, body).map(Some),
            None => Ok(None),
        };
        Ok(Self {
            flanks: [flank(0)?, flank(1)?],
            load_map: read_load_map(folder)?,
            contact,
        })
    }
}

/// The position asked for, or the one with the highest pressure.
fn shown_position(
    result: &RunResult,
    wanted: Option<usize>,
) -> Result<Option<&PositionRow>, ReportError> {
    let rows = &result.path;
    if let Some(number) = wanted {
        let found = rows.iter().find(|row| row.position == number);
        return found.map(Some).ok_or(ReportError::NoSuchPosition {
            number,
            count: rows.len(),
        });
    }
    let pressure = |row: &PositionRow| row.p_max_mpa.unwrap_or(row.hertz_pressure_mpa);
    let highest = rows
        .iter()
        .max_by(|a, b| pressure(a).total_cmp(&pressure(b)));
    Ok(highest)
}
