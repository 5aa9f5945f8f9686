//! Arguments of the studies of one case: each is described by the library.

use std::path::PathBuf;

use asperity_studies::every_study;
use asperity_studies::study::CaseStudy;
use clap::error::ErrorKind;
use clap::{ArgMatches, Args, Command, Error, FromArgMatches, Subcommand};

use super::{SetArgs, WorkArgs};

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

/// One of the studies of the library, with its arguments.
#[derive(Debug)]
pub struct StudyCommand {
    /// Its name.
    pub name: &'static str,
    /// Its arguments.
    pub arguments: ArgMatches,
}

/// A study of the library as a command.
struct Registered {
    name: &'static str,
    command: fn() -> Command,
}

fn registered<S: CaseStudy + Args>() -> Registered {
    Registered {
        name: S::COMMAND,
        command: || {
            let command = StudyArgs::<S>::augment_args(Command::new(S::COMMAND));
            command.about(S::ABOUT).after_help(help::<S>())
        },
    }
}

/// Examples and method, below the options.
fn help<S: CaseStudy>() -> String {
    let examples = S::EXAMPLES.iter().map(|settings| {
        let options = settings
            .iter()
            .map(|(name, value)| match value.contains(' ') {
                true => format!(" --{name} \"{value}\""),
                false => format!(" --{name} {value}"),
            });
        let options: String = options.collect();
        format!("  asperity {} demo/case.toml{options}\n", S::COMMAND)
    });
    let title = if S::EXAMPLES.len() == 1 {
        "Example"
    } else {
        "Examples"
    };
    format!("{title}:\n{}\n{}", examples.collect::<String>(), S::METHOD)
}

impl StudyCommand {
    /// Names of the studies.
    pub fn names() -> impl Iterator<Item = &'static str> {
        every_study!(registered).into_iter().map(|study| study.name)
    }
}

impl FromArgMatches for StudyCommand {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let (name, arguments) = matches.subcommand().unwrap_or(("", matches));
        let name = Self::names().find(|known| *known == name);
        Ok(Self {
            name: name.ok_or_else(|| Error::new(ErrorKind::InvalidSubcommand))?,
            arguments: arguments.clone(),
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
        Self::names().any(|known| known == name)
    }
}
