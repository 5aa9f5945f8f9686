//! From the case as written to the case as computed: defaults filled in, numbers checked.

use asperity_core::lubricant::{Lubricant, LubricantState};
use asperity_core::material::{Material, reduced_modulus};
use asperity_core::quantity::{
    Angle, AngularSpeed, Density, Length, Pressure, Quantity, Ratio, SpecificHeat, Temperature,
    ThermalConductivity, Torque,
};
use asperity_core::{DomainError, OutOfRange};
use asperity_ehl_regime::{FilmLaw, LoadShareLaw, ThermalLaw};
use asperity_gear::{GearPair, GearPairInput, LoadSharing, Plane};
use asperity_ns_film::FluidModel;
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use asperity_roughness::preparation::Preparation;
use asperity_tribo_friction::{FrictionLaw, FrictionSettings, RoughnessReading};
use serde::Serialize;

use super::defaults::{DefaultUsed, Defaults};
use super::error::CaseError;
use super::input::{BodyInput, CaseInput, Formulation, ModelInput, NamedPoint, PathPoint};
use super::source::Source;

/// Young's modulus and Poisson's ratio of steel, as in the reference case of the 2022 paper.
const STEEL_YOUNG: Pressure = Pressure::from_si(210e9);
const STEEL_POISSON: f64 = 0.3;
/// Elastic limit of a case-hardened gear steel: 0.2 % proof stress of the hardened case,
/// about 1500 MPa for 18CrNiMo7-6 at 60 HRC.
const STEEL_ELASTIC_LIMIT: Pressure = Pressure::from_si(1500e6);
/// Indentation hardness over yield strength of a fully plastic contact (Tabor 1951).
const TABOR_RATIO: f64 = 3.0;
/// Density, conductivity and heat capacity of case-hardening steel at 60 °C.
const STEEL_DENSITY: Density = Density::from_si(7830.0);
const STEEL_CONDUCTIVITY: ThermalConductivity = ThermalConductivity::from_si(45.0);
const STEEL_HEAT_CAPACITY: SpecificHeat = SpecificHeat::from_si(465.0);
/// Basic rack of ISO 53.
const PRESSURE_ANGLE: f64 = 20.0 * std::f64::consts::PI / 180.0;
/// Boundary friction of ground steel in oil; measured values lie between 0.065 and 0.13.
const BOUNDARY_FRICTION: f64 = 0.1;
/// Metal on metal as the 2022 paper takes it (its Table 2).
const PAPER_BOUNDARY_FRICTION: f64 = 0.3;
/// Cut-offs of ISO 16610-21 practice: λc 0.8 mm, λs 2.5 µm.
const CUTOFF: Length = Length::from_si(0.8e-3);
const NOISE_CUTOFF: Length = Length::from_si(2.5e-6);

/// A case with every choice made.
#[derive(Debug, Clone)]
pub struct Case {
    /// Title.
    pub title: String,
    /// Which reading of the model.
    pub formulation: Formulation,
    /// Derived gear geometry.
    pub gears: GearPair,
    /// Steel of pinion and wheel.
    pub materials: [Material; 2],
    /// Pressure at which the softer flank flows.
    pub flow_pressure: [Pressure; 2],
    /// Reduced modulus E*.
    pub modulus: Pressure,
    /// Torque at the pinion.
    pub torque: Torque,
    /// Speed of the pinion.
    pub speed: AngularSpeed,
    /// Bulk temperature.
    pub temperature: Temperature,
    /// The oil.
    pub lubricant: Lubricant,
    /// The oil at the bulk temperature.
    pub oil: LubricantState,
    /// What about the oil was outside the range of its laws.
    pub oil_notes: Vec<OutOfRange>,
    /// How the traces are prepared.
    pub preparation: Preparation,
    /// Choices of the model.
    pub model: Model,
    /// The case as read.
    pub input: CaseInput,
    /// Every default that was used.
    pub defaults: Vec<DefaultUsed>,
}

/// Choices of the model, all made.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Model {
    /// Mesh positions along the path of contact.
    pub positions: usize,
    /// The single position of the paper's reading, 0 at A and 1 at E.
    pub position: f64,
    /// Offsets along the traces.
    pub offsets: usize,
    /// Half width of the contact window in Hertz half-widths.
    pub window: f64,
    /// Load sharing of the pairs of teeth in contact.
    pub load_sharing: LoadSharing,
    /// Friction coefficient in the film.
    pub friction: FrictionLaw,
    /// What the laws leave to choose.
    pub friction_settings: FrictionSettings,
    /// Factor on the coefficient.
    pub friction_scale: f64,
    /// Lubricant factor X_L.
    pub lubricant_factor: f64,
    /// Friction coefficient of touching asperities.
    pub boundary_friction: f64,
    /// Film thickness law.
    pub film: FilmLaw,
    /// Thermal reduction.
    pub thermal: ThermalLaw,
    /// Feed the flash temperature back.
    pub flash_feedback: bool,
    /// Share of the load that the film carries.
    pub load_share: LoadShareLaw,
    /// Fluid pressure across the film.
    pub fluid_pressure: FluidModel,
    /// Step of the paper's marching.
    pub delta_step: Length,
    /// Load error at which the marching stops.
    pub numerical_error: f64,
    /// Tolerance of the contact solver.
    pub tolerance: f64,
    /// Count running-in among the losses.
    pub include_running_in: bool,
    /// Fraction of the elastic energy lost.
    pub hysteresis: f64,
    /// Number of depths of subsurface fields.
    pub depths: usize,
}

/// Completes `input` with defaults and checks it; `source` tells where things stand.
///
/// # Errors
/// When a number is outside its domain, the gears cannot mesh, or the oil cannot be.
pub fn resolve(input: CaseInput, source: &Source) -> Result<Case, CaseError> {
    let mut defaults = Defaults::default();
    let formulation = defaults.take("formulation", input.formulation, Formulation::default());
    let gears = gears(&input, source, &mut defaults)?;
    let (materials, flow_pressure) = materials(&input, &mut defaults);
    let modulus =
        reduced_modulus(&materials[0], &materials[1]).map_err(domain(source, "material.pinion"))?;
    for (limit, material) in flow_pressure.iter().zip(&materials) {
        DomainError::positive("flow pressure", *limit)
            .and_then(|_| DomainError::positive("elastic limit", material.elastic_limit))
            .and_then(|_| DomainError::positive("density", material.density))
            .and_then(|_| DomainError::positive("conductivity", material.conductivity))
            .and_then(|_| DomainError::positive("heat capacity", material.heat_capacity))
            .map_err(domain(source, "material.pinion"))?;
    }
    let operation = input.operation;
    check_not_zero("torque", operation.torque, source, "operation.torque")?;
    DomainError::positive("speed", operation.speed).map_err(domain(source, "operation.speed"))?;
    let lubricant = input
        .lubricant
        .resolve(operation.temperature)
        .map_err(lubricant_at(source))?;
    for assumption in lubricant.assumptions() {
        defaults.assume(assumption);
    }
    let oil = lubricant
        .at(operation.temperature)
        .map_err(lubricant_at(source))?;
    let preparation = preparation(&input, source, &mut defaults)?;
    let model = model(&input.model, formulation, &gears, source, &mut defaults)?;
    Ok(Case {
        title: input
            .title
            .clone()
            .unwrap_or_else(|| "untitled case".to_owned()),
        formulation,
        gears,
        materials,
        flow_pressure,
        modulus,
        torque: operation.torque,
        speed: operation.speed,
        temperature: operation.temperature,
        lubricant,
        oil: oil.value,
        oil_notes: oil.outside,
        preparation,
        model,
        input,
        defaults: defaults.into_list(),
    })
}

fn gears(
    input: &CaseInput,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<GearPair, CaseError> {
    let given = &input.gears;
    let shift = match (given.profile_shift, given.centre_distance) {
        (None, None) => Some(defaults.take("gears.profile_shift", None, [0.0, 0.0])),
        (shift, _) => shift,
    };
    let geometry = GearPairInput {
        teeth: given.teeth,
        module: given.module,
        module_plane: defaults.take("gears.module_plane", given.module_plane, Plane::Normal),
        helix: defaults.take("gears.helix", given.helix, Angle::from_si(0.0)),
        pressure_angle: defaults.take(
            "gears.pressure_angle",
            given.pressure_angle,
            Angle::from_si(PRESSURE_ANGLE),
        ),
        face_width: given.face_width.both(),
        overlap: None,
        profile_shift: shift,
        centre_distance: given.centre_distance,
        tip_radius: given.tip_diameter.map(|d| d.map(|d| d / 2.0)),
        addendum: match given.tip_diameter {
            Some(_) => given.addendum.unwrap_or(1.0),
            None => defaults.take("gears.addendum", given.addendum, 1.0),
        },
    };
    GearPair::new(&geometry).map_err(|error| CaseError::Gears {
        place: source.place_of_key("gears"),
        source: error,
    })
}

fn materials(input: &CaseInput, defaults: &mut Defaults) -> ([Material; 2], [Pressure; 2]) {
    let pinion = body(&input.material.pinion, &PINION_KEYS, defaults);
    let wheel = match &input.material.wheel {
        None => pinion,
        Some(wheel) => body(wheel, &WHEEL_KEYS, defaults),
    };
    ([pinion.0, wheel.0], [pinion.1, wheel.1])
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

fn body(given: &BodyInput, keys: &BodyKeys, defaults: &mut Defaults) -> (Material, Pressure) {
    let elastic_limit = defaults.take(keys.elastic_limit, given.elastic_limit, STEEL_ELASTIC_LIMIT);
    let material = Material {
        young: defaults.take(keys.young, given.young, STEEL_YOUNG),
        poisson: defaults.take(keys.poisson, given.poisson, STEEL_POISSON),
        elastic_limit,
        density: defaults.take(keys.density, given.density, STEEL_DENSITY),
        conductivity: defaults.take(keys.conductivity, given.conductivity, STEEL_CONDUCTIVITY),
        heat_capacity: defaults.take(keys.heat_capacity, given.heat_capacity, STEEL_HEAT_CAPACITY),
    };
    let flow = elastic_limit * TABOR_RATIO;
    (
        material,
        defaults.take(keys.flow_pressure, given.flow_pressure, flow),
    )
}

fn preparation(
    input: &CaseInput,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<Preparation, CaseError> {
    let given = &input.surface;
    let cutoff = defaults.take("surface.cutoff", given.cutoff, CUTOFF);
    let noise = defaults.take("surface.noise_cutoff", given.noise_cutoff, NOISE_CUTOFF);
    DomainError::non_negative("cut-off", cutoff).map_err(domain(source, "surface.cutoff"))?;
    DomainError::non_negative("noise cut-off", noise)
        .map_err(domain(source, "surface.noise_cutoff"))?;
    let kept = |length: Length| (length.si() > 0.0).then_some(length);
    Ok(Preparation {
        form: defaults.take("surface.form", given.form, Form::Level),
        lambda_s: kept(noise),
        lambda_c: kept(cutoff),
        ends: defaults.take("surface.ends", given.ends, Ends::Cut),
    })
}

fn model(
    given: &ModelInput,
    formulation: Formulation,
    gears: &GearPair,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<Model, CaseError> {
    let paper = formulation == Formulation::Paper;
    let point = match (paper, given.position) {
        (true, given) => defaults.take("model.position", given, PathPoint::Named(NamedPoint::C)),
        (false, given) => given.unwrap_or(PathPoint::Named(NamedPoint::C)),
    };
    let positions = match paper {
        true => 1,
        false => defaults.take("model.positions", given.positions, 32),
    };
    let model = Model {
        positions,
        position: path_fraction(point, gears),
        offsets: defaults.take("model.offsets", given.offsets, if paper { 1 } else { 16 }),
        window: defaults.take("model.window", given.window, 3.0),
        load_sharing: defaults.take(
            "model.load_sharing",
            given.load_sharing.clone(),
            LoadSharing::Uniform,
        ),
        friction: defaults.take("model.friction", given.friction, FrictionLaw::default()),
        friction_settings: friction_settings(given, paper, defaults),
        lubricant_factor: defaults.take("model.lubricant_factor", given.lubricant_factor, 1.0),
        friction_scale: defaults.take("model.friction_scale", given.friction_scale, 1.0),
        boundary_friction: defaults.take(
            "model.boundary_friction",
            given.boundary_friction,
            if paper {
                PAPER_BOUNDARY_FRICTION
            } else {
                BOUNDARY_FRICTION
            },
        ),
        film: defaults.take(
            "model.film",
            given.film,
            if paper {
                FilmLaw::HamrockDowson
            } else {
                FilmLaw::DowsonToyoda
            },
        ),
        thermal: defaults.take(
            "model.thermal",
            given.thermal,
            if paper {
                ThermalLaw::None
            } else {
                ThermalLaw::Gupta
            },
        ),
        flash_feedback: defaults.take("model.flash_feedback", given.flash_feedback, false),
        load_share: defaults.take(
            "model.load_share",
            given.load_share,
            LoadShareLaw::default(),
        ),
        fluid_pressure: defaults.take(
            "model.fluid_pressure",
            given.fluid_pressure,
            if paper {
                FluidModel::Paper
            } else {
                FluidModel::ReynoldsCross
            },
        ),
        delta_step: defaults.take("model.delta_step", given.delta_step, Length::from_si(80e-9)),
        numerical_error: defaults
            .take(
                "model.numerical_error",
                given.numerical_error,
                Ratio::new(0.01),
            )
            .value(),
        tolerance: defaults.take("model.tolerance", given.tolerance, 1e-8),
        include_running_in: defaults.take(
            "model.include_running_in",
            given.include_running_in,
            false,
        ),
        hysteresis: defaults
            .take("model.hysteresis", given.hysteresis, Ratio::new(0.0))
            .value(),
        depths: defaults.take("model.depths", given.depths, 24),
    };
    check_model(&model, source)?;
    Ok(model)
}

fn friction_settings(given: &ModelInput, paper: bool, defaults: &mut Defaults) -> FrictionSettings {
    let mut settings = FrictionSettings {
        constant: given.constant_friction,
        ..FrictionSettings::default()
    };
    let clamp = defaults.take("model.clamp_roughness", given.clamp_roughness, !paper);
    settings.xu.roughness = if clamp {
        RoughnessReading::Clamped
    } else {
        RoughnessReading::AsIs
    };
    settings
}

/// A row of [`check_model`]: key, what it is called, value, whether it may be, and the rule.
type Check = (&'static str, &'static str, f64, bool, &'static str);

fn check_model(model: &Model, source: &Source) -> Result<(), CaseError> {
    let count = |n: usize| n as f64;
    let checks: [Check; 12] = [
        (
            "model.positions",
            "positions",
            count(model.positions),
            (1..=10_000).contains(&model.positions),
            "must be 1 to 10000",
        ),
        (
            "model.offsets",
            "offsets",
            count(model.offsets),
            (1..=10_000).contains(&model.offsets),
            "must be 1 to 10000",
        ),
        (
            "model.depths",
            "depths",
            count(model.depths),
            model.depths <= 1000,
            "must be at most 1000",
        ),
        (
            "model.position",
            "position",
            model.position,
            (0.0..=1.0).contains(&model.position),
            "must be A to E, or 0 to 1",
        ),
        (
            "model.window",
            "window",
            model.window,
            (1.5..=100.0).contains(&model.window),
            "must be 1.5 to 100 Hertz half-widths",
        ),
        (
            "model.friction_scale",
            "friction scale",
            model.friction_scale,
            model.friction_scale > 0.0 && model.friction_scale <= 10.0,
            "must be positive and at most 10",
        ),
        (
            "model.lubricant_factor",
            "lubricant factor",
            model.lubricant_factor,
            model.lubricant_factor > 0.0 && model.lubricant_factor <= 10.0,
            "must be positive and at most 10",
        ),
        (
            "model.boundary_friction",
            "boundary friction",
            model.boundary_friction,
            (0.0..=2.0).contains(&model.boundary_friction),
            "must be 0 to 2",
        ),
        (
            "model.delta_step",
            "step",
            model.delta_step.si(),
            model.delta_step.si() > 0.0 && model.delta_step.si() < 1e-3,
            "must be positive and below 1 mm",
        ),
        (
            "model.numerical_error",
            "numerical error",
            model.numerical_error,
            model.numerical_error > 0.0 && model.numerical_error <= 0.2,
            "must be above 0 and at most 20 %",
        ),
        (
            "model.tolerance",
            "tolerance",
            model.tolerance,
            (1e-12..=1e-2).contains(&model.tolerance),
            "must be 1e-12 to 1e-2",
        ),
        (
            "model.hysteresis",
            "hysteresis",
            model.hysteresis,
            (0.0..=1.0).contains(&model.hysteresis),
            "must be 0 to 1",
        ),
    ];
    for (key, name, value, holds, rule) in checks {
        DomainError::require(holds, name, value, "", rule).map_err(domain(source, key))?;
    }
    Ok(())
}

/// Where a point lies on the path, 0 at A and 1 at E.
fn path_fraction(point: PathPoint, gears: &GearPair) -> f64 {
    let path = gears.path();
    let s = match point {
        PathPoint::Fraction(fraction) => return fraction,
        PathPoint::Named(NamedPoint::A) => path.a,
        PathPoint::Named(NamedPoint::B) => path.b,
        PathPoint::Named(NamedPoint::C) => path.c,
        PathPoint::Named(NamedPoint::D) => path.d,
        PathPoint::Named(NamedPoint::E) => path.e,
    };
    (s - path.a) / (path.e - path.a)
}

fn check_not_zero<Q: Quantity>(
    name: &'static str,
    quantity: Q,
    source: &Source,
    key: &'static str,
) -> Result<(), CaseError> {
    let value = quantity.si();
    DomainError::require(
        value.is_finite() && value != 0.0,
        name,
        value,
        Q::SI_UNIT,
        "must be finite and not zero",
    )
    .map(|_| ())
    .map_err(domain(source, key))
}

fn domain<'a>(
    source: &'a Source,
    key: &'static str,
) -> impl Fn(DomainError) -> CaseError + use<'a> {
    move |error| CaseError::Domain {
        place: source.place_of(key),
        key,
        source: error,
    }
}

fn lubricant_at(
    source: &Source,
) -> impl Fn(asperity_core::lubricant::LubricantError) -> CaseError + use<'_> {
    |error| CaseError::Lubricant {
        place: source.place_of_key("lubricant"),
        source: error,
    }
}
