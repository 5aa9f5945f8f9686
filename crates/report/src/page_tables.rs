//! Tables that a page shows beside the result.

use asperity::result::ContactView;
use asperity::result::{Outcome, PositionRow, RunResult};
use serde::{Deserialize, Serialize};

use crate::error::{ReportError, TableFault};
use crate::tables::{ContactTables, FlankTables, LoadMapRow, check_field, load_map, thinned_views};

/// Tables of both flanks, of the load over them and of one mesh position. Those that are read back can be drawn: the
/// fields are rectangles of finite numbers, the columns of a view of one length.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Stored")]
pub struct PageTables {
    /// Pinion and wheel; none for a flank without a trace.
    pub flanks: [Option<FlankTables>; 2],
    /// Load over path and face.
    pub load_map: Vec<LoadMapRow>,
    /// The mesh position shown; none where no rough contact was solved.
    pub contact: Option<ContactTables>,
    /// The flanks facing each other along the path; empty where no rough contact was solved.
    #[serde(default)]
    pub views: Vec<ContactView>,
    /// File that holds the tables, where they have no files of their own.
    pub file: Option<String>,
}

/// Page tables as they are in a file, which may be damaged.
#[derive(Deserialize)]
struct Stored {
    flanks: [Option<FlankTables>; 2],
    load_map: Vec<LoadMapRow>,
    contact: Option<ContactTables>,
    #[serde(default)]
    views: Vec<ContactView>,
    file: Option<String>,
}

impl TryFrom<Stored> for PageTables {
    type Error = TableFault;

    fn try_from(stored: Stored) -> Result<Self, TableFault> {
        check_field(&stored.load_map, |row| [row.s_mm, row.y_mm])?;
        if let Some(contact) = &stored.contact {
            contact.check_subsurface()?;
        }
        match stored.views.iter().all(ContactView::is_whole) {
            true => Ok(Self {
                flanks: stored.flanks,
                load_map: stored.load_map,
                contact: stored.contact,
                views: stored.views,
                file: stored.file,
            }),
            false => Err(TableFault::NotAField),
        }
    }
}

impl PageTables {
    /// Tables of a run, with the fields of `position`, or of the highest pressure.
    ///
    /// # Errors
    /// When there is no such position, it has no fields, or a trace cannot be prepared again.
    pub fn of(outcome: &Outcome, position: Option<usize>) -> Result<Self, ReportError> {
        let flank = |body: usize| {
            let record = &outcome.result.flanks[body];
            FlankTables::new(record, outcome.traces[body].as_ref())
        };
        let shown = shown_position(&outcome.result, position)?;
        let contact = shown.and_then(|row| {
            let mut all = outcome.fields.iter();
            let fields = all.find(|fields| fields.position == row.position)?;
            Some(ContactTables::new(fields, row))
        });
        if let (Some(number), None) = (position, &contact) {
            return Err(ReportError::NoFields {
                number,
                place: None,
            });
        }
        Ok(Self {
            flanks: [flank(0)?, flank(1)?],
            load_map: load_map(&outcome.load_map),
            contact,
            views: outcome.views.clone(),
            file: None,
        })
    }

    /// The tables thinned for display, to be kept in `file`.
    ///
    /// # Errors
    /// When `result` does not have the position.
    pub fn thinned(&self, result: &RunResult, file: &str) -> Result<Self, ReportError> {
        let flank = |body: usize| {
            let flank: Option<&FlankTables> = self.flanks[body].as_ref();
            flank.map(FlankTables::thinned)
        };
        let contact = match &self.contact {
            Some(contact) => {
                let row = shown_position(result, Some(contact.position))?;
                row.map(|row| contact.thinned(row))
            }
            None => None,
        };
        Ok(Self {
            flanks: [flank(0), flank(1)],
            load_map: self.load_map.clone(),
            contact,
            views: thinned_views(&self.views, self.contact.as_ref().map(|at| at.position)),
            file: Some(file.to_owned()),
        })
    }

    /// Name of the file that a chart is drawn from, where the table `own` is kept.
    pub(crate) fn source(&self, own: &str) -> String {
        self.file.as_deref().unwrap_or(own).to_owned()
    }
}

/// The position asked for, or the one with the highest pressure.
pub(crate) fn shown_position(
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
