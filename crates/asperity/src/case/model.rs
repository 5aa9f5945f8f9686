//! Choices of the model: defaults by formulation, and what each may be.

use asperity_core::DomainError;
use asperity_core::quantity::{Length, Ratio};
use asperity_ehl_regime::inlet_flow::{CentralFilm, Lay};
use asperity_ehl_regime::{FilmLaw, ThermalLaw};
use asperity_gear::{GearPair, LoadLaw};
use asperity_ns_film::FluidModel;
use asperity_oil::PressureLaw;
use asperity_tribo_friction::boundary::BOUNDARY_LAYER;
use asperity_tribo_friction::{FrictionSettings, RoughnessReading};
use serde::Serialize;

use super::defaults::Defaults;
use super::domain::domain;
use super::error::{CaseError, LOOSEST_TOLERANCE};
use super::input::{EhlInput, Formulation, ModelInput, NamedPoint, OneOrTwo, PathPoint};
use super::law_names::{FilmFrictionLaw, FullFilmName, LoadShareName};
use super::model_defaults::ModelDefaults;
use super::source::Source;
use asperity_mixed_film::SpotSpeed;

/// Choices of the model, all made.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Model {
    /// Cells of the path of contact; one position in the paper's reading.
    pub positions: usize,
    /// The single position of the paper's reading, 0 at A and 1 at E.
    pub position: f64,
    /// Offsets along the traces.
    pub offsets: usize,
    /// Half width of the contact window in Hertz half-widths.
    pub window: f64,
    /// Load over the teeth in contact.
    pub load_distribution: LoadLaw,
    /// Friction in the film.
    pub film_friction: FilmFrictionLaw,
    /// Viscosity over pressure in it.
    pub film_pressure_law: PressureLaw,
    /// Choices that the laws leave open.
    pub friction_settings: FrictionSettings,
    /// Factor on the coefficient.
    pub friction_scale: f64,
    /// Lubricant factor X_L.
    pub lubricant_factor: f64,
    /// Coefficient of boundary friction.
    pub boundary_friction: f64,
    /// Height of the boundary layer on touching asperities.
    pub boundary_layer: Length,
    /// Lay of pinion and wheel.
    pub lay: [Lay; 2],
    /// Reading of the central film in film friction and load share.
    pub central_film: CentralFilm,
    /// Reading of the central film in Λ* and wherever the film is printed.
    pub lambda_film: CentralFilm,
    /// Speed that carries oil into touching asperities.
    pub spot_speed: SpotSpeed,
    /// Factor on the solved share of the asperities.
    pub asperity_share_factor: f64,
    /// Film thickness law.
    pub film: FilmLaw,
    /// Thermal reduction.
    pub thermal: ThermalLaw,
    /// Feed the flash temperature back.
    pub flash_feedback: bool,
    /// Share of the load that the film carries.
    pub load_share: LoadShareName,
    /// Source of a film that carries the whole load.
    pub full_film: FullFilmName,
    /// Elastohydrodynamic solutions.
    pub ehl: EhlChoices,
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
    /// Give the losses of run-in flanks as well.
    pub run_in: bool,
    /// Fraction of the elastic energy lost.
    pub hysteresis: f64,
    /// Number of depths of subsurface fields.
    pub depths: usize,
}

impl Model {
    /// Whether load share or full film need the oil's rheology, whatever the law of film friction.
    pub(super) fn shears_its_film(&self) -> bool {
        self.load_share.supply().is_some()
            || self.load_share == LoadShareName::Ehl
            || self.full_film != FullFilmName::Formulas
    }
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
    let pitch = PathPoint::Named(NamedPoint::C);
    let has_pitch = (0.0..=1.0).contains(&pitch.fraction_of(gears.path()));
    let point = match (own.one_position, given.position) {
        (true, None) if !has_pitch => {
            return Err(CaseError::Conflict {
                place: source.place_of("gears"),
                key: "gears",
                rule: "the pitch point lies outside the path of contact, so model.position needs a value from 0 (A) to 1 (E)",
            });
        }
        (false, None) if !has_pitch => PathPoint::Fraction(0.5),
        (true, given) => defaults.take("model.position", given, pitch),
        (false, given) => given.unwrap_or(pitch),
    };
    let positions = match own.one_position {
        true => 1,
        false => defaults.take("model.positions", given.positions, 16),
    };
    // The paper's reading has none of these; its list of defaults leaves them out.
    let mut unused = Defaults::default();
    let of_share = match own.one_position {
        true => &mut unused,
        false => &mut *defaults,
    };
    let share_choices = ShareChoices::of(given, of_share);
    let load_share = given.load_share.unwrap_or(own.load_share);
    let full_film = given.full_film.unwrap_or_default();
    let model = Model {
        positions,
        position: point.fraction_of(gears.path()),
        offsets: defaults.take("model.offsets", given.offsets, own.offsets),
        window: defaults.take("model.window", given.window, 3.0),
        load_distribution: defaults.take(
            "model.load_distribution",
            given.load_distribution.clone(),
            own.load_distribution.clone(),
        ),
        film_friction: defaults.take(
            "model.film_friction",
            given.film_friction,
            own.film_friction,
        ),
        film_pressure_law: share_choices.film_pressure_law,
        friction_settings: friction_settings(given, own.clamp_roughness, defaults),
        lubricant_factor: defaults.take("model.lubricant_factor", given.lubricant_factor, 1.0),
        friction_scale: defaults.take("model.friction_scale", given.friction_scale, 1.0),
        boundary_friction: defaults.take(
            "model.boundary_friction",
            given.boundary_friction,
            own.boundary_friction,
        ),
        boundary_layer: share_choices.boundary_layer,
        lay: share_choices.lay,
        central_film: share_choices.central_film,
        lambda_film: defaults.take("model.lambda_film", given.lambda_film, own.lambda_film),
        spot_speed: share_choices.spot_speed,
        asperity_share_factor: share_choices.factor,
        film: defaults.take("model.film", given.film, own.film),
        thermal: defaults.take("model.thermal", given.thermal, own.thermal),
        flash_feedback: defaults.take("model.flash_feedback", given.flash_feedback, false),
        load_share: defaults.take("model.load_share", given.load_share, own.load_share),
        full_film,
        ehl: EhlChoices::of(given.ehl.as_ref(), load_share, full_film, defaults),
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
        run_in: share_choices.run_in,
        hysteresis: defaults
            .take(
                "model.hysteresis",
                given.hysteresis,
                Ratio::new(own.hysteresis),
            )
            .value(),
        depths: defaults.take("model.depths", given.depths, 24),
    };
    check_model(&model, source)?;
    check_run_in(formulation, given, source)?;
    check_constant(given.constant_friction, model.film_friction, source)?;
    Ok(model)
}

/// Choices of the elastohydrodynamic solutions.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct EhlChoices {
    /// Records along the path.
    pub records: usize,
    /// Cells across the film.
    pub cells: usize,
    /// Travel of a record in half-widths.
    pub travel: f64,
    /// Cache of records: `user`, `off`, or a folder.
    pub cache: String,
}

impl EhlChoices {
    /// The choices; defaults are recorded where a solution is requested.
    fn of(
        given: Option<&EhlInput>,
        share: LoadShareName,
        film: FullFilmName,
        defaults: &mut Defaults,
    ) -> Self {
        let mut unused = Defaults::default();
        let has_records = share == LoadShareName::Ehl || film == FullFilmName::EhlTransient;
        let is_asked = has_records || film == FullFilmName::Ehl;
        let given = given.cloned().unwrap_or_default();
        let of_grid = if is_asked {
            &mut *defaults
        } else {
            &mut unused
        };
        let cells = of_grid.take("model.ehl.cells", given.cells, 512);
        let of_records = if has_records { defaults } else { &mut unused };
        Self {
            records: of_records.take("model.ehl.records", given.records, 8),
            cells,
            travel: of_records.take("model.ehl.travel", given.travel, 20.0),
            cache: of_records.take("model.ehl.cache", given.cache, "user".to_owned()),
        }
    }
}

/// Choices of the load share and of film friction.
struct ShareChoices {
    boundary_layer: Length,
    lay: [Lay; 2],
    central_film: CentralFilm,
    spot_speed: SpotSpeed,
    factor: f64,
    film_pressure_law: PressureLaw,
    run_in: bool,
}

impl ShareChoices {
    fn of(given: &ModelInput, defaults: &mut Defaults) -> Self {
        let lay = OneOrTwo::One(Lay::ACROSS);
        let (speed, factor) = (given.spot_speed, given.asperity_share_factor);
        let (layer, film) = (given.boundary_layer, given.central_film);
        Self {
            boundary_layer: defaults.take("model.boundary_layer", layer, BOUNDARY_LAYER),
            lay: defaults.take("model.lay", given.lay, lay).both(),
            central_film: defaults.take("model.central_film", film, CentralFilm::MassFlow),
            spot_speed: defaults.take("model.spot_speed", speed, SpotSpeed::Entrainment),
            factor: defaults.take("model.asperity_share_factor", factor, 1.0),
            run_in: defaults.take("model.run_in", given.run_in, false),
            film_pressure_law: defaults.take(
                "model.film_pressure_law",
                given.film_pressure_law,
                PressureLaw::default(),
            ),
        }
    }
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
    let checks: [Check; 17] = [
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
            "model.boundary_layer",
            "boundary layer",
            model.boundary_layer.si(),
            (0.0..=1e-6).contains(&model.boundary_layer.si()),
            "must be 0 to 1 um",
        ),
        (
            "model.asperity_share_factor",
            "factor on the asperity share",
            model.asperity_share_factor,
            model.asperity_share_factor > 0.0 && model.asperity_share_factor <= 1.0,
            "must be above 0 and at most 1",
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
            "model.ehl.records",
            "records along the path",
            count(model.ehl.records),
            (2..=64).contains(&model.ehl.records),
            "must be 2 to 64",
        ),
        (
            "model.ehl.cells",
            "cells across the film",
            count(model.ehl.cells),
            model.ehl.cells.is_multiple_of(64) && (64..=8192).contains(&model.ehl.cells),
            "must be a multiple of 64, 64 to 8192",
        ),
        (
            "model.ehl.travel",
            "travel of a record",
            model.ehl.travel,
            (2.0..=1000.0).contains(&model.ehl.travel),
            "must be 2 to 1000 half-widths",
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

/// Running-in is of the corrected formulation, whose contacts carry the load of the cells.
fn check_run_in(
    formulation: Formulation,
    given: &ModelInput,
    source: &Source,
) -> Result<(), CaseError> {
    let key = "model.run_in";
    if formulation == Formulation::Corrected || given.run_in != Some(true) {
        return Ok(());
    }
    Err(CaseError::Conflict {
        place: source.place_of(key),
        key,
        rule: "belongs to the corrected formulation; leave one of the two out",
    })
}

/// A constant coefficient is given with the law that uses it, and only with it.
fn check_constant(
    given: Option<f64>,
    law: FilmFrictionLaw,
    source: &Source,
) -> Result<(), CaseError> {
    let key = "model.constant_friction";
    let conflict = |rule| CaseError::Conflict {
        place: source.place_of(key),
        key,
        rule,
    };
    match (given, law) {
        (None, FilmFrictionLaw::Constant) => Err(conflict(
            "is missing, and film_friction = \"constant\" needs it, as constant_friction = 0.05",
        )),
        (Some(_), law) if law != FilmFrictionLaw::Constant => Err(conflict(
            "is used with film_friction = \"constant\" only; leave it out or choose that law",
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
