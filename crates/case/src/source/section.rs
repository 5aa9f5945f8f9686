//! A table of the case file with its source: keys by their names, and errors at their places.

use std::borrow::Cow;

use asperity_core::{DomainError, Place};

use super::case_error::CaseError;
use super::source_text::Source;

/// A table of the case, as `surface.pinion`, or a single key.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Section<'a> {
    /// Text of the case.
    pub source: &'a Source,
    /// Path of the table.
    pub table: &'static str,
}

impl<'a> Section<'a> {
    pub(crate) fn new(source: &'a Source, table: &'static str) -> Self {
        Self { source, table }
    }

    /// Path of a key of this table; of the table itself if `name` is empty.
    pub(crate) fn key(self, name: &str) -> Cow<'static, str> {
        match name {
            "" => self.table.into(),
            name => format!("{}.{name}", self.table).into(),
        }
    }

    /// Place of the value of a key.
    pub(crate) fn place(self, name: &str) -> Place {
        self.source.place_of(&self.key(name))
    }

    /// A number outside its domain.
    pub(crate) fn domain(self, name: &str) -> impl Fn(DomainError) -> CaseError + use<'a> {
        domain(self.source, self.key(name))
    }

    /// Keys that exclude or need each other, at the value of a key.
    pub(crate) fn conflict(self, name: &str, rule: &'static str) -> CaseError {
        CaseError::Conflict {
            place: self.place(name),
            key: self.key(name),
            rule,
        }
    }

    /// Keys that exclude or need each other, at the name of a key.
    pub(crate) fn conflict_of_key(self, name: &str, rule: &'static str) -> CaseError {
        let key = self.key(name);
        CaseError::Conflict {
            place: self.source.place_of_key(&key),
            key,
            rule,
        }
    }

    /// A value that cannot be used.
    pub(crate) fn value(self, name: &str, message: impl Into<String>) -> CaseError {
        let message: String = message.into();
        CaseError::value(self.place(name), Some(&self.key(name)), message)
    }
}

/// A number outside its domain, at `key`.
pub(crate) fn domain<'a, K: Into<Cow<'static, str>>>(
    source: &'a Source,
    key: K,
) -> impl Fn(DomainError) -> CaseError + use<'a, K> {
    let key = key.into();
    move |error| CaseError::Domain {
        place: source.place_of(&key),
        written: source.written(&key).map(str::to_owned),
        key: key.clone(),
        source: error,
    }
}

/// An error about a key of a mesh, with the key of the gear train that it comes from.
pub(crate) fn in_train(source: &Source, error: CaseError) -> CaseError {
    match error {
        CaseError::Conflict { place, key, rule } => CaseError::Conflict {
            place,
            key: source.key_in_train(key),
            rule,
        },
        CaseError::Domain {
            place,
            key,
            written,
            source: error,
        } => CaseError::Domain {
            place,
            key: source.key_in_train(key),
            written,
            source: error,
        },
        other => other,
    }
}
