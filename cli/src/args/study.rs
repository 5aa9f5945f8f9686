//! Arguments of the studies of one case: each is described by the library.

use std::path::PathBuf;

use asperity_studies::every_study;
use asperity_studies::study::CaseStudy;
use clap::{ArgMatches, Args, Command, Error, FromArgMatches, Subcommand};

use super::{Common, SetArgs, WorkArgs};
use crate::commands::study::case_study;
use crate::failure::Failure;

/// Case and settings of a study.
#[derive(Debug, Args)]
pub struct StudyArgs<S: Args> {
    /// Case file; - reads standard input
    pub case: PathBuf,
    /// Settings of the study.
    #[command(flatten)]
    pub settings: S,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Folder of the study [default: results/<name of the case>-<command>, named as for run]
    #[arg(long, short)]
    pub output: Option<PathBuf>,
    /// Limits of time and memory.
    #[command(flatten)]
    pub work: WorkArgs,
}

/// A study with its arguments, ready to run.
type Ready = Box<dyn Fn(&Common) -> Result<(), Failure> + std::panic::RefUnwindSafe>;

/// One of the studies of the library.
pub struct StudyCommand {
    name: &'static str,
    /// Runs it, writes its folder and prints it.
    pub run: Ready,
}

impl std::fmt::Debug for StudyCommand {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// A study of the library as a command.
struct Registered {
    name: &'static str,
    command: fn() -> Command,
    ready: fn(&ArgMatches) -> Result<Ready, Error>,
}

fn registered<S: CaseStudy + Args + std::panic::RefUnwindSafe + 'static>() -> Registered {
    Registered {
        name: S::COMMAND,
        command: || {
            let command = StudyArgs::<S>::augment_args(Command::new(S::COMMAND));
            command.about(S::ABOUT).after_help(S::HELP)
        },
        ready: |matches| {
            let args = StudyArgs::<S>::from_arg_matches(matches)?;
            Ok(Box::new(move |common| case_study(&args, common)))
        },
    }
}

impl StudyCommand {
    /// Names of the studies.
    pub fn names() -> impl Iterator<Item = &'static str> {
        every_study!(registered).into_iter().map(|study| study.name)
    }
}

impl FromArgMatches for StudyCommand {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let (name, inner) = matches.subcommand().unwrap_or(("", matches));
        let mut all = every_study!(registered).into_iter();
        let study = all.find(|study| study.name == name);
        let study = study.ok_or_else(|| Error::new(clap::error::ErrorKind::InvalidSubcommand))?;
        Ok(Self {
            name: study.name,
            run: (study.ready)(inner)?,
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl Subcommand for StudyCommand {
    fn augment_subcommands(command: Command) -> Command {
        command.subcommands(every_study!(registered).map(|study| (study.command)()))
    }

    fn augment_subcommands_for_update(command: Command) -> Command {
        Self::augment_subcommands(command)
    }

    fn has_subcommand(name: &str) -> bool {
        every_study!(registered)
            .iter()
            .any(|study| study.name == name)
    }
}
