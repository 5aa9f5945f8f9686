//! SMD, the softgauge format of ISO 5436-2.
//!
//! Record 1 names the axes, record 2 may describe the measurement, record 3 holds the heights, record 4
//! the sum of all bytes before it, modulo 65 536. Fields end with NUL, records with ETX and the file with
//! SUB; NPL's own examples write blanks and blank lines instead, and both are read.
//!
//! | line | fields |
//! |---|---|
//! | `CX I 22401 mm 1.0e0 D 2.5e-4` | axis, incremental, points, unit, factor, type, spacing |
//! | `CZ A 22401 um 1.0e0 D` | axis, absolute, points, unit, factor, type |

use super::damage::{damaged, height, miscounted};
use super::decimal;
use super::error::ReadFault;
use super::file_dialect::BadHeights;
use super::format::Format;
use super::found::Found;
use super::grid::SpacingSource;
use super::header::FilterState;
use super::lengths::Lengths;
use super::metadata::{self, Metadata, PrintedParameter, number, short};
use super::options::LengthUnit;
use super::plain_row::numbers_at_start;
use super::text::{Head, TextSource};
use crate::warning::Warning;

const FORMAT: Format = Format::Smd;
/// Maximum number of fields of a line; an axis has seven.
const MOST_FIELDS: usize = 64;
/// Modulus of the sum of all bytes.
const MODULUS: u32 = 65_536;
const END_OF_RECORD: char = '\u{3}';
const END_OF_FILE: char = '\u{1a}';

/// An axis line.
struct SmdAxis {
    points: usize,
    unit: LengthUnit,
    factor: f64,
    increment: Option<f64>,
}

/// Whether the file starts with the mark of SMD.
pub(super) fn recognised(bytes: &[u8]) -> bool {
    bytes.starts_with(b"ISO 5436")
}

/// Reads an SMD file.
pub(super) fn read(head: &Head, text: &mut TextSource<'_>) -> Result<Found, ReadFault> {
    let marked = head.text.contains(END_OF_RECORD);
    let mut record = 1;
    let (mut x, mut z) = (None, None);
    let mut heights: Vec<f64> = Vec::new();
    let mut metadata = Metadata::default();
    let (mut sum, mut first_line, mut checksum) = (0, 1, None);
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        let sum_before = sum;
        sum = if line.whole.is_ascii() {
            (line.whole.bytes()).fold(sum, |sum, byte| sum + u32::from(byte)) % MODULUS
        } else {
            line.whole.chars().fold(sum, add)
        };
        // Nearly all lines of a file contain a single height.
        if record == 3
            && let Some(height) = decimal::whole(line.text.trim_end(), b'.')
            && height.is_finite()
            && let Some(stated) = z.as_ref().map(|z: &SmdAxis| z.points)
            && heights.len() <= stated
        {
            if heights.is_empty() {
                first_line = line.number;
            }
            heights.push(height);
            let left = stated.saturating_sub(heights.len());
            let (at_hand, end) = (lines.at_hand(), lines.end());
            let (count, bytes) = numbers_at_start(at_hand, end, left, &mut heights);
            let of_block: u64 = bytes.iter().map(|byte| u64::from(*byte)).sum();
            sum = (sum + (of_block % u64::from(MODULUS)) as u32) % MODULUS;
            let length = bytes.len();
            lines.pass(count, length);
            continue;
        }
        let ends = line.text.contains(END_OF_RECORD) || (!marked && line.text.trim().is_empty());
        let content = line.text.split([END_OF_RECORD, END_OF_FILE]).next();
        let fields: Vec<&str> = content
            .unwrap_or_default()
            .split(|c: char| c == '\0' || c.is_whitespace())
            .filter(|field| !field.is_empty())
            .take(MOST_FIELDS)
            .collect();
        match (record, fields.first()) {
            (_, None) => {}
            (1, Some(&"CX")) => x = Some(axis(&fields)?),
            (1, Some(&"CZ")) => z = Some(axis(&fields)?),
            (1, Some(&"CY")) => {
                return Err(damaged(FORMAT, "it holds an areal topography", "CY"));
            }
            (1, Some(&"ISO")) => metadata.title = fields.get(4..).and_then(|f| short(&f.join(" "))),
            (1, Some(_)) => {}
            (2, Some(_)) => describe(&mut metadata, &fields),
            (3, Some(first)) => {
                if heights.is_empty() {
                    first_line = line.number;
                }
                let stated = z.as_ref().map_or(0, |z: &SmdAxis| z.points);
                // The stated number limits the memory.
                if heights.len() > stated {
                    break;
                }
                let Some(height) = height(first) else {
                    let bad = BadHeights::new(FORMAT, first, (line.number, line.text));
                    return Err(bad.in_all(&mut lines, |line| line));
                };
                heights.push(height);
            }
            (_, Some(first)) => checksum = checksum.or_else(|| Some(check(first, sum_before))),
        }
        if ends && !(record == 1 && x.is_none()) {
            record += 1;
        }
    }
    let axes = x.zip(z);
    let (x, z) = axes.ok_or_else(|| damaged(FORMAT, "an axis CX or CZ is missing", ""))?;
    if heights.len() != z.points || x.points != z.points {
        return Err(miscounted(FORMAT, heights.len(), z.points));
    }
    heights.iter_mut().for_each(|h| *h *= z.factor);
    Ok(Found {
        spacing: x
            .increment
            .map(|dx| (Lengths::new(dx * x.factor, x.unit), SpacingSource::Header)),
        filter_state: filter_state(&metadata),
        metadata,
        warnings: checksum.flatten().into_iter().collect(),
        first_line: Some(first_line),
        ..Found::new(FORMAT, Lengths::new(heights, z.unit))
    })
}

fn axis(fields: &[&str]) -> Result<SmdAxis, ReadFault> {
    let line = || fields.join(" ");
    let broken = || damaged(FORMAT, "an axis line cannot be read", &line());
    let field = |at: usize| fields.get(at).copied().unwrap_or_default();
    let points = number(field(2)).filter(|n| *n >= 1.0 && *n < 1e9);
    let increment = number(field(6)).filter(|dx| *dx > 0.0);
    if field(0) == "CX" && field(1) != "I" {
        let what = "the points have individual x, which is not supported";
        return Err(damaged(FORMAT, what, &line()));
    }
    Ok(SmdAxis {
        points: points.ok_or_else(broken)? as usize,
        unit: field(3).parse().map_err(|_| broken())?,
        factor: number(field(4)).ok_or_else(broken)?,
        increment,
    })
}

/// One line of record 2.
fn describe(metadata: &mut Metadata, fields: &[&str]) {
    let rest = fields[1..].join(" ");
    match fields[0].trim_end_matches(':') {
        "DATE" | "TIME" => {
            let before = metadata.date.take().unwrap_or_default();
            metadata.date = short(&format!("{before} {rest}"));
        }
        "CREATED_BY" | "INSTRUMENT_ID" => metadata.instrument = short(&rest),
        "COMMENT" => metadata.title = short(&rest).or(metadata.title.take()),
        "PARAMETER_VALUE" => {
            let field = |at: usize| fields.get(at).copied().unwrap_or_default();
            // NPL's converter lists parameters to be computed with the value zero.
            let printed = PrintedParameter::parse(field(1), field(2), field(3));
            let computed = printed.filter(|printed| printed.value != 0.0);
            if metadata.printed.len() < 200 {
                metadata.printed.extend(computed);
            }
        }
        "PROFILE_FILTER" => {
            let after = |name: &str| {
                let at = fields.iter().position(|field| *field == name)?;
                let value = number(fields.get(at + 1)?)?;
                metadata::length(&format!("{value} mm")).filter(|length| length.si() > 0.0)
            };
            (metadata.lambda_s, metadata.lambda_c) = (after("LS"), after("LC"));
        }
        _ => {}
    }
}

/// Record 2 states the filter to be applied: the heights are a primary profile.
fn filter_state(metadata: &Metadata) -> FilterState {
    match metadata.lambda_c {
        Some(_) => FilterState::Primary,
        None => FilterState::Unknown,
    }
}

/// Adds a character to the sum of the bytes, modulo 65 536. Characters above 127 count as one byte, as in
/// the code pages these files are written in.
fn add(sum: u32, c: char) -> u32 {
    (sum + c as u32 % 256) % MODULUS
}

/// Warning that record 4 differs from the sum of the preceding bytes.
fn check(stated: &str, sum: u32) -> Option<Warning> {
    let agrees = stated
        .parse::<u64>()
        .is_ok_and(|stated| stated % u64::from(MODULUS) == u64::from(sum));
    (!agrees).then(|| Warning::ChecksumDiffers {
        what: "file".into(),
        stated: super::error::shortened(stated),
        found: sum.to_string(),
    })
}
