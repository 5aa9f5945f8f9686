//! The cases of a study in memory, without parts and folders.

use std::ops::Range;

use rayon::prelude::*;

use super::case_list::CaseList;
use super::error::SweepError;
use super::parts::header;
use super::run::{Kept, row_of};
use super::study::Study;

/// The cases of a study, run in any order; those that share their contacts solve them once.
///
/// ```
/// use asperity::case;
/// use asperity_studies::sweep::{Cases, Study};
/// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
/// let case = case::load_with(file, &|input| {
///     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
/// })?;
/// let text = r#"{ "axis": [{ "key": "operation.speed", "values": ["3000 1/min", "9000 1/min"] }], "columns": ["loss_w"] }"#;
/// let cases = Cases::of(Study::of_case(case, text, ".".as_ref())?)?;
/// assert_eq!(cases.header(), ["case", "id", "operation.speed", "loss_w", "code"]);
/// let rows = cases.rows(0..cases.count())?;
/// assert_eq!(rows[1][2], "9000 1/min");
/// assert!(rows[1][3].parse::<f64>()? > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Cases {
    study: Study,
    list: CaseList,
    kept: Kept,
}

impl Cases {
    /// The cases of `study`.
    ///
    /// # Errors
    /// When the study names what cannot be.
    pub fn of(study: Study) -> Result<Self, SweepError> {
        Ok(Self {
            list: CaseList::of(&study)?,
            kept: Kept::default(),
            study,
        })
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.list.count()
    }

    /// Names of the columns of a row: number, id, inputs, results, code of an error.
    #[must_use]
    pub fn header(&self) -> Vec<String> {
        header(&self.study, &self.list)
    }

    /// The rows of the cases with these numbers. A case without a result is a row with its code.
    ///
    /// # Errors
    /// When a file that a case reads changed since the study was loaded.
    pub fn rows(&self, numbers: Range<usize>) -> Result<Vec<Vec<String>>, SweepError> {
        let row = |number| row_of(&self.study, &self.list, number, Some(&self.kept));
        numbers.into_par_iter().map(row).collect()
    }
}
