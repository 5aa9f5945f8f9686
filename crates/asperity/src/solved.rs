//! Solved positions summed up over the path of contact.

use asperity_efficiency::MeshEfficiency;
use asperity_gear::LoadMap;

use crate::case::LoadedCase;
use crate::error::PositionError;
use crate::losses::efficiency_at;
use crate::position::Position;
use crate::records::PathRecords;

/// Solved positions with the rolling force at each and the mesh at each offset.
pub(crate) struct Solved<'a> {
    pub loaded: &'a LoadedCase,
    /// Load over the flanks.
    pub map: &'a LoadMap,
    pub positions: Vec<Position>,
    /// Rolling friction force per metre of contact line on one surface at each position \[N/m\].
    pub rolling: Vec<f64>,
    /// Records of mixed lubrication along the path.
    pub records: Option<&'a PathRecords>,
    /// Mesh with all flanks at each offset.
    pub meshes: Vec<MeshEfficiency>,
}

impl<'a> Solved<'a> {
    /// Sums the losses of the positions up.
    pub(crate) fn new(
        loaded: &'a LoadedCase,
        map: &'a LoadMap,
        positions: Vec<Position>,
        rolling: Vec<f64>,
    ) -> Result<Self, PositionError> {
        let offsets = positions
            .first()
            .map_or(0, |position| position.offsets.len());
        let meshes = (0..offsets)
            .map(|k| {
                efficiency_at(&loaded.case, &positions, &rolling, k, |p, k| {
                    p.offsets[k].friction_force
                })
            })
            .collect::<Result<Vec<_>, _>>()?;
        Ok(Self {
            loaded,
            map,
            positions,
            rolling,
            records: None,
            meshes,
        })
    }
}

/// Mean of equally weighted values.
pub(crate) fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    sum / count
}
