//! `asperity calibrate`: boundary layer and film traction from a rig table, and the design of measurements.

use std::time::Instant;

use asperity::LoadedCase;
use asperity::case::CalibratedName;
use asperity_calibration::{
    Calibration, CalibrationError, Design, Identifiability, Limits, RigFiles, Watch,
    before_the_fit, plan,
};
use asperity_studies::map::axis;

use super::{load_case, stem, study};
use crate::args::{CalibrateArgs, Common};
use crate::failure::Failure;
use crate::output::{Progress, print_text};

/// `asperity calibrate`
pub fn calibrate(args: &CalibrateArgs, common: &Common) -> Result<(), Failure> {
    match args.design {
        true => design(args, common),
        false => fit(args, common),
    }
}

impl From<CalibrationError> for Failure {
    fn from(error: CalibrationError) -> Self {
        Self::new(error.code(), error.to_string())
    }
}

fn held(args: &CalibrateArgs) -> Vec<CalibratedName> {
    args.hold.iter().map(|one| one.name()).collect()
}

fn fit(args: &CalibrateArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let (file, case) = (&args.file, args.case.as_deref());
    let folder = study::folder(args.output.as_deref(), stem(file), "calibration");
    study::check_target::<Calibration>(&folder)?;
    let rig = RigFiles::read(file, case, |path| load_case(path, &args.set, None))?;
    let progress = Progress::of(common.quiet, "evaluations");
    let tell = |result: &Identifiability| {
        if !common.json {
            // An error of standard output is reported at the end of the command.
            let _ = print_text(common, &before_the_fit(result));
        }
    };
    let watch = Watch {
        progress: &|done, total| progress.at(done, total),
        before_the_fit: &tell,
    };
    let result = rig.calibrate(&held(args), &watch);
    drop(progress);
    let result = result?;
    study::write(&result, (), &folder)?;
    study::print(&result, (), Some(&folder), Some(begin), common)
}

fn design(args: &CalibrateArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    if args.case.is_some() {
        let message = "--design takes only the case; omit the table";
        return Err(Failure::new("E205", message));
    }
    let file = &args.file;
    let folder = study::folder(args.output.as_deref(), stem(file), "design");
    study::check_target::<Design>(&folder)?;
    let case = load_case(file, &args.set, None)?;
    let limits = limits(args, &case)?;
    let progress = Progress::of(common.quiet, "evaluations");
    let result = plan(&case, &limits, &held(args), &|done| progress.count(done));
    drop(progress);
    let result = result?;
    let simulated = args
        .simulate
        .map(|seed| asperity_calibration::design::simulated(&case, &result, seed));
    let simulated = simulated.transpose()?;
    let simulated = simulated.as_deref();
    study::write(&result, simulated, &folder)?;
    study::print(&result, simulated, Some(&folder), Some(begin), common)
}

fn limits(args: &CalibrateArgs, case: &LoadedCase) -> Result<Limits, Failure> {
    /// Default number of speeds.
    const SPEEDS: usize = 8;
    /// Lowest default speed relative to the highest.
    const SLOWEST: f64 = 0.02;
    let torque = case.case.torque.si();
    let speed = case.case.speed.si() * 30.0 / std::f64::consts::PI;
    let even = |k: usize| speed * SLOWEST.powf(1.0 - k as f64 / (SPEEDS - 1) as f64);
    let of = |option: &str, text: &Option<String>, default: Vec<f64>| match text {
        None => Ok(default),
        Some(text) => {
            axis(text).map_err(|error| Failure::new("E209", format!("{option}: {error}")))
        }
    };
    Ok(Limits {
        torques_nm: of(
            "--torque",
            &args.torque,
            vec![(torque / 3.0).round(), torque],
        )?,
        speeds_rpm: of(
            "--speed",
            &args.speed,
            (0..SPEEDS).map(|k| even(k).round()).collect(),
        )?,
        temperatures_c: of("--temperature", &args.temperature, vec![40.0, 65.0, 90.0])?,
        hours: args.hours,
        minutes_per_point: args.minutes,
        sigma: args.sigma.value(),
        assemblies: args.assemblies,
    })
}
