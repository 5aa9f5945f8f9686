//! The `asperity` command.
//!
//! ```
//! // A program can run the command itself: this prints the version.
//! assert_eq!(asperity_cli::run(["asperity", "--version"].map(Into::into)), 0);
//! ```

mod args;
mod commands;
mod failure;
#[doc(hidden)]
pub mod fuzzing;
mod help;
mod interrupt;
mod output;
mod words;

use std::ffi::OsString;
use std::panic::AssertUnwindSafe;
use std::process::ExitCode;

use args::{CaseCommand, Cli, Command, Common};
use asperity_core::Code;
use asperity_fixtures::worked::Worked;
use clap::FromArgMatches;
use clap::error::ErrorKind;
use failure::Failure;

/// Runs the command line of this process and returns its exit status.
pub fn main() -> ExitCode {
    run(std::env::args_os()).into()
}

/// Runs a command line, whose first argument is the name of the program, and returns the exit status.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    asperity_paper_2022::register();
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let is_json = arguments.iter().any(|argument| argument == "--json");
    let matches = help::command_line().try_get_matches_from(arguments);
    let cli = match matches.and_then(|matches| Cli::from_arg_matches(&matches)) {
        Ok(cli) => cli,
        Err(refusal) if is_mistake(&refusal) => {
            return Failure::of_command_line(&refusal).report(is_json);
        }
        Err(help) => {
            // The reader may have closed the pipe.
            let _ = help.print();
            return u8::try_from(help.exit_code()).unwrap_or(u8::MAX);
        }
    };
    interrupt::handle();
    // A panic unwinds to here, so that temporary files are removed.
    let done = std::panic::catch_unwind(AssertUnwindSafe(|| {
        start_threads(&cli.common).and_then(|()| dispatch(&cli))
    }));
    match done {
        Ok(Ok(())) => 0,
        Ok(Err(failure)) => failure.report(cli.common.json),
        Err(_) => Failure::new(Code::E501, "internal fault: the program stopped, see above")
            .report(cli.common.json),
    }
}

/// Whether clap refuses the command line, rather than printing help or version.
fn is_mistake(error: &clap::Error) -> bool {
    error.use_stderr() && error.kind() != ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand
}

/// Starts the requested number of threads, at most one per core. The result does not depend on it.
fn start_threads(common: &Common) -> Result<(), Failure> {
    let Some(requested) = common.threads.map(usize::from) else {
        return Ok(());
    };
    let cores = std::thread::available_parallelism().map_or(requested, usize::from);
    let threads = requested.min(cores);
    if threads < requested && !common.quiet {
        output::note(&format!(
            "--threads {requested}: this machine has {cores} cores; {threads} threads are used"
        ));
    }
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_global()
        .map_err(|error| {
            Failure::new(
                Code::E501,
                format!("cannot start {threads} threads: {error}"),
            )
        })
}

fn dispatch(cli: &Cli) -> Result<(), Failure> {
    let common = &cli.common;
    match &cli.command {
        Command::Run(args) => commands::run::run(args, common),
        Command::Report(args) => commands::report::report(args, common),
        Command::Study(study) => commands::study::study(study, common),
        Command::Sweep(command) => commands::sweep::sweep(command, common),
        Command::Completions { kind } => commands::completions::completions(*kind, common),
        Command::Figures(args) => commands::figures::figures(args, common),
        Command::Gear(args) => commands::gear::gear(args, common),
        Command::Contact(args) => commands::contact::contact(args, common),
        Command::Ehl(args) => commands::ehl::ehl(args, common),
        Command::Film(args) => commands::film::film(args, common),
        Command::Profile(command) => commands::profile::run(command, common),
        Command::Equations(args) => commands::reference::equations(args, common),
        Command::Explain { markdown: true, .. } => commands::reference::messages(common),
        Command::Explain { code, .. } => commands::reference::explain(code.as_deref(), common),
        Command::Schema { markdown: true, .. } => commands::reference::keys(common),
        Command::Schema { settings, .. } => commands::reference::schema(*settings),
        Command::Check(args) => commands::check::check(args, common),
        Command::Oil(study) => commands::study::study(study, common),
        Command::List(args) => commands::list::list(args, common),
        Command::New { output } => commands::new_case::new_case(output, common),
        Command::Case(CaseCommand::FromRexs(args)) => commands::from_rexs::from_rexs(args, common),
        Command::Demo {
            folder,
            paper,
            gears,
        } => {
            let worked = match (gears, paper) {
                (Some(name), _) => Worked::Gears(name),
                (None, true) => Worked::Paper,
                (None, false) => Worked::Drive,
            };
            commands::demo::demo(folder.as_deref(), worked, common)
        }
    }
}
