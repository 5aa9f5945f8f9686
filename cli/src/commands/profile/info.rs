//! `asperity profile info` and `compare`: one report, or a table of many.

use std::fmt::Write as _;
use std::path::Path;

use asperity_report::wrapped;

use super::details::Details;
use super::evaluated::{Evaluated, um};
use super::plan::Plan;
use super::{json, text};
use crate::args::{Common, ProfileInfoArgs};
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// `asperity profile info`; of many files those that can be read, and then what is wrong with the others.
pub fn info(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    check(args, common)?;
    if let [file] = args.files.as_slice() {
        let found = evaluated(file, args)?;
        return match common.json {
            true => print_json(&as_json(&found, args)),
            false => print_text(common, &text::report(&found, &Details::of(&found, args))),
        };
    }
    let (mut entries, mut good, mut failures) = (Vec::new(), Vec::new(), Vec::new());
    for file in &args.files {
        match evaluated(file, args) {
            Ok(found) if common.json => entries.push(as_json(&found, args)),
            Ok(found) => good.push(Row::of(&found)),
            Err(failure) => {
                if common.json {
                    entries.push(refused_entry(file, &failure));
                }
                failures.push(failure);
            }
        }
    }
    if common.json {
        print_json(&entries)?;
    }
    for failure in &failures {
        failure.tell();
    }
    if !good.is_empty() {
        print_text(common, &table(&good))?;
    }
    let first = failures.into_iter().next();
    first.map_or(Ok(()), |failure| Err(failure.told()))
}

/// `asperity profile compare`
pub fn compare(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    check(args, common)?;
    let all = args.files.iter().map(|file| evaluated(file, args));
    if common.json {
        let reports = all.map(|found| Ok(as_json(&found?, args)));
        return print_json(&reports.collect::<Result<Vec<_>, Failure>>()?);
    }
    // Of each file its row alone is kept.
    let rows = all.map(|found| Ok(Row::of(&found?)));
    let rows = rows.collect::<Result<Vec<_>, Failure>>()?;
    print_text(common, &(table(&rows) + &ratios(&rows)))
}

fn refused_entry(file: &Path, failure: &Failure) -> serde_json::Value {
    let mut entry = failure.json();
    entry["file"] = serde_json::json!(file.display().to_string());
    entry
}

fn check(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    if args.curves && !common.json {
        let text = "--curves needs --json; asperity profile plot draws the curves";
        return Err(Failure::new("E205", text));
    }
    // A contradiction is told once, not for every file.
    Plan::of(&args.preparing).map(|_| ())
}

fn evaluated(file: &Path, args: &ProfileInfoArgs) -> Result<Evaluated, Failure> {
    Evaluated::of(file, &args.preparing, &args.reading)
}

fn as_json(found: &Evaluated, args: &ProfileInfoArgs) -> serde_json::Value {
    json::report(found, &Details::of(found, args), args.curves)
}

type Column = (&'static str, fn(&Evaluated) -> f64);

const COLUMNS: [Column; 9] = [
    ("Ra", |e| um(e.iso4287.heights.ra)),
    ("Rq", |e| um(e.iso4287.heights.rq)),
    ("Rz", |e| um(e.iso4287.heights.rz)),
    ("Rt", |e| um(e.iso4287.heights.rt)),
    ("Rsk", |e| e.iso4287.heights.rsk.unwrap_or(f64::NAN)),
    ("RSm", |e| e.iso4287.heights.rsm.map_or(f64::NAN, um)),
    ("Rk", |e| um(e.iso4287.material.rk)),
    ("Rpk", |e| um(e.iso4287.material.rpk)),
    ("Rvk", |e| um(e.iso4287.material.rvk)),
];

/// A file in the table.
struct Row {
    name: String,
    points: usize,
    dx_um: f64,
    values: [f64; COLUMNS.len()],
    notes: Vec<String>,
}

impl Row {
    fn of(found: &Evaluated) -> Self {
        let name = shortened(&found.reading.name);
        let warnings = found.warnings();
        let notes = warnings.iter().map(|warning| {
            let note = format!("{name}: {} {warning}", warning.code());
            wrapped(&note, "    ")
        });
        Self {
            points: found.reading.points,
            dx_um: um(found.reading.spacing),
            values: COLUMNS.map(|(_, value)| value(found)),
            notes: notes.collect(),
            name,
        }
    }
}

/// A row a file, ISO 4287, in um.
fn table(rows: &[Row]) -> String {
    let mut text = format!("{:24} {:>8} {:>9}", "ISO 4287, um", "n", "dx");
    for (name, _) in COLUMNS {
        let _ = write!(text, " {name:>8}");
    }
    text.push('\n');
    for row in rows {
        let _ = write!(text, "{:24} {:>8} {:>9.5}", row.name, row.points, row.dx_um);
        for value in row.values {
            let _ = write!(text, " {:>8}", number(value));
        }
        text.push('\n');
    }
    for note in rows.iter().flat_map(|row| &row.notes) {
        let _ = writeln!(text, "{note}");
    }
    text
}

/// Every parameter over that of the first file.
fn ratios(rows: &[Row]) -> String {
    let Some(first) = rows.first() else {
        return String::new();
    };
    let mut text = format!("{:43}", "relative to the first");
    for (name, _) in COLUMNS {
        let _ = write!(text, " {name:>8}");
    }
    text.push('\n');
    for row in rows {
        let _ = write!(text, "{:43}", row.name);
        for (value, of_first) in row.values.iter().zip(first.values) {
            let _ = write!(text, " {:>8}", number(value / of_first));
        }
        text.push('\n');
    }
    text
}

fn number(value: f64) -> String {
    match value.is_finite() {
        true if value.abs() < 100.0 => format!("{value:.4}"),
        true => format!("{value:.1}"),
        false => "none".to_owned(),
    }
}

/// The end of a long name, which distinguishes files.
fn shortened(name: &str) -> String {
    const MOST: usize = 24;
    let base = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let skipped = base.chars().count().saturating_sub(MOST);
    base.chars().skip(skipped).collect()
}
