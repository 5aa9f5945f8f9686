//! Parsers of the command, for fuzz targets and their deterministic twins in the tests: whatever they are given, they
//! return. Also the list of all paths on the command line. Not part of the interface.

use asperity_calibration::{RigRow, RigTable};
use asperity_rexs::{Flanks, Model, RexsError, case_text, stages};
use clap::{Command, CommandFactory, Parser, ValueHint};

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

/// Every argument that is a path or, as its name of a value shows, holds one: the names of its command and of itself.
pub fn paths() -> Vec<(String, String)> {
    fn collect(command: &Command, name: &str, found: &mut Vec<(String, String)>) {
        let paths = command.get_arguments().filter(|argument| {
            let names = argument.get_value_names().unwrap_or_default();
            argument.get_value_hint() == ValueHint::AnyPath
                || names.iter().any(|name| name.contains(".csv"))
        });
        found.extend(paths.map(|argument| (name.to_owned(), argument.get_id().to_string())));
        for inner in command.get_subcommands() {
            collect(inner, format!("{name} {}", inner.get_name()).trim(), found);
        }
    }
    let mut found = Vec::new();
    collect(&Cli::command(), "", &mut found);
    found
}

/// Reads a gearbox file: lists its stages, and writes a case for each; every case is text or refused.
///
/// # Panics
/// When a refusal says nothing, or a case is empty.
pub fn rexs(bytes: &[u8]) -> bool {
    let told = |error: &RexsError| assert!(!error.to_string().is_empty());
    let model = match Model::read(bytes) {
        Ok(model) => model,
        Err(error) => {
            told(&error);
            return false;
        }
    };
    let found = match stages(&model) {
        Ok(found) => found,
        Err(error) => {
            told(&error);
            return false;
        }
    };
    let mut is_written = false;
    for number in 1..=found.len() {
        match case_text(&model, "box.rexs", number, 1, &Flanks::default()) {
            Ok(case) => {
                assert!(!case.toml.is_empty());
                is_written = true;
            }
            Err(error) => told(&error),
        }
    }
    is_written
}

/// Reads the table of a rig; every number of one that is read is finite, and every loss has its weight.
///
/// # Panics
/// When a number is not, or a refusal says nothing.
pub fn rig_table(text: &str) -> bool {
    match RigTable::read("rig.csv", text) {
        Ok(table) => {
            let holds = |row: &RigRow| {
                row.loss_w.ln().is_finite() && row.relative_sigma() > 0.0 && row.omega() > 0.0
            };
            assert!(table.rows.iter().all(holds));
            true
        }
        Err(error) => {
            assert!(!error.to_string().is_empty() && error.code() == "E134");
            false
        }
    }
}
