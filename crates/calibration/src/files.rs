//! Rig table and its cases from files.

use crate::error;
use std::path::Path;

use asperity::LoadedCase;
use asperity::case::CalibratedName;
use asperity::profile_io::read::read_table;
use asperity_core::Fault;
use asperity_report::{Input, Setting, Watch};

use crate::calibrate::calibrate;
use crate::result::Calibration;
use crate::rig::RigCase;
use crate::rig_table::RigTable;

/// Largest size of a table in bytes.
const LARGEST_TABLE: u64 = 10_000_000;

/// Rig table with its text and the cases of its rows.
#[derive(Debug, Clone)]
pub struct RigFiles {
    /// The table.
    pub table: RigTable,
    /// Its text.
    pub text: String,
    /// Its cases.
    pub cases: Vec<RigCase>,
}

impl Input for RigFiles {
    fn described() -> Vec<Setting> {
        let rig = "The measurements, with the columns of the command; a column simulated may say that their losses are";
        let case = "The case of rows that name none";
        let cases = "Cases by the names in the column case; others are files relative to the table, or to the working directory";
        vec![
            Setting::new("rig", "Rig", rig, None),
            Setting::new("case", "Option<Case>", case, None),
            Setting::new("cases", "Option<Cases>", cases, None),
        ]
    }

    fn title(&self) -> String {
        let first = self.cases.first();
        first.map_or_else(String::new, |first| first.case.case.title.clone())
    }
}

impl RigFiles {
    /// Reads the table in the file `rig` and loads the cases of its rows with `load`: the cases that it names, relative
    /// to it, and `case` for rows without a case.
    ///
    /// # Errors
    /// When a file cannot be read.
    pub fn read<E: From<Fault>>(
        rig: &Path,
        case: Option<&Path>,
        load: impl Fn(&Path) -> Result<LoadedCase, E>,
    ) -> Result<Self, E> {
        let file = rig.display().to_string();
        let named = |name: Option<&str>| match (name, case) {
            (Some(name), _) => load(&rig.parent().unwrap_or(Path::new(".")).join(name)),
            (None, Some(path)) => load(path),
            (None, None) => Err(error::no_case(&file).into()),
        };
        Self::of_text(&file, table_text(rig)?, named)
    }

    /// Reads the table in `text`, named `name` in messages, and loads the case of every name in it with `case`; rows
    /// without a name have the name `None`.
    ///
    /// # Errors
    /// When the table is not valid, or `case` fails.
    pub fn of_text<E: From<Fault>>(
        name: &str,
        text: String,
        case: impl Fn(Option<&str>) -> Result<LoadedCase, E>,
    ) -> Result<Self, E> {
        let table = RigTable::read(name, &text)?;
        let cases = table.case_names().into_iter().map(|name| {
            let case = case(name.as_deref())?;
            Ok(RigCase { name, case })
        });
        let cases = cases.collect::<Result<Vec<RigCase>, E>>()?;
        Ok(Self { table, text, cases })
    }

    /// Calibrates the parameters that are not `held`.
    ///
    /// # Errors
    /// As [`calibrate`].
    pub fn calibrate(
        self,
        held: &[CalibratedName],
        watch: &Watch<'_>,
    ) -> Result<Calibration, Fault> {
        calibrate(self.table, &self.text, &self.cases, held, watch)
    }
}

/// Text of the table in `file`.
///
/// # Errors
/// When it cannot be read, is larger than 10 MB or is not text.
pub fn table_text(file: &Path) -> Result<String, Fault> {
    read_table(file, LARGEST_TABLE).map_err(error::open)
}
