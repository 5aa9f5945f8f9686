//! `asperity oil`: oils of the library, traction of the film between ball and disc, and the constants behind it.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity::LoadedCase;
use asperity::case::{OilFile, open_source};
use asperity::tribo_friction::boundary::BOUNDARY_FRICTION;
use asperity_calibration::oil::fit::PointErrors;
use asperity_calibration::oil::problem::Zero;
use asperity_calibration::oil::{
    ConstantsOf, FitSettings, Machine, OilBase, OilFit, OilPlan, PlanSettings, Probe, Readings,
    Stribeck, TractionCurves, TractionRange,
};
use asperity_calibration::table_text;
use asperity_core::quantity::Temperature;
use asperity_core::{Code, DomainError};
use asperity_report::library::oil_named;
use asperity_studies::map::axis;

use super::oils::oils;
use super::{load_case, result_name, study};
use crate::args::{
    Common, ErrorArgs, OilCommand, OilFitArgs, OilPlanArgs, OilStribeckArgs, OilTractionArgs,
    PresetArgs, SetArgs, SpecimenArgs, TemperatureColumnArg, ZeroArg,
};
use crate::failure::Failure;

/// `asperity oil`
pub fn oil(command: &OilCommand, common: &Common) -> Result<(), Failure> {
    match command {
        OilCommand::List => oils(&PresetArgs { name: None }, common),
        OilCommand::Show { name } => {
            let name = Some(name.clone());
            oils(&PresetArgs { name }, common)
        }
        OilCommand::Traction(args) => traction(args, common),
        OilCommand::Fit(args) => fit(args, common),
        OilCommand::Plan(args) => plan(args, common),
        OilCommand::Stribeck(args) => stribeck(args, common),
    }
}

/// An oil with the name of its results, and its case if it is the oil of one.
struct NamedOil {
    oil: OilBase,
    name: OsString,
    case: Option<LoadedCase>,
}

/// The oil of a case file, of an oil file, of a data sheet or of the library.
fn base(oil: &str, set: &SetArgs, constants: ConstantsOf) -> Result<NamedOil, Failure> {
    let path = Path::new(oil);
    let is_file = path.extension().is_some() || path.exists();
    if is_file {
        let name = result_name(path);
        let source = open_source(path).map_err(|error| Failure::of(&error))?;
        if OilFile::is_one(&source) {
            let file = OilFile::of_source(&source);
            let file = file.map_err(|error| Failure::of(&error.into()))?;
            return Ok(NamedOil {
                oil: OilBase::of_file(&name.to_string_lossy(), &file, constants)?,
                name,
                case: None,
            });
        }
        let sheet = OilFile::data_sheet(&source).map_err(|error| Failure::of(&error.into()))?;
        if let Some(sheet) = sheet {
            return Ok(NamedOil {
                oil: OilBase::of_lubricant(&name.to_string_lossy(), sheet)?,
                name,
                case: None,
            });
        }
        let loaded = load_case(path, set, None)?;
        return Ok(NamedOil {
            oil: OilBase::of_case(&loaded.case, constants)?,
            name,
            case: Some(loaded),
        });
    }
    let name = oil_named(oil)?.name;
    Ok(NamedOil {
        oil: OilBase::of_library(&name)?,
        name: OsString::from(name),
        case: None,
    })
}

/// Rejects keys of a case and the name of a mesh where no case is given.
fn refuse_keys(set: &SetArgs, case: Option<&LoadedCase>) -> Result<(), Failure> {
    match case.is_none() && (!set.keys.is_empty() || set.mesh.is_some()) {
        true => Err(Failure::new(
            Code::E205,
            "--set and --mesh change a case, and the oil is not of one",
        )),
        false => Ok(()),
    }
}

fn refused(error: DomainError) -> Failure {
    Failure::new(Code::E209, error.to_string())
}

fn machine(of: &SpecimenArgs) -> Result<Machine, Failure> {
    Machine::ball_on_disc(of.ball_radius, of.second_radius, of.rq).map_err(refused)
}

/// Zeros and errors of the points.
fn errors(args: &ErrorArgs) -> Result<(Zero, PointErrors), Failure> {
    let errors = PointErrors {
        relative: args.point_sd.value(),
        floor: args.point_floor,
    };
    for (option, value) in [
        ("--point-sd", errors.relative),
        ("--point-floor", errors.floor),
    ] {
        let rule = "must be positive and below 1";
        DomainError::require(value > 0.0 && value < 1.0, option, value, "-", rule)
            .map_err(refused)?;
    }
    let zero = match args.zero {
        ZeroArg::Curve => Zero::Curve,
        ZeroArg::Common => Zero::Common,
        ZeroArg::None => Zero::None,
    };
    Ok((zero, errors))
}

fn plan(args: &OilPlanArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let NamedOil { oil, name, case } = base(&args.oil, &args.set, ConstantsOf::Family)?;
    let title = format!("Traction plan of {}", oil.name);
    let output = args.output.as_deref();
    let folder = study::folder::<OilPlan>(output, &name, "plan", &title)?;
    let case = match &args.case {
        Some(path) => Some(load_case(path, &args.set, None)?),
        None => case,
    };
    refuse_keys(&args.set, case.as_ref())?;
    let (zero, errors) = errors(&args.errors)?;
    let settings = PlanSettings {
        machine: machine(&args.specimens)?,
        is_wide: args.errors.wide,
        zero,
        errors,
        simulate: args.simulate,
    };
    let plan = OilPlan::of(&oil, case.as_ref(), &settings)?;
    study::finish(&plan, (), &folder, Some(begin), common)
}

fn stribeck(args: &OilStribeckArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let NamedOil { oil, case, .. } = base(&args.oil, &args.set, ConstantsOf::Family)?;
    refuse_keys(&args.set, case.as_ref())?;
    let title = format!("Boundary friction of {}", oil.name);
    let name = args.files.first().map(|first| result_name(first));
    let name = name.unwrap_or_default();
    let folder = study::folder::<Stribeck>(args.output.as_deref(), &name, "stribeck", &title)?;
    if !args.rubbing.is_empty() && args.rubbing.len() != args.files.len() {
        let rule = "--rubbing takes one time for each file";
        return Err(Failure::new(Code::E205, rule));
    }
    if let Some(time) = args.rubbing.iter().find(|time| time.si() < 0.0) {
        let refusal =
            DomainError::require(false, "--rubbing", time.si(), "s", "must not be negative");
        refusal.map_err(refused)?;
    }
    let machine = machine(&args.specimens)?;
    let mut readings = all_readings(&args.files, &machine, args.temperature_column)?;
    for reading in &mut readings.all {
        let file = args
            .files
            .iter()
            .position(|file| file.display().to_string() == reading.file);
        let time = file.and_then(|k| args.rubbing.get(k));
        reading.rubbing_s = reading.rubbing_s.or(time.map(|time| time.si()));
    }
    let found = Stribeck::of(&oil, readings)?;
    study::finish(&found, (), &folder, Some(begin), common)
}

fn traction(args: &OilTractionArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let NamedOil { oil, name, case } = base(&args.oil, &args.set, ConstantsOf::File)?;
    refuse_keys(&args.set, case.as_ref())?;
    let title = format!("Traction of {}", oil.name);
    let output = args.output.as_deref();
    let folder = study::folder::<TractionCurves>(output, &name, "traction", &title)?;
    let temperatures = axis(&args.temperature)
        .map_err(|error| Failure::new(Code::E209, format!("--temperature: {error}")))?;
    let boundary_friction = args.boundary_friction.unwrap_or(BOUNDARY_FRICTION);
    let is_valid = boundary_friction > 0.0 && boundary_friction < 1.0;
    let rule = "must lie between 0 and 1";
    DomainError::require(
        is_valid,
        "--boundary-friction",
        boundary_friction,
        "-",
        rule,
    )
    .map_err(refused)?;
    let range = TractionRange {
        machine: machine(&args.specimens)?,
        load: args.load,
        mean_speed: args.speed,
        slide_to_roll: args.slide_to_roll.value(),
        temperatures: temperatures
            .into_iter()
            .map(Temperature::from_celsius)
            .collect(),
        boundary_friction,
    };
    let curves = TractionCurves::of(&oil, &range)?;
    study::finish(&curves, (), &folder, Some(begin), common)
}

/// Readings of files.
fn all_readings(
    files: &[PathBuf],
    machine: &Machine,
    column: TemperatureColumnArg,
) -> Result<Readings, Failure> {
    let probe = match column {
        TemperatureColumnArg::Lube => Probe::Lube,
        TemperatureColumnArg::Pot => Probe::Pot,
    };
    let mut readings = Readings::default();
    for path in files {
        let name = path.display().to_string();
        let text = table_text(path).map_err(asperity_calibration::oil::error::of_table)?;
        readings.append(Readings::read(&name, &text, machine, probe)?);
    }
    Ok(readings)
}

fn fit(args: &OilFitArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let NamedOil { oil, case, .. } = base(&args.oil, &args.set, ConstantsOf::Family)?;
    refuse_keys(&args.set, case.as_ref())?;
    let Some(first) = args.files.first() else {
        return Err(Failure::new(Code::E205, "name a file of traction curves"));
    };
    let title = format!("Oil constants of {}", oil.name);
    let name = result_name(first);
    let folder = study::folder::<OilFit>(args.output.as_deref(), &name, "oil", &title)?;
    let machine = machine(&args.specimens)?;
    let (zero, errors) = errors(&args.errors)?;
    let readings = all_readings(&args.files, &machine, args.temperature_column)?;
    let settings = FitSettings {
        is_wide: args.errors.wide,
        zero,
        errors,
        is_forced: args.force,
    };
    let found = OilFit::of(&oil, readings, settings)?;
    study::finish(&found, (), &folder, Some(begin), common)
}
