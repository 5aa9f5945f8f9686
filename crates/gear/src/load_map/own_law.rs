//! Load map of a user-defined law for the load along the path of contact.

use asperity_core::DomainError;
use asperity_core::quantity::{Length, LineLoad};

use super::conditions::LoadConditions;
use super::line_load_table::LineLoadTable;
use super::map::{LoadMap, LoadMapEvidence, LoadSample, Model};
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
        let torque = DomainError::finite("torque", mesh.torque)?.abs();
        DomainError::require(torque > 0.0, "torque", torque, "N m", "must not be zero")?;
        let pair = mesh.pair;
        let positions = pair.positions(POSITIONS, PositionRule::GaussLegendre)?;
        let mut table = Vec::with_capacity(positions.len());
        let mut samples = Vec::with_capacity(positions.len());
        for position in &positions {
            let load = line_load(position.s)?;
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
            model: Model::Table(LineLoadTable(table)),
            marks: vec![pair.path.eps_2],
            samples,
            loss_factor: 0.0,
            evidence: LoadMapEvidence::of_a_rigid_law(),
        };
        map.loss_factor = map.sliding_integral(|_| 1.0);
        Ok(map)
    }
}
