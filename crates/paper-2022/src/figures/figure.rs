//! Figures.

use asperity_core::{Code, Fault};
use asperity_report::chart::{Chart, Drawing};

/// The reference case has no rough contact to draw.
pub(crate) fn no_contact(table: &'static str) -> Fault {
    Fault::new(
        Code::E401,
        format!(
            "the case has no rough contact for {table}; give it two measured flanks in mixed lubrication"
        ),
    )
}

/// Figure: file name without extension, and drawing, which names its table.
pub(super) struct PaperFigure {
    pub name: &'static str,
    pub drawing: Drawing,
}

impl PaperFigure {
    pub(super) fn curves(name: &'static str, chart: Chart) -> Self {
        let drawing = Drawing::Curves(chart);
        Self { name, drawing }
    }
}
