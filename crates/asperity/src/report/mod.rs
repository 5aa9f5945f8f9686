//! Results for people and for other programs: a folder of files, and a summary for the terminal.

pub mod chart;
pub mod compare;
mod draft;
pub mod figures;
mod flanks;
mod folder;
pub mod html;
mod losses;
mod summary;
mod tables;
mod wrap;

pub use draft::{draft_folder, save};
pub use folder::{ReportError, check_place, write_folder, write_unsolved};
pub use summary::summary;
pub use wrap::{COLUMNS, wrapped};

/// Metres to micrometres.
const MICRO: f64 = 1e6;
