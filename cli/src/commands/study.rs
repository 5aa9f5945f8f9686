//! Studies of one case; target and output of every study.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity::pipeline::KeptFields;
use asperity_report::StudyResult;
use asperity_studies::every_study;
use asperity_studies::study::CaseStudy;
use clap::{ArgMatches, Args, FromArgMatches as _};

use super::work::check_work;
use super::{load_train, one_mesh, refuse_other, result_name};
use crate::args::{Common, StudyArgs, StudyCommand};
use crate::failure::Failure;
use crate::output::{Progress, READING, WRITING, print_json, print_verdict, shown};

/// A study with the arguments of its command.
type Run = fn(&ArgMatches, &Common) -> Result<(), Failure>;

fn registered<S: CaseStudy + Args>() -> (&'static str, Run) {
    (S::COMMAND, |arguments, common| {
        let args = StudyArgs::<S>::from_arg_matches(arguments);
        case_study(
            &args.map_err(|refusal| Failure::of_command_line(&refusal))?,
            common,
        )
    })
}

/// Runs one of the studies of one case.
pub fn study(command: &StudyCommand, common: &Common) -> Result<(), Failure> {
    let mut all = every_study!(registered).into_iter();
    let run = all.find(|(name, _)| *name == command.name);
    run.map_or(Ok(()), |(_, run)| run(&command.arguments, common))
}

/// Runs a study of one case, writes its folder and prints it.
fn case_study<S: CaseStudy + Args>(args: &StudyArgs<S>, common: &Common) -> Result<(), Failure> {
    let progress = Progress::of(common.quiet, READING);
    let train = load_train(&args.case, &args.set, None)?;
    if !S::TAKES_TRAINS {
        one_mesh(&train)?;
    }
    let work = args.settings.work(&train)?;
    check_work(&args.work, &work.meshes, &KeptFields::Highest, work.runs)?;
    let output = args.output.as_deref();
    let folder = folder::<S::Found>(output, &result_name(&args.case), S::COMMAND, &train.title)?;
    progress.begin(S::STEPS);
    let found = args
        .settings
        .run(&train, &|done, total| progress.at(done, total));
    let found = found.map_err(|error| error.about(args.case.display()))?;
    progress.begin(WRITING);
    write(&found, (), &folder)?;
    drop(progress);
    print(&found, (), Some(&folder), None, common)
}

/// Folder of a study with `title`, checked before the computation: `output`, or by default `results/NAME-KIND`, which is
/// refused if it holds a study of this kind with another title.
pub fn folder<S: StudyResult>(
    output: Option<&Path>,
    name: &OsStr,
    kind: &str,
    title: &str,
) -> Result<PathBuf, Failure> {
    let default = || Path::new("results").join(format!("{}-{kind}", name.to_string_lossy()));
    let folder = output.map_or_else(default, Path::to_owned);
    S::check_target(&folder)?;
    if let (Some(older), None) = (S::title_of(&folder), output) {
        refuse_other(&folder, title, &older)?;
    }
    Ok(folder)
}

/// Writes a study as `folder`.
pub fn write<'a, S: StudyResult>(
    study: &'a S,
    context: S::Context<'a>,
    folder: &Path,
) -> Result<(), Failure> {
    let written = study.write(context, folder);
    Ok(written?)
}

/// Writes a study as `folder` and prints it, with the time since `begin`.
pub fn finish<'a, S: StudyResult>(
    study: &'a S,
    context: S::Context<'a>,
    folder: &Path,
    begin: Option<Instant>,
    common: &Common,
) -> Result<(), Failure> {
    write(study, context, folder)?;
    print(study, context, Some(folder), begin, common)
}

/// Prints a study and, if it was written, its folder, with the time since `begin`.
pub fn print<'a, S: StudyResult>(
    study: &'a S,
    context: S::Context<'a>,
    folder: Option<&Path>,
    begin: Option<Instant>,
    common: &Common,
) -> Result<(), Failure> {
    if common.json {
        return print_json(study);
    }
    let report = study.report(context);
    let mut text = report.terminal();
    if let Some(folder) = folder {
        let time = begin.map_or(String::new(), |begin| {
            format!(" in {:.1} s", begin.elapsed().as_secs_f64())
        });
        text.push_str(&format!("wrote {}{time}\n", shown(folder)));
    }
    print_verdict(common, &text, &report.verdict_lines())
}
