//! Load map of a user-defined law, which gives the load along the path of contact alone.

use asperity_core::DomainError;
use asperity_core::quantity::{Length, LineLoad};

use super::along::Along;
use super::conditions::LoadConditions;
use super::map::{LoadMap, LoadMapEvidence, LoadSample, Model};
use crate::error::GearError;
use crate::positions::PositionRule;

/// Places along the path at which the law is asked.
const PLACES: usize = 256;

impl LoadMap {
    /// Load map of a law that gives the load per length of contact line at a place of the path of
    /// contact; it is the same over the face.
    ///
    /// # Errors
    /// Those of the law, or when a load is not finite or negative, or the torque is zero.
    pub fn of_line_load(
        mesh: &LoadConditions<'_>,
        line_load: impl Fn(Length) -> Result<LineLoad, GearError>,
    ) -> Result<Self, GearError> {
        let torque = DomainError::finite("torque", mesh.torque)?.abs();
        DomainError::require(torque > 0.0, "torque", torque, "N m", "must not be zero")?;
        let pair = mesh.pair;
        let places = pair.positions(PLACES, PositionRule::GaussLegendre)?;
        let mut table = Vec::with_capacity(places.len());
        let mut samples = Vec::with_capacity(places.len());
        for place in &places {
            let load = line_load(place.s)?;
            DomainError::non_negative("line load", load)?;
            table.push((place.xi, load.si()));
            samples.push(LoadSample {
                phase: place.xi.fract(),
                xi: place.xi,
                y: pair.face_width / 2.0,
                load,
                weight: place.weight,
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
            model: Model::Along(Along(table)),
            marks: vec![pair.path.eps_2],
            samples,
            loss_factor: 0.0,
            evidence: LoadMapEvidence::of_a_rigid_law(),
        };
        map.loss_factor = map.sliding_integral(|_| 1.0);
        Ok(map)
    }
}
