//! A case as the user would write it, made in the test.

#![allow(clippy::unwrap_used, reason = "a helper of tests may panic")]

use std::path::Path;

use asperity::case::{LoadedCase, load};
use asperity::result::{Losses, MeshOutcome};
use asperity::{Contacts, Error, Run};
use toml::{Table, Value};

/// The text of a case file, key by key.
///
/// Every test goes through text, file and schema as a user does: what it proves holds from the file
/// on. The keys of a section may be replaced one at a time.
#[derive(Debug, Clone)]
pub struct CaseText(Table);

/// The friction law of one coefficient everywhere, in a case.
#[must_use]
pub fn constant(mu: f64) -> Table {
    Table::from_iter([("constant".to_owned(), mu.into())])
}

impl CaseText {
    /// A case from TOML.
    ///
    /// # Panics
    /// When the text is no TOML.
    pub fn new(text: &str) -> Self {
        Self(text.parse().unwrap())
    }

    /// The same with `key`, dotted as in `gears.face_width`, set to `value`.
    ///
    /// # Panics
    /// When a part of the key before the last is not a table.
    #[must_use]
    pub fn with(mut self, key: &str, value: impl Into<Value>) -> Self {
        let mut parts: Vec<&str> = key.split('.').collect();
        let last = parts.pop().unwrap();
        let mut table = &mut self.0;
        for part in parts {
            table = table
                .entry(part)
                .or_insert_with(|| Value::Table(Table::new()))
                .as_table_mut()
                .unwrap();
        }
        table.insert(last.to_owned(), value.into());
        self
    }

    /// The case, with the files it names in `folder`.
    ///
    /// # Panics
    /// When the case is refused.
    pub fn load_in(&self, folder: &Path) -> LoadedCase {
        let file = folder.join("case.toml");
        std::fs::write(&file, self.0.to_string()).unwrap();
        asperity_paper_2022::register();
        crate::table_2::register_references();
        load(&file, None).unwrap()
    }

    /// The case, which names no files.
    ///
    /// # Panics
    /// When the case is refused.
    pub fn load(&self) -> LoadedCase {
        self.load_in(tempfile::tempdir().unwrap().path())
    }

    /// Loads and runs the case, which names no files.
    ///
    /// # Panics
    /// When the case is refused or has no solution.
    pub fn run(&self) -> MeshOutcome {
        run(&self.load())
    }
}

/// Runs a loaded case.
///
/// # Panics
/// When it has no solution.
pub fn run(loaded: &LoadedCase) -> MeshOutcome {
    Run::new(loaded).execute().unwrap().into_only().unwrap()
}

/// Losses of a pair of gears.
///
/// # Errors
/// As [`Run::losses`].
pub fn losses(case: &LoadedCase) -> Result<Losses, Error> {
    Run::new(case).losses()?.into_only()
}

/// Losses of a pair of gears with contacts computed before.
///
/// # Errors
/// As [`Run::losses`].
pub fn losses_with(contacts: &Contacts, case: &LoadedCase) -> Result<Losses, Error> {
    Run::new(case).known([contacts]).losses()?.into_only()
}

/// Contacts of a pair of gears.
///
/// # Errors
/// As [`Run::contacts`].
pub fn contacts(case: &LoadedCase) -> Result<Contacts, Error> {
    Ok(Run::new(case).contacts()?.swap_remove(0))
}
