//! Figures and their errors.

use asperity::{Error, PositionError};
use asperity_report::ReportError;
use asperity_report::chart::{Chart, Drawing};

/// Error of a figure.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// The figure cannot be computed.
    #[error(transparent)]
    Run(#[from] Error),
    /// The reference case has no rough contact to draw.
    #[error(
        "the case has no rough contact for {table}; give it two measured flanks in mixed lubrication"
    )]
    NoContact {
        /// The table of the figure.
        table: &'static str,
    },
    /// The figure cannot be written.
    #[error(transparent)]
    Report(#[from] ReportError),
}

impl From<PositionError> for FigureError {
    fn from(error: PositionError) -> Self {
        Self::Run(Error::Whole(Box::new(error)))
    }
}

/// Figure: file name without extension, and drawing, which names its table.
pub(super) struct Figure {
    pub name: &'static str,
    pub drawing: Drawing,
}

impl Figure {
    pub(super) fn curves(name: &'static str, chart: Chart) -> Self {
        let drawing = Drawing::Curves(chart);
        Self { name, drawing }
    }
}
