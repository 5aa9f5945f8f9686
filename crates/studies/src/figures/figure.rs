//! A figure and the reason why one was not made.

use asperity::{Error, PositionError};
use asperity_report::ReportError;
use asperity_report::chart::Drawing;

/// Reason why a figure was not made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// It could not be computed.
    #[error(transparent)]
    Run(#[from] Error),
    /// The reference case has no rough contact to draw.
    #[error(
        "the case has no rough contact for {table}; give it two measured flanks in mixed lubrication"
    )]
    NoContact {
        /// The table that could not be made.
        table: &'static str,
    },
    /// It could not be written.
    #[error(transparent)]
    Report(#[from] ReportError),
}

impl From<PositionError> for FigureError {
    fn from(error: PositionError) -> Self {
        Self::Run(Error::Whole(Box::new(error)))
    }
}

/// A figure: its file without ending, and what it shows. The table it was drawn from is named in it.
pub(super) struct Figure {
    pub name: &'static str,
    pub drawing: Drawing,
}
