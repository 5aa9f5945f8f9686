//! All that the mesh of a case follows from.

use asperity_core::quantity::Pressure;

use asperity_case::case::{Case, LoadInputs, Positions};

/// All that a mesh follows from, except its speed.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MeshInputs {
    pub load: LoadInputs,
    pub modulus: Pressure,
    pub face_zones: Vec<f64>,
    pub places: PathPlaces,
}

/// Places on the path of contact that represent the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum PathPlaces {
    /// This number of cells of the path.
    Cells(usize),
    /// A single place, as a share of the path.
    Single(f64),
}

impl MeshInputs {
    pub(crate) fn from_case(case: &Case) -> Self {
        Self {
            load: case.load_inputs(),
            modulus: case.modulus,
            face_zones: case.face_zones.clone(),
            places: match case.formulation.positions() {
                Positions::AlongPath => PathPlaces::Cells(case.model.positions),
                Positions::Single => PathPlaces::Single(case.paper.position),
            },
        }
    }
}
