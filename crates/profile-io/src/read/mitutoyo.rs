//! Mitutoyo SurfTest workbooks (`.xlsx` of the USB communication tool).
//!
//! Sheet `Certificate` states the conditions as label and value side by side (`Profile` R, `Cut-Off` 0.08mm, λs), sheet
//! `DATA` holds printed results in column A ("Ra 0.018 µm") and the profile in two columns, x in millimetres and
//! heights in micrometres. A workbook without the labels of Mitutoyo is not read.

use super::archive::{Archive, damaged};
use super::error::ReadError;
use super::format::Format;
use super::found::Found;
use super::header::FilterState;
use super::metadata::{self, Metadata, PrintedParameter, short};
use super::options::LengthUnit;
use super::text::Stream;
use super::xml::walk;

const FORMAT: Format = Format::MitutoyoXlsx;
/// Maximum number of columns; the export uses six.
const MOST_COLUMNS: usize = 64;
/// Maximum number of shared texts.
const MOST_TEXTS: usize = 100_000;
/// Maximum number of texts of a sheet.
const MOST_LABELS: usize = 500;

/// One sheet: its texts in reading order and its columns of numbers.
#[derive(Default)]
struct Sheet {
    labels: Vec<String>,
    columns: Vec<Vec<(usize, f64)>>,
}

/// Reads the profile of a workbook.
pub(super) fn read(file: &str, stream: &mut dyn Stream, size: u64) -> Result<Found, ReadError> {
    let unknown = || ReadError::FormatNotRead {
        file: file.to_owned(),
        format: Format::Excel,
    };
    let mut archive = Archive::open(file, FORMAT, stream, size).map_err(|_| unknown())?;
    let texts = texts(file, &mut archive)?;
    let mut metadata = Metadata::default();
    let mut state = FilterState::Unknown;
    let mut known = false;
    let mut best: Option<Pair> = None;
    for number in 1.. {
        let name = format!("xl/worksheets/sheet{number}.xml");
        if !archive.holds(&name) {
            break;
        }
        let sheet = sheet(file, &mut archive, &name, &texts)?;
        known |= describe(&sheet.labels, &mut metadata, &mut state);
        let longer = |found: &Pair| (best.as_ref()).is_none_or(|kept| found.x.len() > kept.x.len());
        if let Some(found) = pair(&sheet).filter(longer) {
            best = Some(found);
        }
    }
    let found = best.filter(|_| known).ok_or_else(unknown)?;
    Ok(Found {
        z_unit: LengthUnit::Micrometre,
        x_unit: LengthUnit::Millimetre,
        x: Some(found.x),
        filter_state: state,
        metadata,
        first_line: found.first_row,
        ..Found::new(FORMAT, found.heights)
    })
}

/// The shared texts of the workbook.
fn texts(file: &str, archive: &mut Archive<'_>) -> Result<Vec<String>, ReadError> {
    let name = "xl/sharedStrings.xml";
    if !archive.holds(name) {
        return Ok(Vec::new());
    }
    archive.read(name, |stream| {
        let mut texts = Vec::new();
        let mut parts = String::new();
        let sound = walk(stream, |leaf| {
            match leaf.name() {
                "t" => parts.push_str(leaf.text),
                "si" => texts.push(std::mem::take(&mut parts)),
                _ => {}
            }
            texts.len() < MOST_TEXTS
        });
        match sound {
            true => Ok(texts),
            false => Err(damaged(file, FORMAT, "the texts are not sound XML", "")),
        }
    })
}

fn sheet(
    file: &str,
    archive: &mut Archive<'_>,
    name: &str,
    texts: &[String],
) -> Result<Sheet, ReadError> {
    archive.read(name, |stream| {
        let mut sheet = Sheet::default();
        let mut value = String::new();
        let sound = walk(stream, |leaf| {
            match leaf.name() {
                "v" | "t" => value = leaf.text.to_owned(),
                "c" => {
                    let kind = leaf.attribute("t").unwrap_or_default();
                    let at = leaf.attribute("r").and_then(cell);
                    sheet.take(kind, at, &std::mem::take(&mut value), texts);
                }
                _ => {}
            }
            true
        });
        match sound {
            true => Ok(sheet),
            false => Err(damaged(file, FORMAT, "a sheet is not sound XML", name)),
        }
    })
}

impl Sheet {
    fn take(&mut self, kind: &str, at: Option<(usize, usize)>, value: &str, texts: &[String]) {
        let text = match kind {
            "s" => value
                .parse()
                .ok()
                .and_then(|at: usize| texts.get(at))
                .map(String::as_str),
            "str" | "inlineStr" => Some(value),
            _ => None,
        };
        if let Some(text) = text {
            if self.labels.len() < MOST_LABELS {
                self.labels.push(text.trim().to_owned());
            }
        } else if let (Some((column, row)), Some(number)) = (at, metadata::number(value))
            && column < MOST_COLUMNS
        {
            if self.columns.len() <= column {
                self.columns.resize_with(column + 1, Vec::new);
            }
            self.columns[column].push((row, number));
        }
    }
}

/// Column and row from 0 of a reference like "F12".
fn cell(reference: &str) -> Option<(usize, usize)> {
    let at = reference.find(|c: char| c.is_ascii_digit())?;
    let (letters, digits) = reference.split_at(at);
    let mut column = 0_usize;
    for letter in letters.chars() {
        let value = (letter.to_ascii_uppercase() as usize).checked_sub('A' as usize)?;
        column = column.checked_mul(26)?.checked_add(value.min(25) + 1)?;
    }
    Some((column.checked_sub(1)?, digits.parse().ok()?))
}

/// Positions and heights from two columns.
struct Pair {
    x: Vec<f64>,
    heights: Vec<f64>,
    /// Row of the first point, from 1.
    first_row: usize,
}

/// The longest pair of adjacent columns with numbers in the same rows and ascending x.
fn pair(sheet: &Sheet) -> Option<Pair> {
    let adjacent = sheet.columns.windows(2).filter(|pair| {
        let (x, z) = (&pair[0], &pair[1]);
        x.len() > 1
            && x.len() == z.len()
            && x.iter().zip(z).all(|(x, z)| x.0 == z.0)
            && x.windows(2).all(|step| step[1].1 > step[0].1)
    });
    let longest = adjacent.max_by_key(|pair| pair[0].len())?;
    let values = |column: &[(usize, f64)]| column.iter().map(|(_, value)| *value).collect();
    Some(Pair {
        x: values(&longest[0]),
        heights: values(&longest[1]),
        first_row: longest[0][0].0,
    })
}

/// Stores conditions and printed results; returns whether the sheet is a Mitutoyo export.
fn describe(labels: &[String], metadata: &mut Metadata, state: &mut FilterState) -> bool {
    let known = labels
        .iter()
        .any(|label| label == "Mitutoyo" || label == "SurfTest");
    for (at, label) in labels.iter().enumerate() {
        let value = labels.get(at + 1).map_or("", String::as_str);
        match label.as_str() {
            "Mitutoyo" | "SurfTest" => {
                let before = metadata.instrument.take().unwrap_or_default();
                metadata.instrument = short(&format!("{before} {label}"));
            }
            "Work Name" => metadata.title = short(value),
            "Profile" => {
                *state = match value {
                    "R" => FilterState::Roughness,
                    "P" => FilterState::Primary,
                    _ => FilterState::Unknown,
                }
            }
            "Cut-Off" | "λc" => metadata.lambda_c = metadata::length(value),
            "λs" => metadata.lambda_s = metadata::length(value),
            _ if at == 0 && label.contains('-') && label.contains(|c: char| c.is_ascii_digit()) => {
                metadata.date = short(label);
            }
            _ => {
                let parts: Vec<&str> = label.split_whitespace().collect();
                if let [name, value, rest @ ..] = parts.as_slice() {
                    let unit = rest.first().copied().unwrap_or_default();
                    let printed = PrintedParameter::parse(name, value, unit);
                    metadata
                        .printed
                        .extend(printed.filter(|_| name.starts_with(['R', 'P', 'W', 'M'])));
                }
            }
        }
    }
    known
}
