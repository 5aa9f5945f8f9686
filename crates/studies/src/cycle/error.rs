//! Errors of a cycle.

use std::fmt::Display;

use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, Fault, number};
use asperity_table::{Ragged, RowFault};

/// Columns are missing; `found` are those of the table, or its first row.
pub(super) fn columns(found: &str, has_names: bool) -> Fault {
    let found = if has_names {
        format!("columns {found}")
    } else {
        format!("no line of names above the first row {found}")
    };
    of_names(format!(
        "{found}; required are a time with torque and speed of the pinion, or a time with the speed of a vehicle, in columns like time_s, torque_nm, speed_rpm, speed_km_h, speed_mph, grade_percent"
    ))
}

/// A quantity is stated in two columns.
pub(super) fn twice(first: &str, second: &str) -> Fault {
    of_names(format!("columns {first} and {second} state one quantity"))
}

fn of_names(text: String) -> Fault {
    let names = Value::Like("time_s,-,speed_km_h".into());
    let remedy = Remedy::act("write these names above the rows")
        .or_set(Setting::Columns, names)
        .because("in the order of the columns, where - leaves one out");
    refused(text).with(remedy)
}

/// A number of a column, or of a quantity computed from the speed of the vehicle, that is not possible for a vehicle or gear
/// drive: its absolute value is above `limit`.
pub(super) fn beyond(line: usize, column: &'static str, value: f64, limit: f64) -> Fault {
    at_line(
        line,
        format!(
            "{column} = {} is beyond -{} to {}; check unit and decimal point",
            number(value),
            number(limit),
            number(limit)
        ),
    )
}

/// Time \[s\] that does not increase.
pub(super) fn time(line: usize, time_s: f64, before: f64) -> Fault {
    at_line(
        line,
        format!(
            "time_s = {} does not rise from {} before it; if another recording begins here, take one of them",
            number(time_s),
            number(before)
        ),
    )
}

/// Fewer than two points.
pub(super) fn short() -> Fault {
    refused("a cycle needs two points at least")
}

/// The table has the speed of a vehicle, but no vehicle is given.
pub(super) fn no_vehicle() -> Fault {
    refused("the speed of a vehicle needs the table [vehicle] in the case of the map")
}

/// A number of the vehicle in SI units is not valid.
pub(super) fn vehicle(key: &'static str, value: f64, rule: &'static str) -> Fault {
    refused(format!("vehicle.{key} = {} must be {rule}", number(value)))
}

/// A row has another number of cells than the header.
pub(super) fn ragged(ragged: Ragged) -> Fault {
    Fault::from_cause(Code::E101, ragged)
}

/// A cell is not a finite number.
pub(super) fn cell(cell: RowFault) -> Fault {
    refused(format!("line {cell}"))
}

/// An error at a line of the file, counted from 1.
fn at_line(line: usize, text: impl Display) -> Fault {
    refused(format!("line {line}: {text}"))
}

fn refused(text: impl Into<String>) -> Fault {
    Fault::new(Code::E101, text)
}
