//! Standard output and progress.

use std::io::{IsTerminal, Write};
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::time::Duration;

use asperity_core::{Code, Fault};
use asperity_report::{LeftOut, Report};
use asperity_storage::{NotJson, json_text};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde::Serialize;
use serde_json::{Value, json};

use crate::args::Common;
use crate::failure::Failure;

/// Prints a value as JSON.
pub fn print_json(value: &dyn erased_serde::Serialize) -> Result<(), Failure> {
    let text = json_text(value).map_err(|error| match error {
        NotJson::NotFinite(number) => Fault::internal(number).about("no result"),
        NotJson::Other(other) => Fault::internal(other).about("cannot be written as JSON"),
    })?;
    write(&format!("{text}\n"))
}

/// Prints a value as JSON if `--json` is given, otherwise as text.
pub fn print<V: Serialize>(
    common: &Common,
    value: impl FnOnce() -> V,
    text: impl FnOnce() -> String,
) -> Result<(), Failure> {
    if common.json {
        print_json(&value())
    } else {
        print_text(common, &text())
    }
}

/// Most lines of a first screen before its last line.
pub const FIRST_SCREEN: usize = 9;

/// Prints a value as JSON if `--json` is given, otherwise its report: the first screen, or everything with `--notes`. The last
/// line names the folder or file that was `written`, and counts what the first screen leaves out.
pub fn print_report<'a, V: Serialize>(
    common: &Common,
    value: impl FnOnce() -> V,
    report: impl FnOnce() -> Report<'a>,
    written: Option<&Path>,
) -> Result<(), Failure> {
    if common.json {
        return print_json(&value());
    }
    let report = report();
    let (mut text, left_out) = if common.notes {
        (report.terminal(), LeftOut::default())
    } else {
        report.brief(FIRST_SCREEN)
    };
    let more = match left_out.lines {
        0 => String::new(),
        _ => format!("{left_out}: --notes"),
    };
    let written = written.map_or(String::new(), |path| format!("wrote {}", shown(path)));
    let last = format!("{written}   {more}");
    if !last.trim().is_empty() {
        text += last.trim();
        text.push('\n');
    }
    print_verdict(common, &text, &report.verdict_lines())
}

/// Warnings with their codes as JSON.
pub fn coded(warnings: Vec<(Code, String)>) -> Value {
    let warnings = warnings.into_iter();
    warnings
        .map(|(code, text)| json!({ "code": code, "text": text }))
        .collect()
}

/// Prints text unless the command is quiet.
pub fn print_text(common: &Common, text: &str) -> Result<(), Failure> {
    if common.quiet {
        return Ok(());
    }
    write(&asperity_storage::printable(text))
}

/// Prints text as [`print_text`], with the lines `verdict` bold on a terminal.
pub fn print_verdict(common: &Common, text: &str, verdict: &[String]) -> Result<(), Failure> {
    if common.quiet {
        return Ok(());
    }
    let text = asperity_storage::printable(text);
    if !std::io::stdout().is_terminal() {
        return write(&text);
    }
    let bold = |line: &str| {
        if verdict.iter().any(|of| of == line.trim_end()) {
            format!("\u{1b}[1m{}\u{1b}[0m\n", line.trim_end())
        } else {
            line.to_owned()
        }
    };
    write(&text.split_inclusive('\n').map(bold).collect::<String>())
}

/// Width of text on standard output: of its terminal within 60 to 120 columns, otherwise 80.
pub fn columns() -> usize {
    let size = terminal_size::terminal_size_of(std::io::stdout());
    size.map_or(asperity_report::COLUMNS, |(width, _)| {
        usize::from(width.0).clamp(60, 120)
    })
}

/// Path of a file or folder as one line of text.
pub fn shown(path: &Path) -> String {
    asperity_storage::one_line(&path.display().to_string()).into_owned()
}

/// Prints a note on standard error.
pub fn note(text: &str) {
    // The reader may have closed the pipe.
    let _ = writeln!(std::io::stderr(), "{}", asperity_storage::printable(text));
}

/// Writes a file completely or not at all; `-` is standard output.
pub fn save(file: &Path, bytes: &[u8]) -> Result<(), Failure> {
    if is_standard_output(file) {
        return write_bytes(bytes);
    }
    asperity_storage::save(file, bytes).map_err(|error| Failure::new(Code::E401, error.to_string()))
}

/// Writes a file with a default name, and never replaces an existing one.
pub fn save_new(file: &Path, bytes: &[u8]) -> Result<(), Failure> {
    asperity_storage::save_new(file, bytes)
        .map_err(|error| Failure::new(Code::E401, error.to_string()))
}

/// Options for printing in addition to a file: quiet if the file itself is written to standard output.
pub fn besides_file(file: &Path, common: &Common) -> Result<Common, Failure> {
    if !is_standard_output(file) {
        return Ok(common.clone());
    }
    if common.json {
        let text = "-o - and --json both write to standard output; omit one";
        return Err(Failure::new(Code::E205, text));
    }
    Ok(Common {
        quiet: true,
        ..common.clone()
    })
}

/// Whether a file name means standard output.
pub fn is_standard_output(file: &Path) -> bool {
    file == Path::new("-")
}

fn write(text: &str) -> Result<(), Failure> {
    write_bytes(text.as_bytes())
}

/// Writes to standard output at once: nobody flushes it at the end of a process of Python. A closed pipe is not an error.
fn write_bytes(bytes: &[u8]) -> Result<(), Failure> {
    let mut output = std::io::stdout().lock();
    match output.write_all(bytes).and_then(|()| output.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::from(Fault::unwritten("standard output", error))
                .advising("Redirect the output to another place, or free some space there."))
        }
        _ => Ok(()),
    }
}

/// Time before progress is shown.
const PROGRESS_DELAY: Duration = Duration::from_secs(1);
/// Interval between drawings of uncounted work.
const TICK: Duration = Duration::from_millis(200);

/// Name of the uncounted work before a computation.
pub const READING: &str = "reading the traces";
/// Name of the uncounted work after a computation.
pub const WRITING: &str = "writing the result";

/// Progress of a command on standard error, on a terminal and after the first second: name of the work with its count and
/// the remaining time, or with the elapsed time for uncounted work.
pub struct Progress {
    bar: ProgressBar,
    /// Set at the end: no bar is drawn any more.
    _end: Sender<()>,
}

impl Progress {
    /// Starts the progress of a command with `work`.
    #[expect(
        clippy::disallowed_methods,
        reason = "a clock, which evaluates no equation"
    )]
    pub fn new(quiet: bool, work: &'static str) -> Self {
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
        let (end, ended) = channel();
        if !quiet && std::io::stderr().is_terminal() {
            let bar = bar.clone();
            std::thread::spawn(move || {
                if ended.recv_timeout(PROGRESS_DELAY) == Err(RecvTimeoutError::Timeout) {
                    bar.set_draw_target(ProgressDrawTarget::stderr());
                    bar.enable_steady_tick(TICK);
                }
            });
        }
        let progress = Self { bar, _end: end };
        progress.begin(work);
        progress
    }

    /// Starts other work, not counted yet.
    pub fn begin(&self, work: &'static str) {
        self.bar.unset_length();
        self.bar.set_position(0);
        self.style("{spinner} {msg}  {elapsed}");
        self.bar.set_message(work);
    }

    /// Shows the count `done` of `total`, which is 0 where it is not known.
    pub fn at(&self, done: usize, total: usize) {
        if total == 0 {
            if done == 1 {
                self.style("{spinner} {msg} {pos}  {elapsed}");
            }
        } else if self.bar.length() != Some(total as u64) {
            self.style("{msg} {bar:30} {pos}/{len}  {per_sec}  {eta} left");
            self.bar.set_length(total as u64);
        }
        self.bar.set_position(done as u64);
    }

    /// Prints a note above the progress.
    pub fn note(&self, text: &str) {
        self.bar.suspend(|| note(text));
    }

    fn style(&self, template: &str) {
        if let Ok(style) = ProgressStyle::with_template(template) {
            self.bar.set_style(style);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_has_no_length_before_something_is_counted() {
        let progress = Progress::new(false, "reading");
        assert_eq!(progress.bar.length(), None);
        progress.at(0, 12);
        assert_eq!(
            (progress.bar.position(), progress.bar.length()),
            (0, Some(12))
        );
        progress.at(3, 12);
        assert_eq!(progress.bar.position(), 3);
        progress.begin("writing");
        assert_eq!((progress.bar.position(), progress.bar.length()), (0, None));
    }
}
