//! Standard output and progress.

use std::io::{IsTerminal, Write};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde::Serialize;

use crate::args::Common;
use crate::failure::Failure;

/// Prints a value as JSON.
pub fn print_json<T: Serialize + ?Sized>(value: &T) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(value)
        .map_err(|error| Failure::new("E501", format!("cannot be written as JSON: {error}")))?;
    write(&format!("{text}\n"))
}

/// Prints text unless it is to be quiet.
pub fn print_text(common: &Common, text: &str) -> Result<(), Failure> {
    if common.quiet {
        return Ok(());
    }
    write(text)
}

/// A reader that has gone away is not an error.
fn write(text: &str) -> Result<(), Failure> {
    match std::io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(Failure::new(
            "E401",
            format!("standard output: cannot be written: {error}"),
        )),
        _ => Ok(()),
    }
}

/// A progress bar on standard error, only on a terminal and only after a second.
pub fn progress(quiet: bool) -> ProgressBar {
    let bar = ProgressBar::new(0);
    if quiet || !std::io::stderr().is_terminal() {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    if let Ok(style) =
        ProgressStyle::with_template("{msg} {bar:30} {pos}/{len}  {per_sec}  {eta} left")
    {
        bar.set_style(style);
    }
    bar.set_message("mesh positions");
    bar
}

/// Work shorter than this shows no progress.
pub const PATIENCE: Duration = Duration::from_secs(1);
