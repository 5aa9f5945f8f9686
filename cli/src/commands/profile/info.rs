//! `asperity profile info` and `compare`: one report, or a table of many.

use std::fmt::Write as _;

use asperity::report::wrapped;

use super::details::Details;
use super::{Evaluated, json, text, um};
use crate::args::{Common, ProfileInfoArgs};
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// `asperity profile info`
pub fn info(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    let found = evaluated(args, common)?;
    match found.as_slice() {
        [one] if common.json => print_json(&as_json(one, args)),
        [one] => print_text(common, &text::report(one, &Details::of(one, args.hurst))),
        many if common.json => print_json(&all_as_json(many, args)),
        many => print_text(common, &table(many)),
    }
}

/// `asperity profile compare`
pub fn compare(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    let found = evaluated(args, common)?;
    if common.json {
        return print_json(&all_as_json(&found, args));
    }
    print_text(common, &(table(&found) + &ratios(&found)))
}

fn evaluated(args: &ProfileInfoArgs, common: &Common) -> Result<Vec<Evaluated>, Failure> {
    if args.curves && !common.json {
        let text =
            "--curves are for programs: say --json with it, or asperity profile plot for a picture";
        return Err(Failure::new("E205", text));
    }
    let of = |file: &std::path::PathBuf| Evaluated::of(file, &args.preparing, &args.reading);
    args.files.iter().map(of).collect()
}

fn as_json(found: &Evaluated, args: &ProfileInfoArgs) -> serde_json::Value {
    json::report(found, &Details::of(found, args.hurst), args.curves)
}

fn all_as_json(found: &[Evaluated], args: &ProfileInfoArgs) -> Vec<serde_json::Value> {
    found.iter().map(|found| as_json(found, args)).collect()
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
