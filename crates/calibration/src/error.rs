//! Errors of a calibration, each with a code.

/// A row that cannot be used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{line}: {column}: {rule}")]
pub struct RowFault {
    /// Its line.
    pub line: usize,
    /// Its column.
    pub column: &'static str,
    /// Seen and expected.
    pub rule: String,
}

/// Why there is no calibration, or no design.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CalibrationError {
    /// The table cannot be read as a table.
    #[error("{file}: {source}")]
    Csv {
        /// Name of the table.
        file: String,
        /// Cause.
        source: csv::Error,
    },
    /// The table cannot be opened.
    #[error("{file}: cannot be opened: {reason}")]
    Open {
        /// Name of the table.
        file: String,
        /// Cause.
        reason: std::io::Error,
    },
    /// A column is missing, or has another unit.
    #[error("{file}:1: {rule}")]
    Column {
        /// Name of the table.
        file: String,
        /// Which column, and what is needed.
        rule: String,
    },
    /// Rows that cannot be used.
    #[error("{}", told(file, faults))]
    Rows {
        /// Name of the table.
        file: String,
        /// All of them.
        faults: Vec<RowFault>,
    },
    /// A row names no case and there is none beside the table.
    #[error("{file}: names no case; give one beside the table, or a column case")]
    NoCase {
        /// Name of the table.
        file: String,
    },
    /// Rows off the fit by more than ten times their standard deviation.
    #[error("{}", told_outliers(file, outliers, *rows))]
    Outliers {
        /// Name of the table.
        file: String,
        /// Line of each, and its residual in standard deviations.
        outliers: Vec<(usize, f64)>,
        /// Rows of the table.
        rows: usize,
    },
    /// The measurements cannot find the boundary layer, which decides the share of boundary friction.
    #[error("{file}: the boundary layer (its share of the load) cannot be found from these {points} points: {}", missing.join("; "))]
    Share {
        /// Name of the table, or of the case of a design.
        file: String,
        /// Distinct operating points.
        points: usize,
        /// What is missing, each with what there is.
        missing: Vec<String>,
    },
    /// The model has none of the parameters.
    #[error(
        "{case}: no parameter to calibrate acts on the loss; the corrected formulation with film_friction = \"eyring\" and load_share = \"solved\" has four"
    )]
    NoParameter {
        /// Name of the case.
        case: String,
    },
    /// Limits of a rig that leave nothing to choose from.
    #[error("{name} = {value}: {rule}")]
    Limit {
        /// The limit.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Rule.
        rule: &'static str,
    },
    /// The case or the model at a point.
    #[error("{place}: {source}")]
    Model {
        /// The row or point.
        place: String,
        /// Cause.
        source: Box<asperity::Error>,
    },
    /// A least squares fit did not end.
    #[error("the fit did not converge: {reason}")]
    NotConverged {
        /// What the method says.
        reason: String,
    },
}

impl CalibrationError {
    /// Stable code of the message.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Csv { .. } | Self::Column { .. } | Self::Rows { .. } | Self::NoCase { .. } => {
                "E134"
            }
            Self::Open { .. } => "E103",
            Self::Outliers { .. } => "E135",
            Self::Share { .. } => "E310",
            Self::NoParameter { .. } => "E205",
            Self::Limit { .. } => "E209",
            Self::Model { source, .. } => source.code(),
            Self::NotConverged { .. } => "E501",
        }
    }
}

/// Rows that a message names; the others are counted.
const NAMED: usize = 8;

fn told(file: &str, faults: &[RowFault]) -> String {
    let named = faults.iter().take(NAMED);
    let lines: Vec<String> = named.map(|fault| format!("{file}:{fault}")).collect();
    let more = faults.len().saturating_sub(NAMED);
    match more {
        0 => lines.join("; "),
        more => format!("{}; and {more} more", lines.join("; ")),
    }
}

fn told_outliers(file: &str, outliers: &[(usize, f64)], rows: usize) -> String {
    let named = outliers.iter().take(NAMED);
    let lines: Vec<String> = named
        .map(|(line, residual)| format!("{file}:{line} by {residual:+.0} sigma"))
        .collect();
    let more = match outliers.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    format!(
        "{} of {rows} rows are off the fit by more than ten sigma: {}{more}",
        outliers.len(),
        lines.join(", ")
    )
}
