//! Inputs of a law of load distribution.

use asperity_core::material::Material;
use asperity_core::quantity::Torque;

use super::law::LoadMapSettings;
use crate::pair::GearPair;
use crate::relief::MicroGeometry;

/// Inputs of a law of load distribution.
#[derive(Debug, Clone, Copy)]
pub struct LoadConditions<'a> {
    /// The pair.
    pub pair: &'a GearPair,
    /// Torque at gear 1, of either sign.
    pub torque: Torque,
    /// Modifications of the flanks.
    pub micro: &'a MicroGeometry,
    /// Materials of gears 1 and 2.
    pub materials: &'a [Material; 2],
    /// Settings of the load map.
    pub settings: &'a LoadMapSettings,
}
