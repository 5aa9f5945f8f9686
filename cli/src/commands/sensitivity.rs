//! `asperity sensitivity`: what the loss does when one thing changes.

use std::path::Path;
use std::time::Instant;

use asperity::kept_fields::KeptFields;
use asperity_studies::sensitivity::{self, CHANGES};

use super::work::check_work;
use super::{load_case, stem};
use crate::args::{Common, SensitivityArgs};
use crate::failure::Failure;
use crate::output::{PATIENCE, print_json, print_text, progress, shown};

/// `asperity sensitivity`
pub fn sensitivity(args: &SensitivityArgs, common: &Common) -> Result<(), Failure> {
    let loaded = load_case(&args.case, &args.set, None)?;
    check_work(&args.work, &loaded, &KeptFields::Highest, 1 + CHANGES)?;
    let folder = args.output.clone().unwrap_or_else(|| {
        let stem = stem(&args.case).to_string_lossy();
        Path::new("results").join(format!("{stem}-sensitivity"))
    });
    // Told before the work, not after it.
    sensitivity::check_place(&folder).map_err(|error| Failure::new("E401", error.to_string()))?;
    let begin = Instant::now();
    let bar = progress(common.quiet);
    bar.set_message("changes");
    let found = sensitivity::sensitivity(&loaded, &|done, total| {
        if begin.elapsed() >= PATIENCE {
            bar.set_length(total as u64);
            bar.set_position(done as u64);
        }
    });
    bar.finish_and_clear();
    let found = found.map_err(|error| Failure::about(&args.case, &error))?;
    sensitivity::write(&found, &folder).map_err(|error| Failure::new("E401", error.to_string()))?;
    if common.json {
        return print_json(&found);
    }
    let text = sensitivity::summary(&found);
    print_text(common, &format!("{text}wrote {}\n", shown(&folder)))
}
