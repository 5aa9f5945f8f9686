//! `asperity calibrate`: boundary layer and film traction from a rig table, and the design of measurements.

use std::time::Instant;

use asperity::LoadedCase;
use asperity_calibration::{
    Calibration, Design, Identifiability, Limits, Reach, RigFiles, Watch, before_the_fit, plan,
};
use asperity_core::Code;
use asperity_core::number;
use asperity_report::axis::axis;

use super::{load_case, result_name, study};
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

fn fit(args: &CalibrateArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let (file, case) = (&args.file, args.case.as_deref());
    let mut rig = RigFiles::read(file, case, |path| load_case(path, &args.set, None))?;
    let first = rig.cases.first();
    let title = first.map_or("", |first| &first.case.case.title);
    let name = result_name(file);
    let folder = study::folder::<Calibration>(args.output.as_deref(), &name, "calibration", title)?;
    rig.table.reach = reach(args)?;
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
    let result = rig.calibrate(&args.hold, &watch);
    drop(progress);
    let result = result?;
    study::finish(&result, (), &folder, Some(begin), common)
}

fn design(args: &CalibrateArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    if args.case.is_some() {
        let message = "--design takes only the case; omit the table";
        return Err(Failure::new(Code::E205, message));
    }
    let file = &args.file;
    let case = load_case(file, &args.set, None)?;
    let (name, title) = (result_name(file), &case.case.title);
    let folder = study::folder::<Design>(args.output.as_deref(), &name, "design", title)?;
    let limits = limits(args, &case)?;
    let progress = Progress::of(common.quiet, "evaluations");
    let result = plan(&case, &limits, &args.hold, &|done| progress.count(done));
    drop(progress);
    let result = result?;
    let simulated = args
        .simulate
        .map(|seed| asperity_calibration::design::simulated(&case, &result, seed));
    let simulated = simulated.transpose()?;
    let simulated = simulated.as_deref();
    study::finish(&result, simulated, &folder, Some(begin), common)
}

/// Positive limit of a rig.
fn limit(option: &str, value: Option<f64>) -> Result<Option<f64>, Failure> {
    match value.filter(|value| !(value.is_finite() && *value > 0.0)) {
        Some(value) => Err(Failure::new(
            Code::E209,
            format!("{option} = {}: must be positive", number(value)),
        )),
        None => Ok(value),
    }
}

fn nodes(option: &str, text: Option<&String>) -> Result<Option<Vec<f64>>, Failure> {
    let parsed = text.map(|text| axis(text));
    parsed
        .transpose()
        .map_err(|error| Failure::new(Code::E209, format!("{option}: {error}")))
}

fn reach(args: &CalibrateArgs) -> Result<Reach, Failure> {
    Ok(Reach {
        torque_max_nm: limit("--torque-max", args.torque_max)?,
        speed_max_rpm: limit("--speed-max", args.speed_max)?,
        temperatures_c: nodes("--temperature", args.temperature.as_ref())?,
    })
}

fn limits(args: &CalibrateArgs, case: &LoadedCase) -> Result<Limits, Failure> {
    let usual = Limits::usual(&case.case, reach(args)?);
    Ok(Limits {
        torques_nm: nodes("--torque", args.torque.as_ref())?.unwrap_or(usual.torques_nm),
        speeds_rpm: nodes("--speed", args.speed.as_ref())?.unwrap_or(usual.speeds_rpm),
        hours: args.hours,
        minutes_per_point: args.minutes,
        sigma: args.sigma.value(),
        assemblies: args.assemblies,
        ..usual
    })
}
