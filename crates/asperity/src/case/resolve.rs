//! From the case as written to the case as computed: defaults filled in, numbers checked.

use asperity_core::lubricant::{Lubricant, LubricantError, LubricantState};
use asperity_core::material::{Material, reduced_modulus};
use asperity_core::quantity::{
    Angle, AngularSpeed, Length, Pressure, Quantity, Temperature, Torque,
};
use asperity_core::{DomainError, OutOfRange};
use asperity_gear::{GearError, GearPair, GearPairInput, Plane};
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use asperity_roughness::preparation::Preparation;

use super::defaults::{DefaultUsed, Defaults};
use super::domain::domain;
use super::error::CaseError;
use super::input::{CaseInput, Formulation};
use super::key_names::key_of;
use super::model::{Model, model};
use super::plausibility::{refuse_impossible, refuse_stiff_oil};
use super::source::Source;
use super::steel::materials;
use crate::laws::Laws;

/// Basic rack of ISO 53.
const PRESSURE_ANGLE: f64 = 20.0 * std::f64::consts::PI / 180.0;
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
    refuse_impossible(&input, source)?;
    let mut defaults = Defaults::default();
    let formulation = defaults.take("formulation", input.formulation, Formulation::default());
    let gears = gears(&input, source, &mut defaults)?;
    let (materials, flow_pressure) = materials(&input, source, &mut defaults)?;
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
        laws: Laws::default(),
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
    GearPair::new(&geometry).map_err(|error| match error {
        GearError::Domain(error) => domain(source, key_of("gears", error.name))(error),
        error => CaseError::Gears {
            place: source.place_of_key("gears"),
            source: error,
        },
    })
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
