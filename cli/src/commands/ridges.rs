//! `asperity ridges`: ridges of both flanks that cost most.

use asperity::pipeline::KeptFields;
use asperity_studies::ridges::{self, RidgeStudy};

use super::work::check_work;
use super::{load_case, result_name, study};
use crate::args::{Common, RidgesArgs};
use crate::failure::Failure;
use crate::output::{Progress, READING, WRITING};

/// Runs whose time a study takes: three with exact contacts, the gradient of each, draws of two, and two gradients at the ends of
/// the lay.
pub(super) const RUNS: usize = 10;

/// Counted work of a study.
pub(super) const GRADIENTS: &str = "gradients";

/// `asperity ridges`
pub fn ridges(args: &RidgesArgs, common: &Common) -> Result<(), Failure> {
    let progress = Progress::of(common.quiet, READING);
    let loaded = load_case(&args.case, &args.set, None)?;
    check_work(&args.work, [&loaded], &KeptFields::Highest, RUNS)?;
    let (name, title) = (result_name(&args.case), &loaded.case.title);
    let folder = study::folder::<RidgeStudy>(args.output.as_deref(), &name, "ridges", title)?;
    progress.begin(GRADIENTS);
    let found = ridges::ridges(&loaded, &|done, total| progress.at(done, total))
        .map_err(|error| Failure::about(&args.case, &error))?;
    progress.begin(WRITING);
    study::write(&found, (), &folder)?;
    drop(progress);
    study::print(&found, (), Some(&folder), None, common)
}
