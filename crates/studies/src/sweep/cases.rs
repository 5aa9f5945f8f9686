//! Cases of a study in memory, without parts and folders.

use std::ops::Range;

use super::case_list::CaseList;
use super::error::SweepError;
use super::parts::header;
use super::run::{SharedContacts, rows_of};
use super::study::Study;

/// Cases of a study, which can be run in any order; shared contacts are solved once.
///
/// ```
/// use asperity::case;
/// use asperity_studies::sweep::{Cases, Study};
/// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
/// let case = case::load_with(file, &|input| {
///     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
/// })?;
/// let text = r#"{ "axis": [{ "key": "operation.speed", "values": ["3000 1/min", "9000 1/min"] }], "columns": ["loss_w"] }"#;
/// let cases = Cases::new(Study::of_case(case, text, ".".as_ref())?)?;
/// assert_eq!(cases.header(), ["case", "id", "operation.speed", "loss_w", "outside", "code"]);
/// let rows = cases.rows(0..cases.count())?;
/// assert_eq!(rows[1][2], "9000 1/min");
/// assert!(rows[1][3].parse::<f64>()? > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Cases {
    study: Study,
    list: CaseList,
    contacts: SharedContacts,
}

impl Cases {
    /// Makes the list of the cases of `study`.
    ///
    /// # Errors
    /// When the study is not valid.
    pub fn new(study: Study) -> Result<Self, SweepError> {
        Ok(Self {
            list: CaseList::new(&study)?,
            contacts: SharedContacts::default(),
            study,
        })
    }

    /// SHA-256 of everything that the cases follow from.
    #[must_use]
    pub fn study(&self) -> &str {
        &self.study.hash
    }

    /// Number of cases.
    #[must_use]
    pub fn count(&self) -> usize {
        self.list.count()
    }

    /// Names and texts of the nodes of the crossed axes, the outermost first; the sample is the innermost.
    #[must_use]
    pub fn axes(&self) -> Vec<(String, Vec<String>)> {
        self.list.axes()
    }

    /// Sampled keys.
    #[must_use]
    pub fn sampled(&self) -> Vec<String> {
        self.list.sampled()
    }

    /// Sets every value of every axis once and reads the files that it names, without running a case.
    ///
    /// # Errors
    /// When a value or a file cannot be read; a case with it would have a row with its error code.
    pub fn check_values(&self) -> Result<(), SweepError> {
        self.list.check_values(&self.study)
    }

    /// Names of the columns of a row: number, id, inputs, results, codes of warnings, error code.
    #[must_use]
    pub fn header(&self) -> Vec<String> {
        header(&self.study, &self.list)
    }

    /// Runs the cases with these numbers and returns their rows. A case without a result has a row with its error code.
    ///
    /// # Errors
    /// When a file that a case reads has changed since the study was loaded.
    pub fn rows(&self, numbers: Range<usize>) -> Result<Vec<Vec<String>>, SweepError> {
        let numbers: Vec<usize> = numbers.collect();
        let rows = rows_of(&self.study, &self.list, &numbers, &self.contacts)?;
        rows.into_iter().collect()
    }
}
