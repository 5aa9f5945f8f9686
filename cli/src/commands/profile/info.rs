//! `asperity profile info` and `compare`: one report, or a table of many.

use std::fmt::Write as _;

use asperity_core::quantity::Length;
use asperity_roughness::ambiguity::ambiguity;
use asperity_roughness::autocorrelation;
use asperity_roughness::summits::summit_statistics;

use super::{Evaluated, filter, recipe, um};
use crate::args::{Common, ProfileInfoArgs};
use crate::commands::profile::report;
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// `asperity profile info`
pub fn info(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    let found = evaluated(args)?;
    if common.json {
        let reports: Vec<_> = found.iter().map(|found| as_json(found, args)).collect();
        return match reports.as_slice() {
            [one] => print_json(one),
            many => print_json(many),
        };
    }
    if let [one] = found.as_slice() {
        return print_text(common, &report::text(one, &args.preparing));
    }
    print_text(common, &table(&found))
}

/// `asperity profile compare`
pub fn compare(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    let found = evaluated(args)?;
    if common.json {
        let reports: Vec<_> = found.iter().map(|found| as_json(found, args)).collect();
        return print_json(&reports);
    }
    print_text(common, &(table(&found) + &ratios(&found)))
}

fn evaluated(args: &ProfileInfoArgs) -> Result<Vec<Evaluated>, Failure> {
    let of = |file: &std::path::PathBuf| Evaluated::of(file, &args.preparing, &args.reading);
    args.files.iter().map(of).collect()
}

/// The report with what costs more than a look: correlation, summits, what is ambiguous.
fn as_json(found: &Evaluated, args: &ProfileInfoArgs) -> serde_json::Value {
    let mut value = report::json(found);
    let rough = &found.parts.roughness.profile;
    let lengths = autocorrelation::lengths(rough).ok();
    let window = recipe(&args.preparing).lambda_s.unwrap_or(rough.spacing());
    let summits = summit_statistics(
        rough,
        Length::from_si(window.si().max(rough.spacing().si())),
    )
    .ok();
    let open = recipe(&args.preparing).lambda_c.and_then(|lambda_c| {
        let recipe = recipe(&args.preparing);
        ambiguity(
            &found.reading.profile,
            &recipe,
            filter(&args.preparing),
            lambda_c,
        )
        .ok()
    });
    if let Some(object) = value.as_object_mut() {
        object.insert("autocorrelation".into(), serde_json::json!(lengths));
        object.insert("summits".into(), serde_json::json!(summits));
        object.insert("ambiguity".into(), serde_json::json!(open));
    }
    value
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
            let _ = writeln!(
                text,
                "{}: {} {warning}",
                shortened(&found.reading.name),
                warning.code()
            );
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
