//! The figures of the 2022 paper, each with its table: Fig. 6 to 13 except the drawings of gears.
//!
//! docs/PAPER.md compares them with the paper.

mod figure;
mod lubricant_matrix;
mod parts;
mod random_contact;
mod reference_case;
mod thick_films;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use asperity::case::LoadedCase;
use asperity_core::Fault;
use asperity_report::chart::Dress;
use asperity_report::write_bytes;
use asperity_storage::{
    Draft, StorageError, check_among, check_folder, replace_folder, whole_file, write_among,
};

/// Largest size of the table of a figure in bytes.
const LARGEST: u64 = 100_000_000;

/// Kind of the folder in messages.
const KIND: &str = "figure";

/// Names of all files, which are checked before the computation.
pub const FILES: &[&str] = &[
    "fig06_subsurface.csv",
    "fig06_surface.csv",
    "fig06a_surfaces.svg",
    "fig06b_deformation.svg",
    "fig06c_contact_stress.svg",
    "fig06d_subsurface.svg",
    "fig07_lubricants.csv",
    "fig07a_lubricants.svg",
    "fig07b_efficiency.svg",
    "fig08a_pitch.csv",
    "fig08a_pitch.svg",
    "fig08b_sliding.csv",
    "fig08b_sliding.svg",
    "fig09_fig10_surface.csv",
    "fig09a_touch.svg",
    "fig09b_load.svg",
    "fig09c_change.svg",
    "fig10a_contact_stress.svg",
    "fig10b_contact_stress_near.svg",
    "fig10c_contact_stress_reflected.svg",
    "fig10c_surface.csv",
    "fig11_subsurface.csv",
    "fig11a_subsurface.svg",
    "fig11b_subsurface_near.svg",
    "fig12_losses.csv",
    "fig12a_in_contact.svg",
    "fig12b_after_contact.svg",
    "fig12c_every_engagement.svg",
    "fig13_convergence.csv",
    "fig13a_load.svg",
    "fig13b_convergence.svg",
];

/// Makes the figures in `folder`; the figures of the reference case from `table_2`, which must be in the paper's
/// formulation. Returns the files written, drawings and tables.
///
/// # Errors
/// When a case has no solution or a file cannot be written.
pub fn write(table_2: &LoadedCase, folder: &Path) -> Result<Vec<PathBuf>, Fault> {
    // A folder that holds only figures is replaced as a whole; in other folders the files are replaced one by one.
    let is_whole = match check_folder(folder, KIND) {
        Err(StorageError::NotOurs { entry: Some(_), .. }) => {
            check_among(folder, FILES)?;
            false
        }
        found => found.map(|()| true)?,
    };
    // Made in a temporary folder, so that no incomplete file appears in the target.
    let refused = StorageError::io(folder);
    let temporary = Draft::beside(folder).map_err(&refused)?;
    let made = &temporary.made();
    std::fs::create_dir(made).map_err(refused)?;
    let mut figures = random_contact::figures(made)?;
    figures.extend(lubricant_matrix::figures(table_2, made)?);
    figures.extend(thick_films::figures(table_2, made)?);
    figures.extend(reference_case::figures(table_2, made)?);
    let mut files = BTreeMap::new();
    for figure in &figures {
        let svg = figure.drawing.svg(Dress::Alone);
        files.insert(format!("{}.svg", figure.name), svg.into_bytes());
        let table = figure.drawing.source();
        let bytes = whole_file(&made.join(table), LARGEST);
        let bytes = bytes.map_err(StorageError::io(&folder.join(table)))?;
        files.insert(table.to_owned(), bytes);
    }
    let files: Vec<(String, Vec<u8>)> = files.into_iter().collect();
    let written = if is_whole {
        replace_folder(folder, KIND, |new| {
            files
                .iter()
                .try_for_each(|(name, bytes)| write_bytes(&new.join(name), bytes))
        })
    } else {
        write_among(folder, &files).map_err(Fault::from)
    };
    written?;
    Ok(files.iter().map(|(name, _)| folder.join(name)).collect())
}
