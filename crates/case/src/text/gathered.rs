//! The files of a case from a resolver.

use std::io;
use std::path::Path;

use asperity_profile_io::read::conditions_of;

use crate::input::case_input::CaseInput;
use crate::input::files::{Content, Files, Named, named};
use crate::source::case_error::CaseError;
use crate::source::source_text::Source;

impl Files {
    /// Holds the files that `input` names, as `resolver` gives them.
    pub(crate) fn gather(
        &mut self,
        input: &CaseInput,
        source: &Source,
        resolver: &dyn Fn(&str) -> io::Result<Vec<u8>>,
    ) -> Result<(), CaseError> {
        self.gather_named(&named(input), source, resolver)
    }

    /// Holds the tables of the gearbox of a train, as `resolver` gives them.
    pub(crate) fn gather_tables<'a>(
        &mut self,
        tables: impl Iterator<Item = &'a Path>,
        source: &Source,
        resolver: &dyn Fn(&str) -> io::Result<Vec<u8>>,
    ) -> Result<(), CaseError> {
        let tables = tables.map(|name| Named::file("gearbox.tables", name));
        self.gather_named(&tables.collect::<Vec<_>>(), source, resolver)
    }

    fn gather_named(
        &mut self,
        named: &[Named],
        source: &Source,
        resolver: &dyn Fn(&str) -> io::Result<Vec<u8>>,
    ) -> Result<(), CaseError> {
        for Named {
            key,
            name,
            is_pattern,
        } in named
        {
            // Patterns are of files on disk.
            if self.held.contains_key(name) || *is_pattern {
                continue;
            }
            let file = name.display().to_string();
            let bytes = resolver(&file)
                .map_err(|reason| CaseError::open_named(file, source.place_of(key), key, reason))?;
            self.hold(name, Content::Bytes(bytes.into()));
            // An optional file that the case does not name.
            if let Some(conditions) = conditions_of(name)
                && let Ok(bytes) = resolver(&conditions.display().to_string())
            {
                self.hold(&conditions, Content::Bytes(bytes.into()));
            }
        }
        Ok(())
    }
}
