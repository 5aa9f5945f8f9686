//! Steels that come with the program.

use serde::{Deserialize, Serialize};

use super::error::PresetError;
use super::figure::{Figure, FigureRow, check};
use super::sources::{PresetSource, sources};
use crate::checked::Checked;
use crate::error::DomainError;
use crate::hardness::Hardness;
use crate::material::Material;
use crate::quantity::{Density, Pressure, Quantity, SpecificHeat, ThermalConductivity};

const FILE: &str = "steels.json";

/// Name of the steel whose constants follow from its density.
pub const POWDER_METAL: &str = "powder-metal";

/// A steel with the hardness of its flanks.
///
/// For [`POWDER_METAL`] the constants are those without pores.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SteelPreset {
    /// Name in a case file.
    pub name: String,
    /// Material number of EN 10027-2, where there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub number: Option<String>,
    /// Heat treatment of the flanks.
    pub treatment: String,
    /// Known and unknown properties.
    pub note: String,
    /// Young's modulus.
    pub young: Figure<Pressure>,
    /// Poisson's ratio.
    pub poisson: Figure<f64>,
    /// Density.
    pub density: Figure<Density>,
    /// Thermal conductivity.
    pub conductivity: Figure<ThermalConductivity>,
    /// Specific heat capacity.
    pub heat_capacity: Figure<SpecificHeat>,
    /// Hardness of the flanks, unless a case gives its own.
    pub hardness: Figure<Hardness>,
}

impl SteelPreset {
    /// Every number, as written in a case file.
    pub fn rows(&self) -> Vec<FigureRow<'_>> {
        fn quoted<Q: Quantity>(value: &Q) -> String {
            format!("\"{value}\"")
        }
        vec![
            self.young.row("young", quoted),
            self.poisson.row("poisson", f64::to_string),
            self.density.row("density", quoted),
            self.conductivity.row("conductivity", quoted),
            self.heat_capacity.row("heat_capacity", quoted),
            self.hardness.row("hardness", |h| format!("\"{h}\"")),
        ]
    }

    /// The constants of a body of this steel, with the elastic limit that follows from its hardness, as in a case.
    ///
    /// # Errors
    /// For [`POWDER_METAL`], whose constants follow from its density ([`crate::powder_metal`]).
    ///
    /// ```
    /// let steel = asperity_core::presets::steel("18CrNiMo7-6")?.material()?.value;
    /// assert!(steel.elastic_limit.si() > 1.8e9);
    /// assert!(asperity_core::presets::steel("powder-metal")?.material().is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn material(&self) -> Result<Checked<Material>, DomainError> {
        DomainError::require(
            !self.is_powder_metal(),
            "density",
            self.density.value.si(),
            "kg/m3",
            "is that without pores, and the constants of a sintered steel follow from its own density",
        )?;
        let limit = self.hardness.value.yield_strength()?;
        Ok(limit.map(|elastic_limit| Material {
            young: self.young.value,
            poisson: self.poisson.value,
            elastic_limit,
            density: self.density.value,
            conductivity: self.conductivity.value,
            heat_capacity: self.heat_capacity.value,
        }))
    }

    /// Whether its constants follow from the density that a case gives.
    pub fn is_powder_metal(&self) -> bool {
        self.name == POWDER_METAL
    }
}

/// The steels in `text`, whose numbers all have a source in `sources`.
///
/// # Errors
/// When the text does not describe steels, a number has no certainty, or its source is not in the list.
pub fn read_steels(text: &str, sources: &[PresetSource]) -> Result<Vec<SteelPreset>, PresetError> {
    let steels: Vec<SteelPreset> =
        serde_json::from_str(text).map_err(|error| PresetError::File {
            file: FILE,
            reason: error.to_string(),
        })?;
    for steel in &steels {
        check(&steel.name, &steel.rows(), sources)?;
    }
    Ok(steels)
}

/// All steels.
///
/// # Errors
/// When a data file cannot be read; a test reads them.
///
/// ```
/// let steels = asperity_core::presets::steels()?;
/// assert!(steels.iter().any(|steel| steel.name == "18CrNiMo7-6"));
/// # Ok::<(), asperity_core::presets::PresetError>(())
/// ```
pub fn steels() -> Result<Vec<SteelPreset>, PresetError> {
    let text = include_str!("../../data/presets/steels.json");
    read_steels(text, &sources()?)
}

/// The steel of this name or material number, whatever the case of its letters.
///
/// # Errors
/// When no steel has the name.
pub fn steel(name: &str) -> Result<SteelPreset, PresetError> {
    let mut steels = steels()?;
    let is_it = |steel: &SteelPreset| {
        let named = |text: &str| text.eq_ignore_ascii_case(name.trim());
        named(&steel.name) || steel.number.as_deref().is_some_and(named)
    };
    let index = steels.iter().position(is_it);
    index
        .map(|index| steels.swap_remove(index))
        .ok_or_else(|| PresetError::Unknown {
            kind: "steels",
            name: name.to_owned(),
            known: steels.into_iter().map(|steel| steel.name).collect(),
        })
}
