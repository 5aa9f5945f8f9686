//! The figures of the 2022 paper, each with its table: Fig. 6 to 13 but for its drawings of gears.
//!
//! docs/FIGURES.md sets them beside what the paper says.

mod lubricant_matrix;
mod random_contact;
mod reference_case;
mod thick_films;

use std::path::{Path, PathBuf};

use super::ReportError;
use super::chart::{Drawing, Dress};
use super::folder::io_at;
use crate::case::LoadedCase;
use crate::error::{PositionError, RunError};

/// Why a figure was not made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// It could not be computed.
    #[error(transparent)]
    Run(#[from] RunError),
    /// It could not be written.
    #[error(transparent)]
    Report(#[from] ReportError),
}

impl From<PositionError> for FigureError {
    fn from(error: PositionError) -> Self {
        Self::Run(RunError::Whole(Box::new(error)))
    }
}

/// A figure: its file without ending, and what it shows. The table it was drawn from is named in it.
struct Figure {
    name: &'static str,
    drawing: Drawing,
}

/// Makes the figures in `folder`; those of the reference case from `table_2`, which is to be in the
/// paper's formulation. Gives the files written, drawings and tables.
///
/// # Errors
/// When a case has no solution or a file cannot be written.
pub fn write(table_2: &LoadedCase, folder: &Path) -> Result<Vec<PathBuf>, FigureError> {
    std::fs::create_dir_all(folder).map_err(io_at(folder))?;
    let mut figures = random_contact::figures(folder)?;
    figures.extend(lubricant_matrix::figures(table_2, folder)?);
    figures.extend(thick_films::figures(table_2, folder)?);
    figures.extend(reference_case::figures(table_2, folder)?);
    let mut files = Vec::new();
    for figure in &figures {
        let file = folder.join(format!("{}.svg", figure.name));
        std::fs::write(&file, figure.drawing.svg(Dress::Alone)).map_err(io_at(&file))?;
        files.push(file);
        files.push(folder.join(figure.drawing.source()));
    }
    files.sort();
    files.dedup();
    Ok(files)
}
