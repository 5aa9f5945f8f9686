//! Errors of a calibration or a design.

use std::fmt::Display;

use asperity::key_words::ended;
use asperity::profile_io::read::ReadError;
use asperity_core::{Code, Fault};
use asperity_core::{decimals, number};
use asperity_table::{Ragged, RowFault};

/// A row of the table has another number of cells than its header.
pub(crate) fn ragged(file: impl Display, source: Ragged) -> Fault {
    Fault::new(Code::E134, format!("{file}: {source}"))
}

/// The table cannot be opened, or is not text.
pub fn open(what: ReadError) -> Fault {
    let remedy = what.remedy().to_string();
    Fault::new(what.code(), ended(&what.to_string(), &remedy))
}

/// A column is missing, or has another unit.
pub(crate) fn column(file: impl Display, rule: impl Display) -> Fault {
    Fault::new(Code::E134, format!("{file}:1: {rule}"))
}

/// Rows are not valid.
pub(crate) fn rows(file: &str, faults: &[RowFault]) -> Fault {
    Fault::new(Code::E134, listed_faults(file, faults))
}

/// A row names no case, and none is given for the table.
pub fn no_case(file: impl Display) -> Fault {
    Fault::new(
        Code::E134,
        format!("{file}: names no case; give one for the table, or a column case"),
    )
}

/// Rows deviate from the fit by more than ten standard deviations.
pub(crate) fn outliers(file: &str, outliers: &[(usize, f64)], rows: usize) -> Fault {
    Fault::new(Code::E135, listed_outliers(file, outliers, rows))
}

/// The residuals are more than three times the stated errors.
pub(crate) fn unexplained(file: &str, ratio: f64, largest: &[(usize, f64)]) -> Fault {
    Fault::new(
        Code::E315,
        format!(
            "{file}: the model does not explain these points within 3 times your errors: the residuals are {ratio} times sigma_w; largest: {}",
            listed_residuals(file, largest),
            ratio = decimals(ratio, 1)
        ),
    )
}

/// Too few measurements to confirm their stated errors.
pub(crate) fn few_rows(file: impl Display, rows: usize, parameters: usize) -> Fault {
    Fault::new(
        Code::E316,
        format!(
            "{file}: {rows} rows for {parameters} parameters; {} or more are required to confirm the stated errors",
            parameters + crate::birge::Scatter::LEAST_FREEDOM
        ),
    )
}

/// The measurements do not identify the boundary layer, which determines the share of boundary friction.
pub(crate) fn share(file: impl Display, points: usize, missing: &[String]) -> Fault {
    Fault::new(
        Code::E310,
        format!(
            "{file}: these {points} points do not identify the boundary layer (its share of the load): {}",
            missing.join("; ")
        ),
    )
}

/// The loss depends on none of the parameters.
pub(crate) fn no_parameter(case: impl Display) -> Fault {
    Fault::new(
        Code::E205,
        format!(
            "{case}: no parameter to calibrate acts on the loss; the corrected formulation with film_friction = \"eyring\" and load_share = \"solved\" has four"
        ),
    )
}

/// A limit of the rig leaves no candidates.
pub(crate) fn limit(name: &'static str, value: f64, rule: &'static str) -> Fault {
    Fault::new(
        Code::E209,
        format!("{name} = {value}: {rule}", value = number(value)),
    )
}

/// A least squares fit did not converge.
pub(crate) fn not_converged(reason: impl Display) -> Fault {
    Fault::new(Code::E501, format!("the fit did not converge: {reason}"))
}

/// Rows listed in a message; the others are counted.
const NAMED: usize = 8;

fn listed_faults(file: &str, faults: &[RowFault]) -> String {
    let named = faults.iter().take(NAMED);
    let lines: Vec<String> = named.map(|fault| format!("{file}:{fault}")).collect();
    let more = faults.len().saturating_sub(NAMED);
    match more {
        0 => lines.join("; "),
        more => format!("{}; and {more} more", lines.join("; ")),
    }
}

fn listed_outliers(file: &str, outliers: &[(usize, f64)], rows: usize) -> String {
    let named = listed_residuals(file, &outliers[..outliers.len().min(NAMED)]);
    let more = match outliers.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    format!(
        "{} of {rows} rows deviate from the fit by more than ten sigma: {named}{more}",
        outliers.len(),
    )
}

fn listed_residuals(file: &str, residuals: &[(usize, f64)]) -> String {
    let lines: Vec<String> = residuals
        .iter()
        .map(|(line, residual)| format!("{file}:{line} by {residual:+.0} sigma"))
        .collect();
    lines.join(", ")
}
