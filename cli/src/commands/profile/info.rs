//! `asperity profile info` and `compare`: one report, or a table of many.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use asperity_report::wrapped;

use super::details::Details;
use super::plan::Plan;
use super::{Evaluated, json, text, um};
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
            false => print_text(
                common,
                &text::report(&found, &Details::of(&found, args.hurst)),
            ),
        };
    }
    let all: Vec<_> = args
        .files
        .iter()
        .map(|file| evaluated(file, args))
        .collect();
    if common.json {
        let entry = |(file, found): (&PathBuf, &Result<Evaluated, Failure>)| match found {
            Ok(found) => as_json(found, args),
            Err(failure) => {
                let mut entry = failure.json();
                entry["file"] = serde_json::json!(file.display().to_string());
                entry
            }
        };
        let entries: Vec<_> = args.files.iter().zip(&all).map(entry).collect();
        print_json(&entries)?;
    }
    let mut refused = None;
    let mut good = Vec::new();
    for found in all {
        match found {
            Ok(found) => good.push(found),
            Err(failure) => {
                failure.tell();
                refused = refused.or(Some(failure));
            }
        }
    }
    if !common.json && !good.is_empty() {
        print_text(common, &table(&good))?;
    }
    refused.map_or(Ok(()), |failure| Err(failure.told()))
}

/// `asperity profile compare`
pub fn compare(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    check(args, common)?;
    let all = args.files.iter().map(|file| evaluated(file, args));
    let found = all.collect::<Result<Vec<_>, _>>()?;
    if common.json {
        let reports: Vec<_> = found.iter().map(|found| as_json(found, args)).collect();
        return print_json(&reports);
    }
    print_text(common, &(table(&found) + &ratios(&found)))
}

fn check(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    if args.curves && !common.json {
        let text =
            "--curves are for programs: say --json with it, or asperity profile plot for a picture";
        return Err(Failure::new("E205", text));
    }
    // A contradiction is told once, not for every file.
    Plan::of(&args.preparing).map(|_| ())
}

fn evaluated(file: &Path, args: &ProfileInfoArgs) -> Result<Evaluated, Failure> {
    Evaluated::of(file, &args.preparing, &args.reading)
}

fn as_json(found: &Evaluated, args: &ProfileInfoArgs) -> serde_json::Value {
    json::report(found, &Details::of(found, args.hurst), args.curves)
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

/// A row a file, ISO 4287, in um.
fn table(found: &[Evaluated]) -> String {
    let mut text = format!("{:24} {:>8} {:>9}", "ISO 4287, um", "n", "dx");
    for (name, _) in COLUMNS {
        let _ = write!(text, " {name:>8}");
    }
    text.push('\n');
    for found in found {
        let name = shortened(&found.reading.name);
        let (n, dx) = (found.reading.points, um(found.reading.spacing));
        let _ = write!(text, "{name:24} {n:>8} {dx:>9.5}");
        for (_, value) in COLUMNS {
            let _ = write!(text, " {:>8}", number(value(found)));
        }
        text.push('\n');
    }
    for found in found {
        for warning in found.warnings() {
            let name = shortened(&found.reading.name);
            let note = format!("{name}: {} {warning}", warning.code());
            let _ = writeln!(text, "{}", wrapped(&note, "    "));
        }
    }
    text
}

/// Every parameter over that of the first file.
fn ratios(found: &[Evaluated]) -> String {
    let Some(first) = found.first() else {
        return String::new();
    };
    let mut text = format!("{:43}", "relative to the first");
    for (name, _) in COLUMNS {
        let _ = write!(text, " {name:>8}");
    }
    text.push('\n');
    for found in found {
        let _ = write!(text, "{:43}", shortened(&found.reading.name));
        for (_, value) in COLUMNS {
            let _ = write!(text, " {:>8}", number(value(found) / value(first)));
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

/// The end of a long name, which tells files apart.
fn shortened(name: &str) -> String {
    const MOST: usize = 24;
    let base = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let skipped = base.chars().count().saturating_sub(MOST);
    base.chars().skip(skipped).collect()
}
