//! Errors of a calibration, each with a code.

use asperity::key_words::ended;
use asperity::profile_io::read::ReadError;
use asperity_core::{Code, Fault};
use asperity_core::{decimals, number};
use asperity_table::{Ragged, RowFault};

/// Error of a calibration or a design.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CalibrationError {
    /// A row of the table has another number of cells than its header.
    #[error("{file}: {source}")]
    Ragged {
        /// Name of the table.
        file: String,
        /// Its line and numbers.
        source: Ragged,
    },
    /// The table cannot be opened, or is not text.
    #[error("{}", ended(&.0.to_string(), &.0.remedy().to_string()))]
    Open(ReadError),
    /// A column is missing, or has another unit.
    #[error("{file}:1: {rule}")]
    Column {
        /// Name of the table.
        file: String,
        /// The column and the rule that it violates.
        rule: String,
    },
    /// Rows are not valid.
    #[error("{}", listed_faults(file, faults))]
    Rows {
        /// Name of the table.
        file: String,
        /// The rows.
        faults: Vec<RowFault>,
    },
    /// A row names no case, and none is given for the table.
    #[error("{file}: names no case; give one for the table, or a column case")]
    NoCase {
        /// Name of the table.
        file: String,
    },
    /// Rows deviate from the fit by more than ten standard deviations.
    #[error("{}", listed_outliers(file, outliers, *rows))]
    Outliers {
        /// Name of the table.
        file: String,
        /// Line of each, and its residual in standard deviations.
        outliers: Vec<(usize, f64)>,
        /// Rows of the table.
        rows: usize,
    },
    /// The residuals are more than three times the stated errors.
    #[error(
        "{file}: the model does not explain these points within 3 times your errors: the residuals are {ratio} times sigma_w; largest: {}",
        listed_residuals(file, largest), ratio = decimals(*ratio, 1))]
    Unexplained {
        /// Name of the table.
        file: String,
        /// Birge ratio.
        ratio: f64,
        /// Lines with the largest residuals, in standard deviations.
        largest: Vec<(usize, f64)>,
    },
    /// Too few measurements to confirm their stated errors.
    #[error(
        "{file}: {rows} rows for {parameters} parameters; {} or more are required to confirm the stated errors",
        parameters + crate::birge::Scatter::LEAST_FREEDOM
    )]
    FewRows {
        /// Name of the table.
        file: String,
        /// Its rows.
        rows: usize,
        /// Fitted parameters.
        parameters: usize,
    },
    /// The measurements do not identify the boundary layer, which determines the share of boundary friction.
    #[error("{file}: these {points} points do not identify the boundary layer (its share of the load): {}", missing.join("; "))]
    Share {
        /// Name of the table, or of the case of a design.
        file: String,
        /// Distinct operating points.
        points: usize,
        /// The missing ranges, each with the available one.
        missing: Vec<String>,
    },
    /// The loss depends on none of the parameters.
    #[error(
        "{case}: no parameter to calibrate acts on the loss; the corrected formulation with film_friction = \"eyring\" and load_share = \"solved\" has four"
    )]
    NoParameter {
        /// Name of the case.
        case: String,
    },
    /// A limit of the rig leaves no candidates.
    #[error("{name} = {value}: {rule}", value = number(*value))]
    Limit {
        /// The limit.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Rule.
        rule: &'static str,
    },
    /// The case is not valid, or the model has no solution at a point.
    #[error("{place}: {source}")]
    Model {
        /// The row or point.
        place: String,
        /// Cause.
        source: Box<asperity::Error>,
    },
    /// A least squares fit did not converge.
    #[error("the fit did not converge: {reason}")]
    NotConverged {
        /// Termination reason of the method.
        reason: String,
    },
}

impl CalibrationError {
    /// Stable code of the message.
    #[must_use]
    pub fn code(&self) -> Code {
        match self {
            Self::Ragged { .. } | Self::Column { .. } | Self::Rows { .. } | Self::NoCase { .. } => {
                Code::E134
            }
            Self::Open(error) => error.code(),
            Self::Outliers { .. } => Code::E135,
            Self::Share { .. } => Code::E310,
            Self::Unexplained { .. } => Code::E315,
            Self::FewRows { .. } => Code::E316,
            Self::NoParameter { .. } => Code::E205,
            Self::Limit { .. } => Code::E209,
            Self::Model { source, .. } => source.code(),
            Self::NotConverged { .. } => Code::E501,
        }
    }
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

impl From<CalibrationError> for Fault {
    fn from(error: CalibrationError) -> Self {
        Self::of(error.code(), error)
    }
}
