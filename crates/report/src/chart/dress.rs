//! Style of charts in a page and in files of their own.

/// Colours and lines of charts, for the page and for files; Okabe and Ito's palette.
pub const STYLE: &str = include_str!("chart.css");

/// Place in which a chart is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dress {
    /// In a page that gives title, legend and style.
    Page,
    /// A file of its own, with title, legend and style inside.
    Alone,
}
