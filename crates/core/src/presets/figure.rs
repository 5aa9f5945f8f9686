//! A number with its certainty and its source.

use serde::{Deserialize, Serialize};

use super::error::PresetError;
use super::sources::{OWN_CHOICE, PresetSource};

/// Certainty of a number of a preset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Certainty {
    /// Read in the source itself: a paper, a data sheet, a file of its maker.
    A,
    /// Quoted by others: the source names or implies another one that was not read.
    B,
    /// Derived from numbers of the source.
    C,
    /// Not known of this preset: taken over from elsewhere, or chosen.
    #[serde(rename = "assumed")]
    Assumed,
}

impl Certainty {
    /// The letter, or `assumed`.
    pub const fn text(self) -> &'static str {
        match self {
            Self::A => "A",
            Self::B => "B",
            Self::C => "C",
            Self::Assumed => "assumed",
        }
    }
}

impl std::fmt::Display for Certainty {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.text())
    }
}

/// A number of a preset.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Figure<T> {
    /// The number, with its unit.
    pub value: T,
    /// Certainty.
    pub certainty: Certainty,
    /// Key of its source.
    pub source: String,
    /// Derivation, or the number that it was copied from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
}

impl<T> Figure<T> {
    /// The row of this number, its value as text.
    pub(super) fn row(&self, key: &'static str, text: impl Fn(&T) -> String) -> FigureRow<'_> {
        FigureRow {
            key,
            value: text(&self.value),
            certainty: self.certainty,
            source: &self.source,
            note: self.note.as_deref(),
        }
    }
}

/// A number of a preset as text.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FigureRow<'a> {
    /// Key of the number in a case file.
    pub key: &'static str,
    /// The value as written in a case file.
    pub value: String,
    /// Certainty.
    pub certainty: Certainty,
    /// Key of its source.
    pub source: &'a str,
    /// Derivation, or the number that it was copied from.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub note: Option<&'a str>,
}

/// Refuses numbers without a source that counts.
pub(super) fn check(
    preset: &str,
    rows: &[FigureRow<'_>],
    sources: &[PresetSource],
) -> Result<(), PresetError> {
    for row in rows {
        if !sources.iter().any(|source| source.key == row.source) {
            return Err(PresetError::NoSource {
                preset: preset.to_owned(),
                key: row.key,
                source_key: row.source.to_owned(),
            });
        }
        if row.source == OWN_CHOICE && row.certainty != Certainty::Assumed {
            return Err(PresetError::OwnChoice {
                preset: preset.to_owned(),
                key: row.key,
                certainty: row.certainty.text(),
            });
        }
    }
    Ok(())
}
