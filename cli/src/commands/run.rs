//! `asperity run`: the main job.

use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity::result::RunResult;
use asperity::{Error, pipeline};
use asperity_report::{self as report, Fields, ReportError};

use super::bibtex::bibtex;
use super::work::check_work;
use super::{load_case, stem};
use crate::args::{Common, RunArgs};
use crate::failure::Failure;
use crate::output::{PATIENCE, print_json, print_text, progress};

/// `asperity run`
pub fn run(args: &RunArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let fields = fields(args)?;
    let loaded = load_case(&args.case, &args.set, args.formulation)?;
    check_work(&args.work, &loaded, 1)?;
    let folder = (!args.no_output).then(|| result_folder(args));
    if let Some(folder) = &folder {
        // Told before the work, not after it.
        report::check_place(folder).map_err(|error| not_written(&error))?;
    }
    let bar = progress(common.quiet);
    let shown = |done: usize, total: usize| {
        if begin.elapsed() >= PATIENCE {
            bar.set_length(total as u64);
            bar.set_position(done as u64);
        }
    };
    let outcome = pipeline::run(&loaded, &shown);
    bar.finish_and_clear();
    let outcome = outcome.map_err(|error| failed(&error, args, folder.as_deref()))?;
    if let Some(folder) = &folder {
        report::write_folder(&outcome, folder, &fields).map_err(|error| not_written(&error))?;
    }
    if common.json {
        return print_json(&outcome.result);
    }
    if args.cite {
        return print_text(common, &bibtex(&outcome.result));
    }
    print_text(
        common,
        &text(&outcome.result, args, folder.as_deref(), begin),
    )
}

fn text(result: &RunResult, args: &RunArgs, folder: Option<&Path>, begin: Instant) -> String {
    let mut text = match args.notes {
        true => report::summary(result),
        false => report::brief(result),
    };
    if args.explain_defaults {
        text.push_str("defaults used\n");
        for default in &result.defaults {
            let source = default
                .source
                .as_deref()
                .map(|s| format!("  ({s})"))
                .unwrap_or_default();
            text.push_str(&format!("  {} = {}{source}\n", default.key, default.value));
        }
    } else {
        text.push_str(&format!(
            "defaults used: {} (--explain-defaults)\n",
            result.defaults.len()
        ));
    }
    let seconds = begin.elapsed().as_secs_f64();
    match folder {
        Some(folder) => {
            text.push_str(&format!("wrote {} in {seconds:.1} s\n", folder.display()));
        }
        None => text.push_str(&format!("in {seconds:.1} s\n")),
    }
    text
}

fn not_written(error: &ReportError) -> Failure {
    let code = match error {
        ReportError::NoSuchPosition { .. } | ReportError::NoFields { .. } => "E402",
        ReportError::NotFinite { .. } => "E501",
        _ => "E401",
    };
    Failure::new(code, error.to_string())
}

/// The fields to keep, as `all` or as numbers of positions.
fn fields(args: &RunArgs) -> Result<Fields, Failure> {
    let Some(text) = args.fields.as_deref() else {
        return Ok(Fields::Page);
    };
    if text.trim() == "all" {
        return Ok(Fields::All);
    }
    let numbers = text.split(',').map(|number| number.trim().parse());
    match numbers.collect::<Result<Vec<usize>, _>>() {
        Ok(numbers) if !numbers.contains(&0) => Ok(Fields::Positions(numbers)),
        _ => Err(Failure::new(
            "E209",
            format!("--fields {text}: must be all, or numbers of positions as 1,5"),
        )),
    }
}

/// The error of a run; a contact without solution is saved beside the result folders.
fn failed(error: &Error, args: &RunArgs, folder: Option<&Path>) -> Failure {
    let failure = Failure::about(&args.case, error);
    if let (Some(contact), Some(folder)) = (error.unsolved(), folder) {
        let name = folder.file_name().unwrap_or_default();
        let file = folder
            .with_file_name("failed")
            .join(name)
            .with_extension("csv");
        return match report::write_unsolved(contact, &file) {
            Ok(()) => failure.adding(&format!(
                ". Fields saved in {}: asperity contact --gap solves it alone",
                file.display()
            )),
            Err(error) => failure.adding(&format!(". Its fields could not be saved: {error}")),
        };
    }
    failure
}

fn result_folder(args: &RunArgs) -> PathBuf {
    args.output
        .clone()
        .unwrap_or_else(|| Path::new("results").join(stem(&args.case)))
}
