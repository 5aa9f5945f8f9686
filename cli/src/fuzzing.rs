//! Parsers of the command, for fuzz targets and their deterministic twins in the tests: whatever they are given, they
//! return. No part of the interface.

use clap::Parser;

use crate::args::Cli;
use crate::commands::contact::column_file;

/// Reads a gap file; every number of one that is read is finite.
///
/// # Panics
/// When a number is not.
pub fn gap(bytes: &[u8]) -> bool {
    match column_file::of_bytes("gap.csv", bytes, column_file::GAP) {
        Ok(file) => {
            assert!(file.spacing.si() > 0.0 && file.values.iter().all(|h| h.is_finite()));
            true
        }
        Err(failure) => {
            assert!(!failure.to_string().is_empty());
            false
        }
    }
}

/// Reads a command line, one argument a line: finishes to compare, keys to set, quantities, positions.
pub fn arguments(text: &str) -> bool {
    let arguments = std::iter::once("asperity").chain(text.lines());
    Cli::try_parse_from(arguments).is_ok()
}
