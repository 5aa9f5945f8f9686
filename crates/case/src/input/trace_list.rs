//! Keys of several traces of one flank: a list, a pattern, or a table for each.

use std::path::{Path, PathBuf};

use asperity_core::quantity::Length;
use asperity_profile_io::read::TraceRange;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::flank_place::{FlankPlaceInput, TraceStart};
use super::rows::{Judge, KeyPath, RangedKey, table};

/// Traces of one flank: `"pinion_*.csv"`, or a list of files and of tables.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum TraceList {
    /// A file, or a pattern with `*` and `?` in the name of the file.
    Pattern(String),
    /// Files, patterns, and tables.
    List(Vec<TraceEntry>),
}

/// One entry of a list of traces.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum TraceEntry {
    /// A file, or a pattern with `*` and `?` in the name of the file.
    Pattern(String),
    /// A file with what differs from the keys of the flank.
    Table(TraceInput),
}

table! {
    /// One of several traces of a flank; all other keys are those of the flank.
    #[derive(Default)]
    TraceInput;

    /// File of the trace, relative to the case file, or a pattern.
    file: PathBuf;
    /// Number of the tooth; default: a tooth of its own for every trace.
    #[serde(skip_serializing_if = "Option::is_none")]
    tooth: Option<u32> = "" usual [1.0, 1000.0] possible [1.0, 1e6];
    /// Place across the face, from the end of the face width that comes into contact last.
    #[serde(skip_serializing_if = "Option::is_none")]
    y: Option<Length> = "mm" usual [0.1, 1000.0] possible [1e-4, 10_000.0];
    /// End of the flank at which the trace begins, where it is not that of the flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    from: Option<TraceStart>;
    /// A point of the trace whose place is known, where it is not that of the flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<FlankPlaceInput> => table;
    /// Number of the profile in a file that holds several, counted from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    row: Option<usize> = "" usual [1.0, 10_000.0] possible [1.0, 1e7];
    /// Part of the trace that is used, where it is not that of the flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    range: Option<TraceRange> = "mm" usual [0.001, 100.0] possible [1e-5, 10_000.0];
    /// Engagements of a tooth until the trace was measured, which separate the stages of `after`.
    #[serde(skip_serializing_if = "Option::is_none")]
    engagements: Option<f64> = "" usual [1.0, 1e10] possible [1e-3, 1e15];
}

impl RangedKey for TraceList {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        match stated {
            Some(Self::List(entries)) => Vec::visit(Some(entries), at, judge),
            Some(Self::Pattern(_)) => {}
            None => TraceInput::visit(None, at, judge),
        }
    }
}

impl RangedKey for TraceEntry {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        if let Some(Self::Table(trace)) = stated {
            TraceInput::visit(Some(trace), at, judge);
        }
    }
}

impl TraceList {
    /// The entries in order; their files may be patterns.
    pub(crate) fn entries(&self) -> Vec<TraceInput> {
        let file = |text: &String| TraceInput {
            file: text.into(),
            ..TraceInput::default()
        };
        match self {
            Self::Pattern(text) => vec![file(text)],
            Self::List(entries) => {
                let entries = entries.iter().map(|entry| match entry {
                    TraceEntry::Pattern(text) => file(text),
                    TraceEntry::Table(table) => table.clone(),
                });
                entries.collect()
            }
        }
    }
}

impl<'de> Deserialize<'de> for TraceList {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ListVisitor)
    }
}

impl<'de> Deserialize<'de> for TraceEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(EntryVisitor)
    }
}

/// Implemented by hand, so that an error in an entry is described in the words of its type.
struct ListVisitor;

impl<'de> Visitor<'de> for ListVisitor {
    type Value = TraceList;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "a pattern as \"pinion_*.csv\", or a list of files and tables as [{{ file = \"a.csv\", tooth = 1 }}]"
        )
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Self::Value, E> {
        Ok(TraceList::Pattern(text.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, sequence: A) -> Result<Self::Value, A::Error> {
        Deserialize::deserialize(SeqAccessDeserializer::new(sequence)).map(TraceList::List)
    }
}

struct EntryVisitor;

impl<'de> Visitor<'de> for EntryVisitor {
    type Value = TraceEntry;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "a file, or a table as {{ file = \"a.csv\", tooth = 1, y = \"4 mm\" }}"
        )
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Self::Value, E> {
        Ok(TraceEntry::Pattern(text.to_owned()))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
        Deserialize::deserialize(MapAccessDeserializer::new(map)).map(TraceEntry::Table)
    }
}

/// Whether `name` is a pattern rather than the name of a file.
pub(crate) fn is_pattern(name: &Path) -> bool {
    name.to_string_lossy().contains(['*', '?'])
}

/// Whether `name` is of `pattern`, in which `*` stands for any characters and `?` for one.
pub(crate) fn matches(pattern: &str, name: &str) -> bool {
    let (pattern, name): (Vec<char>, Vec<char>) =
        (pattern.chars().collect(), name.chars().collect());
    // Where to go on after the last star, should the rest not fit.
    let (mut p, mut n, mut again) = (0, 0, None);
    while n < name.len() {
        match pattern.get(p) {
            Some('*') => {
                again = Some((p + 1, n));
                p += 1;
            }
            Some(c) if *c == '?' || *c == name[n] => (p, n) = (p + 1, n + 1),
            _ => match again {
                Some((after, from)) => {
                    again = Some((after, from + 1));
                    (p, n) = (after, from + 1);
                }
                None => return false,
            },
        }
    }
    pattern[p..].iter().all(|c| *c == '*')
}
