//! `asperity completions`: completions for shells, and the man page.

use clap::CommandFactory;
use clap_complete::{Shell, generate};
use clap_mangen::Man;

use crate::args::{Cli, Common, CompletionKind};
use crate::failure::Failure;
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
                Failure::new("E501", format!("the man page cannot be made: {error}"))
            })?;
            return print_text(common, &String::from_utf8_lossy(&text));
        }
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
