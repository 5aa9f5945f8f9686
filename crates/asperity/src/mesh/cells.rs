//! Places along the path of contact that represent the mesh.
//!
//! The path is cut into cells with one contact each. The friction coefficient of a cell times its share of
//! the loss factor is its sliding power, so that a constant coefficient gives μ H_V exactly. A formulation may take a
//! single place for the whole mesh.

use asperity_core::quantity::{AngularSpeed, Length, LineLoad};
use asperity_gear::{LoadCell, LoadMap};

use super::inputs::{MeshInputs, PathPlaces};
use asperity_case::error::PositionError;
use asperity_case::mesh_position::Resolution;

/// A place on the path of contact that represents a part of the mesh.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CellPlace {
    /// Coordinate along the line of action from T₁.
    pub s: Length,
    /// Load per length of contact line.
    pub load: LineLoad,
    /// Weight in the cycle mean: the loaded length of contact line.
    pub weight: Length,
    /// Mean of f |V_s| over that length, over the same at the place itself.
    pub sliding_factor: f64,
    /// Whether the rough contact must be resolved.
    pub resolution: Resolution,
    /// Cell of the path, from 0.
    pub cell: usize,
    /// Zone of the face that it represents.
    pub zone: usize,
}

impl CellPlace {
    /// A place that is shown and has no weight, under the mean load over the face.
    pub(super) fn shown(
        map: &LoadMap,
        s: Length,
        resolution: Resolution,
    ) -> Result<Self, PositionError> {
        Ok(Self {
            s,
            load: map.mean_line_load(s)?,
            weight: Length::from_si(0.0),
            sliding_factor: 1.0,
            resolution,
            cell: 0,
            zone: 0,
        })
    }
}

/// Share of the sliding power below which a cell stops no run.
const LIGHT_CELL: f64 = 0.01;
/// Share of the sliding power that the lightest cells may have together.
const LIGHT_CELLS: f64 = 0.02;

/// The places of a mesh at a speed of the pinion under the load of `map`.
pub(super) fn places(
    inputs: &MeshInputs,
    speed: AngularSpeed,
    map: &LoadMap,
) -> Result<Vec<CellPlace>, PositionError> {
    match inputs.places {
        PathPlaces::Cells(count) => along_path(inputs, count, speed, map),
        PathPlaces::Single(share) => single(inputs, share, map).map(|place| vec![place]),
    }
}

/// One place for each cell of the path.
fn along_path(
    inputs: &MeshInputs,
    count: usize,
    speed: AngularSpeed,
    map: &LoadMap,
) -> Result<Vec<CellPlace>, PositionError> {
    let gears = &inputs.load.gears;
    let width = gears.face_width;
    let edges: Vec<_> = inputs.face_zones.iter().map(|edge| width * *edge).collect();
    let cells = map.cells_in_zones(count, &edges)?;
    let light = lightly_loaded(&cells);
    let power = inputs.load.torque.si().abs() * speed.si();
    cells
        .iter()
        .zip(light)
        .map(|(cell, is_light)| {
            let sliding = gears.kinematics(cell.s, speed)?.sliding.si();
            let at_its_place = cell.contact_length.si() * cell.load.si() * sliding.abs();
            Ok(CellPlace {
                s: cell.s,
                load: cell.load,
                weight: cell.contact_length,
                sliding_factor: cell.loss_factor * power / at_its_place,
                resolution: if is_light {
                    Resolution::WhereFine
                } else {
                    Resolution::Required
                },
                cell: cell.number,
                zone: cell.zone,
            })
        })
        .collect()
}

/// A single place, whose weight is the mean loaded length of contact line.
fn single(inputs: &MeshInputs, share: f64, map: &LoadMap) -> Result<CellPlace, PositionError> {
    let gears = &inputs.load.gears;
    let path = gears.path();
    let s = path.a + (path.e - path.a) * share;
    let place = CellPlace::shown(map, s, Resolution::Required)?;
    Ok(CellPlace {
        weight: gears.single_position(s)?.weight,
        ..place
    })
}

/// Cells that contribute so little of the loss that their contact may go unresolved.
///
/// Zones of the face divide a cell of the path, and with it what is little.
fn lightly_loaded(cells: &[LoadCell]) -> Vec<bool> {
    let zones = cells.iter().map(|cell| cell.zone + 1).max().unwrap_or(1);
    let mut order: Vec<usize> = (0..cells.len()).collect();
    order.sort_by(|&i, &j| cells[i].sliding_share.total_cmp(&cells[j].sliding_share));
    let mut light = vec![false; cells.len()];
    let mut together = 0.0;
    for index in order {
        let share = cells[index].sliding_share;
        together += share;
        light[index] = share * (zones as f64) < LIGHT_CELL || together <= LIGHT_CELLS;
    }
    light
}
