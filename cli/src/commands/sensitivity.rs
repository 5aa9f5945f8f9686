//! `asperity sensitivity`: sensitivity of the loss to single changes.

use std::path::Path;

use asperity::pipeline::KeptFields;
use asperity_studies::sensitivity::{self, CHANGES};

use super::work::check_work;
use super::{load_case, stem};
use crate::args::{Common, SensitivityArgs};
use crate::failure::Failure;
use crate::output::{Progress, READING, WRITING, print_json, print_text, shown};

/// `asperity sensitivity`
pub fn sensitivity(args: &SensitivityArgs, common: &Common) -> Result<(), Failure> {
    let progress = Progress::of(common.quiet, READING);
    let loaded = load_case(&args.case, &args.set, None)?;
    check_work(&args.work, &loaded, &KeptFields::Highest, 1 + CHANGES)?;
    let folder = args.output.clone().unwrap_or_else(|| {
        let stem = stem(&args.case).to_string_lossy();
        Path::new("results").join(format!("{stem}-sensitivity"))
    });
    // Checked before the computation.
    sensitivity::check_place(&folder).map_err(|error| Failure::new("E401", error.to_string()))?;
    progress.begin("changes");
    let study = sensitivity::sensitivity(&loaded, &|done, total| progress.at(done, total))
        .map_err(|error| Failure::about(&args.case, &error))?;
    progress.begin(WRITING);
    sensitivity::write(&study, &folder).map_err(|error| Failure::new("E401", error.to_string()))?;
    drop(progress);
    if common.json {
        return print_json(&study);
    }
    let text = sensitivity::summary(&study);
    print_text(common, &format!("{text}wrote {}\n", shown(&folder)))
}
