//! `asperity diff`: differences between two results.

use asperity_core::{Code, Fault};
use asperity_report::{columns, read_result};
use asperity_studies::diff::{Change, ResultDiff, diff as compare};
use serde_json::Value;

use crate::args::{Common, DiffArgs};
use crate::failure::Failure;
use crate::output::print;

/// `asperity diff`
pub fn diff(args: &DiffArgs, common: &Common) -> Result<(), Failure> {
    let read =
        |path| read_result(path).map_err(|error| Failure::new(Code::E402, error.to_string()));
    let (_, first) = read(&args.first)?;
    let (_, second) = read(&args.second)?;
    let differences = compare(&first, &second)
        .map_err(|error| Fault::internal(error).about("cannot be compared"))?;
    print(common, || &differences, || text(&differences))
}

fn text(differences: &ResultDiff) -> String {
    if differences.is_empty() {
        return "no difference\n".to_owned();
    }
    let mut text = String::new();
    section(&mut text, "inputs and defaults", &differences.inputs);
    section(&mut text, "summary", &differences.summary);
    if !differences.path.is_empty() {
        text.push_str("largest difference along the path\n");
        let table = columns! { change in &differences.path;
            head column "column" "";
            number first "first" "" = digits(change.first);
            number second "second" "" = digits(change.second);
            number position "position" "";
        };
        text.push_str(&table.text("  "));
    }
    for (name, lists) in [
        ("warnings", &differences.warnings),
        ("equations", &differences.equations),
    ] {
        for (list, whose) in lists.iter().zip(["first", "second"]) {
            if !list.is_empty() {
                text.push_str(&format!("{name} only in the {whose}\n"));
            }
            for entry in list {
                text.push_str(&format!("  {entry}\n"));
            }
        }
    }
    text
}

fn section(text: &mut String, title: &str, changes: &[Change]) {
    if changes.is_empty() {
        return;
    }
    text.push_str(&format!("{title}\n"));
    let table = columns! { change in changes;
        head key "key" "";
        text first "first" "" = shown(change.first.as_ref());
        text second "second" "" = shown(change.second.as_ref());
        number relative "change" "%" "{:+.3}" = change.relative.map(|relative| 100.0 * relative);
    };
    text.push_str(&table.text("  "));
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
