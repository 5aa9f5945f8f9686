//! Arguments of the studies: each is described by the library.

use std::ffi::OsString;
use std::fmt::Debug;
use std::marker::PhantomData;
use std::path::PathBuf;

use asperity_report::{Input, StudySettings, Work};
use asperity_studies::every_study;
use clap::error::ErrorKind;
use clap::{ArgMatches, Args, Command, Error, FromArgMatches, Subcommand};

use super::SetArgs;
use crate::failure::Failure;

/// Subject of a study, as read from its arguments.
#[derive(Debug)]
pub struct Subject<I> {
    /// The subject.
    pub input: I,
    /// Name of its results.
    pub name: OsString,
    /// File that errors of the study are about.
    pub file: Option<PathBuf>,
}

/// Subject of a study, as arguments of a command.
pub trait Given: Input {
    /// The arguments.
    type Args: Args + Debug;
    /// Limits of the work.
    type Limits: Args + Debug;
    /// Name by which the folder of a result is named.
    const NAMED_BY: &'static str;

    /// Reads the subject.
    fn read(args: &Self::Args, set: &SetArgs) -> Result<Subject<Self>, Failure>;

    /// Rejects work above the limits.
    fn check(_limits: &Self::Limits, _work: &Work) -> Result<(), Failure> {
        Ok(())
    }
}

/// Subject of a study, its settings, and the target of its result.
#[derive(Debug, Args)]
pub struct StudyArgs<S: StudySettings<Input: Given> + Args> {
    /// Its subject.
    #[command(flatten)]
    pub given: <S::Input as Given>::Args,
    /// Settings of the study, without the heading of the arguments before.
    #[command(flatten, next_help_heading = None::<&'static str>)]
    pub settings: S,
    /// Keys of the case set on the command line.
    #[command(flatten)]
    pub set: SetArgs,
    /// Folder of the result
    #[arg(long, short)]
    pub output: Option<PathBuf>,
    /// Do not write a folder
    #[arg(long, conflicts_with = "output")]
    pub no_output: bool,
    /// Limits of the work.
    #[command(flatten)]
    pub limits: <S::Input as Given>::Limits,
}

/// Commands that have their studies.
pub trait KeyGroup: Debug {
    /// Name of the command, with a space behind it; empty for the program itself.
    const NAME: &'static str;
}

/// The program.
#[derive(Debug)]
pub struct Top;

impl KeyGroup for Top {
    const NAME: &'static str = "";
}

/// One of the studies of the library, with its arguments.
#[derive(Debug)]
pub struct StudyCommand<G> {
    /// Words of its command.
    pub words: &'static str,
    /// Its arguments.
    pub arguments: ArgMatches,
    group: PhantomData<G>,
}

/// A study of the library as a command.
struct Registered {
    words: &'static str,
    command: fn(&'static str) -> Command,
}

fn registered<S: StudySettings<Input: Given> + Args>() -> Registered {
    Registered {
        words: S::COMMAND,
        command: command::<S>,
    }
}

/// Name of the folder of a study with the end `kind`.
pub fn named(subject: &str, kind: &str) -> String {
    match kind {
        "" => subject.to_owned(),
        kind => format!("{subject}-{kind}"),
    }
}

/// The study as the command `name`.
pub fn command<S: StudySettings<Input: Given> + Args>(name: &'static str) -> Command {
    let mut command = StudyArgs::<S>::augment_args(Command::new(name)).about(S::ABOUT);
    for setting in S::described() {
        command = command.mut_arg(setting.name, |arg| {
            let takes_values = arg.get_action().takes_values();
            arg.allow_hyphen_values(takes_values)
        });
    }
    let name = named(S::Input::NAMED_BY, S::FOLDER);
    let folder = format!("Folder of the result [default: results/{name}, named as for run]");
    let command = command.mut_arg("output", |arg| arg.help(folder));
    let help = help::<S>(&command);
    command.after_help(help)
}

/// Examples and method, below the options.
fn help<S: StudySettings>(command: &Command) -> String {
    let stated = |name: &str, value: &str| {
        let value = if value.contains(' ') {
            format!("\"{value}\"")
        } else {
            value.to_owned()
        };
        let argument = command.get_arguments().find(|arg| arg.get_id() == name);
        match argument.map(|arg| (arg.get_short(), arg.get_long())) {
            Some((Some(short), _)) => format!(" -{short} {value}"),
            Some((None, Some(long))) => format!(" --{long} {value}"),
            _ => format!(" {value}"),
        }
    };
    let examples = S::EXAMPLES.iter().map(|example| {
        let arguments: String = example
            .iter()
            .map(|(name, value)| stated(name, value))
            .collect();
        format!("  asperity {}{arguments}\n", S::COMMAND)
    });
    let title = match S::EXAMPLES.len() {
        1 => "Example",
        _ => "Examples",
    };
    format!("{title}:\n{}\n{}", examples.collect::<String>(), S::METHOD)
}

/// The studies of a command by their names there.
fn of_group<G: KeyGroup>() -> impl Iterator<Item = (&'static str, Registered)> {
    let own = |study: Registered| {
        let name = study.words.strip_prefix(G::NAME)?;
        (!name.contains(' ')).then_some((name, study))
    };
    every_study!(registered).into_iter().filter_map(own)
}

impl<G: KeyGroup> StudyCommand<G> {
    /// Names of the studies.
    pub fn names() -> impl Iterator<Item = &'static str> {
        of_group::<G>().map(|(name, _)| name)
    }
}

impl<G: KeyGroup> FromArgMatches for StudyCommand<G> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let (name, arguments) = matches.subcommand().unwrap_or(("", matches));
        let study = of_group::<G>().find(|(known, _)| *known == name);
        let (_, study) = study.ok_or_else(|| Error::new(ErrorKind::InvalidSubcommand))?;
        Ok(Self {
            words: study.words,
            arguments: arguments.clone(),
            group: PhantomData,
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl<G: KeyGroup> Subcommand for StudyCommand<G> {
    fn augment_subcommands(command: Command) -> Command {
        command.subcommands(of_group::<G>().map(|(name, study)| (study.command)(name)))
    }

    fn augment_subcommands_for_update(command: Command) -> Command {
        Self::augment_subcommands(command)
    }

    fn has_subcommand(name: &str) -> bool {
        Self::names().any(|known| known == name)
    }
}

#[cfg(test)]
mod tests {
    use asperity_report::{Described, schema_of_settings};
    use clap::Arg;
    use serde_json::{Value, json};

    use super::*;

    fn described<S: StudySettings>() -> Described {
        Described::new::<S>()
    }

    #[test]
    fn every_study_has_a_name_of_its_own_and_every_setting_is_described() {
        let all = every_study!(described);
        for (k, study) in all.iter().enumerate() {
            let is_other = |other: &Described| {
                other.command != study.command && other.function != study.function
            };
            assert!(all[..k].iter().all(is_other));
            assert!(!study.about.is_empty() && !study.input.is_empty());
            let mut settings = study.input.iter().chain(&study.settings);
            assert!(settings.all(|setting| !setting.about.is_empty()));
        }
    }

    /// The choices of a type of the schema, or of its definition, with hyphens.
    fn choices(node: &Value, definitions: &Value) -> Vec<String> {
        let name = |node: &Value| Some(node["$ref"].as_str()?.rsplit('/').next()?.to_owned());
        let parts = ["anyOf", "oneOf", "enum"].iter().flat_map(|key| {
            let parts = node[*key].as_array();
            parts.cloned().unwrap_or_default()
        });
        let inner = parts.chain(node.get("items").cloned());
        let inner = inner.chain(name(node).map(|name| definitions[name].clone()));
        let own = node.as_str().or(node["const"].as_str());
        let own = own.map(|name| name.replace('_', "-")).into_iter();
        own.chain(inner.flat_map(|node| choices(&node, definitions)))
            .collect()
    }

    #[test]
    fn the_schema_of_the_settings_is_that_of_the_options() {
        fn options<S: StudySettings<Input: Given> + Args>() -> (&'static str, Command, bool) {
            let is_complete = S::of_json(json!({})).is_ok();
            (S::FUNCTION, command::<S>("study"), is_complete)
        }
        let schema = schema_of_settings(&every_study!(described));
        let studies = schema["properties"].as_object().unwrap();
        let all = every_study!(options);
        assert_eq!(studies.len(), all.len());
        let described = every_study!(described).into_iter();
        for ((function, command, is_complete), described) in all.into_iter().zip(described) {
            let study = &studies[function];
            assert_eq!(study["description"], described.about);
            let settings = study["properties"].as_object().unwrap();
            assert_eq!(settings.len(), described.settings.len());
            let required = study["required"].as_array().unwrap();
            assert_eq!(required.is_empty(), is_complete, "{function}");
            for (name, setting) in settings {
                let what = format!("{function} {name}: {setting}");
                let of_name = |arg: &&Arg| arg.get_id() == name.as_str();
                let option = command.get_arguments().find(of_name).unwrap();
                let help = option.get_help().map(ToString::to_string);
                assert_eq!(setting["description"].as_str(), help.as_deref(), "{what}");
                let is_required = required.iter().any(|one| one == name.as_str());
                assert_eq!(option.is_required_set(), is_required, "{what}");
                let default = match &setting["default"] {
                    Value::String(text) => text.clone(),
                    Value::Null => String::new(),
                    other => other.to_string(),
                };
                let of_option = if option.get_action().takes_values() {
                    option.get_default_values()
                } else {
                    &[]
                };
                let of_option = of_option.iter().map(|text| text.to_string_lossy());
                assert_eq!(of_option.collect::<String>(), default, "{what}");
                let values = option.get_possible_values();
                let values = values.iter().map(|value| value.get_name().to_owned());
                let is_flag = !option.get_action().takes_values();
                let of_option: Vec<String> = values.filter(|_| !is_flag).collect();
                let of_schema = choices(setting, &schema["$defs"]);
                assert!(of_option.is_empty() || of_option == of_schema, "{what}");
                assert_eq!(is_flag, setting["type"] == "boolean", "{what}");
            }
        }
    }

    #[test]
    fn the_arguments_of_every_example_are_those_of_the_command() {
        fn known<S: StudySettings<Input: Given> + Args>() -> bool {
            let command = command::<S>("study");
            let mut stated = S::EXAMPLES.iter().copied().flatten();
            stated.all(|(name, _)| command.get_arguments().any(|arg| arg.get_id() == *name))
        }
        assert!(every_study!(known).iter().all(|known| *known));
    }
}
