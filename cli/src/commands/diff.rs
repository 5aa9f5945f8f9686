//! `asperity diff`: differences between two results.

use asperity::result::loss_band::rounded;
use asperity_core::{Code, Fault};
use asperity_report::{Report, columns, read_result};
use asperity_studies::diff::{Change, ResultDiff, diff as compare};
use serde_json::Value;

use crate::args::{Common, DiffArgs};
use crate::failure::Failure;
use crate::output::print_report;

/// `asperity diff`
pub fn diff(args: &DiffArgs, common: &Common) -> Result<(), Failure> {
    let read =
        |path| read_result(path).map_err(|error| Failure::new(Code::E402, error.to_string()));
    let (_, first) = read(&args.first)?;
    let (_, second) = read(&args.second)?;
    let differences = compare(&first, &second)
        .map_err(|error| Fault::internal(error).about("cannot be compared"))?;
    print_report(common, || &differences, || report(&differences), None)
}

fn report<'a>(differences: &ResultDiff) -> Report<'a> {
    let report = Report::new("", "");
    if differences.is_empty() {
        return report.verdict(["the results do not differ"]);
    }
    let path = columns! { change in &differences.path;
        head column "column" "";
        number first "first" "" = digits(change.first);
        number second "second" "" = digits(change.second);
        number position "position" "";
    };
    let report = report.verdict(loss(differences));
    let report = section(report, "inputs and defaults", &differences.inputs);
    let report = section(report, "summary", &differences.summary);
    let report = match path.is_empty() {
        true => report,
        false => report
            .heading("largest difference along the path")
            .table(path),
    };
    let lists = [
        ("warnings", &differences.warnings),
        ("equations", &differences.equations),
    ];
    lists.into_iter().fold(report, |report, (name, lists)| {
        let whose = lists.iter().zip(["first", "second"]);
        whose.fold(report, |report, (list, whose)| match list.is_empty() {
            true => report,
            false => report
                .heading(format!("{name} only in the {whose}"))
                .text(list),
        })
    })
}

/// The loss of both results.
fn loss(differences: &ResultDiff) -> Option<String> {
    let of = |key: &str| {
        let mut changes = differences.summary.iter();
        let change = changes.find(|change| change.key == key)?;
        let watts = |value: Option<&Value>| value?.as_f64();
        let (first, second) = (
            watts(change.first.as_ref())?,
            watts(change.second.as_ref())?,
        );
        Some((first, second, 100.0 * change.relative?))
    };
    let (first, second, percent) = of("loss_w")?;
    // Three digits of the larger.
    let power = |watts: f64| rounded(watts, 0.01 * first.max(second));
    Some(format!(
        "the loss of the second result is {} W, of the first {} W: {percent:+.1} %",
        power(second),
        power(first)
    ))
}

fn section<'a>(report: Report<'a>, title: &str, changes: &[Change]) -> Report<'a> {
    if changes.is_empty() {
        return report;
    }
    report.heading(title).table(columns! { change in changes;
        head key "key" "";
        text first "first" "" = shown(change.first.as_ref());
        text second "second" "" = shown(change.second.as_ref());
        number relative "change" "%" "{:+.3}" = change.relative.map(|relative| 100.0 * relative);
    })
}

fn shown(value: Option<&Value>) -> String {
    match value {
        None => "-".to_owned(),
        Some(Value::Number(number)) => match number.as_f64() {
            Some(value) if number.is_f64() => digits(value),
            _ => number.to_string(),
        },
        Some(Value::String(text)) => text.clone(),
        Some(value) => value.to_string(),
    }
}

/// Value with six significant digits.
fn digits(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e7).contains(&size) {
        return format!("{value:.5e}");
    }
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    rounded.to_string()
}
