//! Parsers of the command for fuzz targets and the corresponding deterministic tests: they must return for any input.
//! Also the list of all paths on the command line. Not part of the interface.

use asperity_calibration::{RigRow, RigTable};
use asperity_core::{Code, Fault};
use asperity_rexs::{Flanks, Model, case_text, stages};
use clap::{Command, CommandFactory, Parser, ValueHint};

use crate::args::Cli;

/// Reads a command line with one argument per line: finishes to compare, keys to set, quantities, positions.
pub fn arguments(text: &str) -> bool {
    asperity_paper_2022::register();
    let arguments = std::iter::once("asperity").chain(text.lines());
    Cli::try_parse_from(arguments).is_ok()
}

/// Command and name of all arguments that are paths or, by their value name, include one.
pub fn paths() -> Vec<(String, String)> {
    fn collect(command: &Command, name: &str, paths_of: &mut Vec<(String, String)>) {
        let paths = command.get_arguments().filter(|argument| {
            let names = argument.get_value_names().unwrap_or_default();
            argument.get_value_hint() == ValueHint::AnyPath
                || names.iter().any(|name| name.contains(".csv"))
        });
        paths_of.extend(paths.map(|argument| (name.to_owned(), argument.get_id().to_string())));
        for inner in command.get_subcommands() {
            collect(
                inner,
                format!("{name} {}", inner.get_name()).trim(),
                paths_of,
            );
        }
    }
    let mut paths = Vec::new();
    collect(&Cli::command(), "", &mut paths);
    paths
}

/// Reads a gearbox file, lists its stages, and writes a case for each; a stage without a case must have an error.
///
/// # Panics
/// When an error has no message, or a case is empty.
pub fn rexs(bytes: &[u8]) -> bool {
    let check_message = |error: &Fault| assert!(!error.to_string().is_empty());
    let model = match Model::read(bytes) {
        Ok(model) => model,
        Err(error) => {
            check_message(&error);
            return false;
        }
    };
    let stages = match stages(&model) {
        Ok(stages) => stages,
        Err(error) => {
            check_message(&error);
            return false;
        }
    };
    let mut is_written = false;
    for number in 1..=stages.len() {
        match case_text(&model, "box.rexs", number, 1, &Flanks::default()) {
            Ok(case) => {
                assert!(!case.toml.is_empty());
                is_written = true;
            }
            Err(error) => check_message(&error),
        }
    }
    is_written
}

/// Reads a rig table and checks that its numbers are finite and every loss has its weight.
///
/// # Panics
/// When a number is not finite, or an error has no message.
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
            assert!(!error.to_string().is_empty() && error.code() == Code::E134);
            false
        }
    }
}
