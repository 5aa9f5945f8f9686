//! All that the load over the teeth follows from.

use std::sync::Arc;

use asperity_core::material::Material;
use asperity_core::quantity::Torque;
use asperity_gear::{
    GearError, GearPair, LoadConditions, LoadDistribution, LoadLaw, LoadMap, LoadMapSettings,
    MicroGeometry,
};

/// Inputs of the load over the teeth: two equal ones have the same load.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadInputs {
    law: InputLaw,
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
enum InputLaw {
    Named(LoadLaw),
    Own(Arc<dyn LoadDistribution>),
}

impl PartialEq for InputLaw {
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
    /// The inputs of a user-defined law under `conditions`.
    pub(crate) fn by_own(law: &Arc<dyn LoadDistribution>, conditions: &LoadConditions<'_>) -> Self {
        Self::with_law(InputLaw::Own(Arc::clone(law)), conditions)
    }

    /// The inputs of a named law under `conditions`.
    pub(crate) fn by_law(law: &LoadLaw, conditions: &LoadConditions<'_>) -> Self {
        Self::with_law(InputLaw::Named(law.clone()), conditions)
    }

    fn with_law(law: InputLaw, conditions: &LoadConditions<'_>) -> Self {
        Self {
            law,
            gears: conditions.pair.clone(),
            micro_geometry: conditions.micro.clone(),
            materials: *conditions.materials,
            settings: *conditions.settings,
            torque: conditions.torque,
        }
    }

    /// The same at another torque.
    #[must_use]
    pub fn at(&self, torque: Torque) -> Self {
        Self {
            torque,
            ..self.clone()
        }
    }

    /// Modifications of the flanks.
    pub(crate) const fn micro_geometry(&self) -> &MicroGeometry {
        &self.micro_geometry
    }

    /// The same with other modifications of the flanks, and with edge contact of the tips of an external pair if `is_edged`.
    pub(crate) fn on(&self, micro_geometry: MicroGeometry, is_edged: bool) -> Self {
        let mut other = self.clone();
        other.micro_geometry = micro_geometry;
        // The edges of a ring are no part of the model.
        other.settings.edge_contact |= is_edged && !self.gears.internal;
        other
    }

    /// Whether the law lets the teeth deform.
    pub(crate) fn is_elastic(&self) -> bool {
        matches!(&self.law, InputLaw::Named(law) if law.is_elastic())
    }

    /// The load over the flanks.
    ///
    /// # Errors
    /// When the law does not hold for these gears, or puts no load on the teeth.
    pub fn load_map(&self) -> Result<LoadMap, GearError> {
        let map = self.by_its_law()?;
        if map.samples().iter().all(|sample| sample.load.si() == 0.0) {
            let law = self.law().name().to_owned();
            return Err(GearError::no_load(law));
        }
        Ok(map)
    }

    /// The load that the law gives, which may be none.
    pub(crate) fn by_its_law(&self) -> Result<LoadMap, GearError> {
        self.law().load_map(&LoadConditions {
            pair: &self.gears,
            torque: self.torque,
            micro: &self.micro_geometry,
            materials: &self.materials,
            settings: &self.settings,
        })
    }

    fn law(&self) -> &dyn LoadDistribution {
        match &self.law {
            InputLaw::Named(law) => law,
            InputLaw::Own(law) => law.as_ref(),
        }
    }
}
