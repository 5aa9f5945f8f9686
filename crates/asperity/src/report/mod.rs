//! Results for people and for other programs: a folder of files, and a summary for the terminal.

pub mod chart;
mod folder;
mod summary;
mod tables;

pub use folder::{ReportError, write_folder};
pub use summary::summary;
