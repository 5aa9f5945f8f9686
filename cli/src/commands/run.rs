//! `asperity run`: runs a case.

use std::path::{Path, PathBuf};

use asperity::result::RunResult;
use asperity::{Error, Run};
use asperity_calibration::evidence::standard_plan;
use asperity_core::Code;
use asperity_report::{self as report, Fields, Results};
use asperity_studies::ridges::add_ridges;

use super::bibtex::bibtex;
use super::check::defaults;
use super::work::check_work;
use super::{load_train, refuse_other, result_name};
use crate::args::{Common, RunArgs};
use crate::failure::Failure;
use crate::output::{
    FIRST_SCREEN, Progress, READING, WRITING, columns, print_json, print_text, print_verdict, shown,
};
use asperity_report::StudySettings as _;
use asperity_studies::ridges::{RUNS, RidgeSettings};

/// Counted work of a run.
const POSITIONS: &str = "mesh positions";

/// Runs whose time a run takes.
fn runs(args: &RunArgs) -> usize {
    if args.ridges { 1 + RUNS } else { 1 }
}

/// `asperity run`
pub fn run(args: &RunArgs, common: &Common) -> Result<(), Failure> {
    let fields = fields(args)?;
    let progress = Progress::new(common.quiet, READING);
    let train = load_train(&args.case, &args.set, args.formulation)?;
    let kept = fields.kept();
    check_work(&args.work, train.cases(), &kept, runs(args))?;
    let target = Target::from_args(args, &train.title)?;
    let folder = target.as_ref().map(|target| &*target.folder);
    progress.begin(POSITIONS);
    let at = |done, total| progress.at(done, total);
    let run = Run::new(&train).pictures(kept).interval(!args.no_band);
    let outcome = run.evidence(&standard_plan).progress(&at).execute();
    let mut outcome = outcome.map_err(|error| failed(&error, args, folder))?;
    if args.ridges {
        progress.begin(RidgeSettings::STEPS);
        for (mesh, case) in outcome.meshes.iter_mut().zip(outcome.settled.cases()) {
            add_ridges(&mut mesh.result, case, &at)
                .map_err(|error| Failure::about(&args.case, &error))?;
        }
    }
    if let Some(folder) = folder {
        progress.begin(WRITING);
        report::write_folder(&outcome, folder, &fields)?;
        if args.load_map {
            report::write_load_points(&outcome, folder)?;
        }
    }
    drop(progress);
    if common.json {
        return print_json(&outcome);
    }
    let runs = || outcome.meshes.iter().map(|mesh| &mesh.result);
    if args.cite {
        return print_text(common, &bibtex(runs()));
    }
    let results = Results::from(&outcome);
    // The line about an earlier result.
    let replaced = usize::from(target.as_ref().is_some_and(|target| target.older.is_some()));
    let text = if common.notes || args.models || args.laws || args.explain_defaults {
        results.with_each(&|result| details(result, args, common.notes))
    } else {
        results.brief(columns(), FIRST_SCREEN - replaced)
    };
    let count = runs().map(|run| run.warnings.len()).sum();
    let text = text + &last_lines(target.as_ref(), &train.title, common.notes, count);
    print_verdict(common, &text, &[results.headline()])
}

/// The summary of a run, with what `args` request in addition.
fn details(result: &RunResult, args: &RunArgs, notes: bool) -> String {
    let mut text = if notes {
        report::summary_within(result, columns())
    } else {
        report::brief(result, columns(), usize::MAX)
    };
    if args.models {
        text.push_str(&report::models(result));
    }
    if args.laws {
        text.push_str(&report::published_laws(result));
    }
    if args.explain_defaults || notes {
        text.push_str(&defaults(&result.defaults, args.explain_defaults));
    }
    text
}

/// Last lines of the output: the folder, and the number of warnings if they are not printed.
fn last_lines(target: Option<&Target>, title: &str, notes: bool, count: usize) -> String {
    let more = match (notes, count) {
        (true, _) => String::new(),
        (false, 1) => "1 note: --notes".to_owned(),
        (false, count) => format!("{count} notes: --notes"),
    };
    match target {
        Some(target) => target.text(title, &more),
        None if more.is_empty() => String::new(),
        None => more + "\n",
    }
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
            Code::E209,
            format!("--fields {text}: must be all, or numbers of positions, e.g. 1,5"),
        )),
    }
}

/// Error of a run; a contact without solution is saved next to the result folders.
fn failed(error: &Error, args: &RunArgs, folder: Option<&Path>) -> Failure {
    let failure = Failure::about(&args.case, error);
    if let (Some(contact), Some(folder)) = (error.unsolved(), folder) {
        let name = folder.file_name().unwrap_or_default();
        let file = folder
            .with_file_name("failed")
            .join(name)
            .with_extension("csv");
        return match report::write_unsolved(contact, &file) {
            Ok(()) => failure.adding(&format!(". Its gap is saved in {}", file.display())),
            Err(error) => failure.adding(&format!(". Its fields could not be saved: {error}")),
        };
    }
    failure
}

/// Folder of a result.
struct Target {
    folder: PathBuf,
    /// Title of the earlier result that is replaced.
    older: Option<String>,
}

impl Target {
    /// The folder of `args` for a case with `title`, checked before the run; `None` without output. A folder that the user
    /// did not name is refused if it holds the result of a case with another title.
    fn from_args(args: &RunArgs, title: &str) -> Result<Option<Self>, Failure> {
        if args.no_output {
            return Ok(None);
        }
        let folder = match &args.output {
            Some(folder) => folder.clone(),
            None => Path::new("results").join(result_name(&args.case)),
        };
        report::check_place(&folder)?;
        let older = report::title_of(&folder);
        if let (Some(older), None) = (&older, &args.output) {
            refuse_other(&folder, title, older)?;
        }
        Ok(Some(Self { folder, older }))
    }

    /// Last lines of the output: the replaced result, and the page, with `more` at its right.
    fn text(&self, title: &str, more: &str) -> String {
        let folder = shown(&self.folder);
        let replaced = match &self.older {
            Some(older) if older == title => format!("replaced {folder} (same title)\n"),
            Some(older) => format!(
                "replaced {folder} ({})\n",
                asperity_storage::one_line(older)
            ),
            None => String::new(),
        };
        let page = format!("report: {}", shown(&self.folder.join(report::PAGE)));
        let between = if more.is_empty() { "" } else { "   " };
        format!("{replaced}{page}{between}{more}\n")
    }
}
