//! `asperity oil`: oils of the library, and traction of the film between ball and disc.

use std::ffi::OsString;
use std::path::Path;
use std::time::Instant;

use asperity::tribo_friction::boundary::BOUNDARY_FRICTION;
use asperity_calibration::oil::{Machine, OilBase, OilError, TractionCurves, TractionRange};
use asperity_core::DomainError;
use asperity_core::quantity::Temperature;
use asperity_studies::map::axis;

use super::oils::{named, oils};
use super::{load_case, result_name, study};
use crate::args::{Common, OilCommand, OilTractionArgs, PresetArgs, SetArgs};
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
