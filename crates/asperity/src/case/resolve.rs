//! From the case as written to the case as computed: defaults filled in, numbers checked.

use asperity_core::material::{Material, reduced_modulus};
use asperity_core::quantity::{AngularSpeed, Length, Pressure, Quantity, Temperature, Torque};
use asperity_core::{DomainError, OutOfRange};
use asperity_gear::{GearPair, LoadConditions, LoadMapSettings, MicroGeometry};
use asperity_oil::{FilmRheology, Lubricant, LubricantError, LubricantState, TractionConstants};
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use asperity_roughness::preparation::Preparation;

use super::bulk::{BulkModel, FoundBulk, bulk_model};
use super::calibrated;
use super::calibration::CalibrationInput;
use super::defaults::{DefaultUsed, Defaults};
use super::domain::domain;
use super::error::CaseError;
use super::gearbox::Gearbox;
use super::gears::{check_load, gears, load_settings, micro_geometry};
use super::input::{CaseInput, Formulation};
use super::key_names::key_of;
use super::model::{Model, model};
use super::plausibility::{refuse_impossible, refuse_stiff_oil};
use super::source::Source;
use super::steel::{Steels, steels};
use crate::lubrication::laws::Laws;

/// Cut-offs of gear practice: λc 0.25 mm, which a flank a few millimetres long holds several times, λs 2.5 µm.
const CUTOFF: Length = Length::from_si(0.25e-3);
const NOISE_CUTOFF: Length = Length::from_si(2.5e-6);

/// A case with every choice made.
#[derive(Debug, Clone)]
pub struct Case {
    /// Title.
    pub title: String,
    /// Reading of the model.
    pub formulation: Formulation,
    /// Derived gear geometry.
    pub gears: GearPair,
    /// Modifications of the flanks.
    pub micro_geometry: MicroGeometry,
    /// Numbers of the load map.
    pub load_settings: LoadMapSettings,
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
    /// Bulk temperature of the flanks; that of the oil where `bulk` has still to be found.
    pub temperature: Temperature,
    /// Law of the bulk temperature, where it has still to be found: [`settled`](crate::pipeline::settled).
    pub bulk: Option<BulkModel>,
    /// The bulk temperature found from the loss, where that was asked for.
    pub found_bulk: Option<FoundBulk>,
    /// The oil.
    pub lubricant: Lubricant,
    /// The oil at the bulk temperature.
    pub oil: LubricantState,
    /// The oil in the film, where film friction or load share look at it.
    pub rheology: Option<FilmRheology>,
    /// Properties of the steels outside the range of their relations.
    pub steel_notes: Vec<OutOfRange>,
    /// Properties of the oil outside the range of its laws.
    pub oil_notes: Vec<OutOfRange>,
    /// Preparation of the traces.
    pub preparation: Preparation,
    /// Places y/b between zones of the face that have traces of their own; empty where traces stand for the whole face.
    pub face_zones: Vec<f64>,
    /// Choices of the model.
    pub model: Model,
    /// Losses beside that of the mesh, where the case states any; filled in with the traces.
    pub gearbox: Option<Gearbox>,
    /// Laws of a user's own.
    pub laws: Laws,
    /// The case as read.
    pub input: CaseInput,
    /// Every default that was used.
    pub defaults: Vec<DefaultUsed>,
}

/// Completes `input` with defaults and checks it; `source` tells where things stand.
///
/// # Errors
/// When a number is outside its domain, the gears cannot mesh, or the oil cannot be.
pub fn resolve(input: CaseInput, source: &Source) -> Result<Case, CaseError> {
    resolve_checked(input, source, false)
}

/// The same, where the load over the teeth may have been checked before.
pub(super) fn resolve_checked(
    input: CaseInput,
    source: &Source,
    load_is_checked: bool,
) -> Result<Case, CaseError> {
    refuse_impossible(&input, source)?;
    let mut defaults = Defaults::default();
    let formulation = defaults.take("formulation", input.formulation, Formulation::default());
    check_micropitting(&input, formulation, source)?;
    let gears = gears(&input, source, &mut defaults)?;
    let micro_geometry = micro_geometry(&input, source, &mut defaults)?;
    let Steels {
        materials,
        flow_pressure,
        notes: steel_notes,
    } = steels(&input, source, &mut defaults)?;
    let modulus =
        reduced_modulus(&materials[0], &materials[1]).map_err(domain(source, "material.pinion"))?;
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
    refuse_stiff_oil(&oil.value, source)?;
    let preparation = preparation(&input, source, &mut defaults)?;
    let given = match &input.calibration {
        None => input.model.clone(),
        Some(calibration) => {
            calibrated::check(calibration, &input.model, formulation, source)?;
            calibrated::put_into(calibration, &input.model)
        }
    };
    let model = model(&given, formulation, &gears, source, &mut defaults)?;
    let bulk = bulk_model(operation.bulk.as_ref(), formulation, &model, source)?;
    let is_elastic = model.load_distribution.is_elastic();
    let load_settings = load_settings(&input, is_elastic, &mut defaults);
    let mesh = LoadConditions {
        pair: &gears,
        torque: operation.torque,
        micro: &micro_geometry,
        materials: &materials,
        settings: &load_settings,
    };
    if !load_is_checked {
        check_load(&mesh, &model, formulation, source)?;
    }
    let mut oil_state = oil.value;
    let rheology = match model.film_friction.shear_law().is_some() || model.shears_its_film() {
        false => None,
        true => {
            let rheology = rheology(
                &lubricant,
                &model,
                operation.temperature,
                input.calibration.as_ref(),
            )
            .map_err(lubricant_at(source))?;
            // One film in the whole run: as thick as the film friction has it.
            let state = rheology
                .state(operation.temperature)
                .map_err(lubricant_at(source))?;
            oil_state.pressure_viscosity = state.pressure_viscosity;
            oil_state.thermal_conductivity = state.conductivity;
            Some(rheology)
        }
    };
    Ok(Case {
        title: input
            .title
            .clone()
            .unwrap_or_else(|| "untitled case".to_owned()),
        formulation,
        gears,
        micro_geometry,
        load_settings,
        materials,
        flow_pressure,
        modulus,
        torque: operation.torque,
        speed: operation.speed,
        temperature: operation.temperature,
        bulk,
        found_bulk: None,
        lubricant,
        oil: oil_state,
        rheology,
        steel_notes,
        oil_notes: oil.outside,
        preparation,
        face_zones: Vec::new(),
        model,
        gearbox: None,
        laws: Laws::default(),
        input,
        defaults: defaults.into_list(),
    })
}

/// The oil in the film: constants of its family, α as given at the temperature of the case or by Gold.
fn rheology(
    lubricant: &Lubricant,
    model: &Model,
    bulk: Temperature,
    calibration: Option<&CalibrationInput>,
) -> Result<FilmRheology, LubricantError> {
    let family = lubricant.base_oil().ok_or(LubricantError::NoBaseOil)?;
    let mut constants = TractionConstants::of(family)?;
    if let Some(given) = lubricant.given_thermal_conductivity() {
        constants.conductivity = given;
    }
    if let Some(found) = calibration.and_then(|found| found.limiting_shear) {
        constants.limiting_shear = found.value;
    }
    if let Some(found) = calibration.and_then(|found| found.eyring_stress) {
        constants.eyring_stress = found.value;
    }
    let rheology = match lubricant.given_pressure_viscosity() {
        Some(alpha) => FilmRheology::with_alpha(lubricant, constants, alpha, bulk)?,
        None => FilmRheology::new(lubricant, family)?.with_constants(constants)?,
    };
    let shear = model.film_friction.shear_law().unwrap_or_default();
    Ok(rheology.with_laws(shear, model.film_pressure_law))
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
    if let Some(deviations) = given.outliers {
        let is_positive = deviations > 0.0 && deviations.is_finite();
        DomainError::require(is_positive, "outliers", deviations, "-", "must be positive")
            .map_err(domain(source, "surface.outliers"))?;
    }
    let kept = |length: Length| (length.si() > 0.0).then_some(length);
    Ok(Preparation {
        form: defaults.take("surface.form", given.form, Form::Level),
        lambda_s: kept(noise),
        lambda_c: kept(cutoff),
        ends: defaults.take("surface.ends", given.ends, Ends::Cut),
    })
}

fn check_micropitting(
    input: &CaseInput,
    formulation: Formulation,
    source: &Source,
) -> Result<(), CaseError> {
    let Some(given) = &input.micropitting else {
        return Ok(());
    };
    if formulation != Formulation::Corrected {
        return Err(CaseError::Conflict {
            place: source.place_of_key("micropitting"),
            key: "micropitting",
            rule: "rates the whole path, and the paper's formulation has one position; leave one of the two out",
        });
    }
    let rule = "must be finite and greater than zero";
    for (key, name, value) in [
        ("micropitting.load_factor", "load factor", given.load_factor),
        (
            "micropitting.permissible",
            "permissible film",
            given.permissible,
        ),
    ] {
        let holds = value.is_none_or(|value| value.is_finite() && value > 0.0);
        let checked = DomainError::require(holds, name, value.unwrap_or(1.0), "-", rule);
        checked.map_err(domain(source, key))?;
    }
    for ra in given.ra.iter().flatten() {
        DomainError::positive("Ra", *ra).map_err(domain(source, "micropitting.ra"))?;
    }
    Ok(())
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

fn lubricant_at(source: &Source) -> impl Fn(LubricantError) -> CaseError + use<'_> {
    |error| match error {
        LubricantError::Domain(error) => domain(source, key_of("lubricant", error.name))(error),
        error => {
            let key = match error {
                LubricantError::ImplausiblePressureViscosity { .. } => {
                    "lubricant.pressure_viscosity"
                }
                _ => "lubricant",
            };
            CaseError::Lubricant {
                place: source.place_of_key(key),
                key,
                written: source.written(key).map(str::to_owned),
                source: error,
            }
        }
    }
}
