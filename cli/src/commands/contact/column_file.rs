//! Text file with two columns on an even grid: positions x and a gap, a profile or a pressure, with units in the
//! header.

use std::io::Read;
use std::path::Path;

use asperity_core::quantity::Length;
use asperity_core::{Code, Fault, Profile};
use asperity_storage::regular_file;

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
/// Largest file in bytes: about ten million points.
const MAX_BYTES: u64 = 1 << 29;

/// Reads the positions and one other column of a file.
pub fn read(path: &Path, column: Column) -> Result<Columns, Failure> {
    let name = path.display().to_string();
    let cannot = |error: std::io::Error| {
        Failure::from(Fault::unopened(&name, error)).advising("Check the name and the permissions.")
    };
    let mut bytes = vec![];
    let file = regular_file(path).map_err(cannot)?;
    file.take(MAX_BYTES + 1)
        .read_to_end(&mut bytes)
        .map_err(cannot)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(Failure::new(
            Code::E118,
            format!(
                "{name}: larger than {} MiB, which no gap or profile is",
                MAX_BYTES >> 20
            ),
        )
        .advising("Give a file with one row per point."));
    }
    of_bytes(&name, &bytes, column)
}

/// Reads the positions and one other column of the content of the file `name`.
pub fn of_bytes(name: &str, bytes: &[u8], column: Column) -> Result<Columns, Failure> {
    let text = decoded(bytes).ok_or_else(|| {
        Failure::new(
            Code::E108,
            format!("{name}: not text: it holds bytes that are not characters"),
        )
        .advising("Save the columns as text, in UTF-8, UTF-16 or Latin-1.")
    })?;
    parse(name, &text, column)
}

/// Reads a profile from a file with the columns x and z.
pub fn profile(path: &Path) -> Result<Profile, Failure> {
    let file = read(path, HEIGHT)?;
    // The spacing of positions with few digits is accurate to about as many digits, so it is rounded.
    let spacing = Length::from_si(
        format!("{:.9e}", file.spacing.si())
            .parse()
            .unwrap_or(file.spacing.si()),
    );
    Profile::new(spacing, file.values)
        .map_err(|error| Failure::new(Code::E209, format!("{}: {error}", path.display())))
}

/// Decodes `bytes` in UTF-8, in UTF-16 with or without a byte order mark, or else in Latin-1; `None` if it is not
/// text.
fn decoded(bytes: &[u8]) -> Option<String> {
    let utf16 = |bytes: &[u8], unit: fn([u8; 2]) -> u16| -> Option<String> {
        let (pairs, rest) = bytes.as_chunks::<2>();
        let text = char::decode_utf16(pairs.iter().map(|&pair| unit(pair)));
        rest.is_empty()
            .then(|| text.collect::<Result<_, _>>().ok())?
    };
    let text = match bytes {
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes)?,
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes)?,
        // The header consists of ASCII characters, whose upper bytes are zero.
        [first, 0, ..] if *first != 0 => utf16(bytes, u16::from_le_bytes)?,
        [0, first, ..] if *first != 0 => utf16(bytes, u16::from_be_bytes)?,
        _ => match std::str::from_utf8(bytes) {
            Ok(text) => text.trim_start_matches('\u{feff}').to_owned(),
            Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
        },
    };
    let is_text = |c: char| !c.is_control() || matches!(c, '\n' | '\r' | '\t' | '\u{c}' | '\u{1a}');
    text.chars().all(is_text).then_some(text)
}

fn parse(name: &str, text: &str, wanted: Column) -> Result<Columns, Failure> {
    let header = text.lines().next().unwrap_or_default();
    let separator = [';', '\t', ',']
        .into_iter()
        .find(|c| header.contains(*c))
        .ok_or_else(|| no_column(name, X, wanted))?;
    let titles: Vec<&str> = header.split(separator).map(str::trim).collect();
    let find = |column| find(name, &titles, column, wanted);
    let ((x_column, x_unit), (column, unit)) = (find(X)?, find(wanted)?);
    let mut x = Vec::new();
    let mut values = Vec::new();
    for (index, line) in text.lines().enumerate().skip(1) {
        if line.trim().is_empty() {
            continue;
        }
        let cells: Vec<&str> = line.split(separator).collect();
        let value = |column: usize, unit: f64| {
            let cell = cells.get(column).map_or("", |cell| cell.trim());
            number(cell, separator)
                .map(|value| value / unit)
                .ok_or_else(|| unreadable(name, index + 1, cell))
        };
        x.push(value(x_column, x_unit)?);
        values.push(value(column, unit)?);
    }
    let spacing = even_spacing(name, &x)?;
    Ok(Columns { spacing, x, values })
}

/// Index of `column`, and the number of its units per SI unit.
fn find(
    name: &str,
    titles: &[&str],
    column: Column,
    wanted: Column,
) -> Result<(usize, f64), Failure> {
    for (index, title) in titles.iter().enumerate() {
        let bare = title.trim_matches('"').trim();
        let lower = bare.to_lowercase();
        let Some(rest) = lower.strip_prefix(column.name) else {
            continue;
        };
        let is_unit_part = rest.is_empty() || rest.starts_with([' ', '_', '[', '(', '/', ',']);
        if !is_unit_part {
            continue;
        }
        let unit = rest
            .trim_start_matches([' ', '_', '[', '(', '/'])
            .trim_start_matches("in ")
            .trim_end_matches([']', ')', ' '])
            .replace(['µ', 'μ'], "u");
        let known = column.units.iter().find(|(name, _)| *name == unit);
        return match known {
            Some((_, per_unit)) => Ok((index, *per_unit)),
            None => Err(no_unit(name, bare, column)),
        };
    }
    Err(no_column(name, column, wanted))
}

fn number(cell: &str, separator: char) -> Option<f64> {
    let cell = cell.trim_matches('"');
    let value: f64 = if separator == ';' {
        cell.replace(',', ".").parse().ok()?
    } else {
        cell.parse().ok()?
    };
    value.is_finite().then_some(value)
}

fn even_spacing(name: &str, x: &[f64]) -> Result<Length, Failure> {
    let (Some(first), Some(last)) = (x.first(), x.last()) else {
        return Err(
            Failure::new(Code::E102, format!("{name}: no rows below the header"))
                .advising("Give one row per point below the header."),
        );
    };
    if x.len() < 2 {
        return Err(Failure::new(
            Code::E106,
            format!("{name}: one point is too few for a contact; give at least two"),
        )
        .advising("Give one row per point below the header."));
    }
    let spacing = (last - first) / (x.len() - 1) as f64;
    if spacing <= 0.0 {
        return Err(Failure::new(
            Code::E105,
            format!(
                "{name}: column x must increase, it runs from {} m to {} m",
                asperity_core::number(*first),
                asperity_core::number(*last)
            ),
        )
        .advising("Sort the rows by x."));
    }
    for (index, value) in x.iter().enumerate() {
        let expected = first + spacing * index as f64;
        if (value - expected).abs() > UNEVEN * spacing {
            return Err(Failure::new(
                Code::E109,
                format!(
                    "{name}:{}: x = {value} m is off the even grid of {spacing} m (expected {expected} m); \
                     resample the gap evenly",
                    index + 2
                ),
            )
            .advising("Resample the rows at even positions."));
        }
    }
    Ok(Length::from_si(spacing))
}

fn unreadable(name: &str, line: usize, cell: &str) -> Failure {
    Failure::new(
        Code::E101,
        format!(
            "{name}:{line}: cannot read \"{cell}\" as a number; expected one value per column, e.g. 1.25e-6"
        ),
    )
    .advising("Check this line. Decimal commas need semicolons between the columns.")
}

fn no_unit(name: &str, title: &str, column: Column) -> Failure {
    let units: Vec<&str> = column.units.iter().map(|(unit, _)| *unit).collect();
    let kind = if column.units == LENGTHS {
        "length"
    } else {
        "pressure"
    };
    Failure::new(
        Code::E104,
        format!(
            "{name}:1: the header \"{title}\" does not name a {kind} unit ({})",
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
            "{name}:1: no column {}; the first line must name the columns with their units, e.g. \"x_um,{}_{unit}\"",
            missing.name, wanted.name
        ),
    )
    .advising("Name the columns in the first line, separated by commas, semicolons or tabs.")
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
            let separator = [';', '\t', ',']
                .into_iter()
                .find(|c| header.contains(*c))
                .unwrap();
            let text = format!("{header}\n0{separator}1\n2{separator}3\n4{separator}5\n");
            let read = parse("gap.csv", &text, GAP).unwrap();
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
            ("x_um,h_um\n0,1\n1,a\n", "gap.csv:3: cannot read \"a\""),
            ("x_um,h_um\n0,1\n1\n", "gap.csv:3"),
            ("x_um,h_um\n0,1\n1,nan\n", "cannot read \"nan\""),
            ("x_um,h_um\n0,1\n1,1\n5,1\n", "off the even grid"),
            ("x_um,h_um\n5,1\n1,1\n", "must increase"),
            ("x_um,h_um\n5,1\n", "one point"),
        ] {
            let message = parse("gap.csv", text, GAP).unwrap_err().to_string();
            assert!(message.contains(expected), "{message}");
        }
    }

    #[test]
    fn a_file_is_read_in_any_usual_encoding() {
        let text = "x (µm);h (nm)\r\n0;1,5\r\n2;3\r\n";
        let latin: Vec<u8> = text.chars().map(|c| c as u8).collect();
        let wide = |order: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(order).collect();
        let (little, big): (Vec<u8>, Vec<u8>) = (wide(u16::to_le_bytes), wide(u16::to_be_bytes));
        let marked = |mark: &[u8], bytes: &[u8]| [mark, bytes].concat();
        for bytes in [
            text.as_bytes().to_vec(),
            marked(b"\xef\xbb\xbf", text.as_bytes()),
            marked(b"\xff\xfe", &little),
            marked(b"\xfe\xff", &big),
            latin,
            little,
            big,
        ] {
            let text = decoded(&bytes).unwrap();
            let read = parse("gap.csv", &text, GAP).unwrap();
            assert_eq!(read.values, [1.5e-9, 3e-9], "{bytes:?}");
        }
        for bytes in [&b"\0\0\0\0"[..], b"PK\x03\x04x,h", b"\xff\xfe\x00"] {
            assert_eq!(decoded(bytes), None, "{bytes:?}");
        }
    }

    #[test]
    fn pressures_have_units_of_their_own() {
        let read = parse("p.csv", "x_um\tp [MPa]\n0\t1\n1\t2\n", PRESSURE).unwrap();
        assert_eq!(read.values, [1e6, 2e6]);
        let message = parse("p.csv", "x_um,p_um\n0,1\n", PRESSURE).unwrap_err();
        assert!(message.to_string().contains("pressure unit"), "{message}");
    }
}
