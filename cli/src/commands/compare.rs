//! `asperity compare`: several finishes on one case.

use asperity::case::CaseInput;
use asperity::pipeline::KeptFields;
use asperity_core::Code;
use asperity_studies::compare::{self, CompareSettings, Comparison};

use super::finish::{self, check_names};
use super::study::of_option;
use super::work::check_work;
use super::{result_name, study};
use crate::args::{Common, CompareArgs};
use crate::failure::Failure;
use crate::output::{Progress, READING, WRITING};

/// `asperity compare`
pub fn compare(args: &CompareArgs, common: &Common) -> Result<(), Failure> {
    if args.finishes.len() < 2 {
        return Err(single());
    }
    check_names(&args.finishes)?;
    let settings = &args.settings;
    settings.check().map_err(of_option::<CompareSettings>)?;
    let progress = Progress::of(common.quiet, READING);
    let change = |input: &mut CaseInput| {
        if settings.offsets.is_some() {
            input.model.offsets = settings.offsets;
        }
    };
    let finishes = finish::finishes(&args.case, &args.set, &args.finishes, &change)?;
    if finishes.len() < 2 {
        return Err(single());
    }
    if let Some(first) = finishes.first() {
        let kept = KeptFields::Highest;
        check_work(&args.work, first.case.cases(), &kept, finishes.len())?;
    }
    let title = finishes.first().map_or("", |first| &first.case.title);
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

fn single() -> Failure {
    let message = "--finish: one finish cannot be compared; give at least two";
    Failure::new(Code::E205, message)
}
