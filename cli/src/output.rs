//! Standard output and progress.

use std::io::{IsTerminal, Write};
use std::path::Path;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde::Serialize;

use crate::args::Common;
use crate::failure::Failure;

/// Prints a value as JSON.
pub fn print_json<T: Serialize + ?Sized>(value: &T) -> Result<(), Failure> {
    asperity_storage::check_finite(value)
        .map_err(|error| Failure::new("E501", format!("no result: {error}")))?;
    let text = serde_json::to_string_pretty(value)
        .map_err(|error| Failure::new("E501", format!("cannot be written as JSON: {error}")))?;
    write(&format!("{text}\n"))
}

/// Prints text unless it is to be quiet.
pub fn print_text(common: &Common, text: &str) -> Result<(), Failure> {
    if common.quiet {
        return Ok(());
    }
    write(&asperity_storage::printable(text))
}

/// A file or folder for a line of text.
pub fn shown(path: &Path) -> String {
    asperity_storage::one_line(&path.display().to_string()).into_owned()
}

/// Prints a remark beside the result.
pub fn note(text: &str) {
    // Whoever reads may have gone away.
    let _ = writeln!(std::io::stderr(), "{}", asperity_storage::printable(text));
}

/// Writes a file whole or not at all; `-` is standard output.
pub fn save(file: &Path, bytes: &[u8]) -> Result<(), Failure> {
    if is_standard_output(file) {
        return write_bytes(bytes);
    }
    asperity_storage::save(file, bytes).map_err(|error| Failure::new("E401", error.to_string()))
}

/// Writes a file whose name the user did not choose: never over another.
pub fn save_new(file: &Path, bytes: &[u8]) -> Result<(), Failure> {
    asperity_storage::save_new(file, bytes).map_err(|error| Failure::new("E401", error.to_string()))
}

/// Options for what is printed beside a file: nothing where the file itself goes to standard output.
pub fn beside(file: &Path, common: &Common) -> Result<Common, Failure> {
    if !is_standard_output(file) {
        return Ok(common.clone());
    }
    if common.json {
        let text = "-o - and --json both write to standard output; leave one out";
        return Err(Failure::new("E205", text));
    }
    Ok(Common {
        quiet: true,
        ..common.clone()
    })
}

fn is_standard_output(file: &Path) -> bool {
    file == Path::new("-")
}

fn write(text: &str) -> Result<(), Failure> {
    write_bytes(text.as_bytes())
}

/// A reader that has gone away is not an error.
fn write_bytes(bytes: &[u8]) -> Result<(), Failure> {
    match std::io::stdout().write_all(bytes) {
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
