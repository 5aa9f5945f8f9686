//! Steel of the gears: the values of the case, completed from the steel that it names, or from a case-hardened steel.

use asperity_core::material::Material;
use asperity_core::powder_metal;
use asperity_core::presets::{self, Figure, PresetError, SteelPreset};
use asperity_core::quantity::{Density, Pressure, Quantity, SpecificHeat, ThermalConductivity};
use asperity_core::{Checked, DomainError, OutOfRange, nearest_name};

use crate::input::case_input::{BodyInput, CaseInput, MaterialInput};
use crate::source::case_error::CaseError;
use crate::source::defaults::Defaults;
use crate::source::section::Section;
use crate::source::source_text::Source;

/// Young's modulus and Poisson's ratio of steel, as in the reference case of the 2022 paper.
const STEEL_YOUNG: Pressure = Pressure::from_si(210e9);
const STEEL_POISSON: f64 = 0.3;
/// Elastic limit of a case-hardened gear steel: 0.2 % proof stress of the hardened case,
/// about 1500 MPa for 18CrNiMo7-6 at 60 HRC.
const STEEL_ELASTIC_LIMIT: Pressure = Pressure::from_si(1500e6);
/// Indentation hardness of case-hardened steel of 60 HRC, at which asperities flow.
pub const STEEL_FLOW_PRESSURE: Pressure = Pressure::from_si(7e9);
/// Density, conductivity and heat capacity of case-hardening steel at 60 °C.
const STEEL_DENSITY: Density = Density::from_si(7830.0);
const STEEL_CONDUCTIVITY: ThermalConductivity = ThermalConductivity::from_si(45.0);
const STEEL_HEAT_CAPACITY: SpecificHeat = SpecificHeat::from_si(465.0);

/// Both steels of a case.
pub(crate) struct Steels {
    /// Material of pinion and wheel.
    pub materials: [Material; 2],
    /// Pressure at which their surfaces flow.
    pub flow_pressure: [Pressure; 2],
    /// Quantities outside of the range of a relation.
    pub notes: Vec<OutOfRange>,
}

/// The steels of pinion and wheel.
pub(crate) fn steels(
    input: &CaseInput,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<Steels, CaseError> {
    let mut notes = Vec::new();
    // The other bodies are those of named meshes.
    let MaterialInput { pinion, wheel, .. } = &input.material;
    let of_pinion = Section::new(source, "material.pinion");
    let pinion = body(pinion, of_pinion, defaults, &mut notes)?;
    let wheel = match wheel {
        None => pinion,
        Some(wheel) => {
            let of_wheel = Section::new(source, "material.wheel");
            body(wheel, of_wheel, defaults, &mut notes)?
        }
    };
    Ok(Steels {
        materials: [pinion.0, wheel.0],
        flow_pressure: [pinion.1, wheel.1],
        notes,
    })
}

/// Default of a property, with its source if it has one.
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

/// Defaults of the properties of a body.
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
    /// Case-hardened steel of an unspecified grade.
    fn of_unspecified_grade() -> Self {
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

    /// A steel of the library, with the strength of an unspecified grade.
    fn from_preset(steel: &SteelPreset) -> Self {
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
            ..Self::of_unspecified_grade()
        }
    }
}

/// Whether `name` begins with the symbol of a plastic of gears (ISO 1043-1), followed by no other letter.
fn is_plastic(name: &str) -> bool {
    const SYMBOLS: [&str; 9] = [
        "PA", "POM", "PEEK", "PPS", "PBT", "PET", "PAI", "PC", "NYLON",
    ];
    let letters = name.chars().take_while(char::is_ascii_alphabetic);
    SYMBOLS.contains(&&*letters.collect::<String>().to_uppercase())
}

/// The steel that a body names.
fn named(stated: &BodyInput, section: Section<'_>) -> Result<Option<SteelPreset>, CaseError> {
    let Some(name) = &stated.steel else {
        return Ok(None);
    };
    if is_plastic(name) {
        let message = format!(
            "\"{name}\" is a plastic: the bending, creep and heat of plastic teeth are not modelled"
        );
        return Err(section.value("steel", message));
    }
    let refused = |error| match error {
        PresetError::Unknown { name, known, .. } => CaseError::unknown_steel(
            section.place("steel"),
            section.key("steel"),
            &name,
            nearest_name(&name, &known),
            &known,
        ),
        source => CaseError::steels(source),
    };
    presets::steel(name).map(Some).map_err(refused)
}

/// Sets the properties that follow from the hardness.
fn harden(
    standards: &mut Standards,
    stated: &BodyInput,
    steel: Option<&SteelPreset>,
    notes: &mut Vec<OutOfRange>,
) -> Result<(), DomainError> {
    let (hardness, of) = match (stated.hardness, steel) {
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
    if stated.elastic_limit.is_none() && !steel.is_some_and(SteelPreset::is_powder_metal) {
        let limit = six_digits(noted(hardness.yield_strength()?, notes));
        standards.elastic_limit = Standard::from(
            limit,
            format!("pavlina_2008, from the hardness {hardness}{of}"),
        );
    }
    Ok(())
}

/// Sets the properties that follow from the density of a sintered steel.
fn sinter(
    standards: &mut Standards,
    stated: &BodyInput,
    density: Density,
    notes: &mut Vec<OutOfRange>,
) -> Result<(), DomainError> {
    let at = |relation: &str| format!("{relation}, from the density {density}");
    let poisson = (1e6 * powder_metal::poisson(density)?).round() / 1e6;
    standards.poisson = Standard::from(poisson, at("hirose_2009"));
    let conductivity = powder_metal::conductivity(standards.conductivity.value, density)?;
    let conductivity = six_digits(conductivity);
    standards.conductivity = Standard::from(conductivity, at("maxwell_1873"));
    if stated.young.is_none() {
        let young = six_digits(noted(powder_metal::young(density)?, notes));
        standards.young = Standard::from(young, at("mpif_35_1997"));
    }
    if stated.elastic_limit.is_none() {
        let strength = six_digits(noted(powder_metal::strength(density)?, notes));
        standards.elastic_limit = Standard::from(strength, at("ace_powder_metal_mpif_35"));
    }
    Ok(())
}

/// A value that follows from a relation, rounded to the six digits that the result lists.
fn six_digits<Q: Quantity>(quantity: Q) -> Q {
    let text = format!("{:.5e}", quantity.si());
    Q::from_si(text.parse().unwrap_or(quantity.si()))
}

/// The value; its distinct notes are added to `notes`.
fn noted<T>(checked: Checked<T>, notes: &mut Vec<OutOfRange>) -> T {
    for note in checked.outside {
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    checked.value
}

/// Material and flow pressure of one body.
fn body(
    stated: &BodyInput,
    section: Section<'_>,
    defaults: &mut Defaults,
    notes: &mut Vec<OutOfRange>,
) -> Result<(Material, Pressure), CaseError> {
    let steel = named(stated, section)?;
    let mut standards = steel
        .as_ref()
        .map_or_else(Standards::of_unspecified_grade, Standards::from_preset);
    harden(&mut standards, stated, steel.as_ref(), notes).map_err(section.domain("hardness"))?;
    if steel.as_ref().is_some_and(SteelPreset::is_powder_metal) {
        let rule = "powder-metal needs density as well, from which its constants follow, e.g. density = \"7.1 g/cm3\"";
        let density = stated
            .density
            .ok_or_else(|| section.conflict("steel", rule))?;
        sinter(&mut standards, stated, density, notes).map_err(section.domain("density"))?;
    }
    // Every key of the body is used.
    let BodyInput {
        steel: _,
        hardness: _,
        young,
        poisson,
        elastic_limit,
        flow_pressure,
        density,
        conductivity,
        heat_capacity,
    } = stated;
    let mut body = Body { section, defaults };
    let elastic_limit = body.take("elastic_limit", *elastic_limit, standards.elastic_limit);
    let material = Material {
        young: body.take("young", *young, standards.young),
        poisson: body.take("poisson", *poisson, standards.poisson),
        elastic_limit,
        density: body.take("density", *density, standards.density),
        conductivity: body.take("conductivity", *conductivity, standards.conductivity),
        heat_capacity: body.take("heat_capacity", *heat_capacity, standards.heat_capacity),
    };
    let flow = body.take("flow_pressure", *flow_pressure, standards.flow_pressure);
    positive(section, "elastic_limit", "elastic limit", elastic_limit)?;
    positive(section, "flow_pressure", "flow pressure", flow)?;
    positive(section, "young", "Young's modulus", material.young)?;
    positive(section, "density", "density", material.density)?;
    positive(
        section,
        "conductivity",
        "conductivity",
        material.conductivity,
    )?;
    positive(
        section,
        "heat_capacity",
        "heat capacity",
        material.heat_capacity,
    )?;
    // The only number that it can still refuse is Poisson's ratio.
    material.compliance().map_err(section.domain("poisson"))?;
    Ok((material, flow))
}

/// A body whose properties are chosen.
struct Body<'a, 'b> {
    section: Section<'a>,
    defaults: &'b mut Defaults,
}

impl Body<'_, '_> {
    fn take<T: serde::Serialize>(
        &mut self,
        name: &str,
        stated: Option<T>,
        standard: Standard<T>,
    ) -> T {
        let key = self.section.key(name);
        self.defaults
            .take_from(key, stated, standard.value, standard.source)
    }
}

fn positive<Q: Quantity>(
    section: Section<'_>,
    key: &str,
    name: &'static str,
    quantity: Q,
) -> Result<(), CaseError> {
    let positive = DomainError::positive(name, quantity);
    positive.map(|_| ()).map_err(section.domain(key))
}
