//! Choices of the model: defaults by formulation, and what each may be.

use asperity_core::DomainError;
use asperity_core::quantity::{Length, Ratio};
use asperity_ehl_regime::{FilmLaw, LoadShareLaw, ThermalLaw};
use asperity_gear::{GearPair, LoadSharing, PositionRule};
use asperity_ns_film::FluidModel;
use asperity_tribo_friction::{FrictionLaw, FrictionSettings, RoughnessReading};
use serde::Serialize;

use super::defaults::Defaults;
use super::domain::domain;
use super::error::CaseError;
use super::input::{Formulation, ModelInput, NamedPoint, PathPoint};
use super::model_defaults::ModelDefaults;
use super::source::Source;

/// Loosest tolerance of a rough contact: at 1e-2 pressures were 56 to 65 % off.
pub(super) const LOOSEST_TOLERANCE: f64 = 1e-4;

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

/// Makes every choice that the case leaves open.
pub(super) fn model(
    given: &ModelInput,
    formulation: Formulation,
    gears: &GearPair,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<Model, CaseError> {
    let own = ModelDefaults::of(formulation);
    let point = match (own.one_position, given.position) {
        (true, given) => defaults.take("model.position", given, PathPoint::Named(NamedPoint::C)),
        (false, given) => given.unwrap_or(PathPoint::Named(NamedPoint::C)),
    };
    let positions = match own.one_position {
        true => 1,
        false => defaults.take("model.positions", given.positions, 32),
    };
    let model = Model {
        positions,
        position: point.fraction_of(gears.path()),
        offsets: defaults.take("model.offsets", given.offsets, own.offsets),
        window: defaults.take("model.window", given.window, 3.0),
        load_sharing: defaults.take(
            "model.load_sharing",
            given.load_sharing.clone(),
            LoadSharing::Uniform,
        ),
        friction: defaults.take("model.friction", given.friction, FrictionLaw::default()),
        friction_settings: friction_settings(given, own.clamp_roughness, defaults),
        lubricant_factor: defaults.take("model.lubricant_factor", given.lubricant_factor, 1.0),
        friction_scale: defaults.take("model.friction_scale", given.friction_scale, 1.0),
        boundary_friction: defaults.take(
            "model.boundary_friction",
            given.boundary_friction,
            own.boundary_friction,
        ),
        film: defaults.take("model.film", given.film, own.film),
        thermal: defaults.take("model.thermal", given.thermal, own.thermal),
        flash_feedback: defaults.take("model.flash_feedback", given.flash_feedback, false),
        load_share: defaults.take(
            "model.load_share",
            given.load_share,
            LoadShareLaw::default(),
        ),
        fluid_pressure: defaults.take(
            "model.fluid_pressure",
            given.fluid_pressure,
            own.fluid_pressure,
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
    check_against_gears(&model, own, gears, source)?;
    check_constant(given.constant_friction, model.friction, source)?;
    Ok(model)
}

fn friction_settings(
    given: &ModelInput,
    clamp_roughness: bool,
    defaults: &mut Defaults,
) -> FrictionSettings {
    let mut settings = FrictionSettings {
        constant: given.constant_friction,
        ..FrictionSettings::default()
    };
    let clamp = defaults.take(
        "model.clamp_roughness",
        given.clamp_roughness,
        clamp_roughness,
    );
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
            (1e-16..=LOOSEST_TOLERANCE).contains(&model.tolerance),
            "must be 1e-16 to 1e-4",
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
        DomainError::require(holds, name, value, "-", rule).map_err(domain(source, key))?;
    }
    Ok(())
}

/// What only some gears take: positions fewer than the segments of the path, laws for spur gears.
fn check_against_gears(
    model: &Model,
    own: &ModelDefaults,
    gears: &GearPair,
    source: &Source,
) -> Result<(), CaseError> {
    let refused = |key| {
        move |error| CaseError::NotForTheseGears {
            place: source.place_of(key),
            key,
            source: error,
        }
    };
    if !own.one_position {
        gears
            .positions(model.positions, PositionRule::default())
            .map_err(refused("model.positions"))?;
    }
    gears
        .loss_factors(&model.load_sharing)
        .map_err(refused("model.load_sharing"))?;
    Ok(())
}

/// A constant coefficient is given with the law that uses it, and only with it.
fn check_constant(given: Option<f64>, law: FrictionLaw, source: &Source) -> Result<(), CaseError> {
    let key = "model.constant_friction";
    let conflict = |rule| CaseError::Conflict {
        place: source.place_of(key),
        key,
        rule,
    };
    match (given, law) {
        (None, FrictionLaw::Constant) => Err(conflict(
            "is missing, and friction = \"constant\" needs it, as constant_friction = 0.05",
        )),
        (Some(_), law) if law != FrictionLaw::Constant => Err(conflict(
            "is used with friction = \"constant\" only; leave it out or choose that law",
        )),
        (Some(value), _) => DomainError::require(
            (0.0..=2.0).contains(&value),
            "constant friction",
            value,
            "-",
            "must be 0 to 2",
        )
        .map(|_| ())
        .map_err(domain(source, key)),
        (None, _) => Ok(()),
    }
}
