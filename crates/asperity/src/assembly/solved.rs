//! Solved positions summed up over the path of contact.

use asperity_efficiency::MeshEfficiency;
use asperity_gear::LoadMap;

use super::cycle::efficiency_at;
use crate::lubrication::{LubricatedPosition, rolling};
use crate::records::PathRecords;
use asperity_case::case::OperatingCase;
use asperity_case::error::PositionError;

/// Solved positions with the rolling force at each and the mesh at each offset.
pub(crate) struct Solved<'a> {
    pub loaded: &'a OperatingCase,
    /// Load over the flanks.
    pub map: &'a LoadMap,
    pub positions: Vec<LubricatedPosition>,
    /// Rolling friction force per metre of contact line on one surface at each position \[N/m\].
    pub rolling: Vec<f64>,
    /// Reference solutions along the path.
    pub records: Option<&'a PathRecords>,
    /// Mesh with all flanks at each offset.
    pub meshes: Vec<MeshEfficiency>,
}

impl<'a> Solved<'a> {
    /// Sums the losses of the positions over the path.
    pub(crate) fn new(
        loaded: &'a OperatingCase,
        map: &'a LoadMap,
        positions: Vec<LubricatedPosition>,
        records: Option<&'a PathRecords>,
    ) -> Result<Self, PositionError> {
        let case = loaded;
        let rolling = positions
            .iter()
            .map(|position| rolling(case, &position.at, &position.film))
            .collect::<Result<Vec<_>, _>>()?;
        let offsets = positions
            .first()
            .map_or(0, |position| position.offsets.len());
        let force = |position: &LubricatedPosition, k: usize| position.offsets[k].friction_force;
        let meshes = (0..offsets)
            .map(|k| efficiency_at(case, &positions, &rolling, k, force))
            .collect::<Result<Vec<_>, _>>()?;
        Ok(Self {
            loaded,
            map,
            positions,
            rolling,
            records,
            meshes,
        })
    }
}
