//! Steel of the gears: the values of the case, completed with those of a case-hardened steel.

use asperity_core::DomainError;
use asperity_core::material::Material;
use asperity_core::quantity::{Density, Pressure, Quantity, SpecificHeat, ThermalConductivity};

use super::defaults::Defaults;
use super::domain::domain;
use super::error::CaseError;
use super::input::{BodyInput, CaseInput};
use super::source::Source;

/// Young's modulus and Poisson's ratio of steel, as in the reference case of the 2022 paper.
const STEEL_YOUNG: Pressure = Pressure::from_si(210e9);
const STEEL_POISSON: f64 = 0.3;
/// Elastic limit of a case-hardened gear steel: 0.2 % proof stress of the hardened case,
/// about 1500 MPa for 18CrNiMo7-6 at 60 HRC.
const STEEL_ELASTIC_LIMIT: Pressure = Pressure::from_si(1500e6);
/// Indentation hardness of case-hardened steel of 60 HRC, at which asperities flow.
const STEEL_FLOW_PRESSURE: Pressure = Pressure::from_si(7e9);
/// Density, conductivity and heat capacity of case-hardening steel at 60 °C.
const STEEL_DENSITY: Density = Density::from_si(7830.0);
const STEEL_CONDUCTIVITY: ThermalConductivity = ThermalConductivity::from_si(45.0);
const STEEL_HEAT_CAPACITY: SpecificHeat = SpecificHeat::from_si(465.0);

/// Material and flow pressure of pinion and wheel.
pub(super) fn materials(
    input: &CaseInput,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<([Material; 2], [Pressure; 2]), CaseError> {
    let pinion = body(&input.material.pinion, &PINION_KEYS, source, defaults)?;
    let wheel = match &input.material.wheel {
        None => pinion,
        Some(wheel) => body(wheel, &WHEEL_KEYS, source, defaults)?,
    };
    Ok(([pinion.0, wheel.0], [pinion.1, wheel.1]))
}

/// Keys of a body in the case file.
struct BodyKeys {
    young: &'static str,
    poisson: &'static str,
    elastic_limit: &'static str,
    flow_pressure: &'static str,
    density: &'static str,
    conductivity: &'static str,
    heat_capacity: &'static str,
}

const PINION_KEYS: BodyKeys = BodyKeys {
    young: "material.pinion.young",
    poisson: "material.pinion.poisson",
    elastic_limit: "material.pinion.elastic_limit",
    flow_pressure: "material.pinion.flow_pressure",
    density: "material.pinion.density",
    conductivity: "material.pinion.conductivity",
    heat_capacity: "material.pinion.heat_capacity",
};

const WHEEL_KEYS: BodyKeys = BodyKeys {
    young: "material.wheel.young",
    poisson: "material.wheel.poisson",
    elastic_limit: "material.wheel.elastic_limit",
    flow_pressure: "material.wheel.flow_pressure",
    density: "material.wheel.density",
    conductivity: "material.wheel.conductivity",
    heat_capacity: "material.wheel.heat_capacity",
};

fn body(
    given: &BodyInput,
    keys: &BodyKeys,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<(Material, Pressure), CaseError> {
    let elastic_limit = defaults.take(keys.elastic_limit, given.elastic_limit, STEEL_ELASTIC_LIMIT);
    let material = Material {
        young: defaults.take(keys.young, given.young, STEEL_YOUNG),
        poisson: defaults.take(keys.poisson, given.poisson, STEEL_POISSON),
        elastic_limit,
        density: defaults.take(keys.density, given.density, STEEL_DENSITY),
        conductivity: defaults.take(keys.conductivity, given.conductivity, STEEL_CONDUCTIVITY),
        heat_capacity: defaults.take(keys.heat_capacity, given.heat_capacity, STEEL_HEAT_CAPACITY),
    };
    let flow = defaults.take(keys.flow_pressure, given.flow_pressure, STEEL_FLOW_PRESSURE);
    positive("elastic limit", elastic_limit, source, keys.elastic_limit)?;
    positive("flow pressure", flow, source, keys.flow_pressure)?;
    positive("Young's modulus", material.young, source, keys.young)?;
    positive("density", material.density, source, keys.density)?;
    let (conductivity, heat) = (material.conductivity, material.heat_capacity);
    positive("conductivity", conductivity, source, keys.conductivity)?;
    positive("heat capacity", heat, source, keys.heat_capacity)?;
    // What is left for it to refuse is Poisson's ratio.
    material
        .compliance()
        .map_err(domain(source, keys.poisson))?;
    Ok((material, flow))
}

fn positive<Q: Quantity>(
    name: &'static str,
    quantity: Q,
    source: &Source,
    key: &'static str,
) -> Result<(), CaseError> {
    DomainError::positive(name, quantity)
        .map(|_| ())
        .map_err(domain(source, key))
}
