//! `asperity sweep`: many cases, in shards.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity::message::{self, Warning};
use asperity_core::Code;
use asperity_report::StudyResult as _;
use asperity_studies::sweep::{
    self, Event, Merged, Plan, Refused, Shard, Status, Study, SweepError,
};

use super::study;
use crate::args::{Common, SweepArgs, SweepCommand, SweepMergeArgs, SweepRunArgs, named};
use crate::failure::Failure;
use crate::interrupt::cancelling;
use crate::output::{Progress, print, shown};

/// Name of the work before the first case is run.
const CHECKING: &str = "checking the cases";

/// `asperity sweep`
pub fn sweep(command: &SweepCommand, common: &Common) -> Result<(), Failure> {
    match command {
        SweepCommand::Run(args) if args.plan => plan(args, common),
        SweepCommand::Run(args) if args.status => status(&args.sweep, common),
        SweepCommand::Run(args) => run(args, common),
        SweepCommand::Merge(args) => merge(args, common),
    }
}

fn load(args: &SweepArgs) -> Result<Study, Failure> {
    Study::load(&args.study).map_err(|error| refused(args, &error))
}

/// Folder of the parts.
fn parts(args: &SweepArgs, study: &Study) -> PathBuf {
    let default = || study.folder.join("parts");
    args.parts.clone().unwrap_or_else(default)
}

fn refused(args: &SweepArgs, error: &SweepError) -> Failure {
    let study = args.study.display();
    match error {
        SweepError::Study { .. } => Failure::new(error.code(), error.to_string())
            .advising("docs/files/sweeps.md lists the keys of a study."),
        SweepError::Key { .. } => Failure::new(error.code(), format!("{study}: {error}"))
            .advising("docs/files/sweeps.md lists the keys of a study."),
        SweepError::Column { .. } => Failure::new(error.code(), format!("{study}: {error}"))
            .advising("docs/files/sweeps.md says which columns a study can have."),
        SweepError::Case(error) => {
            Failure::from_error(error).adding(&format!(" (case of {study})"))
        }
        SweepError::Missing { .. } | SweepError::Changed { .. } => {
            Failure::new(error.code(), format!("{study}: {error}"))
        }
        SweepError::Part { .. } | SweepError::Contradiction { .. } => {
            Failure::new(error.code(), error.to_string())
                .advising("Remove this part; its cases are then run again.")
        }
        _ => Failure::new(error.code(), error.to_string()),
    }
}

fn plan(args: &SweepRunArgs, common: &Common) -> Result<(), Failure> {
    let study = load(&args.sweep)?;
    let progress = Progress::new(common.quiet, CHECKING);
    let plan = sweep::plan(&study, &|done, total| progress.at(done, total));
    drop(progress);
    let plan = plan.map_err(|error| refused(&args.sweep, &error))?;
    print(common, || &plan, || text_of_plan(&plan))
}

fn text_of_plan(plan: &Plan) -> String {
    let mut text = format!(
        "study {}\n{} cases: {} on the axes x {} of the sample\n",
        plan.study, plan.cases, plan.axis_points, plan.sample_points
    );
    if plan.checked < plan.cases {
        text.push_str(&format!(
            "checked {} of them: the corners of the axes and a sample\n",
            plan.checked
        ));
    }
    text.extend(
        plan.refused
            .iter()
            .map(|(code, refused)| line_of(code, refused)),
    );
    let minutes = plan.seconds / 60.0;
    text.push_str(&format!(
        "about {minutes:.1} min on this machine, less where cases share their contacts; {:.2} MB\n",
        plan.bytes * 1e-6
    ));
    text
}

/// Line about the cases that cannot be resolved, by error code.
fn line_of(code: &Code, refused: &Refused) -> String {
    let Refused {
        count,
        first,
        message,
    } = refused;
    format!("{code} in {count} cases, the first is case {first}: {message}\n")
}

fn run(args: &SweepRunArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let shard: Shard = args.shard.parse().map_err(|message: &str| {
        Failure::new(Code::E209, format!("--shard {}: {message}", args.shard))
    })?;
    let study = load(&args.sweep)?;
    let folder = parts(&args.sweep, &study);
    let progress = Progress::new(common.quiet, CHECKING);
    let watch = |event: Event<'_>| match event {
        Event::Checking { cases, of } => progress.at(cases, of),
        Event::Checked {
            refused,
            checked,
            of,
        } => {
            progress.begin("cases");
            let count: usize = refused.values().map(|refused| refused.count).sum();
            if count > 0 && !common.quiet {
                let lines: String = refused
                    .iter()
                    .map(|(code, refused)| line_of(code, refused))
                    .collect();
                let rows = "cases cannot be run; their rows hold only the error code";
                let cases = if checked < of {
                    format!("{checked} checked")
                } else {
                    of.to_string()
                };
                let warning = Warning::new(Code::W430, format!("{count} of {cases} {rows}"));
                progress.note(&format!("{warning}\n{}", lines.trim_end()));
            }
        }
        Event::Done { cases, of } => progress.at(cases, of),
    };
    let done = cancelling(|| sweep::run(&study, shard, &folder, &watch));
    drop(progress);
    let status = || sweep::status(&study, &folder).map_err(|error| refused(&args.sweep, &error));
    let done = match done {
        Err(error) if error.is_cancelled() => return Err(interrupted(&status()?, &folder)),
        done => done.map_err(|error| refused(&args.sweep, &error))?,
    };
    let status = status()?;
    let text = || {
        format!(
            "ran {done} cases of shard {}\n{}wrote {} in {:.1} s\n",
            args.shard,
            text_of(&status),
            shown(&folder),
            begin.elapsed().as_secs_f64()
        )
    };
    print(common, || &status, text)?;
    refuse_if_all_failed(status.cases, &status.failed, common)
}

/// Error of a run that a signal ended.
fn interrupted(status: &Status, folder: &Path) -> Failure {
    let message = format!(
        "interrupted: {} of {} cases are done, with their parts in {}",
        status.done,
        status.cases,
        shown(folder)
    );
    Failure::new(Code::E502, message).advising("The same command runs the other cases.")
}

/// Error if all `cases` have an error code; `failed` is their number by code. The result is already on standard output.
fn refuse_if_all_failed(
    cases: usize,
    failed: &BTreeMap<String, usize>,
    common: &Common,
) -> Result<(), Failure> {
    let most = failed.iter().max_by_key(|(_, count)| **count);
    match most.and_then(|(code, _)| message::explain(code)) {
        Some(entry) if failed.values().sum::<usize>() == cases => {
            let codes: Vec<_> = failed
                .iter()
                .map(|(code, n)| format!("{code} in {n}"))
                .collect();
            let message = format!("none of {cases} cases has a result: {}", codes.join(", "));
            Err(already_shown(Failure::new(entry.code, message), common))
        }
        _ => Ok(()),
    }
}

/// The error of a command whose result is already on standard output.
fn already_shown(failure: Failure, common: &Common) -> Failure {
    if common.json {
        failure.print();
        return failure.printed();
    }
    failure
}

fn text_of(status: &Status) -> String {
    let mut text = format!(
        "study {}: {} of {} cases done in {} parts\n",
        status.study, status.done, status.cases, status.parts
    );
    for (code, count) in &status.failed {
        text.push_str(&format!("{code} in {count} cases\n"));
    }
    text
}

fn status(args: &SweepArgs, common: &Common) -> Result<(), Failure> {
    let study = load(args)?;
    let folder = parts(args, &study);
    let status = sweep::status(&study, &folder).map_err(|error| refused(args, &error))?;
    print(common, || &status, || text_of(&status))?;
    if status.done == status.cases {
        return refuse_if_all_failed(status.cases, &status.failed, common);
    }
    let missing = status.cases - status.done;
    let message = format!(
        "{missing} of {} cases are in no part: {}",
        status.cases, status.missing
    );
    Err(already_shown(Failure::new(Code::E309, message), common))
}

fn merge(args: &SweepMergeArgs, common: &Common) -> Result<(), Failure> {
    let study = load(&args.sweep)?;
    let folder = parts(&args.sweep, &study);
    let name = named(&study.name, "sweep");
    let target = study::folder::<Merged>(args.output.as_deref(), &name, &study.case.title)?;
    let merged = sweep::merge(&study, &folder).map_err(|error| refused(&args.sweep, &error))?;
    merged.write(&target)?;
    study::print(&merged, Some(&target), common)?;
    if merged.failed < merged.cases {
        return Ok(());
    }
    let status = sweep::status(&study, &folder).map_err(|error| refused(&args.sweep, &error))?;
    refuse_if_all_failed(status.cases, &status.failed, common)
}
