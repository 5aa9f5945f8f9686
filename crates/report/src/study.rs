//! Folders of study results: a JSON file, tables and a page, written completely or not at all.

use std::path::Path;

use asperity_core::Fault;
use asperity_storage::{check_folder, replace_folder};
use serde::Serialize;

use crate::Report;
use crate::folder::{title_in, write_json, write_text};

/// Result of a study, of which terminal, page and folder show the [`Report`].
pub trait StudyResult: Serialize + Sized {
    /// Kind of the folder in messages.
    const KIND: &'static str;
    /// Name of the JSON file and of the page, without extension.
    const NAME: &'static str;
    /// Its report.
    fn report(&self) -> Report<'_>;

    /// Summary for the terminal.
    fn summary(&self) -> String {
        self.report().terminal()
    }

    /// Page of the result.
    fn page(&self) -> String {
        self.report().page()
    }

    /// Checks that a result may be written as folder `target`.
    ///
    /// # Errors
    /// When `target` holds something else than an earlier result of this kind.
    fn check_target(target: &Path) -> Result<(), Fault> {
        Ok(check_folder(target, Self::KIND)?)
    }

    /// Title of the earlier result of this kind in folder `target`; `None` if there is none, or no title can be read.
    fn title_of(target: &Path) -> Option<String> {
        title_in(&target.join(Self::NAME).with_extension("json"))
    }

    /// Writes the result as folder `target`, completely or not at all, and replaces an older one.
    ///
    /// # Errors
    /// When a file cannot be written, or `target` holds something else.
    fn write(&self, target: &Path) -> Result<(), Fault> {
        let name = Self::NAME;
        replace_folder(target, Self::KIND, |folder| {
            write_json(&folder.join(format!("{name}.json")), self)?;
            let report = self.report();
            report.write_files(folder)?;
            write_text(&folder.join(format!("{name}.html")), &report.page())
        })
    }
}
