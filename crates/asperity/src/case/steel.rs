//! Steel of the gears: the values of the case, completed with those of the steel that it names, else of a
//! case-hardened steel.

use asperity_core::material::Material;
use asperity_core::powder_metal;
use asperity_core::presets::{self, Figure, PresetError, SteelPreset};
use asperity_core::quantity::{Density, Pressure, Quantity, SpecificHeat, ThermalConductivity};
use asperity_core::{Checked, DomainError, OutOfRange};

use super::defaults::Defaults;
use super::domain::domain;
use super::error::CaseError;
use super::input::{BodyInput, CaseInput};
use super::known_keys::nearest_name;
use super::source::Source;

/// Young's modulus and Poisson's ratio of steel, as in the reference case of the 2022 paper.
const STEEL_YOUNG: Pressure = Pressure::from_si(210e9);
const STEEL_POISSON: f64 = 0.3;
/// Elastic limit of a case-hardened gear steel: 0.2 % proof stress of the hardened case,
/// about 1500 MPa for 18CrNiMo7-6 at 60 HRC.
const STEEL_ELASTIC_LIMIT: Pressure = Pressure::from_si(1500e6);
/// Indentation hardness of case-hardened steel of 60 HRC, at which asperities flow.
pub(crate) const STEEL_FLOW_PRESSURE: Pressure = Pressure::from_si(7e9);
/// Density, conductivity and heat capacity of case-hardening steel at 60 °C.
const STEEL_DENSITY: Density = Density::from_si(7830.0);
const STEEL_CONDUCTIVITY: ThermalConductivity = ThermalConductivity::from_si(45.0);
const STEEL_HEAT_CAPACITY: SpecificHeat = SpecificHeat::from_si(465.0);

/// Both steels of a case.
pub(super) struct Steels {
    /// Material of pinion and wheel.
    pub materials: [Material; 2],
    /// Pressure at which their surfaces flow.
    pub flow_pressure: [Pressure; 2],
    /// What left the range of a relation.
    pub notes: Vec<OutOfRange>,
}

/// The steels of pinion and wheel.
pub(super) fn steels(
    input: &CaseInput,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<Steels, CaseError> {
    let mut notes = Vec::new();
    let given = &input.material;
    let pinion = body(&given.pinion, &PINION_KEYS, source, defaults, &mut notes)?;
    let wheel = match &given.wheel {
        None => pinion,
        Some(wheel) => body(wheel, &WHEEL_KEYS, source, defaults, &mut notes)?,
    };
    Ok(Steels {
        materials: [pinion.0, wheel.0],
        flow_pressure: [pinion.1, wheel.1],
        notes,
    })
}

/// Keys of a body in the case file.
struct BodyKeys {
    steel: &'static str,
    hardness: &'static str,
    young: &'static str,
    poisson: &'static str,
    elastic_limit: &'static str,
    flow_pressure: &'static str,
    density: &'static str,
    conductivity: &'static str,
    heat_capacity: &'static str,
}

const PINION_KEYS: BodyKeys = BodyKeys {
    steel: "material.pinion.steel",
    hardness: "material.pinion.hardness",
    young: "material.pinion.young",
    poisson: "material.pinion.poisson",
    elastic_limit: "material.pinion.elastic_limit",
    flow_pressure: "material.pinion.flow_pressure",
    density: "material.pinion.density",
    conductivity: "material.pinion.conductivity",
    heat_capacity: "material.pinion.heat_capacity",
};

const WHEEL_KEYS: BodyKeys = BodyKeys {
    steel: "material.wheel.steel",
    hardness: "material.wheel.hardness",
    young: "material.wheel.young",
    poisson: "material.wheel.poisson",
    elastic_limit: "material.wheel.elastic_limit",
    flow_pressure: "material.wheel.flow_pressure",
    density: "material.wheel.density",
    conductivity: "material.wheel.conductivity",
    heat_capacity: "material.wheel.heat_capacity",
};

/// A value that stands in for one that is not given, and its source where it has one of its own.
struct Standard<T> {
    value: T,
    source: Option<String>,
}

impl<T> Standard<T> {
    fn plain(value: T) -> Self {
        Self {
            value,
            source: None,
        }
    }

    fn from(value: T, source: String) -> Self {
        Self {
            value,
            source: Some(source),
        }
    }
}

/// Everything that stands in for what a body does not give.
struct Standards {
    young: Standard<Pressure>,
    poisson: Standard<f64>,
    elastic_limit: Standard<Pressure>,
    flow_pressure: Standard<Pressure>,
    density: Standard<Density>,
    conductivity: Standard<ThermalConductivity>,
    heat_capacity: Standard<SpecificHeat>,
}

impl Standards {
    /// Case-hardened steel of no particular grade.
    fn of_no_grade() -> Self {
        Self {
            young: Standard::plain(STEEL_YOUNG),
            poisson: Standard::plain(STEEL_POISSON),
            elastic_limit: Standard::plain(STEEL_ELASTIC_LIMIT),
            flow_pressure: Standard::plain(STEEL_FLOW_PRESSURE),
            density: Standard::plain(STEEL_DENSITY),
            conductivity: Standard::plain(STEEL_CONDUCTIVITY),
            heat_capacity: Standard::plain(STEEL_HEAT_CAPACITY),
        }
    }

    /// A steel of the library, its strength still that of no grade.
    fn of(steel: &SteelPreset) -> Self {
        fn of<T: Copy>(steel: &SteelPreset, figure: &Figure<T>) -> Standard<T> {
            let (name, certainty, key) = (&steel.name, figure.certainty, &figure.source);
            Standard::from(figure.value, format!("{name}: {certainty}, {key}"))
        }
        Self {
            young: of(steel, &steel.young),
            poisson: of(steel, &steel.poisson),
            density: of(steel, &steel.density),
            conductivity: of(steel, &steel.conductivity),
            heat_capacity: of(steel, &steel.heat_capacity),
            ..Self::of_no_grade()
        }
    }
}

/// The steel that a body names.
fn named(
    given: &BodyInput,
    keys: &BodyKeys,
    source: &Source,
) -> Result<Option<SteelPreset>, CaseError> {
    let Some(name) = &given.steel else {
        return Ok(None);
    };
    let refused = |error| match error {
        PresetError::Unknown { name, known, .. } => CaseError::UnknownSteel {
            place: source.place_of(keys.steel),
            key: keys.steel,
            nearest: nearest_name(&name, &known),
            name,
            known,
        },
        source => CaseError::Steels { source },
    };
    presets::steel(name).map(Some).map_err(refused)
}

/// Sets what follows from the hardness.
fn harden(
    standards: &mut Standards,
    given: &BodyInput,
    steel: Option<&SteelPreset>,
    notes: &mut Vec<OutOfRange>,
) -> Result<(), DomainError> {
    let (hardness, of) = match (given.hardness, steel) {
        (Some(hardness), _) => (hardness, String::new()),
        (None, Some(steel)) => {
            let figure = &steel.hardness;
            let of = format!(
                " of {}, {}, {}",
                steel.name, figure.certainty, figure.source
            );
            (figure.value, of)
        }
        (None, None) => return Ok(()),
    };
    let flow = six_digits(hardness.flow_pressure()?);
    standards.flow_pressure = Standard::from(
        flow,
        format!("9.80665 MPa per HV of the hardness {hardness}{of}"),
    );
    if given.elastic_limit.is_none() && !steel.is_some_and(SteelPreset::is_powder_metal) {
        let limit = six_digits(noted(hardness.yield_strength()?, notes));
        standards.elastic_limit = Standard::from(
            limit,
            format!("pavlina_2008, from the hardness {hardness}{of}"),
        );
    }
    Ok(())
}

/// Sets what follows from the density of a sintered steel.
fn sinter(
    standards: &mut Standards,
    given: &BodyInput,
    density: Density,
    notes: &mut Vec<OutOfRange>,
) -> Result<(), DomainError> {
    let at = |relation: &str| format!("{relation}, from the density {density}");
    let poisson = (1e6 * powder_metal::poisson(density)?).round() / 1e6;
    standards.poisson = Standard::from(poisson, at("hirose_2009"));
    let conductivity = powder_metal::conductivity(standards.conductivity.value, density)?;
    let conductivity = six_digits(conductivity);
    standards.conductivity = Standard::from(conductivity, at("maxwell_1873"));
    if given.young.is_none() {
        let young = six_digits(noted(powder_metal::young(density)?, notes));
        standards.young = Standard::from(young, at("mpif_35_1997"));
    }
    if given.elastic_limit.is_none() {
        let strength = six_digits(noted(powder_metal::strength(density)?, notes));
        standards.elastic_limit = Standard::from(strength, at("ace_powder_metal_mpif_35"));
    }
    Ok(())
}

/// A value that follows from a relation, to six digits: as the result lists it, and as a case could give it.
fn six_digits<Q: Quantity>(quantity: Q) -> Q {
    let text = format!("{:.5e}", quantity.si());
    Q::from_si(text.parse().unwrap_or(quantity.si()))
}

/// The value, its notes kept once.
fn noted<T>(checked: Checked<T>, notes: &mut Vec<OutOfRange>) -> T {
    for note in checked.outside {
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    checked.value
}

fn body(
    given: &BodyInput,
    keys: &BodyKeys,
    source: &Source,
    defaults: &mut Defaults,
    notes: &mut Vec<OutOfRange>,
) -> Result<(Material, Pressure), CaseError> {
    let steel = named(given, keys, source)?;
    let mut standards = steel
        .as_ref()
        .map_or_else(Standards::of_no_grade, Standards::of);
    harden(&mut standards, given, steel.as_ref(), notes).map_err(domain(source, keys.hardness))?;
    if steel.as_ref().is_some_and(SteelPreset::is_powder_metal) {
        let density = given.density.ok_or_else(|| CaseError::Conflict {
            place: source.place_of(keys.steel),
            key: keys.steel,
            rule: "powder-metal needs density beside it, from which its constants follow, e.g. density = \"7.1 g/cm3\"",
        })?;
        sinter(&mut standards, given, density, notes).map_err(domain(source, keys.density))?;
    }
    let Standards {
        young,
        poisson,
        elastic_limit,
        flow_pressure,
        density,
        conductivity,
        heat_capacity,
    } = standards;
    let elastic_limit = take(
        defaults,
        keys.elastic_limit,
        given.elastic_limit,
        elastic_limit,
    );
    let material = Material {
        young: take(defaults, keys.young, given.young, young),
        poisson: take(defaults, keys.poisson, given.poisson, poisson),
        elastic_limit,
        density: take(defaults, keys.density, given.density, density),
        conductivity: take(
            defaults,
            keys.conductivity,
            given.conductivity,
            conductivity,
        ),
        heat_capacity: take(
            defaults,
            keys.heat_capacity,
            given.heat_capacity,
            heat_capacity,
        ),
    };
    let flow = take(
        defaults,
        keys.flow_pressure,
        given.flow_pressure,
        flow_pressure,
    );
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

fn take<T: serde::Serialize>(
    defaults: &mut Defaults,
    key: &'static str,
    given: Option<T>,
    standard: Standard<T>,
) -> T {
    defaults.take_from(key, given, standard.value, standard.source)
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
