//! Completion of a case: defaults filled in, numbers checked.

use std::ops::Deref;
use std::sync::Arc;

use asperity_core::material::{Material, reduced_modulus};
use asperity_core::quantity::{AngularSpeed, Length, Pressure, Quantity, Temperature, Torque};
use asperity_core::{Checked, DomainError, OutOfRange};
use asperity_ehl_regime::inlet_flow::Lay;
use asperity_flanks::error::PositionError;
use asperity_flanks::flank_lay::FlankLay;
use asperity_gear::{GearPair, LoadConditions, LoadMapSettings, MeasuredForm, MicroGeometry};
use asperity_oil::{
    Assumption, FilmRheology, Lubricant, LubricantError, LubricantInput, LubricantState,
    PressureLaw,
};
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use asperity_roughness::preparation::{LAMBDA_C, LAMBDA_S, Preparation};
use asperity_tribo_friction::XuCalibration;
use serde_json::Value;

use super::assumed_relief::{AssumedRelief, ReliefInputs};
use super::bulk::{BulkModel, bulk_model};
use super::calibrated;
use super::gearbox::Gearbox;
use super::gears::{gears, load_settings, micro_geometry, note_relief};
use super::load_inputs::LoadInputs;
use super::oil_at::OilAtTemperature;
use super::oil_file::OilFile;
use super::overrides::Overrides;
use super::plausibility::{at_pitch_point, refuse_stiff_oil};
use super::running_in::{RunningInPlan, running_in};
use super::solved_teeth::{LoadCheck, SolvedTeeth};
use super::steel::{Steels, steels};
use crate::input::case_input::{CaseInput, OperationInput, SurfaceInput, TEMPERATURE_KEYS};
use crate::input::formulation::FormulationChoice;
use crate::input::micropitting_input::MicropittingInput;
use crate::input::model::{Model, ModelInput, OfFormulation, PaperChoices, model};
use crate::input::path_point::Positions;
use crate::input::ranges::refuse_impossible;
use crate::laws::Laws;
use crate::source::case_error::CaseError;
use crate::source::defaults::{DefaultUsed, Defaults};
use crate::source::section::{Section, domain, in_train};
use crate::source::source_text::Source;
use crate::text::{key_of, missing_key};

/// A case with every choice made: made from a [`CaseInput`], and read only. [`Overrides`] are what a draw or a study changes of it.
#[derive(Debug, Clone)]
pub struct Case(Resolved);

impl Deref for Case {
    type Target = Resolved;

    fn deref(&self) -> &Resolved {
        &self.0
    }
}

/// The values of a [`Case`].
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Resolved {
    /// Title.
    pub title: String,
    /// The formulation of the model.
    pub formulation: FormulationChoice,
    /// Derived gear geometry.
    pub gears: GearPair,
    /// Modifications of the flanks, with the middle of the tip relief that is not stated.
    pub micro_geometry: MicroGeometry,
    /// Tip relief that the case does not state; none where it states the relief of both gears, and in a formulation that assumes none.
    pub assumed_relief: Option<AssumedRelief>,
    /// Numbers of the load map.
    pub load_settings: LoadMapSettings,
    /// Steel of pinion and wheel.
    pub materials: [Material; 2],
    /// Flow pressure of pinion and wheel.
    pub flow_pressure: [Pressure; 2],
    /// Reduced modulus E*.
    pub modulus: Pressure,
    /// Torque at the pinion.
    pub torque: Torque,
    /// Speed of the pinion.
    pub speed: AngularSpeed,
    /// Running-in of the flanks before the loss is computed, if the case states one.
    pub running_in: Option<RunningInPlan>,
    /// The temperature that the case states: of the oil where `bulk` has a law, else of the flanks.
    pub stated_temperature: Temperature,
    /// Law by which the bulk temperature of the flanks follows from the loss; `None` where the case states it.
    pub bulk: Option<BulkModel>,
    /// The oil, whose state at a temperature an [`OperatingCase`](crate::case::OperatingCase) has.
    pub lubricant: Lubricant,
    /// The oil file that the case names.
    pub oil_file: Option<Arc<OilFile>>,
    /// Properties of the steels outside the range of their relations.
    pub steel_notes: Vec<OutOfRange>,
    /// Preparation of the traces.
    pub preparation: Preparation,
    /// Places y/b between zones of the face with separate traces; empty if the traces represent the whole face.
    pub face_zones: Vec<f64>,
    /// Choices of the model.
    pub model: Model,
    /// Choices of the formulation `paper`.
    pub paper: PaperChoices,
    /// Losses other than that of the mesh, if the case states any; filled in with the traces.
    pub gearbox: Option<Gearbox>,
    /// User-defined laws.
    pub laws: Laws,
    /// What a draw or a study changes, in the other values already.
    pub overrides: Overrides,
    /// The case as read.
    pub input: CaseInput,
    /// Every default in use.
    pub defaults: Vec<DefaultUsed>,
}

/// Completes `input`, which names no oil file, with defaults and checks it; `source` gives the places of the keys.
///
/// # Errors
/// When a number is outside its domain, the gears cannot mesh, or the oil cannot be.
pub fn resolve(input: CaseInput, source: &Source) -> Result<Case, CaseError> {
    resolve_with(input, None, source, None).map(|found| found.case)
}

/// Completes and checks a case with the oil file that it names; the load over the teeth is not solved again where it is known.
pub(crate) fn resolve_with(
    input: CaseInput,
    oil_file: Option<Arc<OilFile>>,
    source: &Source,
    known: Option<&SolvedTeeth>,
) -> Result<Completed, CaseError> {
    refuse_impossible(&input, source)?;
    let oil_file = oil_file.map(|file| file.by_law(input.model.film_pressure_law));
    let mut defaults = Defaults::default();
    let formulation = defaults.take("formulation", input.formulation, Default::default());
    refuse_keys(formulation, &input, source)?;
    check_micropitting(&input, source)?;
    let gears = gears(&input, source, &mut defaults)?;
    let mut micro_geometry = micro_geometry(&input, source, &mut defaults)?;
    let Steels {
        materials,
        flow_pressure,
        notes: steel_notes,
    } = steels(&input, source, &mut defaults)?;
    let modulus =
        reduced_modulus(&materials[0], &materials[1]).map_err(domain(source, "material.pinion"))?;
    let (torque, speed) = (input.operation.torque, input.operation.speed);
    let temperature = operating_temperature(&input.operation, source)?;
    check_operation(torque, speed, &gears, modulus, source)?;
    let running_in = running_in(&input.operation, (&gears, modulus), flow_pressure, source)?;
    let lubricant_at = |error| lubricant_at(source, &input.operation, error);
    let lubricant = completed_oil(&input.lubricant, oil_file.as_deref());
    let lubricant = lubricant.and_then(|oil| oil.resolve(temperature));
    let lubricant = lubricant.map_err(lubricant_at)?;
    for assumption in lubricant.assumptions() {
        defaults.assume(assumption);
    }
    let oil = lubricant.at(temperature).map_err(lubricant_at)?;
    refuse_stiff_oil(&oil.value, &input.operation, source)?;
    let preparation = preparation(&input, source, &mut defaults)?;
    let choices = fitted_choices(&input, oil_file.as_deref(), source, &mut defaults)?;
    let stated = OfFormulation {
        defaults: formulation.defaults(),
        unused_keys: formulation.unused_keys(),
        positions: formulation.positions(),
        xu_roughness: formulation.xu_roughness(),
    };
    let of_paper = &input.paper;
    let (model, paper) = model(&choices, of_paper, &stated, &gears, source, &mut defaults)?;
    let bulk = bulk_model(input.operation.bulk.as_ref(), &model, source)?;
    let load_settings = load_settings(&input, &model, source, &mut defaults);
    let mesh = LoadConditions {
        pair: &gears,
        torque,
        micro: &micro_geometry,
        materials: &materials,
        settings: &load_settings,
    };
    let check = load_check(&model, formulation.positions(), &mesh);
    let assumes = formulation.assumes_relief();
    let relief = assumes.then(|| ReliefInputs::new(&input, &check.load));
    let teeth = SolvedTeeth::new(known, check, relief, source)?;
    let assumed_relief = teeth.relief().cloned();
    note_relief(&input, assumed_relief.as_ref(), source, &mut defaults);
    if let Some(assumed) = &assumed_relief {
        let [amount, length] = [AssumedRelief::AMOUNT, AssumedRelief::LENGTH];
        micro_geometry = assumed.put_into(&micro_geometry, amount, length);
    }
    let of_film = (&model, (&input, oil_file.as_deref()));
    let oil = film_oil(&lubricant, oil, of_film, temperature, source)?;
    assume_conductivity(&lubricant, oil.rheology.as_ref(), &mut defaults);
    let title = input.title.clone();
    let case = Case(Resolved {
        title: title.unwrap_or_else(|| title_by_gears(&gears.teeth, gears.normal_module)),
        formulation,
        gears,
        micro_geometry,
        assumed_relief,
        load_settings,
        materials,
        flow_pressure,
        modulus,
        torque,
        speed,
        running_in,
        stated_temperature: temperature,
        bulk,
        lubricant,
        oil_file,
        steel_notes,
        preparation,
        face_zones: Vec::new(),
        model,
        paper,
        gearbox: None,
        laws: Laws::default(),
        overrides: Overrides::default(),
        input,
        defaults: defaults.into_list(),
    });
    Ok(Completed { case, teeth, oil })
}

/// A case with what was computed to check it.
pub(crate) struct Completed {
    pub case: Case,
    pub teeth: SolvedTeeth,
    /// The oil at the temperature that the case states.
    pub oil: OilAtTemperature,
}

/// What the files of a case add to its keys.
pub(crate) struct OfFiles<'a> {
    /// Coefficients of Xu's friction law.
    pub xu: Option<&'a XuCalibration>,
    pub gearbox: Option<Gearbox>,
    pub laws: Option<Laws>,
}

/// What the flanks of a case add to its keys.
pub(crate) struct OfFlanks<'a> {
    /// Values of the files of the traces, instead of defaults.
    pub assumed: &'a [DefaultUsed],
    /// Lay of both flanks, and its row among the defaults, where the case states none and a surface shows it.
    pub lay: Option<([Lay; 2], DefaultUsed)>,
    /// Places y/b between zones of the face.
    pub zones: &'a [f64],
    /// Forms of the flanks of pinion and wheel that were measured.
    pub forms: &'a [Option<MeasuredForm>; 2],
}

/// Refuses a load or a speed that no pair of gears has.
fn check_operation(
    torque: Torque,
    speed: AngularSpeed,
    gears: &GearPair,
    modulus: Pressure,
    source: &Source,
) -> Result<(), CaseError> {
    let section = Section::new(source, "operation");
    let (value, rule) = (torque.si(), "must be finite and not zero");
    let is_loaded = value.is_finite() && value != 0.0;
    DomainError::require(is_loaded, "torque", value, Torque::SI_UNIT, rule)
        .map_err(section.domain("torque"))?;
    DomainError::positive("speed", speed).map_err(section.domain("speed"))?;
    for load in at_pitch_point(gears, modulus, torque, speed) {
        load.refuse_impossible(source)?;
    }
    Ok(())
}

/// The oil of a case with what its oil file states.
fn completed_oil(
    stated: &LubricantInput,
    file: Option<&OilFile>,
) -> Result<LubricantInput, LubricantError> {
    match file {
        Some(file) => file.completing(stated),
        None => Ok(stated.clone()),
    }
}

/// The choices of the model with the constants of a calibration and of an oil file.
fn fitted_choices(
    input: &CaseInput,
    oil_file: Option<&OilFile>,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<ModelInput, CaseError> {
    let mut choices = input.model.clone();
    if let Some(calibration) = &input.calibration {
        calibrated::check(calibration, &input.model, source)?;
        choices = calibrated::put_into(calibration, &choices);
    }
    if let Some(file) = oil_file {
        choices = file.put_into(&choices, source)?;
        let by = "the law by which the constants of lubricant.oil_file were fitted".to_owned();
        defaults.take_from(
            "model.film_pressure_law",
            input.model.film_pressure_law,
            file.film_friction.pressure_law,
            Some(by),
        );
    }
    Ok(choices)
}

/// The check of the load over the teeth, by the law that the case names.
fn load_check(model: &Model, positions: Positions, mesh: &LoadConditions<'_>) -> LoadCheck {
    LoadCheck {
        load: LoadInputs::by_law(&model.load_distribution, mesh),
        positions: (positions == Positions::AlongPath).then_some(model.positions),
    }
}

impl Case {
    /// The case with what its files state.
    pub(crate) fn with_files(mut self, files: OfFiles<'_>) -> Self {
        if let Some(calibration) = files.xu {
            self.0.model.friction_settings.xu.coefficients = calibration.coefficients;
        }
        self.0.gearbox = files.gearbox;
        match files.laws {
            Some(laws) => self.with_laws(laws),
            None => self,
        }
    }

    /// The case with user-defined laws, which are named among the defaults instead of the laws that they replace.
    pub(crate) fn with_laws(mut self, laws: Laws) -> Self {
        for row in laws.rows() {
            self.0.defaults.retain(|default| default.key != row.key);
            self.0.defaults.push(row);
        }
        self.0.laws = laws;
        self
    }

    /// The case with what its flanks show.
    pub(crate) fn with_flanks(mut self, flanks: OfFlanks<'_>) -> Self {
        let Resolved {
            defaults, model, ..
        } = &mut self.0;
        defaults.retain(|default| {
            flanks
                .assumed
                .iter()
                .all(|stated| stated.key != default.key)
        });
        defaults.extend(flanks.assumed.iter().cloned());
        if let Some((lay, row)) = flanks.lay
            && let Some(listed) = defaults.iter_mut().find(|default| default.key == row.key)
        {
            model.lay = lay;
            *listed = row;
        }
        self.0.face_zones = flanks.zones.to_vec();
        if *flanks.forms != [None, None] {
            self.0.micro_geometry.measured.clone_from(flanks.forms);
        }
        self
    }

    /// The case without the losses besides its mesh; its input still states them.
    pub(crate) fn without_gearbox(mut self) -> Self {
        self.0.gearbox = None;
        self
    }

    /// The case, in which nothing is overridden yet, with `overrides` and the lays of its flanks.
    ///
    /// # Errors
    /// When a value is outside its domain.
    pub(crate) fn overridden(
        &self,
        overrides: Overrides,
        lays: [FlankLay; 2],
    ) -> Result<Self, PositionError> {
        let mut case = self.0.clone();
        overrides.put_into(&mut case.model, lays)?;
        let offsets = case.model.offsets;
        if offsets != self.model.offsets {
            let mut defaults = case.defaults.iter_mut();
            if let Some(used) = defaults.find(|used| used.key == "model.offsets") {
                used.value = offsets.to_string();
            }
        }
        if overrides.as_measured {
            case.running_in = None;
        }
        case.overrides = overrides;
        Ok(Self(case))
    }

    /// The oil at another temperature than the case states.
    pub(crate) fn oil_at(
        &self,
        at: Temperature,
        source: &Source,
    ) -> Result<OilAtTemperature, CaseError> {
        let operation = &self.input.operation;
        let lubricant_at = |error| lubricant_at(source, operation, error);
        let file = self.oil_file.as_deref();
        let stated = self.input.lubricant.stated_at(self.stated_temperature);
        let stated = stated.and_then(|stated| completed_oil(&stated, file));
        let lubricant = stated
            .and_then(|stated| stated.resolve(at))
            .map_err(lubricant_at)?;
        let oil = lubricant.at(at).map_err(lubricant_at)?;
        refuse_stiff_oil(&oil.value, operation, source)?;
        film_oil(
            &lubricant,
            oil,
            (&self.model, (&self.input, file)),
            at,
            source,
        )
    }

    /// Operating point, and numbers of positions and offsets, in words.
    #[must_use]
    pub fn conditions(&self) -> String {
        format!("{}, {}", self.input.operation.in_words(), self.sampling())
    }

    /// Numbers of positions and offsets in words: a run may choose more offsets if the case states none.
    #[must_use]
    pub fn sampling(&self) -> String {
        let least = match self.input.model.offsets {
            Some(_) => "",
            None => "at least ",
        };
        format!(
            "{} positions and {least}{} offsets",
            self.model.positions, self.model.offsets
        )
    }

    /// Inputs of the load over the teeth.
    #[must_use]
    pub fn load_inputs(&self) -> LoadInputs {
        match &self.laws.load_distribution {
            Some(own) => LoadInputs::by_own(own, &self.load_conditions()),
            None => LoadInputs::by_law(&self.model.load_distribution, &self.load_conditions()),
        }
    }

    /// The check of the load over the teeth with the flanks as they are now, by the law that the case names.
    pub(crate) fn load_check(&self) -> LoadCheck {
        let positions = self.formulation.positions();
        load_check(&self.model, positions, &self.load_conditions())
    }

    fn load_conditions(&self) -> LoadConditions<'_> {
        LoadConditions {
            pair: &self.gears,
            torque: self.torque,
            micro: &self.micro_geometry,
            materials: &self.materials,
            settings: &self.load_settings,
        }
    }

    /// Elastic limit of the softer steel.
    #[must_use]
    pub fn elastic_limit(&self) -> Pressure {
        let [pinion, wheel] = self.materials.each_ref().map(|steel| steel.elastic_limit);
        if wheel < pinion { wheel } else { pinion }
    }

    /// The law of pressure besides the one of the run that the curves of the oil file admit, with its probability; `None` if
    /// the curves or the case decide.
    #[must_use]
    pub fn other_law(&self) -> Option<(PressureLaw, f64)> {
        let file = self.oil_file.as_ref()?;
        let other = file.other_law.as_ref()?;
        let is_open = self.input.model.film_pressure_law.is_none();
        is_open.then(|| {
            (
                other.pressure_law,
                file.film_friction.probability_of_other_law(),
            )
        })
    }
}

/// Title of a case without one: cases of other gears have another.
pub(crate) fn title_by_gears(teeth: &[u32], module: Length) -> String {
    let teeth: Vec<String> = teeth.iter().map(u32::to_string).collect();
    format!("untitled, {} teeth, module {module}", teeth.join("/"))
}

/// The oil at the bulk temperature, and the oil in the film if film friction or load share use it. The whole run uses the film
/// thickness that follows from the oil of the film friction.
fn film_oil(
    lubricant: &Lubricant,
    oil: Checked<LubricantState>,
    (model, of_file): (&Model, (&CaseInput, Option<&OilFile>)),
    bulk: Temperature,
    source: &Source,
) -> Result<OilAtTemperature, CaseError> {
    let (state, notes) = (oil.value, oil.outside);
    if model.film_friction.shear_law().is_none() && !model.shears_its_film() {
        without_film_friction(of_file.0, source)?;
        return Ok(OilAtTemperature {
            state,
            rheology: None,
            notes,
        });
    }
    let lubricant_at = |error| lubricant_at(source, &of_file.0.operation, error);
    let rheology = rheology(lubricant, model, bulk, of_file).map_err(lubricant_at)?;
    let of_film = rheology.state(bulk).map_err(lubricant_at)?;
    Ok(OilAtTemperature {
        state: LubricantState {
            pressure_viscosity: of_film.pressure_viscosity,
            thermal_conductivity: of_film.conductivity,
            ..state
        },
        rheology: Some(rheology),
        notes,
    })
}

/// Lists the thermal conductivity of a film with constants of its base oil instead of the one by density.
fn assume_conductivity(
    lubricant: &Lubricant,
    rheology: Option<&FilmRheology>,
    defaults: &mut Defaults,
) {
    if rheology.is_some() && lubricant.given_thermal_conductivity().is_none() {
        defaults.assume_instead(&Assumption {
            key: "thermal_conductivity",
            value: "by the base oil".to_owned(),
            source: "constants of the film",
        });
    }
}

/// Refuses properties of the oil that only film friction with a shear stress uses.
fn without_film_friction(input: &CaseInput, source: &Source) -> Result<(), CaseError> {
    let oil = &input.lubricant;
    let stated = [
        ("oil_file", oil.oil_file.is_some()),
        (
            "pressure_viscosity_factor",
            oil.pressure_viscosity_factor.is_some(),
        ),
        (
            "limiting_shear_temperature",
            oil.limiting_shear_temperature.is_some(),
        ),
    ];
    match stated.into_iter().find(|(_, is_stated)| *is_stated) {
        None => Ok(()),
        Some((key, _)) => {
            let rule = "belongs to film friction by a shear stress, which this model does not have; leave it out";
            Err(Section::new(source, "lubricant").conflict(key, rule))
        }
    }
}

/// The oil in the film: constants of its family, of the oil file or of a calibration, α as stated at the temperature of the case or by Gold.
fn rheology(
    lubricant: &Lubricant,
    model: &Model,
    bulk: Temperature,
    (input, oil_file): (&CaseInput, Option<&OilFile>),
) -> Result<FilmRheology, LubricantError> {
    let family = lubricant
        .base_oil()
        .ok_or_else(LubricantError::no_base_oil)?;
    let mut constants = lubricant.traction_constants(family)?;
    if let Some(file) = oil_file {
        file.set_constants(input, &mut constants);
    }
    let calibration = input.calibration.as_ref();
    if let Some(fitted) = calibration.and_then(|fit| fit.limiting_shear) {
        constants.limiting_shear = fitted.value;
    }
    if let Some(fitted) = calibration.and_then(|fit| fit.eyring_stress) {
        constants.eyring_stress = fitted.value;
    }
    let rheology = FilmRheology::from_lubricant(lubricant, family, constants, bulk)?;
    let shear = model.film_friction.shear_law().unwrap_or_default();
    Ok(rheology.with_laws(shear, model.film_pressure_law))
}

/// Filters of the traces.
fn preparation(
    input: &CaseInput,
    source: &Source,
    defaults: &mut Defaults,
) -> Result<Preparation, CaseError> {
    // The other keys are of the traces.
    let SurfaceInput {
        form,
        cutoff,
        noise_cutoff,
        ends,
        outliers,
        pinion: _,
        wheel: _,
        sun: _,
        planet: _,
        ring: _,
        finish: _,
        contact: _,
        coast: _,
    } = &input.surface;
    let section = Section::new(source, "surface");
    let cutoff = defaults.take("surface.cutoff", *cutoff, LAMBDA_C);
    let noise = defaults.take("surface.noise_cutoff", *noise_cutoff, LAMBDA_S);
    DomainError::non_negative("cut-off", cutoff).map_err(section.domain("cutoff"))?;
    DomainError::non_negative("noise cut-off", noise).map_err(section.domain("noise_cutoff"))?;
    if let Some(deviations) = *outliers {
        let is_positive = deviations > 0.0 && deviations.is_finite();
        DomainError::require(is_positive, "outliers", deviations, "-", "must be positive")
            .map_err(section.domain("outliers"))?;
    }
    let unless_zero = |length: Length| (length.si() > 0.0).then_some(length);
    Ok(Preparation {
        form: defaults.take("surface.form", *form, Form::Level),
        lambda_s: unless_zero(noise),
        lambda_c: unless_zero(cutoff),
        ends: defaults.take("surface.ends", *ends, Ends::Cut),
    })
}

/// Refuses the keys that the formulation of the case does not have; a switch that is off does not count.
fn refuse_keys(
    formulation: FormulationChoice,
    input: &CaseInput,
    source: &Source,
) -> Result<(), CaseError> {
    let refused = formulation.refused_keys();
    if refused.is_empty() {
        return Ok(());
    }
    let stated = serde_json::to_value(input).unwrap_or_default();
    for &(key, rule) in refused {
        let section = Section::new(source, key);
        let error = match stated.pointer(&format!("/{}", key.replace('.', "/"))) {
            None | Some(Value::Null | Value::Bool(false)) => continue,
            Some(Value::Object(_)) => section.conflict_of_key("", rule),
            Some(_) => section.conflict("", rule),
        };
        return Err(in_train(source, error));
    }
    Ok(())
}

fn check_micropitting(input: &CaseInput, source: &Source) -> Result<(), CaseError> {
    let Some(stated) = &input.micropitting else {
        return Ok(());
    };
    let section = Section::new(source, "micropitting");
    let MicropittingInput {
        load_factor,
        permissible,
        ra,
    } = stated;
    for (key, name, value) in [
        ("load_factor", "load factor", load_factor),
        ("permissible", "permissible film", permissible),
    ] {
        let value = value.unwrap_or(1.0);
        let holds = value.is_finite() && value > 0.0;
        let rule = "must be finite and greater than zero";
        DomainError::require(holds, name, value, "-", rule).map_err(section.domain(key))?;
    }
    for ra in ra.iter().flatten() {
        DomainError::positive("Ra", *ra).map_err(section.domain("ra"))?;
    }
    Ok(())
}

/// The temperature that the case states: of the flanks, or of the oil with a law of the bulk temperature.
fn operating_temperature(
    operation: &OperationInput,
    source: &Source,
) -> Result<Temperature, CaseError> {
    let section = Section::new(source, "operation");
    let OperationInput {
        bulk_temperature,
        oil_temperature,
        bulk,
        ..
    } = operation;
    if bulk_temperature.is_some() && oil_temperature.is_some() {
        let rule = "is not used if operation.bulk_temperature is stated; leave one of the two out";
        return Err(section.conflict_of_key("oil_temperature", rule));
    }
    if bulk_temperature.is_some() && bulk.is_some() {
        let rule = "is the law of the bulk temperature, which operation.bulk_temperature states; leave the law out, or state operation.oil_temperature instead of the bulk temperature";
        return Err(section.conflict_of_key("bulk", rule));
    }
    if oil_temperature.is_some() && bulk.is_none() {
        let rule = "needs a law by which the loss heats the flanks above the oil, e.g. the line bulk = { law = \"iso\", lubrication = \"dip\" } under [operation], whose constants are unconfirmed, or \"network\" with the conductances of your gearbox; or state operation.bulk_temperature instead";
        return Err(section.conflict_of_key("oil_temperature", rule));
    }
    operation.stated_temperature().ok_or_else(|| {
        CaseError::value(
            section.place("bulk_temperature"),
            Some(section.table),
            missing_key(section.table, "bulk_temperature"),
        )
    })
}

fn lubricant_at(source: &Source, operation: &OperationInput, error: LubricantError) -> CaseError {
    match error {
        LubricantError::Domain(error) => {
            let key = key_of("lubricant", error.name);
            let key = if TEMPERATURE_KEYS.iter().any(|(name, _)| *name == key) {
                operation.temperature_key().into()
            } else {
                key
            };
            domain(source, key)(error)
        }
        error => {
            let key = match error {
                LubricantError::ImplausiblePressureViscosity { .. } => {
                    "lubricant.pressure_viscosity"
                }
                _ => "lubricant",
            };
            CaseError::lubricant(
                source.place_of_key(key),
                key,
                source.written(key).map(str::to_owned),
                error,
            )
        }
    }
}
