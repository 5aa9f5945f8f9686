//! A bare gap file: columns x and h, with their units in the header.

use std::path::Path;

use asperity_core::quantity::Length;

use crate::failure::Failure;

/// Gap of two undeformed bodies on an even grid.
#[derive(Debug, Clone, PartialEq)]
pub struct GapFile {
    /// Distance of the points.
    pub spacing: Length,
    /// Positions \[m\].
    pub x: Vec<f64>,
    /// Gap \[m\].
    pub gap: Vec<f64>,
}

/// Positions may be off an even grid by this share of the spacing: rounding in the file.
const UNEVEN: f64 = 0.05;

/// Reads a gap file.
pub fn read(path: &Path) -> Result<GapFile, Failure> {
    let name = path.display();
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::new("E103", format!("{name}: cannot be opened: {error}")))?;
    parse(&name.to_string(), text.trim_start_matches('\u{feff}'))
}

fn parse(name: &str, text: &str) -> Result<GapFile, Failure> {
    let header = text.lines().next().unwrap_or_default();
    let separator = [';', '\t', ',']
        .into_iter()
        .find(|c| header.contains(*c))
        .ok_or_else(|| no_column(name, "x"))?;
    let titles: Vec<&str> = header.split(separator).map(str::trim).collect();
    let (x_column, x_unit) = column(name, &titles, "x")?;
    let (h_column, h_unit) = column(name, &titles, "h")?;
    let mut x = Vec::new();
    let mut gap = Vec::new();
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
        gap.push(value(h_column, h_unit)?);
    }
    let spacing = even_spacing(name, &x)?;
    Ok(GapFile { spacing, x, gap })
}

/// Column of `wanted` and how many of its unit make a metre.
fn column(name: &str, titles: &[&str], wanted: &str) -> Result<(usize, f64), Failure> {
    for (index, title) in titles.iter().enumerate() {
        let bare = title.trim_matches('"').trim();
        let lower = bare.to_lowercase();
        let Some(rest) = lower.strip_prefix(wanted) else {
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
        let per_metre = match unit.as_str() {
            "m" => 1.0,
            "mm" => 1e3,
            "um" => 1e6,
            "nm" => 1e9,
            _ => return Err(no_unit(name, bare, wanted)),
        };
        return Ok((index, per_metre));
    }
    Err(no_column(name, wanted))
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
        return Err(Failure::new(
            "E102",
            format!("{name}: no rows below the header"),
        ));
    };
    if x.len() < 2 {
        return Err(Failure::new(
            "E106",
            format!("{name}: one point is too few for a contact; give at least two"),
        ));
    }
    let spacing = (last - first) / (x.len() - 1) as f64;
    if spacing <= 0.0 {
        return Err(Failure::new(
            "E105",
            format!("{name}: column x must increase, it runs from {first} m to {last} m"),
        ));
    }
    for (index, value) in x.iter().enumerate() {
        let expected = first + spacing * index as f64;
        if (value - expected).abs() > UNEVEN * spacing {
            return Err(Failure::new(
                "E109",
                format!(
                    "{name}:{}: x = {value} m is off the even grid of {spacing} m (expected {expected} m); \
                     resample the gap evenly",
                    index + 2
                ),
            ));
        }
    }
    Ok(Length::from_si(spacing))
}

fn unreadable(name: &str, line: usize, cell: &str) -> Failure {
    Failure::new(
        "E101",
        format!(
            "{name}:{line}: cannot read \"{cell}\" as a number; expected one value per column, as 1.25e-6"
        ),
    )
}

fn no_unit(name: &str, title: &str, wanted: &str) -> Failure {
    Failure::new(
        "E104",
        format!(
            "{name}:1: the header \"{title}\" does not name a length unit; \
             write \"{wanted}_um\" or \"{wanted} [um]\" (m, mm, um, nm)"
        ),
    )
}

fn no_column(name: &str, wanted: &str) -> Failure {
    Failure::new(
        "E102",
        format!(
            "{name}:1: no column {wanted}; the first line must name the columns with their units, as \"x_um,h_um\""
        ),
    )
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
            let read = parse("gap.csv", &text).unwrap();
            assert_eq!(read.spacing.si(), 2e-6, "{header}");
            assert_eq!(read.gap, [1e-9, 3e-9, 5e-9], "{header}");
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
            let message = parse("gap.csv", text).unwrap_err().to_string();
            assert!(message.contains(expected), "{message}");
        }
    }
}
