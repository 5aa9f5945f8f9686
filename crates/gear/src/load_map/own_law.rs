//! Load map of a user-defined law for the load along the path of contact.

use std::sync::Arc;

use asperity_core::DomainError;
use asperity_core::quantity::{Length, LineLoad};

use super::conditions::LoadConditions;
use super::line_load_table::LineLoadTable;
use super::map::{LoadMap, LoadMapEvidence, LoadModel, LoadSample};
use crate::error::GearError;
use crate::positions::PositionRule;

/// Number of positions at which the law is evaluated.
const POSITIONS: usize = 256;

impl LoadMap {
    /// Load map of a law for the load per length of contact line at a position of the path of contact, constant over
    /// the face width.
    ///
    /// # Errors
    /// When the law fails, a load is not finite or negative, or the torque is zero.
    pub fn of_line_load(
        mesh: &LoadConditions<'_>,
        line_load: impl Fn(Length) -> Result<LineLoad, GearError>,
    ) -> Result<Self, GearError> {
        Self::of_line_loads(mesh, |places| {
            places.iter().map(|s| line_load(*s)).collect()
        })
    }

    /// Load map of a law for the loads per length of contact line at all positions of the path of contact at once,
    /// constant over the face width.
    ///
    /// # Errors
    /// When the law fails or does not return one load for each position, a load is not finite or negative, or the torque
    /// is zero.
    pub fn of_line_loads(
        mesh: &LoadConditions<'_>,
        line_loads: impl FnOnce(&[Length]) -> Result<Vec<LineLoad>, GearError>,
    ) -> Result<Self, GearError> {
        let torque = DomainError::finite("torque", mesh.torque)?.abs();
        DomainError::require(torque > 0.0, "torque", torque, "N m", "must not be zero")?;
        let pair = mesh.pair;
        let positions = pair.positions(POSITIONS, PositionRule::GaussLegendre)?;
        let mut table = Vec::with_capacity(positions.len());
        let mut samples = Vec::with_capacity(positions.len());
        let places: Vec<Length> = positions.iter().map(|position| position.s).collect();
        let loads = line_loads(&places)?;
        let is_whole = loads.len() == places.len();
        DomainError::require(
            is_whole,
            "line loads",
            loads.len() as f64,
            "-",
            "must be one for each position",
        )?;
        for (position, load) in positions.iter().zip(loads) {
            DomainError::non_negative("line load", load)?;
            table.push((position.xi, load.si()));
            samples.push(LoadSample {
                phase: position.xi.fract(),
                xi: position.xi,
                y: pair.face_width / 2.0,
                load,
                weight: position.weight,
            });
        }
        let mut map = Self {
            pair: pair.clone(),
            torque,
            force: pair.forces(mesh.torque)?.normal_base.si().abs(),
            law: None,
            micro: mesh.micro.clone(),
            materials: *mesh.materials,
            settings: *mesh.settings,
            model: LoadModel::Table(LineLoadTable(table)),
            marks: vec![pair.path.eps_2],
            samples,
            loss_factor: 0.0,
            evidence: LoadMapEvidence::of_a_rigid_law(),
            edge_contact: Arc::default(),
        };
        map.loss_factor = map.sliding_integral(|_| 1.0);
        Ok(map)
    }
}
