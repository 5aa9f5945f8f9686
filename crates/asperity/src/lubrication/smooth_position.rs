//! A mesh position with the film between smooth flanks.

use crate::mesh::MeshPosition;
use asperity_case::formula_film::FormulaFilm;

/// A mesh position with its film between smooth flanks, from which lubrication and friction of the windows follow.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SmoothPosition<'a> {
    pub at: &'a MeshPosition,
    pub film: &'a FormulaFilm,
}
