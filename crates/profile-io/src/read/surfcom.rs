//! Surfcom text profiles: `.tx1` (primary), `.tx2` (roughness), with the conditions in `.tx3`.
//!
//! Line 1 of a profile is the nominal length in millimetres, line 2 the number of points, then heights in micrometres.
//! For an aborted trace the nominal length is wrong by up to 80 %. The conditions state the evaluation length; the
//! spacing is the evaluation length divided by the number of points if the length is printed in full. The labels of the
//! conditions are in the language of the instrument; Spanish labels are known from files, English and German ones from
//! manuals.

use std::io::Cursor;
use std::path::Path;

use asperity_core::quantity::Length;

use super::damage::height;
use asperity_storage::whole_file;

use super::conditions::conditions_of;
use super::error::{ReadFault, SpacingHint};
use super::file_dialect::BadHeights;
use super::format::{Format, extension};
use super::found::Found;
use super::grid::SpacingSource;
use super::header::FilterState;
use super::lengths::Lengths;
use super::metadata::{self, Metadata, PrintedParameter, number, short};
use super::options::{LengthUnit, ReadOptions};
use super::text::{Head, Start, TextSource};
use crate::warning::Warning;

const FORMAT: Format = Format::SurfcomText;
const HEADER_LINES: usize = 2;
/// Maximum size of a file of measuring conditions in bytes.
const MOST_CONDITIONS: u64 = 1 << 20;

/// The measuring conditions of a profile; `None` if they cannot be read.
pub(super) fn conditions_beside(path: &Path) -> Option<Vec<u8>> {
    whole_file(&conditions_of(path)?, MOST_CONDITIONS).ok()
}

/// Whether the first two lines are a length and the number of remaining lines.
pub(super) fn recognised(head: &Head, text: &mut TextSource<'_>) -> Result<bool, ReadFault> {
    let mut lines = head.lines().map(|line| line.text.trim());
    let length = lines.next().and_then(number);
    let points = lines.next().and_then(|line| line.parse::<usize>().ok());
    let points = points.filter(|points| *points > 0);
    let Some(points) = points.filter(|_| length.is_some_and(|length| length > 0.0)) else {
        return Ok(false);
    };
    let mut count = 0;
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        count += usize::from(line.number > HEADER_LINES && !line.is_blank());
    }
    Ok(points == count)
}

/// Reads a `.tx1` or `.tx2` file with its conditions, if given.
pub(super) fn read(
    text: &mut TextSource<'_>,
    conditions: Option<&[u8]>,
    options: &ReadOptions,
) -> Result<Found, ReadFault> {
    let file = text.file;
    let mut lines = text.lines()?;
    let nominal = lines.next()?.and_then(|line| number(line.text));
    let nominal = Length::from_si(LengthUnit::Millimetre.metres(nominal.unwrap_or(0.0)));
    lines.next()?;
    let mut heights = Vec::new();
    while let Some(line) = lines.next()? {
        if !line.is_blank() {
            let Some(height) = height(line.text) else {
                let bad = BadHeights::new(FORMAT, line.text, (line.number, line.text));
                return Err(bad.in_all(&mut lines, |line| line));
            };
            heights.push(height);
        }
    }
    let points = heights.len();
    let conditions = conditions.map(|bytes| Conditions::new(file, bytes, options));
    let conditions = conditions.transpose()?;
    let mut warnings = Vec::new();
    let traced = conditions
        .as_ref()
        .and_then(|conditions| conditions.evaluation);
    let spacing = traced.map(|(traced, uncertainty)| {
        let (dx, warning) = spacing_of(nominal, traced, uncertainty, points);
        warnings.extend(warning);
        (Lengths::Metres(dx), SpacingSource::EvaluationLength)
    });
    if spacing.is_none() && options.dx.is_none() {
        return Err(ReadFault::no_spacing(SpacingHint::NominalLength {
            length: nominal,
            points,
        }));
    }
    let mut metadata = conditions.map_or_else(Metadata::default, |conditions| conditions.metadata);
    metadata.nominal_length = Some(nominal);
    Ok(Found {
        spacing,
        filter_state: match extension(file).as_str() {
            "tx1" => FilterState::Primary,
            "tx2" => FilterState::Roughness,
            _ => FilterState::Unknown,
        },
        metadata,
        warnings,
        first_line: Some(HEADER_LINES + 1),
        ..Found::new(FORMAT, Lengths::new(heights, LengthUnit::Micrometre))
    })
}

/// Spacing `[m]` of `points` over an evaluation length, with a warning about it.
///
/// A completed trace ends with the first point at or beyond its nominal length, which determines the spacing to one
/// part in the number of points; the length of an aborted trace is printed to 0.1 nm.
fn spacing_of(
    nominal: Length,
    traced: Length,
    uncertainty: f64,
    points: usize,
) -> (f64, Option<Warning>) {
    // Lengths printed to a tenth of a millimetre differ by rounding.
    const ABORTED: f64 = 0.01;
    // Relative uncertainty of a length printed in full, with seven digits.
    const EXACT: f64 = 1e-6;
    let steps = points.saturating_sub(1).max(1) as f64;
    if (traced / nominal - 1.0).abs() > ABORTED {
        let dx = traced.si() / points.max(1) as f64;
        return (dx, Some(Warning::TraceAborted { nominal, traced }));
    }
    if uncertainty <= EXACT {
        return (traced.si() / points.max(1) as f64, None);
    }
    let warning = Warning::LengthRounded {
        length: traced,
        uncertainty: 1.0 / steps,
    };
    (traced.si() / steps, Some(warning))
}

/// The measuring conditions.
struct Conditions {
    metadata: Metadata,
    /// Evaluation length and half a unit of its last digit, relative.
    evaluation: Option<(Length, f64)>,
}

impl Conditions {
    fn new(file: &str, bytes: &[u8], options: &ReadOptions) -> Result<Self, ReadFault> {
        let mut stream = Cursor::new(bytes);
        let start = Start::read(&mut stream)?;
        let (_, mut text) = TextSource::new(file, &mut stream, &start, options.encoding);
        let mut metadata = Metadata {
            instrument: Some("Surfcom".to_owned()),
            ..Metadata::default()
        };
        let mut evaluation = None;
        let mut lines = text.lines()?;
        while let Some(line) = lines.next()? {
            let mut fields = line.text.split('\t').map(str::trim);
            let (Some(label), Some(value)) = (fields.next(), fields.next()) else {
                continue;
            };
            let is = |labels: &[&str]| labels.contains(&label.to_lowercase().as_str());
            if is(&["longitud evaluación", "evaluation length", "auswertelänge"]) {
                evaluation = metadata::length(value).map(|length| (length, uncertainty(value)));
            } else if is(&["onda de corte", "cutoff", "cut-off", "grenzwellenlänge"]) {
                metadata.lambda_c = metadata::length(value);
            } else if is(&["longitud onda corte ls", "ls cutoff", "cutoff ls"]) {
                metadata.lambda_s = metadata::length(value);
            } else if is(&["fecha", "date", "datum"]) {
                metadata.date = short(value);
            } else if is(&["hora", "time", "zeit"]) {
                let date = metadata.date.take().unwrap_or_default();
                metadata.date = short(&format!("{date} {value}"));
            } else if is_parameter(label) && metadata.printed.len() < 200 {
                metadata
                    .printed
                    .extend(PrintedParameter::parse(label, value, ""));
            }
        }
        Ok(Self {
            metadata,
            evaluation: evaluation.filter(|(length, _)| length.si() > 0.0),
        })
    }
}

/// Labels of results start with the letter of their profile.
fn is_parameter(label: &str) -> bool {
    let known = ["Mr1", "Mr2", "VO", "K", "AVH", "Hmax", "Hmin"];
    let mut letters = label.chars();
    known.contains(&label)
        || (matches!(letters.next(), Some('P' | 'R' | 'W'))
            && letters.next().is_some_and(|c| c.is_ascii_alphabetic())
            && label.len() <= 6)
}

/// Half a unit of the last digit divided by the value.
fn uncertainty(printed: &str) -> f64 {
    let digits = printed.trim_end_matches(|c: char| !c.is_ascii_digit());
    let decimals = digits
        .split_once(['.', ','])
        .map_or(0, |(_, after)| after.len());
    number(digits).map_or(1.0, |value| 0.5 * 10f64.powi(-(decimals as i32)) / value)
}
