//! `asperity compare`: several finishes on one case.

use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity::case::{self, CaseInput, FlankInput, LoadedCase, Source};
use asperity::kept_fields::KeptFields;
use asperity_studies::compare::{self, Finish};

use super::work::check_work;
use super::{keys, pair_only, source, stem};
use crate::args::{Common, CompareArgs, FinishArg};
use crate::failure::Failure;
use crate::output::{PATIENCE, print_json, print_text, progress};

/// `asperity compare`
pub fn compare(args: &CompareArgs, common: &Common) -> Result<(), Failure> {
    if args.finishes.len() < 2 {
        let message = "--finish: one finish cannot be compared; give at least two";
        return Err(Failure::new("E205", message));
    }
    for (index, finish) in args.finishes.iter().enumerate() {
        let before = &args.finishes[..index];
        if before.iter().any(|other| other.name == finish.name) {
            let name = &finish.name;
            let message = format!("--finish {name}: two finishes have this name; rename one");
            return Err(Failure::new("E205", message));
        }
    }
    if args.offsets < 2 {
        let offsets = args.offsets;
        let message = format!("--offsets {offsets}: must be at least 2, as one has no spread");
        return Err(Failure::new("E209", message));
    }
    // Once for all finishes: standard input is read but once.
    let (text, folder) = source(&args.case)?;
    pair_only(&text)?;
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
    let folder = args.output.clone().unwrap_or_else(|| {
        let stem = stem(&args.case).to_string_lossy();
        Path::new("results").join(format!("{stem}-compare"))
    });
    // Told before the work, not after it.
    compare::check_place(&folder).map_err(|error| Failure::new("E401", error.to_string()))?;
    let begin = Instant::now();
    let bar = progress(common.quiet);
    bar.set_message("finishes");
    let found = compare::compare(&finishes, &|done, total| {
        if begin.elapsed() >= PATIENCE {
            bar.set_length(total as u64);
            bar.set_position(done as u64);
        }
    });
    bar.finish_and_clear();
    let found = found.map_err(|error| Failure::about(&args.case, &error))?;
    compare::write(&found, &folder).map_err(|error| Failure::new("E401", error.to_string()))?;
    if common.json {
        return print_json(&found);
    }
    let text = compare::summary(&found);
    print_text(common, &format!("{text}wrote {}\n", folder.display()))
}

/// The case with the traces of a finish; a single one serves both flanks, mirrored for the wheel.
fn load(
    args: &CompareArgs,
    (text, folder): (&Source, &Path),
    finish: &FinishArg,
) -> Result<LoadedCase, Failure> {
    let name = &finish.name;
    let whole = |file: &PathBuf| {
        // Told here: the case does not name this file.
        if !file.is_file() {
            let message = format!(
                "{}: there is no such file (named by --finish {name})",
                file.display()
            );
            return Err(Failure::new("E103", message));
        }
        std::path::absolute(file)
            .map_err(|error| Failure::new("E103", format!("{}: {error}", file.display())))
    };
    let pinion = whole(&finish.pinion)?;
    let wheel = finish.wheel.as_ref().map(whole).transpose()?;
    let change = |input: &mut CaseInput| {
        let surface = &mut input.surface;
        // How the files of the case are read holds for those of the finish; values of a flank without a file
        // do not.
        let on_file = |given: &FlankInput, file: &Path| FlankInput {
            file: Some(file.to_owned()),
            rq: None,
            ra: None,
            rz: None,
            rpk: None,
            asperity_radius: None,
            ..given.clone()
        };
        let of_wheel = surface.wheel.clone();
        let of_wheel = of_wheel.unwrap_or_else(|| surface.pinion.for_wheel());
        surface.pinion = on_file(&surface.pinion, &pinion);
        surface.wheel = wheel.as_deref().map(|file| on_file(&of_wheel, file));
        input.model.offsets = Some(args.offsets);
    };
    case::load_set(text.clone(), folder, &keys(&args.set), &change)
        .map_err(|error| Failure::of(&error).adding(&format!(" (--finish {name})")))
}
