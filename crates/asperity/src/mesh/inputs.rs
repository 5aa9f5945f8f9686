//! All that the mesh of a case follows from.

use asperity_core::quantity::Pressure;

use asperity_case::case::{Case, Formulation, LoadInputs};

/// All that a mesh follows from, except its speed.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MeshInputs {
    pub load: LoadInputs,
    pub modulus: Pressure,
    pub formulation: Formulation,
    pub face_zones: Vec<f64>,
    /// Cells of the path.
    pub cells: usize,
    /// Place of the paper's single position, as a share of the path.
    pub single: f64,
}

impl MeshInputs {
    pub(crate) fn of(case: &Case) -> Self {
        Self {
            load: case.load_inputs(),
            modulus: case.modulus,
            formulation: case.formulation,
            face_zones: case.face_zones.clone(),
            cells: case.model.positions,
            single: case.model.position,
        }
    }
}
