//! The oils that come with the program, one data file per source.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::{LubricantError, LubricantInput};
use asperity_core::presets::Certainty;

/// The data files, named after their sources.
const FILES: [(&str, &str); 4] = [
    (
        "arana_2019.json",
        include_str!("../data/oils/arana_2019.json"),
    ),
    (
        "liqui_moly_data_sheet.json",
        include_str!("../data/oils/liqui_moly_data_sheet.json"),
    ),
    (
        "petry_johnson_2008.json",
        include_str!("../data/oils/petry_johnson_2008.json"),
    ),
    (
        "rodriguez_2022.json",
        include_str!("../data/oils/rodriguez_2022.json"),
    ),
];

/// An oil of the library.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LibraryOil {
    /// Name in a case file.
    pub name: String,
    /// Source of the numbers.
    pub source: String,
    /// Notes for its use.
    pub note: String,
    /// Certainty of each key.
    pub certainty: BTreeMap<String, Certainty>,
    /// The numbers.
    pub lubricant: LubricantInput,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    source: String,
    oils: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    name: String,
    note: String,
    certainty: BTreeMap<String, Certainty>,
    lubricant: LubricantInput,
}

/// Every oil of the library.
///
/// # Errors
/// When a data file cannot be read; a test reads them all.
///
/// ```
/// let oils = asperity_oil::library()?;
/// assert!(oils.iter().any(|oil| oil.name == "m100"));
/// # Ok::<(), asperity_oil::LubricantError>(())
/// ```
pub fn library() -> Result<Vec<LibraryOil>, LubricantError> {
    let mut oils = Vec::new();
    for (file, text) in FILES {
        let File {
            source,
            oils: entries,
        } = serde_json::from_str(text).map_err(|error| LubricantError::library(file, error))?;
        oils.extend(entries.into_iter().map(|entry| LibraryOil {
            name: entry.name,
            source: source.clone(),
            note: entry.note,
            certainty: entry.certainty,
            lubricant: entry.lubricant,
        }));
    }
    Ok(oils)
}

/// The oil of this name, in upper or lower case.
///
/// # Errors
/// When the library has no such oil, or cannot be read.
pub fn library_oil(name: &str) -> Result<LibraryOil, LubricantError> {
    let mut oils = library()?;
    match oils
        .iter()
        .position(|oil| oil.name.eq_ignore_ascii_case(name.trim()))
    {
        Some(index) => Ok(oils.swap_remove(index)),
        None => Err(LubricantError::unknown_oil(
            name,
            &Vec::from_iter(oils.into_iter().map(|oil| oil.name)),
        )),
    }
}
