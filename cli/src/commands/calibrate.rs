//! `asperity calibrate`: boundary layer and film traction from a rig table, and the design of measurements.

use std::time::Instant;

use asperity_calibration::{
    Calibration, Design, DesignSettings, Identifiability, RigFiles, Watch, before_the_fit, plan,
};
use asperity_core::Code;

use super::study::of_option;
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
    let settings = &args.settings.rig;
    rig.table.reach = settings.reach().map_err(of_option::<DesignSettings>)?;
    let progress = Progress::of(common.quiet, "evaluations");
    let tell = |result: &Identifiability| {
        if common.notes && !common.json {
            // An error of standard output is reported at the end of the command.
            let _ = print_text(common, &before_the_fit(result));
        }
    };
    let watch = Watch {
        progress: &|done, total| progress.at(done, total),
        before_the_fit: &tell,
    };
    let result = rig.calibrate(&settings.hold, &watch);
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
    let settings = &args.settings;
    let limits = settings.limits(&case.case);
    let limits = limits.map_err(of_option::<DesignSettings>)?;
    let progress = Progress::of(common.quiet, "evaluations");
    let result = plan(&case, &limits, &settings.rig.hold, &|done| {
        progress.count(done)
    });
    drop(progress);
    let result = result?;
    let simulated = settings
        .simulate
        .map(|seed| asperity_calibration::design::simulated(&case, &result, seed));
    let simulated = simulated.transpose()?;
    let simulated = simulated.as_deref();
    study::finish(&result, simulated, &folder, Some(begin), common)
}
