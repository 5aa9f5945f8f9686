//! Tables of a page, in addition to the result.

use crate::error;
use asperity::result::ContactView;
use asperity::result::{MeshOutcome, PositionRow, RunResult};
use asperity_core::Fault;
use serde::{Deserialize, Serialize};

use asperity_table::own::OwnFault;

use crate::tables::{ContactTables, FlankTables, LoadMapRow, check_field, load_map, thinned_views};

/// Tables of both flanks, of the load map and of one mesh position. Tables that are read back are checked: fields are
/// rectangles of finite numbers, and the columns of a view have equal length.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Stored")]
pub struct PageTables {
    /// Pinion and wheel, thinned for display; `None` for a flank without a trace.
    pub flanks: [Option<FlankTables>; 2],
    /// Load over path and face.
    pub load_map: Vec<LoadMapRow>,
    /// The mesh position shown; `None` if no rough contact was solved.
    pub contact: Option<ContactTables>,
    /// The flanks facing each other along the path; empty if no rough contact was solved.
    pub views: Vec<ContactView>,
    /// File that holds the tables, if they do not have separate files.
    pub file: Option<String>,
}

/// Unchecked page tables from a file.
#[derive(Deserialize)]
struct Stored {
    flanks: [Option<FlankTables>; 2],
    load_map: Vec<LoadMapRow>,
    contact: Option<ContactTables>,
    views: Vec<ContactView>,
    file: Option<String>,
}

impl TryFrom<Stored> for PageTables {
    type Error = OwnFault;

    fn try_from(stored: Stored) -> Result<Self, OwnFault> {
        check_field(&stored.load_map, |row| [row.s_mm, row.y_mm])?;
        if let Some(contact) = &stored.contact {
            contact.check()?;
        }
        if stored.views.iter().all(ContactView::is_whole) {
            Ok(Self {
                flanks: stored.flanks,
                load_map: stored.load_map,
                contact: stored.contact,
                views: stored.views,
                file: stored.file,
            })
        } else {
            Err(OwnFault::NotAField)
        }
    }
}

impl PageTables {
    /// Makes the tables of a run, with the fields of `position`, or of the position with the highest pressure.
    ///
    /// # Errors
    /// When the position does not exist or has no fields, or a trace cannot be prepared.
    pub fn new(outcome: &MeshOutcome, position: Option<usize>) -> Result<Self, Fault> {
        let flank = |body: usize| {
            let record = &outcome.result.flanks[body];
            FlankTables::shown(record, outcome.traces[body].as_ref())
        };
        let shown = shown_position(&outcome.result, position)?;
        let contact = shown.and_then(|row| {
            let mut all = outcome.fields.iter();
            let fields = all.find(|fields| fields.position == row.position)?;
            Some(ContactTables::new(fields, row))
        });
        if let (Some(number), None) = (position, &contact) {
            return Err(error::no_fields(number, None));
        }
        Ok(Self {
            flanks: [
                flank(0).map_err(error::of_flank)?,
                flank(1).map_err(error::of_flank)?,
            ],
            load_map: load_map(&outcome.load_map),
            contact,
            views: outcome.views.clone(),
            file: None,
        })
    }

    /// The tables thinned for display, as stored in `file`.
    ///
    /// # Errors
    /// When `result` does not have the position.
    pub fn thinned(&self, result: &RunResult, file: &str) -> Result<Self, Fault> {
        let contact = match &self.contact {
            Some(contact) => {
                let row = shown_position(result, Some(contact.position))?;
                row.map(|row| contact.thinned(row))
            }
            None => None,
        };
        Ok(Self {
            flanks: self.flanks.clone(),
            load_map: self.load_map.clone(),
            contact,
            views: thinned_views(&self.views, self.contact.as_ref().map(|at| at.position)),
            file: Some(file.to_owned()),
        })
    }

    /// Name of the data file of a chart whose table is `table`.
    pub(crate) fn source(&self, table: &str) -> String {
        self.file.as_deref().unwrap_or(table).to_owned()
    }
}

/// The requested position, or the one with the highest pressure.
pub(crate) fn shown_position(
    result: &RunResult,
    requested: Option<usize>,
) -> Result<Option<&PositionRow>, Fault> {
    let rows = &result.path;
    if let Some(number) = requested {
        let row = rows.iter().find(|row| row.position == number);
        return row
            .map(Some)
            .ok_or(error::no_such_position(number, rows.len()));
    }
    let pressure = |row: &PositionRow| row.p_max_mpa.unwrap_or(row.hertz_pressure_mpa);
    let highest = rows
        .iter()
        .max_by(|a, b| pressure(a).total_cmp(&pressure(b)));
    Ok(highest)
}
