//! `asperity completions`: completions for shells, the man page, and the list of commands for the documents.

use std::fmt::Write as _;

use asperity_core::Code;
use clap::{Command, CommandFactory};
use clap_complete::{Shell, generate};
use clap_mangen::Man;

use crate::args::{Cli, Common, CompletionKind};
use crate::failure::Failure;
use crate::help::questions;
use crate::output::print_text;

/// `asperity completions`
pub fn completions(kind: CompletionKind, common: &Common) -> Result<(), Failure> {
    let mut text = Vec::new();
    let shell = match kind {
        CompletionKind::Bash => Shell::Bash,
        CompletionKind::Elvish => Shell::Elvish,
        CompletionKind::Fish => Shell::Fish,
        CompletionKind::Powershell => Shell::PowerShell,
        CompletionKind::Zsh => Shell::Zsh,
        CompletionKind::Man => {
            man_page(&mut text).map_err(|error| {
                Failure::new(Code::E501, format!("the man page cannot be made: {error}"))
            })?;
            return print_text(common, &String::from_utf8_lossy(&text));
        }
        CompletionKind::Markdown => return print_text(common, &markdown()),
    };
    generate(shell, &mut Cli::command(), "asperity", &mut text);
    print_text(common, &String::from_utf8_lossy(&text))
}

/// One man page for the program and all its commands; the commands follow the options.
fn man_page(text: &mut Vec<u8>) -> std::io::Result<()> {
    let mut command = Cli::command();
    command.build();
    Man::new(command.clone()).render(text)?;
    for inner in command
        .get_subcommands()
        .filter(|inner| inner.get_name() != "help")
    {
        let page = Man::new(inner.clone());
        let name = inner.get_name().to_uppercase();
        text.extend_from_slice(format!(".SH \"ASPERITY {name}\"\n").as_bytes());
        page.render_description_section(text)?;
        page.render_synopsis_section(text)?;
        page.render_options_section(text)?;
        page.render_extra_section(text)?;
    }
    Ok(())
}

/// The page of all commands: a table by question, then the help of each.
fn markdown() -> String {
    let mut root = Cli::command().term_width(100).disable_help_subcommand(true);
    root.build();
    let about = |command: &Command| {
        command
            .get_about()
            .map(ToString::to_string)
            .unwrap_or_default()
    };
    let mut text = String::from(
        "# Commands\n\n`asperity completions markdown` prints this page, `asperity COMMAND --help` the help of one command.\n",
    );
    let mut details = String::new();
    for (question, names) in questions() {
        let _ = write!(text, "\n## {question}\n\n| command | does |\n|---|---|\n");
        for command in names.iter().filter_map(|name| root.find_subcommand(name)) {
            let inner: Vec<&Command> = command.get_subcommands().collect();
            let all = if inner.is_empty() {
                vec![command]
            } else {
                inner
            };
            for command in all {
                let name = command.get_bin_name().unwrap_or_default();
                let anchor = name.replace(' ', "-");
                let _ = writeln!(
                    text,
                    "| [`{name}`](#{anchor}) | {} |",
                    about(command).replace('|', "\\|")
                );
                let help = command.clone().render_help();
                let _ = write!(
                    details,
                    "\n### {name}\n\n```text\n{}\n```\n",
                    help.to_string().trim_end()
                );
            }
        }
    }
    text + "\n## Help of each command\n" + &details
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_command_answers_one_question() {
        let command = Cli::command();
        let mut listed: Vec<&str> = questions()
            .into_iter()
            .flat_map(|(_, names)| names)
            .collect();
        let mut all: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
        listed.sort_unstable();
        all.sort_unstable();
        assert_eq!(listed, all);
    }

    #[test]
    fn the_commands_stay_few() {
        /// Commands that run: one with sub-commands only names them.
        fn count(command: &Command) -> usize {
            if command.has_subcommands() {
                command.get_subcommands().map(count).sum()
            } else {
                1
            }
        }
        let count = count(&Cli::command());
        assert!((20..=40).contains(&count), "{count} commands");
    }
}
