//! `asperity oil`: oils of the library, traction of the film between ball and disc, and the constants behind it.

use std::ffi::OsString;
use std::path::Path;
use std::time::Instant;

use asperity::fingerprint::sha256;
use asperity::tribo_friction::boundary::BOUNDARY_FRICTION;
use asperity_calibration::oil::fit::PointErrors;
use asperity_calibration::oil::problem::Zero;
use asperity_calibration::oil::{
    FitSettings, Machine, OilBase, OilError, OilFit, Probe, Reading, TractionCurves, TractionRange,
    is_pcs, read_pcs, read_table,
};
use asperity_calibration::table_text;
use asperity_core::DomainError;
use asperity_core::quantity::Temperature;
use asperity_studies::map::axis;

use super::oils::{named, oils};
use super::{load_case, result_name, study};
use crate::args::{
    Common, OilCommand, OilFitArgs, OilTractionArgs, PresetArgs, SetArgs, TemperatureColumnArg,
    ZeroArg,
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
    }
}

impl From<OilError> for Failure {
    fn from(error: OilError) -> Self {
        Self::new(error.code(), error.to_string())
    }
}

/// The oil of a case file or of the library, with the name of its results.
fn base(oil: &str, set: &SetArgs) -> Result<(OilBase, OsString), Failure> {
    let path = Path::new(oil);
    let is_file = path.extension().is_some() || path.exists();
    if is_file {
        let loaded = load_case(path, set, None)?;
        return Ok((OilBase::of_case(&loaded.case)?, result_name(path)));
    }
    let name = named(oil)?.name;
    Ok((OilBase::of_library(&name)?, OsString::from(name)))
}

fn traction(args: &OilTractionArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let refused = |error: DomainError| Failure::new("E209", error.to_string());
    let (oil, name) = base(&args.oil, &args.set)?;
    let title = format!("Traction of {}", oil.name);
    let output = args.output.as_deref();
    let folder = study::folder::<TractionCurves>(output, &name, "traction", &title)?;
    let temperatures = axis(&args.temperature)
        .map_err(|error| Failure::new("E209", format!("--temperature: {error}")))?;
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
        machine: Machine::ball_on_disc(args.ball_radius, args.second_radius, args.rq)
            .map_err(refused)?,
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
    study::write(&curves, (), &folder)?;
    study::print(&curves, (), Some(&folder), Some(begin), common)
}

/// Readings of a file, and its SHA-256.
fn readings(
    path: &Path,
    machine: &Machine,
    probe: Probe,
) -> Result<(Vec<Reading>, [String; 2]), Failure> {
    let name = path.display().to_string();
    let text = table_text(path).map_err(OilError::Table)?;
    let readings = match is_pcs(&text) {
        true => read_pcs(&name, &text, machine, probe)?,
        false => read_table(&name, &text, machine).map_err(OilError::Table)?,
    };
    Ok((readings, [name, sha256(text.as_bytes())]))
}

fn fit(args: &OilFitArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let refused = |error: DomainError| Failure::new("E209", error.to_string());
    let (oil, _) = base(&args.oil, &args.set)?;
    let Some(first) = args.files.first() else {
        return Err(Failure::new("E205", "name a file of traction curves"));
    };
    let title = format!("Oil constants of {}", oil.name);
    let name = result_name(first);
    let folder = study::folder::<OilFit>(args.output.as_deref(), &name, "oil", &title)?;
    let machine = Machine::ball_on_disc(args.ball_radius, args.second_radius, args.rq);
    let machine = machine.map_err(refused)?;
    let probe = match args.temperature_column {
        TemperatureColumnArg::Lube => Probe::Lube,
        TemperatureColumnArg::Pot => Probe::Pot,
    };
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
    let (mut all, mut sources) = (Vec::new(), Vec::new());
    for path in &args.files {
        let (readings, source) = readings(path, &machine, probe)?;
        all.extend(readings);
        sources.push(source);
    }
    let settings = FitSettings {
        is_wide: args.wide,
        zero: match args.zero {
            ZeroArg::Curve => Zero::Curve,
            ZeroArg::Common => Zero::Common,
            ZeroArg::None => Zero::None,
        },
        errors,
        is_forced: args.force,
    };
    let found = OilFit::of(&oil, &all, sources, settings)?;
    study::write(&found, (), &folder)?;
    study::print(&found, (), Some(&folder), Some(begin), common)
}
