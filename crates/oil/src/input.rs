//! The lubricant as a case file states it.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::BaseOil;
use asperity_core::quantity::{
    Density, DynamicViscosity, KinematicViscosity, PerKelvin, PressureViscosity, SpecificHeat,
    Temperature, ThermalConductivity,
};

/// Viscosity law and its values; the law may be left out where the two values of a data sheet, or grade and index, are given.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "law", rename_all = "kebab-case", deny_unknown_fields)]
pub enum ViscosityLaw {
    /// ASTM D341 through the two kinematic viscosities of a data sheet.
    AstmD341 {
        /// Kinematic viscosity at 40 °C.
        at_40: KinematicViscosity,
        /// Kinematic viscosity at 100 °C.
        at_100: KinematicViscosity,
    },
    /// ASTM D341 through the viscosities of an ISO VG grade and a viscosity index.
    IsoVg {
        /// Grade of ISO 3448: 100 or `"ISO VG 100"`.
        grade: f64,
        /// Viscosity index of ASTM D2270.
        viscosity_index: f64,
    },
    /// Vogel's law η = K·exp(b/(T − θ)).
    Vogel {
        /// Limit K of the viscosity at high temperature.
        limit_viscosity: DynamicViscosity,
        /// Constant b \[K\].
        slope_kelvin: f64,
        /// Pole θ \[K\].
        pole_kelvin: f64,
    },
    /// One dynamic viscosity; the lubricant then needs a `temperature_coefficient`.
    Given {
        /// Dynamic viscosity.
        dynamic_viscosity: DynamicViscosity,
        /// Temperature it holds at; default the temperature of the operation as the case states it.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        temperature: Option<Temperature>,
    },
}

/// The lubricant as the case file states it; every key is optional, some are needed together.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(default, deny_unknown_fields)]
pub struct LubricantInput {
    /// Name of an oil in the library; the other keys override its values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub oil: Option<String>,
    /// Oil file, relative to the case file: constants of the film friction fitted to traction curves (`asperity oil fit`
    /// writes it), and the properties of the oil; the other keys override them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub oil_file: Option<PathBuf>,
    /// Viscosity law and its values; the law may be left out where the two values of a data sheet, or grade and index, are given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub viscosity: Option<ViscosityLaw>,
    /// Temperature coefficient −(dη/dT)/η of a viscosity given at one temperature.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub temperature_coefficient: Option<PerKelvin>,
    /// Density at `density_temperature`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub density: Option<Density>,
    /// Temperature of the density; default 15 °C, or the temperature of the operation as the case states it if the viscosity is
    /// given at one temperature.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub density_temperature: Option<Temperature>,
    /// Thermal expansion relative to `density`; default that of the base oil.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thermal_expansion: Option<PerKelvin>,
    /// Family of the base oil, for film friction and for estimates of properties not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base_oil: Option<BaseOil>,
    /// Family assumed when the base oil is unknown; the result lists it as an assumption.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub assume_base_oil: Option<BaseOil>,
    /// Pressure-viscosity coefficient α; default estimated from the base oil.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pressure_viscosity: Option<PressureViscosity>,
    /// Pressure-viscosity coefficient of the film friction over the one of the film thickness; default 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pressure_viscosity_factor: Option<f64>,
    /// Fall of the logarithm of the limiting shear stress with temperature, from its value at 90 °C; default 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limiting_shear_temperature: Option<PerKelvin>,
    /// Thermal conductivity; default of the base oil in the film, otherwise from the density.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thermal_conductivity: Option<ThermalConductivity>,
    /// Specific heat capacity; default estimated from the density.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heat_capacity: Option<SpecificHeat>,
    /// Keys of another oil that this one, named over a case, replaces; not a key of the case.
    #[serde(skip)]
    pub replaced: Vec<String>,
}

impl LubricantInput {
    /// Keys that are stated.
    pub fn stated(&self) -> impl Iterator<Item = String> {
        let keys = match serde_json::to_value(self) {
            Ok(serde_json::Value::Object(keys)) => keys,
            _ => serde_json::Map::new(),
        };
        keys.into_iter().map(|(key, _)| key)
    }

    /// Keys that `other` states too, with another value.
    pub fn stated_otherwise(&self, other: &Self) -> impl Iterator<Item = String> {
        let table = |input: &Self| match serde_json::to_value(input) {
            Ok(serde_json::Value::Object(keys)) => keys,
            _ => serde_json::Map::new(),
        };
        let other = table(other);
        let differs = move |(key, value): &(String, serde_json::Value)| {
            other.get(key).is_some_and(|other| other != value)
        };
        table(self).into_iter().filter(differs).map(|(key, _)| key)
    }
}
