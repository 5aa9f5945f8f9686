//! `asperity calibrate`: boundary layer and film traction from a rig's table, and the points to measure.

use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity::LoadedCase;
use asperity::case::CalibratedName;
use asperity_calibration::{
    CalibrationError, Identifiability, Limits, RigCase, RigTable, Watch, before_the_fit,
    check_place, design_summary, plan, summary, write, write_design,
};
use asperity_studies::map::axis;

use super::{load_case, stem};
use crate::args::{CalibrateArgs, Common};
use crate::failure::Failure;
use crate::output::{PATIENCE, print_json, print_text, progress};

/// `asperity calibrate`
pub fn calibrate(args: &CalibrateArgs, common: &Common) -> Result<(), Failure> {
    match args.design {
        true => design(args, common),
        false => fit(args, common),
    }
}

fn failed(error: &CalibrationError) -> Failure {
    Failure::new(error.code(), error.to_string())
}

fn held(args: &CalibrateArgs) -> Vec<CalibratedName> {
    args.hold.iter().map(|one| one.name()).collect()
}

fn fit(args: &CalibrateArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let [file, rest @ ..] = args.files.as_slice() else {
        return Err(Failure::new("E501", "a calibration without a table"));
    };
    let text = std::fs::read_to_string(file)
        .map_err(|error| Failure::new("E103", format!("{}: {error}", file.display())))?;
    let table =
        RigTable::read(&file.display().to_string(), &text).map_err(|error| failed(&error))?;
    let folder = folder(args, stem(file), "calibration");
    place_is_free(&folder)?;
    let cases = cases(args, file, &table, rest.first())?;
    let bar = progress(common.quiet);
    bar.set_message("evaluations");
    let tell = |found: &Identifiability| {
        if !common.json {
            // A reader that has gone away is told by the end of the command.
            let _ = print_text(common, &before_the_fit(found));
        }
    };
    let watch = Watch {
        progress: &|done, total| {
            if begin.elapsed() >= PATIENCE {
                bar.set_length(total as u64);
                bar.set_position(done as u64);
            }
        },
        before_the_fit: &tell,
    };
    let found = asperity_calibration::calibrate(table, &text, &cases, &held(args), &watch);
    bar.finish_and_clear();
    let found = found.map_err(|error| failed(&error))?;
    write(&found, &folder).map_err(|error| Failure::new("E401", error.to_string()))?;
    if common.json {
        return print_json(&found);
    }
    finish(common, summary(&found), &folder, begin)
}

/// The cases that the rows of a table name, relative to it, and the one beside it.
fn cases(
    args: &CalibrateArgs,
    file: &Path,
    table: &RigTable,
    beside: Option<&PathBuf>,
) -> Result<Vec<RigCase>, Failure> {
    let names = table.case_names();
    let mut found = Vec::with_capacity(names.len());
    for name in names {
        let path = match (&name, beside) {
            (Some(name), _) => file.parent().unwrap_or(Path::new(".")).join(name),
            (None, Some(path)) => path.clone(),
            (None, None) => {
                let file = file.display().to_string();
                return Err(failed(&CalibrationError::NoCase { file }));
            }
        };
        let case = load_case(&path, &args.set, None)?;
        found.push(RigCase { name, case });
    }
    Ok(found)
}

fn design(args: &CalibrateArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let [file] = args.files.as_slice() else {
        let message = "--design takes the case alone; leave the table out";
        return Err(Failure::new("E205", message));
    };
    let folder = folder(args, stem(file), "design");
    place_is_free(&folder)?;
    let case = load_case(file, &args.set, None)?;
    let limits = limits(args, &case)?;
    let bar = progress(common.quiet);
    bar.set_message("evaluations");
    let found = plan(&case, &limits, &held(args), &|done| {
        if begin.elapsed() >= PATIENCE {
            bar.set_position(done as u64);
        }
    });
    bar.finish_and_clear();
    let found = found.map_err(|error| failed(&error))?;
    let simulated = args
        .simulate
        .map(|seed| asperity_calibration::design::simulated(&case, &found, seed));
    let simulated = simulated.transpose().map_err(|error| failed(&error))?;
    write_design(&found, simulated.as_deref(), &folder)
        .map_err(|error| Failure::new("E401", error.to_string()))?;
    if common.json {
        return print_json(&found);
    }
    let mut text = design_summary(&found);
    if simulated.is_some() {
        text.push_str("simulated.csv holds SIMULATED losses at these points\n");
    }
    finish(common, text, &folder, begin)
}

fn limits(args: &CalibrateArgs, case: &LoadedCase) -> Result<Limits, Failure> {
    /// Speeds where none are given, and the part of the largest that they begin at.
    const SPEEDS: usize = 8;
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

/// Told before the work, not after it.
fn place_is_free(folder: &Path) -> Result<(), Failure> {
    check_place(folder).map_err(|error| Failure::new("E401", error.to_string()))
}

fn finish(common: &Common, mut text: String, folder: &Path, begin: Instant) -> Result<(), Failure> {
    let seconds = begin.elapsed().as_secs_f64();
    text.push_str(&format!("wrote {} in {seconds:.1} s\n", folder.display()));
    print_text(common, &text)
}
