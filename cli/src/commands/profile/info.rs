//! `asperity profile info` and `compare`: one report, or a table of many.

use std::path::Path;

use asperity_core::Code;
use asperity_report::profile_json::um;
use asperity_report::{Column, Kind, Report, Table, columns};

use super::case_lines::case_lines;
use super::details::Details;
use super::evaluated::{EvaluatedFile, opened_trace};
use super::file_facts::FileFacts;
use super::plan::PreparationPlan;
use super::{json, surface_facts, text};
use crate::args::{Common, ProfileInfoArgs};
use crate::failure::Failure;
use crate::output::{print_json, print_report};

/// `asperity profile info`; for several files the readable ones, then the errors of the others.
pub fn info(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    check(args, common)?;
    if let [file] = args.files.as_slice() {
        let trace = match opened_trace(file, &args.reading, args.preparing.base_radius) {
            // A file of several traces is a surface until one of them is chosen.
            Err(failure) if failure.is_of_several() && args.reading.row.is_none() => {
                let is_shown = surface_facts::print(file, args, common, &failure)?;
                return Err(if is_shown && common.json {
                    within_json(failure)
                } else {
                    failure
                });
            }
            trace => trace?,
        };
        let facts = FileFacts::new(&trace, &args.reading);
        return match EvaluatedFile::of_trace(trace, &args.preparing, &args.reading) {
            Ok(evaluated_file) => {
                let details = Details::new(&evaluated_file, args);
                let used = evaluated_file.plan.recipe.lambda_c;
                let lines = case_lines(file, args, Some(used.unwrap_or_default()), None);
                print_report(
                    common,
                    || json::report(&evaluated_file, &details, args.curves),
                    || text::report(&evaluated_file, &facts, &details, lines),
                    None,
                )
            }
            // A contradiction of options is no property of the trace.
            Err(failure) if !failure.is_of_trace() => Err(failure),
            // What was read is shown even if it has no parameters.
            Err(failure) if common.json => {
                print_json(&facts.json(&failure))?;
                Err(within_json(failure))
            }
            Err(failure) => {
                let lines = case_lines(file, args, args.preparing.lambda_c, None);
                let reason = "no parameters: the error says why";
                let report = || facts.report().verdict([reason]).code(lines);
                print_report(common, || (), report, None)?;
                Err(failure)
            }
        };
    }
    let (mut entries, mut good, mut failures) = (Vec::new(), Vec::new(), Vec::new());
    for file in &args.files {
        match evaluated(file, args) {
            Ok(evaluated_file) if common.json => entries.push(as_json(&evaluated_file, args)),
            Ok(evaluated_file) => good.push(FileRow::from_evaluated(&evaluated_file)),
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
        failure.print();
    }
    if !common.json && !good.is_empty() {
        print_report(common, || (), || of_rows(&good), None)?;
    }
    let first = failures.into_iter().next();
    first.map_or(Ok(()), |failure| Err(failure.printed()))
}

/// `asperity profile compare`
pub fn compare(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    check(args, common)?;
    let all = args.files.iter().map(|file| evaluated(file, args));
    if common.json {
        let reports = all.map(|evaluated_file| Ok(as_json(&evaluated_file?, args)));
        return print_json(&reports.collect::<Result<Vec<_>, Failure>>()?);
    }
    // Only the row of each file is stored.
    let rows = all.map(|evaluated_file| Ok(FileRow::from_evaluated(&evaluated_file?)));
    let rows = rows.collect::<Result<Vec<_>, Failure>>()?;
    print_report(common, || (), || of_rows(&rows).table(ratios(&rows)), None)
}

/// An error that is part of the JSON already printed: only its text remains to be printed.
fn within_json(failure: Failure) -> Failure {
    failure.print();
    failure.printed()
}

fn refused_entry(file: &Path, failure: &Failure) -> serde_json::Value {
    let mut entry = failure.json();
    entry["file"] = serde_json::json!(file.display().to_string());
    entry
}

fn check(args: &ProfileInfoArgs, common: &Common) -> Result<(), Failure> {
    if args.curves && !common.json {
        let text = "--curves needs --json; asperity profile plot draws the curves";
        return Err(Failure::new(Code::E205, text));
    }
    // A contradiction of options is reported once, not for every file.
    PreparationPlan::from_args(&args.preparing).map(|_| ())
}

fn evaluated(file: &Path, args: &ProfileInfoArgs) -> Result<EvaluatedFile, Failure> {
    EvaluatedFile::new(file, &args.preparing, &args.reading)
}

fn as_json(evaluated_file: &EvaluatedFile, args: &ProfileInfoArgs) -> serde_json::Value {
    json::report(
        evaluated_file,
        &Details::new(evaluated_file, args),
        args.curves,
    )
}

/// Parameters of a table: name, unit, value.
type ListedParameter = (&'static str, &'static str, fn(&EvaluatedFile) -> f64);

const PARAMETERS: [ListedParameter; 9] = [
    ("Ra", "µm", |e| um(e.iso4287.heights.ra)),
    ("Rq", "µm", |e| um(e.iso4287.heights.rq)),
    ("Rz", "µm", |e| um(e.iso4287.heights.rz)),
    ("Rt", "µm", |e| um(e.iso4287.heights.rt)),
    ("Rsk", "", |e| e.iso4287.heights.rsk.unwrap_or(f64::NAN)),
    ("RSm", "µm", |e| e.iso4287.heights.rsm.map_or(f64::NAN, um)),
    ("Rk", "µm", |e| um(e.iso4287.material.rk)),
    ("Rpk", "µm", |e| um(e.iso4287.material.rpk)),
    ("Rvk", "µm", |e| um(e.iso4287.material.rvk)),
];

/// FileRow of a file in the table.
struct FileRow {
    name: String,
    points: usize,
    dx_um: f64,
    values: [f64; PARAMETERS.len()],
    notes: Vec<String>,
}

impl FileRow {
    fn from_evaluated(evaluated_file: &EvaluatedFile) -> Self {
        let name = shortened(&evaluated_file.reading.name);
        let warnings = evaluated_file.warnings();
        let notes = warnings
            .iter()
            .map(|warning| format!("{name}: {} {warning}", warning.code()));
        Self {
            points: evaluated_file.reading.points,
            dx_um: um(evaluated_file.reading.spacing),
            values: PARAMETERS.map(|(.., value)| value(evaluated_file)),
            notes: notes.collect(),
            name,
        }
    }
}

/// A row of ISO 4287 per file, and the warnings.
fn of_rows<'a>(rows: &[FileRow]) -> Report<'a> {
    let table = columns! { row in rows;
        head name "ISO 4287" "";
        number points "points" "";
        number dx_um "spacing" "µm" "{:.5}";
    };
    let values = PARAMETERS.iter().enumerate().map(|(k, (name, unit, _))| {
        let cells = rows.iter().map(|row| number(row.values[k]));
        Column::new(Kind::Number, name, unit, cells)
    });
    Report::new("", "")
        .table(table.with(values))
        .warning(rows.iter().flat_map(|row| &row.notes))
}

/// Parameters relative to the first file.
fn ratios(rows: &[FileRow]) -> Table {
    let Some(first) = rows.first() else {
        return Table::default();
    };
    let table = columns! { row in rows; head name "relative to the first" ""; };
    let values = PARAMETERS.iter().enumerate().map(|(k, (name, ..))| {
        let cells = rows
            .iter()
            .map(|row| number(row.values[k] / first.values[k]));
        Column::new(Kind::Number, name, "", cells)
    });
    table.with(values)
}

fn number(value: f64) -> String {
    match value.is_finite() {
        true if value.abs() < 100.0 => format!("{value:.4}"),
        true => format!("{value:.1}"),
        false => "none".to_owned(),
    }
}

/// End of a long name, which distinguishes files.
fn shortened(name: &str) -> String {
    const MOST: usize = 24;
    let base = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let skipped = base.chars().count().saturating_sub(MOST);
    base.chars().skip(skipped).collect()
}
