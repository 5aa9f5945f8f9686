//! Delimited text in any dialect: from lines to a [`Reading`].

use asperity_core::quantity::Length;

use super::dialect::{Dialect, Line, Sniffed};
use super::error::{FirstLine, ReadError, SpacingHint};
use super::format::{Format, extension};
use super::grid::SpacingSource;
use super::header::{FilterState, Label};
use super::metadata::{self, Metadata};
use super::options::{Axis, Encoding, LengthUnit, ReadOptions};
use super::single_column::Special;
use super::table::{Chosen, Row};
use super::units::Extent;
use super::{Reading, TableLayout, dialect, grid, header, single_column, table, trace, units};
use crate::Warning;
use crate::height_parameters::extremes;

/// Reads the profile of a table in `text`.
pub(super) fn read(
    name: &str,
    text: &str,
    encoding: Encoding,
    options: &ReadOptions,
) -> Result<Reading, ReadError> {
    let lines = lines(text);
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
            None => single_column::interpret(name, &mut rows, table, self.options, &mut warnings)?,
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
        let measured = self.measure(&rows, &heights, column, &special, &mut warnings)?;
        let spacing = Length::from_si(measured.spacing);
        let profile = trace::profile(name, &heights, spacing, measured.z_unit)?;
        let filter_state = header::filter_state(name, self.header());
        if filter_state == FilterState::Roughness {
            warnings.push(Warning::AlreadyFiltered);
        }
        Ok(Reading {
            name: name.to_owned(),
            format: self.format(special.format),
            encoding: Some(self.encoding),
            table: Some(TableLayout {
                separator: self.sniffed.dialect.separator,
                decimal: self.sniffed.dialect.decimal,
                columns: self.chosen.columns(),
            }),
            metadata: self.metadata(),
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
        special: &Special,
        warnings: &mut Vec<Warning>,
    ) -> Result<Measured, ReadError> {
        let (low, high) = extremes(heights);
        let span = high - low;
        let z_stated = self.unit(Axis::Height, self.chosen.z)?.or(special.unit);
        if let Some(dx) = self.options.dx {
            warnings.extend(self.overridden(rows, dx));
            let length = dx.si() * (heights.len() - 1) as f64;
            return self.with_stated_spacing(dx, z_stated, Extent { length, span }, warnings);
        }
        if let (Some(spacing), Some(z_unit)) = (special.spacing, z_stated) {
            return Ok(Measured {
                spacing,
                source: SpacingSource::FirstLine,
                x_unit: Some(LengthUnit::Micrometre),
                z_unit,
            });
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
        // x carries rounding; the header of a written file carries the spacing itself.
        const SAME: f64 = 1e-6;
        let from_column = x_unit.metres(column);
        let agrees = |dx: &f64| (dx / from_column - 1.0).abs() < SAME;
        let (spacing, source) = match self.header_spacing().filter(agrees) {
            Some(dx) => (dx, SpacingSource::Header),
            None => (from_column, SpacingSource::XColumn),
        };
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
        let unit = self.unit(Axis::Trace, self.chosen.x?).ok().flatten()?;
        let (first, last) = (rows.first()?.x?, rows.last()?.x?);
        let column = Length::from_si(unit.metres((last - first).abs() / (rows.len() - 1) as f64));
        trace::overridden(stated, column)
    }

    /// Formats that are tables, told by their name or header.
    fn format(&self, found: Format) -> Format {
        let starts = |text: &str| self.header().iter().any(|line| line.text.starts_with(text));
        match () {
            () if found != Format::DelimitedText => found,
            () if extension(self.name) == "hfm" => Format::HommelHfm,
            () if starts("Meta Data") && starts("Lateral") => Format::DektakCsv,
            () => found,
        }
    }

    /// What header lines of the form "name, value" or "name = value" say.
    fn metadata(&self) -> Metadata {
        let mut metadata = Metadata::default();
        for line in self.header() {
            let text = line.text.trim_start_matches(['#', '%', ' ']);
            let Some((key, value)) = text.split_once(['=', ',', ';', '\t']) else {
                continue;
            };
            let value = value.trim_matches([',', ';', ' ', '\t', '"']);
            match key.trim().trim_matches('"').to_lowercase().as_str() {
                "date" | "datetime" | "datum" | "fecha" => metadata.date = metadata::short(value),
                "instrument" | "scanner type" | "instrument model" => {
                    metadata.instrument = metadata::short(value);
                }
                "title" | "name" | "sample" => metadata.title = metadata::short(value),
                _ => {}
            }
        }
        metadata
    }

    /// The spacing of a header line "dx = 5e-7 m", to all its digits.
    fn header_spacing(&self) -> Option<f64> {
        let text = |line: &Line<'_>| {
            let rest = line
                .text
                .trim_start_matches(['#', ' '])
                .strip_prefix("dx = ")?;
            metadata::length(rest).map(Length::si)
        };
        self.header().iter().find_map(text)
    }
}
