//! `asperity callout`: limit of a roughness parameter for a stated loss.

use asperity::core::quantity::Ratio;
use asperity::pipeline::KeptFields;
use asperity_studies::callout::{self, CallOut, CallOutSettings};

use super::work::check_work;
use super::{load_case, result_name, study};
use crate::args::{CalloutArgs, Common};
use crate::failure::Failure;
use crate::output::{Progress, READING, WRITING};

/// `asperity callout`
pub fn callout(args: &CalloutArgs, common: &Common) -> Result<(), Failure> {
    let progress = Progress::of(common.quiet, READING);
    let loaded = load_case(&args.case, &args.set, None)?;
    let settings = CallOutSettings {
        loss: args.loss,
        confidence: args.confidence.value(),
        scatter: args.scatter.value(),
        parameter: args.parameter,
        traces: args.traces,
        lots: args.lots,
        seed: args.seed,
    };
    let [pairs, offsets] = settings.work();
    let mut pair = loaded.first_pair();
    pair.case.model.offsets = offsets;
    check_work(&args.work, [&pair], &KeptFields::Highest, pairs)?;
    let (name, title) = (result_name(&args.case), &loaded.case.title);
    let folder = study::folder::<CallOut>(args.output.as_deref(), &name, "callout", title)?;
    progress.begin("lots");
    let found = callout::callout(&loaded, &settings, &|done, total| progress.at(done, total));
    let shares = [args.confidence, args.scatter].map(Ratio::value);
    let found = found.map_err(|error| {
        let error = error.about(args.case.display());
        match shares.iter().any(|share| *share > 1.0) {
            true => error.helping("A share without % is a fraction: write 0.9 or \"90 %\"."),
            false => error,
        }
    })?;
    progress.begin(WRITING);
    study::write(&found, (), &folder)?;
    drop(progress);
    study::print(&found, (), Some(&folder), None, common)
}
