//! Target and output of a study.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity_report::StudyResult;

use crate::args::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text, shown};

/// Folder of a study: `output`, or by default `results/NAME-KIND`.
pub fn folder(output: Option<&Path>, name: &OsStr, kind: &str) -> PathBuf {
    let default = || Path::new("results").join(format!("{}-{kind}", name.to_string_lossy()));
    output.map_or_else(default, Path::to_owned)
}

/// Checks, before the computation, that the study may be written as `folder`.
pub fn check_target<S: StudyResult>(folder: &Path) -> Result<(), Failure> {
    Ok(S::check_target(folder)?)
}

/// Writes a study as `folder`.
pub fn write<S: StudyResult>(
    study: &S,
    context: S::Context<'_>,
    folder: &Path,
) -> Result<(), Failure> {
    let written = study.write(context, folder);
    Ok(written?)
}

/// Prints a study and, if it was written, its folder, with the time since `begin`.
pub fn print<S: StudyResult>(
    study: &S,
    context: S::Context<'_>,
    folder: Option<&Path>,
    begin: Option<Instant>,
    common: &Common,
) -> Result<(), Failure> {
    if common.json {
        return print_json(study);
    }
    let mut text = study.summary(context);
    if let Some(folder) = folder {
        let time = begin.map_or(String::new(), |begin| {
            format!(" in {:.1} s", begin.elapsed().as_secs_f64())
        });
        text.push_str(&format!("wrote {}{time}\n", shown(folder)));
    }
    print_text(common, &text)
}
