//! All that the load over the teeth follows from.

use std::sync::Arc;

use asperity_core::material::Material;
use asperity_core::quantity::Torque;
use asperity_gear::{
    GearError, GearPair, LoadConditions, LoadDistribution, LoadLaw, LoadMap, LoadMapSettings,
    MicroGeometry,
};

use super::resolve::Case;

/// Inputs of the load over the teeth: two equal ones have the same load.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadInputs {
    law: Law,
    /// The gears.
    pub gears: GearPair,
    micro_geometry: MicroGeometry,
    materials: [Material; 2],
    settings: LoadMapSettings,
    /// Torque of the pinion.
    pub torque: Torque,
}

/// Law of the load over the teeth.
#[derive(Debug, Clone)]
enum Law {
    Named(LoadLaw),
    Own(Arc<dyn LoadDistribution>),
}

impl PartialEq for Law {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Named(one), Self::Named(other)) => one == other,
            // A user-defined law equals only itself.
            (Self::Own(one), Self::Own(other)) => Arc::ptr_eq(one, other),
            _ => false,
        }
    }
}

impl LoadInputs {
    /// The inputs that a case states.
    #[must_use]
    pub fn of(case: &Case) -> Self {
        Self {
            law: match &case.laws.load_distribution {
                Some(own) => Law::Own(Arc::clone(own)),
                None => Law::Named(case.model.load_distribution.clone()),
            },
            gears: case.gears.clone(),
            micro_geometry: case.micro_geometry.clone(),
            materials: case.materials,
            settings: case.load_settings,
            torque: case.torque,
        }
    }

    /// The load over the flanks.
    ///
    /// # Errors
    /// When the law does not hold for these gears, or puts no load on the teeth.
    pub fn load_map(&self) -> Result<LoadMap, GearError> {
        let law: &dyn LoadDistribution = match &self.law {
            Law::Named(law) => law,
            Law::Own(law) => law.as_ref(),
        };
        let map = law.load_map(&LoadConditions {
            pair: &self.gears,
            torque: self.torque,
            micro: &self.micro_geometry,
            materials: &self.materials,
            settings: &self.settings,
        })?;
        if map.samples().iter().all(|sample| sample.load.si() == 0.0) {
            let law = law.name().to_owned();
            return Err(GearError::no_load(law));
        }
        Ok(map)
    }
}
