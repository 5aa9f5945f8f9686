//! Table with two columns on an even grid: positions x and a gap, a profile or a pressure, with units in the header.

use std::path::Path;

use asperity::profile_io::read::read_table;
use asperity_core::message::Warning;
use asperity_core::quantity::Length;
use asperity_core::{Code, Profile, number};
use asperity_studies::cycle::LARGEST_TABLE;
use asperity_table::Table;

use super::solved::POINTS_HEAD;
use crate::failure::Failure;

/// Values on an even grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns {
    /// Spacing of the points.
    pub spacing: Length,
    /// Positions \[m\].
    pub x: Vec<f64>,
    /// Values in SI units.
    pub values: Vec<f64>,
    /// Columns of the table that were not read.
    pub unread: Option<Warning>,
}

/// Required column.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    name: &'static str,
    /// Units in lower case, with the number of each per SI unit.
    units: &'static [(&'static str, f64)],
    /// Advice for a header without a unit.
    advice: &'static str,
}

const LENGTHS: &[(&str, f64)] = &[("m", 1.0), ("mm", 1e3), ("um", 1e6), ("nm", 1e9)];
const NAME_A_LENGTH: &str =
    "Name the unit in the header, e.g. x_um or x [um]; units are m, mm, um and nm.";

/// Positions.
const X: Column = Column {
    name: "x",
    units: LENGTHS,
    advice: NAME_A_LENGTH,
};
/// Gap of the undeformed bodies.
pub const GAP: Column = Column { name: "h", ..X };
/// Heights of a profile out of its material.
const HEIGHT: Column = Column { name: "z", ..X };
/// Pressure.
pub const PRESSURE: Column = Column {
    name: "p",
    units: &[("pa", 1.0), ("kpa", 1e-3), ("mpa", 1e-6), ("gpa", 1e-9)],
    advice: "Name the unit in the header, e.g. p_MPa or p [MPa]; units are Pa, kPa, MPa and GPa.",
};

/// Largest deviation of a position from an even grid, relative to the spacing: round-off of the file.
const UNEVEN: f64 = 0.05;

/// Reads the positions and one other column of a file.
pub fn read(path: &Path, column: Column) -> Result<Columns, Failure> {
    of_text(
        &path.display().to_string(),
        &read_table(path, LARGEST_TABLE)?,
        column,
    )
}

/// Reads the positions and one other column of the table in `text`, named `name` in messages.
pub fn of_text(name: &str, text: &str, wanted: Column) -> Result<Columns, Failure> {
    let unreadable = |fault: String| {
        Failure::new(Code::E101, format!("{name}:{fault}")).advising(
            "Check this line. With decimal commas, the columns need semicolons or tabs between them.",
        )
    };
    let table = Table::read(text).map_err(|ragged| unreadable(format!(" {ragged}")))?;
    let find = |column| find(name, &table, column, wanted);
    let ((x_column, x_unit), (column, unit)) = (find(X)?, find(wanted)?);
    let rows = table.values(|row| Ok((row.number(x_column)? / x_unit, row.number(column)? / unit)));
    let rows = rows.map_err(|fault| unreadable(fault.to_string()))?;
    let (x, values): (Vec<f64>, Vec<f64>) = rows.into_iter().unzip();
    let is_own = table.heads().eq(POINTS_HEAD.split(','));
    Ok(Columns {
        spacing: even_spacing(name, &table, &x)?,
        x,
        values,
        unread: table.unread(name).filter(|_| !is_own),
    })
}

/// Reads a profile from a file with the columns x and z, and the warning of columns that were not read.
pub fn profile(path: &Path) -> Result<(Profile, Option<Warning>), Failure> {
    let file = read(path, HEIGHT)?;
    // The spacing of positions with few digits is accurate to about as many digits, so it is rounded.
    let spacing = Length::from_si(
        format!("{:.9e}", file.spacing.si())
            .parse()
            .unwrap_or(file.spacing.si()),
    );
    let profile = Profile::new(spacing, file.values)
        .map_err(|error| Failure::new(Code::E209, format!("{}: {error}", path.display())))?;
    Ok((profile, file.unread))
}

/// Name of `column` in the table, and the number of its units per SI unit.
fn find<'a>(
    name: &str,
    table: &'a Table,
    column: Column,
    wanted: Column,
) -> Result<(&'a str, f64), Failure> {
    /// Signs between a symbol and its unit.
    const SIGNS: [char; 3] = ['_', '/', ','];
    let unit = |title: &'a str| {
        let rest = title.strip_prefix(column.name)?;
        (rest.is_empty() || rest.starts_with(SIGNS)).then_some(rest)
    };
    let mut titles = table.names().iter().zip(table.heads());
    let found = titles.find_map(|(title, head)| Some((title, head, unit(title)?)));
    let (title, head, unit) = found.ok_or_else(|| no_column(name, column, wanted))?;
    let unit = unit.trim_start_matches(SIGNS).trim_start_matches("in_");
    let unit = unit.replace(['µ', 'μ'], "u");
    let known = column.units.iter().find(|(name, _)| *name == unit);
    let (_, per_unit) = known.ok_or_else(|| no_unit(name, head, column))?;
    Ok((title, *per_unit))
}

fn even_spacing(name: &str, table: &Table, x: &[f64]) -> Result<Length, Failure> {
    let refused = |code: Code, text: String, advice: &'static str| {
        Failure::new(code, format!("{name}:{text}")).advising(advice)
    };
    let few = |code, text: &str| {
        let advice = "Give one row per point below the header.";
        refused(code, text.to_owned(), advice)
    };
    let (first, last) = match x {
        [] => return Err(few(Code::E102, " no rows below the header")),
        [_] => {
            let text = " one point is too few for a contact; give at least two";
            return Err(few(Code::E106, text));
        }
        [first, .., last] => (*first, *last),
    };
    let spacing = (last - first) / (x.len() - 1) as f64;
    if spacing <= 0.0 {
        let (first, last) = (number(first), number(last));
        let text = format!(" column x must increase, it runs from {first} m to {last} m");
        return Err(refused(Code::E105, text, "Sort the rows by x."));
    }
    for (index, (row, value)) in table.rows().zip(x).enumerate() {
        let expected = first + spacing * index as f64;
        if (value - expected).abs() > UNEVEN * spacing {
            let text = format!(
                "{}: x = {value} m is off the even grid of {spacing} m (expected {expected} m); \
                 resample the gap evenly",
                row.line
            );
            let advice = "Resample the rows at even positions.";
            return Err(refused(Code::E109, text, advice));
        }
    }
    Ok(Length::from_si(spacing))
}

fn no_unit(name: &str, title: &str, column: Column) -> Failure {
    let units: Vec<&str> = column.units.iter().map(|(unit, _)| *unit).collect();
    let kind = match column.units == LENGTHS {
        true => "length",
        false => "pressure",
    };
    Failure::new(
        Code::E104,
        format!(
            "{name}: the header \"{title}\" does not name a {kind} unit ({})",
            units.join(", ")
        ),
    )
    .advising(column.advice)
}

fn no_column(name: &str, missing: Column, wanted: Column) -> Failure {
    let unit = wanted.units[wanted.units.len() / 2].0;
    Failure::new(
        Code::E102,
        format!(
            "{name}: no column {}; the header must name the columns with their units, e.g. \"x_um,{}_{unit}\"",
            missing.name, wanted.name
        ),
    )
    .advising("Name the columns in a line above the rows.")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_name_their_units_in_the_usual_ways() {
        for header in [
            "x_um,h_nm",
            "x [um],h [nm]",
            "x (µm);h (nm)",
            "x in um\th in nm",
            "\"x/um\",\"h/nm\"",
        ] {
            let mut separators = [';', '\t', ','].into_iter();
            let separator = separators.find(|c| header.contains(*c)).unwrap();
            let text = format!("{header}\n0{separator}1\n2{separator}3\n4{separator}5\n");
            let read = of_text("gap.csv", &text, GAP).unwrap();
            assert_eq!(read.spacing.si(), 2e-6, "{header}");
            assert_eq!(read.values, [1e-9, 3e-9, 5e-9], "{header}");
        }
    }

    #[test]
    fn every_bad_gap_file_says_where_and_why() {
        for (text, expected) in [
            ("", "no column x"),
            ("x_um,z_um\n0,1\n", "no column h"),
            ("x,h\n0,1\n", "does not name a length unit"),
            (
                "x_um,h_um\n0,1\n1,a\n",
                "E101 gap.csv:3: h_um: \"a\" is not a finite number",
            ),
            ("x_um,h_um\n0,1\n1\n", "E101 gap.csv: line 3 has 1 cells"),
            ("x_um,h_um\n0,1\n1,nan\n", "h_um: \"nan\" is not"),
            (
                "x_um,h_um\n0,1\n\n1,1\n5,1\n",
                "E109 gap.csv:4: x = 0.000001 m is off the even grid",
            ),
            ("x_um,h_um\n5,1\n1,1\n", "must increase"),
            ("x_um,h_um\n5,1\n", "one point"),
            ("x_um,h_um\n", "no rows below"),
            ("0,1\n1,1\n", "E102 gap.csv: no column x"),
        ] {
            let message = of_text("gap.csv", text, GAP).unwrap_err().to_string();
            assert!(message.contains(expected), "{message}");
        }
    }

    #[test]
    fn columns_that_are_not_read_are_named_unless_the_program_wrote_them() {
        let unread = |text: &str| of_text("gap.csv", text, GAP).unwrap().unread;
        let warning = unread("x_um,remark,h_um,p_MPa\n0,a,1,2\n1,b,1,2\n").unwrap();
        let expected = "W454 columns of gap.csv that are not read: remark, p_MPa";
        assert_eq!(warning.to_string(), expected);
        let rows = "0,1,2,3,4,5\n1,1,2,3,4,5\n";
        assert_eq!(unread(&format!("{POINTS_HEAD}\n{rows}")), None);
        assert_eq!(unread("x_um;h_um\n0;1,5\n1;2\n"), None);
    }

    #[test]
    fn pressures_have_units_of_their_own() {
        let read = of_text("p.csv", "x_um\tp [MPa]\n0\t1\n1\t2\n", PRESSURE).unwrap();
        assert_eq!(read.values, [1e6, 2e6]);
        let below = of_text("p.csv", "x;p\num;MPa\n0;1\n1;2\n", PRESSURE).unwrap();
        assert_eq!(below, read);
        let message = of_text("p.csv", "x_um,p_um\n0,1\n", PRESSURE).unwrap_err();
        assert!(message.to_string().contains("pressure unit"), "{message}");
    }
}
