//! `asperity calibrate`: boundary layer and film traction from a rig table, and the design of measurements.

use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity::LoadedCase;
use asperity::case::CalibratedName;
use asperity_calibration::{
    CalibrationError, Identifiability, Limits, RigFiles, Watch, before_the_fit, check_place,
    design_summary, plan, summary, write, write_design,
};
use asperity_studies::map::axis;

use super::{load_case, stem};
use crate::args::{CalibrateArgs, Common};
use crate::failure::Failure;
use crate::output::{Progress, print_json, print_text, shown};

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
    let folder = folder(args, stem(file), "calibration");
    check_target(&folder)?;
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
    write(&result, &folder).map_err(|error| Failure::new("E401", error.to_string()))?;
    if common.json {
        return print_json(&result);
    }
    finish(common, summary(&result), &folder, begin)
}

fn design(args: &CalibrateArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    if args.case.is_some() {
        let message = "--design takes only the case; omit the table";
        return Err(Failure::new("E205", message));
    }
    let file = &args.file;
    let folder = folder(args, stem(file), "design");
    check_target(&folder)?;
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
    write_design(&result, simulated.as_deref(), &folder)
        .map_err(|error| Failure::new("E401", error.to_string()))?;
    if common.json {
        return print_json(&result);
    }
    let mut text = design_summary(&result);
    if simulated.is_some() {
        text.push_str("simulated.csv holds SIMULATED losses at these points\n");
    }
    finish(common, text, &folder, begin)
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

fn folder(args: &CalibrateArgs, name: &std::ffi::OsStr, kind: &str) -> PathBuf {
    let default = || Path::new("results").join(format!("{}-{kind}", name.to_string_lossy()));
    args.output.clone().unwrap_or_else(default)
}

/// Checks the target before the computation.
fn check_target(folder: &Path) -> Result<(), Failure> {
    check_place(folder).map_err(|error| Failure::new("E401", error.to_string()))
}

fn finish(common: &Common, mut text: String, folder: &Path, begin: Instant) -> Result<(), Failure> {
    let seconds = begin.elapsed().as_secs_f64();
    text.push_str(&format!("wrote {} in {seconds:.1} s\n", shown(folder)));
    print_text(common, &text)
}
