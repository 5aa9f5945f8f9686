//! The studies of the library; target and output of every study.

use std::path::{Path, PathBuf};

use asperity_core::Fault;
use asperity_report::{StudyResult, StudySettings, Watch};
use asperity_studies::every_study;
use clap::{Arg, ArgMatches, Args, FromArgMatches as _};

use super::refuse_other;
use crate::args::{Common, Given, KeyGroup, StudyArgs, StudyCommand, command, named};
use crate::failure::Failure;
use crate::output::{Progress, READING, WRITING, print_report, print_text};

/// A study with the arguments of its command.
type Run = fn(&ArgMatches, &Common) -> Result<(), Failure>;

fn registered<S: StudySettings<Input: Given> + Args>() -> (&'static str, Run) {
    (S::COMMAND, |arguments, common| {
        let args = StudyArgs::<S>::from_arg_matches(arguments);
        run(
            &args.map_err(|refusal| Failure::of_command_line(&refusal))?,
            common,
        )
    })
}

/// Runs one of the studies.
pub fn study<G: KeyGroup>(command: &StudyCommand<G>, common: &Common) -> Result<(), Failure> {
    let mut all = every_study!(registered).into_iter();
    let run = all.find(|(words, _)| *words == command.words);
    run.map_or(Ok(()), |(_, run)| run(&command.arguments, common))
}

/// Runs a study, writes its folder and prints it.
fn run<S: StudySettings<Input: Given> + Args>(
    args: &StudyArgs<S>,
    common: &Common,
) -> Result<(), Failure> {
    let progress = Progress::new(common.quiet, READING);
    let given = S::Input::read(&args.given, &args.set)?;
    let title = S::title(&given.input);
    let target = || {
        let name = named(&given.name.to_string_lossy(), S::FOLDER);
        folder::<S::Found>(args.output.as_deref(), &name, &title)
    };
    let folder = (!args.no_output).then(target).transpose()?;
    let refused = |error: Fault| {
        let named = of_option::<S>(error.clone());
        match &given.file {
            // A place of the case names its file.
            Some(file) if named == error && error.place().is_none() => error.about(file.display()),
            _ => named,
        }
    };
    if let Some(work) = args.settings.work(&given.input).map_err(refused)? {
        S::Input::check(&args.limits, &work)?;
    }
    progress.begin(S::STEPS);
    let watch = Watch {
        progress: &|done, total| progress.at(done, total),
        say: &|text| {
            if common.notes && !common.json {
                // An error of standard output is reported at the end of the command.
                let _ = print_text(common, text);
            }
        },
    };
    let found = args.settings.run(given.input, &watch).map_err(refused)?;
    progress.begin(WRITING);
    if let Some(folder) = &folder {
        found.write(folder)?;
    }
    drop(progress);
    print(&found, folder.as_deref(), common)
}

/// An error whose message begins with the name of an argument, under the name of its option.
fn of_option<S: StudySettings<Input: Given> + Args>(error: Fault) -> Fault {
    let command = command::<S>("");
    let about = |arg: &Arg| {
        let rest = error.message().strip_prefix(arg.get_id().as_str())?;
        let is_own = rest.starts_with(": ") || rest.starts_with(" = ");
        is_own.then(|| Some(format!("--{}{rest}", arg.get_long()?)))?
    };
    match command.get_arguments().find_map(about) {
        Some(message) => error.saying(message),
        None => error,
    }
}

/// Folder of a study with `title`, checked before the computation: `output`, or by default `results/NAME`, which is
/// refused if it holds a study of this kind with another title.
pub fn folder<S: StudyResult>(
    output: Option<&Path>,
    name: &str,
    title: &str,
) -> Result<PathBuf, Failure> {
    let default = || Path::new("results").join(name);
    let folder = output.map_or_else(default, Path::to_owned);
    S::check_target(&folder)?;
    if let (Some(older), None) = (S::title_of(&folder), output) {
        refuse_other(&folder, title, &older)?;
    }
    Ok(folder)
}

/// Prints a study and, if it was written, its folder.
pub fn print<S: StudyResult>(
    study: &S,
    folder: Option<&Path>,
    common: &Common,
) -> Result<(), Failure> {
    print_report(common, || study, || study.report(), folder)
}
