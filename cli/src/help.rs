//! Help of the program: its commands by the question that they answer.

use std::fmt::Write as _;

use asperity_report::wrapped_within;
use clap::builder::StyledStr;
use clap::{Command, CommandFactory};

use crate::args::{Cli, StudyCommand, Top};
use crate::output::columns;

/// Questions, and the commands that answer each; studies without a question of their own are among the comparisons.
pub fn questions() -> Vec<(&'static str, Vec<&'static str>)> {
    let with_studies = |(question, names): (&'static str, &[&'static str])| {
        let mut names = names.to_vec();
        if question == COMPARE {
            let is_listed = |name: &&str| QUESTIONS.iter().any(|(_, names)| names.contains(name));
            let others = StudyCommand::<Top>::names().filter(|name| !is_listed(name));
            names.splice(1..1, others);
        }
        (question, names)
    };
    QUESTIONS.into_iter().map(with_studies).collect()
}

const COMPARE: &str = "Compare";
const QUESTIONS: [(&str, &[&str]); 7] = [
    ("One loss", &["demo", "new", "check", "run", "report"]),
    (COMPARE, &["compare", "sweep"]),
    ("Narrow the interval", &["evidence", "calibrate", "design"]),
    ("Torque, speed and drive cycles", &["map", "cycle"]),
    (
        "One part of the model",
        &["gear", "contact", "film", "ehl", "figures"],
    ),
    (
        "Profiles, oils and gears",
        &["profile", "oil", "list", "case"],
    ),
    (
        "Look things up",
        &["explain", "equations", "schema", "completions"],
    ),
];

/// Columns before the description of a command.
const INDENT: usize = 15;

/// The command line, with a help that lists the commands by question.
pub fn command_line() -> Command {
    let command = Cli::command();
    let header = *command.get_styles().get_header();
    let name_style = *command.get_styles().get_literal();
    let mut help = String::from("{about-with-newline}\n{usage-heading} {usage}\n");
    for (question, names) in questions() {
        let _ = writeln!(help, "\n{header}{question}:{header:#}");
        for inner in names
            .iter()
            .filter_map(|name| command.find_subcommand(name))
        {
            let name = inner.get_name();
            let about = inner.get_about().map(StyledStr::to_string);
            let about = wrapped_within(
                &format!("{:INDENT$}{}", "", about.unwrap_or_default()),
                &" ".repeat(INDENT),
                columns().min(100),
            );
            let _ = writeln!(
                help,
                "  {name_style}{name}{name_style:#}{}",
                about.get(2 + name.len()..).unwrap_or_default()
            );
        }
    }
    let _ = write!(
        help,
        "\n{header}Options:{header:#}\n{{options}}{{after-help}}"
    );
    command.help_template(help)
}
