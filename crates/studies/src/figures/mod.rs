//! The figures of the 2022 paper, each with its table: Fig. 6 to 13 but for its drawings of gears.
//!
//! docs/FIGURES.md sets them beside what the paper says.

mod figure;
mod lubricant_matrix;
mod random_contact;
mod reference_case;
mod thick_films;

use std::path::{Path, PathBuf};

use asperity::case::LoadedCase;
use asperity_report::chart::Dress;
use asperity_report::{make_folder, write_text};

pub use figure::FigureError;

/// Makes the figures in `folder`; those of the reference case from `table_2`, which is to be in the
/// paper's formulation. Gives the files written, drawings and tables.
///
/// # Errors
/// When a case has no solution or a file cannot be written.
pub fn write(table_2: &LoadedCase, folder: &Path) -> Result<Vec<PathBuf>, FigureError> {
    make_folder(folder)?;
    let mut figures = random_contact::figures(folder)?;
    figures.extend(lubricant_matrix::figures(table_2, folder)?);
    figures.extend(thick_films::figures(table_2, folder)?);
    figures.extend(reference_case::figures(table_2, folder)?);
    let mut files = Vec::new();
    for figure in &figures {
        let file = folder.join(format!("{}.svg", figure.name));
        write_text(&file, &figure.drawing.svg(Dress::Alone))?;
        files.push(file);
        files.push(folder.join(figure.drawing.source()));
    }
    files.sort();
    files.dedup();
    Ok(files)
}
