//! Comparison of the loss factors of all laws.

use asperity_core::material::Material;
use asperity_core::quantity::Torque;

use super::law::{LoadLaw, LoadMapSettings};
use super::map::LoadMap;
use crate::error::GearError;
use crate::pair::GearPair;
use crate::relief::MicroGeometry;

impl LoadMap {
    /// H_V of every law, or the reason why the law does not hold for the pair. Laws without deflections are evaluated
    /// on unmodified flanks.
    pub fn loss_factor_of_every_law(
        pair: &GearPair,
        torque: Torque,
        micro: &MicroGeometry,
        materials: &[Material; 2],
        settings: &LoadMapSettings,
    ) -> Vec<(LoadLaw, Result<f64, GearError>)> {
        let unmodified = MicroGeometry::default();
        LoadLaw::all()
            .into_iter()
            .map(|law| {
                let micro = if law.is_elastic() { micro } else { &unmodified };
                let map = Self::new(pair, torque, &law, micro, materials, settings);
                (law, map.map(|map| map.loss_factor()))
            })
            .collect()
    }
}
