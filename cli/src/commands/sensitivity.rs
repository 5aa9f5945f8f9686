//! `asperity sensitivity`: sensitivity of the loss to single changes.

use asperity::pipeline::KeptFields;
use asperity_studies::sensitivity::{self, CHANGES, Sensitivity};

use super::work::check_work;
use super::{load_train, result_name, study};
use crate::args::{Common, SensitivityArgs};
use crate::failure::Failure;
use crate::output::{Progress, READING, WRITING};

/// `asperity sensitivity`
pub fn sensitivity(args: &SensitivityArgs, common: &Common) -> Result<(), Failure> {
    let progress = Progress::of(common.quiet, READING);
    let loaded = load_train(&args.case, &args.set, None)?;
    check_work(
        &args.work,
        loaded.cases(),
        &KeptFields::Highest,
        1 + CHANGES,
    )?;
    let (name, title) = (result_name(&args.case), &loaded.title);
    let folder = study::folder::<Sensitivity>(args.output.as_deref(), &name, "sensitivity", title)?;
    progress.begin("changes");
    let changes = sensitivity::sensitivity(&loaded, &|done, total| progress.at(done, total))
        .map_err(|error| Failure::about(&args.case, &error))?;
    progress.begin(WRITING);
    study::write(&changes, (), &folder)?;
    drop(progress);
    study::print(&changes, (), Some(&folder), None, common)
}
