//! Reading measured profiles from files, with everything that was found or assumed.
//!
//! A file is recognised ([`Format`]), decoded ([`Encoding`]), its dialect is sniffed ([`Dialect`]),
//! its table read, put on an even grid and given units. What the user states in [`ReadOptions`]
//! wins over what the file looks like. Nothing is repaired in silence: a file is read as it stands,
//! with [`Warning`]s for what was assumed, or refused with the line and a remedy.
//!
//! | quantity | rule |
//! |---|---|
//! | spacing dx | (x_last − x_first)/(n − 1), or as stated |
//! | units | as stated, else from the header, else the only possible ones, else refused |
//! | missing heights | refused, or interpolated on request |
//!
//! Reading is linear in the length of the file. This is the only module of the crate that opens files.

mod dialect;
mod encoding;
mod error;
mod format;
mod grid;
mod header;
mod options;
mod single_column;
mod table;
mod units;

use std::path::Path;

use asperity_core::Profile;
use asperity_core::quantity::Length;
use serde::Serialize;

pub use dialect::Dialect;
pub use error::{FirstLine, ReadError, SpacingHint};
pub use format::Format;
pub use grid::SpacingSource;
pub use header::FilterState;
pub use options::{
    Axis, Columns, DecimalSign, Encoding, Gaps, LengthUnit, ReadOptions, Separator, UnknownChoice,
};

use crate::Warning;
use crate::height_parameters::extremes;
use dialect::{Line, Sniffed};
use header::Label;
use single_column::Special;
use table::{Chosen, Row};
use units::Extent;

/// A profile with all that was found out about its file. Serialises without the heights, as the echo.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reading {
    /// Name of the file as given.
    pub name: String,
    /// The profile, heights as in the file (no offset, form or tilt removed).
    #[serde(skip)]
    pub profile: Profile,
    /// Format of the file.
    pub format: Format,
    /// Character encoding.
    pub encoding: Encoding,
    /// What separates the columns.
    pub separator: Separator,
    /// The decimal sign.
    pub decimal: DecimalSign,
    /// Columns read.
    pub columns: Columns,
    /// Unit of x; none when the spacing was stated and no x column was needed.
    pub x_unit: Option<LengthUnit>,
    /// Unit of the heights in the file.
    pub z_unit: LengthUnit,
    /// Distance between points.
    pub spacing: Length,
    /// How the spacing was found.
    pub spacing_source: SpacingSource,
    /// Length of the trace, (n − 1)·dx.
    pub length: Length,
    /// Whether the file says its heights are filtered.
    pub filter_state: FilterState,
    /// Number of points n.
    pub points: usize,
    /// Points that were interpolated on request.
    pub gaps_filled: usize,
    /// What the user should know.
    pub warnings: Vec<Warning>,
}

/// Reads the profile in the file at `path`.
///
/// # Errors
/// When the file cannot be opened, is in a format that is not read, or holds no usable profile;
/// [`ReadError`] lists the reasons.
///
/// ```
/// use asperity_roughness::read::{ReadOptions, read};
/// let missing = read("no such file.csv".as_ref(), &ReadOptions::default());
/// assert_eq!(missing.map_err(|error| error.code()), Err("E103"));
/// ```
pub fn read(path: &Path, options: &ReadOptions) -> Result<Reading, ReadError> {
    let name = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|source| ReadError::NotReadable {
        file: name.clone(),
        source,
    })?;
    read_bytes(&name, &bytes, options)
}

/// Reads the profile in `bytes`, the content of a file called `name`.
///
/// # Errors
/// As [`read`], except that nothing is opened.
///
/// ```
/// use asperity_roughness::read::{LengthUnit, ReadOptions, read_bytes};
/// let mut text = String::from("Weg [mm];Höhe [µm]\r\n");
/// for i in 0..200 {
///     text += &format!("{},{:04};0,{}\r\n", i / 2000, 5 * i % 10000, i % 7);
/// }
/// let reading = read_bytes("flank.csv", text.as_bytes(), &ReadOptions::default())?;
/// assert_eq!(reading.points, 200);
/// assert_eq!(reading.spacing, "0.5 um".parse()?);
/// assert_eq!(reading.z_unit, LengthUnit::Micrometre);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_bytes(name: &str, bytes: &[u8], options: &ReadOptions) -> Result<Reading, ReadError> {
    let refused = |format| ReadError::FormatNotRead {
        file: name.to_owned(),
        format,
    };
    if let Some(format) = format::by_magic(name, bytes) {
        return Err(refused(format));
    }
    let (text, encoding) = encoding::decode(bytes, options.encoding);
    let text = text.trim_end_matches(['\0', '\u{1a}']);
    if !encoding::is_text(text) {
        return Err(refused(
            format::by_extension(name).unwrap_or(Format::UnknownBinary),
        ));
    }
    let lines = lines(text);
    if let Some(format) = format::by_lines(name, lines.iter().map(|line| line.text)) {
        return Err(refused(format));
    }
    let sniffed = sniff(name, &lines, options)?;
    table::check_line_above(name, &lines, &sniffed)?;
    if options.separator.is_none() && options.columns.is_none() {
        table::check_commas(name, &lines[sniffed.first..], &sniffed)?;
    }
    let (header, _) = lines.split_at(sniffed.first);
    let labels = header::labels(header, sniffed.dialect, sniffed.columns);
    let chosen = table::choose(name, sniffed.columns, &labels, options)?;
    let rows = table::rows(name, &lines, &sniffed, chosen)?;
    let found = Found {
        name,
        lines: &lines,
        sniffed,
        labels,
        chosen,
        encoding,
        options,
    };
    found.assemble(rows)
}

/// Lines that are not blank, numbered as an editor does; a stray CR before CR LF is no line.
fn lines(text: &str) -> Vec<Line<'_>> {
    let end = if text.contains('\n') { '\n' } else { '\r' };
    text.split(end)
        .enumerate()
        .map(|(at, line)| Line {
            number: at + 1,
            text: line.trim_end_matches('\r'),
        })
        .filter(|line| !line.text.trim().is_empty())
        .collect()
}

fn sniff(name: &str, lines: &[Line<'_>], options: &ReadOptions) -> Result<Sniffed, ReadError> {
    let stated = dialect::Stated {
        separator: options.separator,
        decimal: options.decimal,
        columns: options.columns,
    };
    if let Some(sniffed) = dialect::sniff(lines, stated) {
        return Ok(sniffed);
    }
    let free = dialect::sniff(
        lines,
        dialect::Stated {
            columns: options.columns,
            ..Default::default()
        },
    );
    let Some(free) = free else {
        let first = lines.first().map(|line| table::shortened(line.text));
        return Err(ReadError::NoData {
            file: name.to_owned(),
            lines: lines.len(),
            first: FirstLine(first),
        });
    };
    // The file is a table, but not in the stated dialect: show the first cell that fails.
    let used = Dialect {
        separator: options.separator.unwrap_or(free.dialect.separator),
        decimal: options.decimal.unwrap_or(free.dialect.decimal),
    };
    let line = &lines[free.first];
    let cells = used.cells(line.text);
    match cells
        .iter()
        .find(|cell| used.cell(cell) == dialect::Cell::Other)
    {
        Some(cell) => Err(table::unreadable(name, lines, line, cell, used)),
        None => Err(ReadError::SeparatorDoesNotFit {
            file: name.to_owned(),
            separator: used.separator,
        }),
    }
}

/// A file on its way to a [`Reading`].
struct Found<'a> {
    name: &'a str,
    lines: &'a [Line<'a>],
    sniffed: Sniffed,
    labels: Vec<Label>,
    chosen: Chosen,
    encoding: Encoding,
    options: &'a ReadOptions,
}

/// Spacing `[m]` with its origin, and the units.
struct Measured {
    spacing: f64,
    source: SpacingSource,
    x_unit: Option<LengthUnit>,
    z_unit: LengthUnit,
}

impl Found<'_> {
    fn assemble(self, mut rows: Vec<Row>) -> Result<Reading, ReadError> {
        let name = self.name;
        let mut warnings = Vec::new();
        let table = &self.lines[self.sniffed.first..];
        let special = match self.chosen.x {
            None => single_column::interpret(name, &mut rows, table, self.options)?,
            Some(_) => Special::delimited(),
        };
        let column = match self.options.dx {
            // A stated spacing makes x unnecessary, even an x that would be refused.
            Some(_) if rows.len() >= grid::FEWEST_POINTS => None,
            _ => grid::spacing(name, &mut rows, &mut warnings)?,
        };
        let text_of = |number: usize| {
            let line = self.lines.iter().find(|line| line.number == number);
            line.map_or_else(String::new, |line| table::shortened(line.text))
        };
        let (heights, gaps_filled) =
            grid::heights(name, &rows, self.options.gaps, text_of, &mut warnings)?;
        let measured = self.measure(&rows, &heights, column, special.unit, &mut warnings)?;
        let profile = self.profile(&heights, &measured)?;
        let filter_state = header::filter_state(name, self.header());
        if filter_state == FilterState::Roughness {
            warnings.push(Warning::AlreadyFiltered);
        }
        Ok(Reading {
            name: name.to_owned(),
            format: special.format,
            encoding: self.encoding,
            separator: self.sniffed.dialect.separator,
            decimal: self.sniffed.dialect.decimal,
            columns: self.chosen.columns(),
            x_unit: measured.x_unit,
            z_unit: measured.z_unit,
            spacing: profile.spacing(),
            spacing_source: measured.source,
            length: profile.length(),
            filter_state,
            points: profile.len(),
            gaps_filled,
            warnings,
            profile,
        })
    }

    fn header(&self) -> &[Line<'_>] {
        &self.lines[..self.sniffed.first]
    }

    /// The unit a column has by statement or header.
    fn unit(&self, axis: Axis, column: usize) -> Result<Option<LengthUnit>, ReadError> {
        let stated = match axis {
            Axis::Trace => self.options.x_unit,
            Axis::Height => self.options.z_unit,
        };
        match (
            stated,
            self.labels
                .get(column)
                .and_then(|label| label.unit.as_ref()),
        ) {
            (Some(unit), _) | (None, Some(&header::Stated::Length(unit))) => Ok(Some(unit)),
            (None, Some(header::Stated::Other(unit))) => Err(ReadError::UnknownUnit {
                file: self.name.to_owned(),
                axis,
                unit: table::shortened(unit),
            }),
            (None, None) => Ok(None),
        }
    }

    fn no_spacing(&self, hint: SpacingHint) -> ReadError {
        ReadError::NoSpacing {
            file: self.name.to_owned(),
            hint,
        }
    }

    fn no_unit(&self, axis: Axis, span: f64) -> ReadError {
        ReadError::NoUnit {
            file: self.name.to_owned(),
            axis,
            span,
        }
    }

    /// Spacing and units: stated, from the header, or the only possible ones.
    fn measure(
        &self,
        rows: &[Row],
        heights: &[f64],
        column: Option<f64>,
        format_unit: Option<LengthUnit>,
        warnings: &mut Vec<Warning>,
    ) -> Result<Measured, ReadError> {
        let (low, high) = extremes(heights);
        let span = high - low;
        let z_stated = self.unit(Axis::Height, self.chosen.z)?.or(format_unit);
        if let Some(dx) = self.options.dx {
            warnings.extend(self.overridden(rows, dx));
            let length = dx.si() * (heights.len() - 1) as f64;
            return self.with_stated_spacing(dx, z_stated, Extent { length, span }, warnings);
        }
        let (Some(column), Some(x_column)) = (column, self.chosen.x) else {
            return Err(self.no_spacing(SpacingHint::None));
        };
        let x_stated = self.unit(Axis::Trace, x_column)?;
        if x_stated.is_none() && grid::counts_points(rows) {
            return Err(self.no_spacing(SpacingHint::XCounts));
        }
        let length = column * (rows.len() - 1) as f64;
        let extent = Extent { length, span };
        let found = units::pair(extent, x_stated, z_stated);
        let (x_unit, z_unit) = found.ok_or_else(|| match z_stated {
            None => self.no_unit(Axis::Height, span),
            Some(_) => self.no_unit(Axis::Trace, length),
        })?;
        for (axis, stated, unit) in [
            (Axis::Trace, x_stated, x_unit),
            (Axis::Height, z_stated, z_unit),
        ] {
            if stated.is_none() {
                warnings.push(Warning::UnitAssumed { axis, unit });
            }
        }
        let (spacing, source) = (x_unit.metres(column), SpacingSource::XColumn);
        Ok(Measured {
            spacing,
            source,
            x_unit: Some(x_unit),
            z_unit,
        })
    }

    fn with_stated_spacing(
        &self,
        dx: Length,
        z_stated: Option<LengthUnit>,
        extent: Extent,
        warnings: &mut Vec<Warning>,
    ) -> Result<Measured, ReadError> {
        let z_unit = z_stated.or_else(|| units::heights_only(extent.span, extent.length));
        let z_unit = z_unit.ok_or_else(|| self.no_unit(Axis::Height, extent.span))?;
        if z_stated.is_none() {
            warnings.push(Warning::UnitAssumed {
                axis: Axis::Height,
                unit: z_unit,
            });
        }
        let (spacing, source) = (dx.si(), SpacingSource::Stated);
        Ok(Measured {
            spacing,
            source,
            x_unit: None,
            z_unit,
        })
    }

    /// The warning that a stated spacing differs from what the x column says, where it says anything.
    fn overridden(&self, rows: &[Row], stated: Length) -> Option<Warning> {
        const DIFFERS: f64 = 0.01;
        let unit = self.unit(Axis::Trace, self.chosen.x?).ok().flatten()?;
        let (first, last) = (rows.first()?.x?, rows.last()?.x?);
        let column = Length::from_si(unit.metres((last - first).abs() / (rows.len() - 1) as f64));
        let differs = (column / stated - 1.0).abs() > DIFFERS;
        differs.then_some(Warning::SpacingOverridden { stated, column })
    }

    fn profile(&self, heights: &[f64], measured: &Measured) -> Result<Profile, ReadError> {
        let unit = measured.z_unit;
        let metres = heights.iter().map(|z| unit.metres(*z)).collect();
        Profile::new(Length::from_si(measured.spacing), metres).map_err(|error| {
            ReadError::Impossible {
                file: self.name.to_owned(),
                what: error.name,
                value: error.value,
                unit: LengthUnit::Metre,
            }
        })
    }
}
