//! `asperity compare`: several finishes on one case.

use std::path::Path;

use asperity::case::{CaseInput, LoadedCase, Source};
use asperity::pipeline::KeptFields;
use asperity_studies::compare::{self, Comparison, Finish};

use super::finish::{Traces, check_names};
use super::work::check_work;
use super::{load_pair, result_name, source, study};
use crate::args::{Common, CompareArgs, FinishArg};
use crate::failure::Failure;
use crate::output::{Progress, READING, WRITING};

/// `asperity compare`
pub fn compare(args: &CompareArgs, common: &Common) -> Result<(), Failure> {
    if args.finishes.len() < 2 {
        let message = "--finish: one finish cannot be compared; give at least two";
        return Err(Failure::new("E205", message));
    }
    check_names(&args.finishes)?;
    if let Some(offsets @ ..2) = args.offsets {
        let message = format!("--offsets {offsets}: must be at least 2, as one has no spread");
        return Err(Failure::new("E209", message));
    }
    let progress = Progress::of(common.quiet, READING);
    // Read once for all finishes, since standard input can be read only once.
    let (text, folder) = source(&args.case)?;
    let finishes = args
        .finishes
        .iter()
        .map(|finish| {
            Ok(Finish {
                name: finish.name.clone(),
                case: load(args, (&text, folder), finish)?,
            })
        })
        .collect::<Result<Vec<_>, Failure>>()?;
    if let Some(first) = finishes.first() {
        check_work(
            &args.work,
            &first.case,
            &KeptFields::Highest,
            finishes.len(),
        )?;
    }
    let title = finishes.first().map_or("", |first| &first.case.case.title);
    let name = result_name(&args.case);
    let folder = study::folder::<Comparison>(args.output.as_deref(), &name, "compare", title)?;
    progress.begin("finishes");
    let comparison = compare::compare(&finishes, &|done, total| progress.at(done, total))
        .map_err(|error| Failure::about(&args.case, &error))?;
    progress.begin(WRITING);
    study::write(&comparison, (), &folder)?;
    drop(progress);
    study::print(&comparison, (), Some(&folder), None, common)
}

/// Loads the case with the traces of a finish; a single trace is used for both flanks, mirrored for the wheel.
fn load(
    args: &CompareArgs,
    (text, folder): (&Source, &Path),
    finish: &FinishArg,
) -> Result<LoadedCase, Failure> {
    let (name, traces) = (&finish.name, Traces::of(finish)?);
    let change = |input: &mut CaseInput| {
        traces.put_into(input);
        if args.offsets.is_some() {
            input.model.offsets = args.offsets;
        }
    };
    load_pair(text.clone(), folder, &args.set, &change)
        .map_err(|error| error.adding(&format!(" (--finish {name})")))
}
