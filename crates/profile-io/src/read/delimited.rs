//! Delimited text in any dialect.

use asperity_core::numerics::extremes;
use asperity_core::profile::common_spacing;
use asperity_core::quantity::Length;

use super::areal::trace::Areal;
use super::dialect::Sniffed;
use super::error::{ReadFault, SpacingHint, shortened};
use super::first_look::{no_data, sniff};
use super::format::{Format, extension};
use super::grid::{Spacing, SpacingSource};
use super::header::{FilterState, Label, Role};
use super::header_values::HeaderValues;
use super::layout::TableLayout;
use super::matrix::HeightMatrix;
use super::metadata::{self, Metadata};
use super::options::{Abscissa, Axis, Encoding, LengthUnit, ReadOptions, TraceLine};
use super::rows::{self, Rows};
use super::single_column::Special;
use super::table::Chosen;
use super::text::{Head, Line, TextSource};
use super::trace::{Positions, Trace, own};
use super::units::Extent;
use super::{
    found, grid, header, lengths, matrix, points, roll_length, single_column, stated_count, table,
    units,
};
use crate::warning::Warning;

/// Reads the profile of a table.
pub(super) fn read(
    head: &Head,
    text: &mut TextSource<'_>,
    options: &ReadOptions,
) -> Result<Trace, ReadFault> {
    let name = text.file;
    let lines: Vec<Line<'_>> = head.lines().filter(|line| !line.is_blank()).collect();
    let Some(sniffed) = sniff(&lines, options)? else {
        return Err(no_data(text)?);
    };
    table::check_line_above(&lines, &sniffed)?;
    let (header, table) = lines.split_at(sniffed.first);
    if options.separator.is_none() && options.columns.is_none() {
        table::check_commas(table, &sniffed)?;
    }
    let labels = header::labels(header, sniffed.dialect, sniffed.columns);
    let values = HeaderValues::from_header(header);
    if matrix::is_matrix(&labels, &values, options) {
        let matrix = HeightMatrix::new(&lines, &sniffed, &labels, &values);
        let found = match options.line {
            TraceLine::Row if !matrix.is_wrapped() => matrix.read(text, options)?,
            _ => matrix.surface(text, options)?.trace(options)?,
        };
        return found.finish(name, options);
    }
    let first = table.first().map_or(1, |line| line.number);
    let points = match points::columns(&labels, options) {
        Some(columns) => points::read(text, first, &lines, &sniffed, columns)?.zip(Some(columns)),
        None => None,
    };
    let (chosen, rows, before, is_listed, format) = match &points {
        Some((points, [x, y, z])) => {
            let trace = points.trace(options)?;
            let along = if points.runs_along_y(options) { y } else { x };
            let chosen = Chosen {
                x: Some(*along),
                z: *z,
                valid: None,
                count: sniffed.columns,
            };
            (
                chosen,
                trace.rows,
                trace.before,
                trace.is_listed,
                Format::PointText,
            )
        }
        None => {
            let chosen = table::choose(sniffed.columns, &labels, options)?;
            let rows = rows::read(text, first, &lines, &sniffed, chosen)?;
            (chosen, rows, 0, true, Format::DelimitedText)
        }
    };
    let used = match &points {
        Some((_, columns)) => columns.to_vec(),
        None => [chosen.x, Some(chosen.z), chosen.valid]
            .into_iter()
            .flatten()
            .collect(),
    };
    // Whoever states the columns leaves the others out on purpose.
    let labelled = labels.iter().take(sniffed.columns).enumerate();
    let unread = labelled.filter(|(at, label)| {
        options.columns.is_none() && !used.contains(at) && !label.text.trim().is_empty()
    });
    let unread = unread.map(|(_, label)| shortened(&label.text)).collect();
    let parsed = Parsed {
        name,
        unread,
        mean_of: points
            .as_ref()
            .map(|(points, _)| points.lines())
            .filter(|lines| options.line.is_mean() && *lines > 1),
        has_pixels: points.is_some_and(|(points, _)| points.are_pixels()),
        header,
        values,
        first,
        before,
        is_listed,
        sniffed,
        labels,
        chosen,
        encoding: text.encoding,
        format,
        options,
    };
    parsed.assemble(text, rows)
}

/// Reads all rows of a matrix, which has no labels and no x.
pub(super) fn surface(
    head: &Head,
    text: &mut TextSource<'_>,
    options: &ReadOptions,
) -> Result<Areal, ReadFault> {
    /// Minimum number of columns of a matrix.
    const FEWEST: usize = 3;
    let lines: Vec<Line<'_>> = head.lines().filter(|line| !line.is_blank()).collect();
    let Some(sniffed) = sniff(&lines, options)? else {
        return Err(no_data(text)?);
    };
    table::check_line_above(&lines, &sniffed)?;
    let (header, table) = lines.split_at(sniffed.first);
    let labels = header::labels(header, sniffed.dialect, sniffed.columns);
    let values = HeaderValues::from_header(header);
    let first = table.first().map_or(1, |line| line.number);
    if let Some(columns) = points::columns(&labels, options)
        && let Some(points) = points::read(text, first, &lines, &sniffed, columns)?
    {
        let unit = |axis, column: usize, of_header| {
            let label: Option<&header::StatedHeader> = labels[column].unit.as_ref();
            header::unit_of_file(label.or(of_header), axis, options)
        };
        let [x, y, z] = columns;
        let mut areal = points.surface(
            unit(Axis::Trace, x, None)?,
            unit(Axis::Trace, y, None)?,
            unit(Axis::Height, z, values.z_unit.as_ref())?,
        );
        let depths = labels[z].is_depth.then_some(Warning::DepthsTurned);
        areal.warnings.extend(depths);
        areal.encoding = Some(text.encoding);
        return Ok(areal);
    }
    let is_matrix = sniffed.columns >= FEWEST && labels.iter().all(|label| label.role.is_none());
    if !is_matrix && !matrix::is_matrix(&labels, &values, options) {
        return Err(ReadFault::no_heights(
            Format::DelimitedText,
            "no matrix of heights",
        ));
    }
    HeightMatrix::new(&lines, &sniffed, &labels, &values).surface(text, options)
}

/// Relative difference up to which a value of a header and the value used are taken as equal.
const HEADER_DIGITS: f64 = 0.01;

/// Root mean square of the steps between neighbours.
fn root_mean_square_step(z: &[f64]) -> f64 {
    let squares = z.windows(2).map(|pair| (pair[1] - pair[0]).powi(2));
    (squares.sum::<f64>() / (z.len().max(2) - 1) as f64).sqrt()
}

/// A parsed table, to be converted to a [`Trace`].
struct Parsed<'a> {
    name: &'a str,
    /// Names of the columns that are not read.
    unread: Vec<String>,
    /// Number of lines of points of which the trace is the mean.
    mean_of: Option<usize>,
    /// Whether the positions are numbers of pixels.
    has_pixels: bool,
    header: &'a [Line<'a>],
    /// Values that the header states.
    values: HeaderValues,
    /// Number of the first line of the table.
    first: usize,
    /// Number of rows of the table above the first row of the trace.
    before: usize,
    /// Whether the points of the trace are successive rows of the table.
    is_listed: bool,
    sniffed: Sniffed,
    labels: Vec<Label>,
    chosen: Chosen,
    encoding: Encoding,
    /// Format, unless the name or the header specifies another.
    format: Format,
    options: &'a ReadOptions,
}

/// Spacing `[m]` with its origin, and the units.
struct MeasuredSpacing {
    spacing: f64,
    source: SpacingSource,
    x_unit: Option<LengthUnit>,
    z_unit: LengthUnit,
}

impl Parsed<'_> {
    /// Doubts about the columns that were read, of which `empty` rows have no numbers.
    fn doubts_of_columns(&self, empty: usize) -> Vec<Warning> {
        let mut warnings = Vec::from_iter(self.mean_of.map(|lines| Warning::MeanLine { lines }));
        warnings.extend((!self.unread.is_empty()).then(|| Warning::ColumnsNotRead {
            columns: self.unread.clone(),
        }));
        warnings.extend((empty > 0).then_some(Warning::EmptyRows { rows: empty }));
        let label = self.labels.get(self.chosen.z);
        let depths = label.filter(|label| label.is_depth);
        warnings.extend(depths.map(|_| Warning::DepthsTurned));
        warnings
    }

    /// Base radius of positions that are roll lengths or roll angles.
    fn base_radius(
        &self,
        abscissa: Abscissa,
        warnings: &mut Vec<Warning>,
    ) -> Result<Option<Length>, ReadFault> {
        match (abscissa, self.options.base_radius) {
            (Abscissa::Distance, _) => Ok(None),
            (_, Some(radius)) => {
                let differs = |stated: &Length| (*stated / radius - 1.0).abs() > HEADER_DIGITS;
                let stated = self.values.base_radius.filter(differs);
                warnings.extend(stated.map(|stated| Warning::HeaderDisagrees {
                    what: "base radius".into(),
                    stated,
                    used: radius,
                    reason: "as stated".into(),
                }));
                Ok(Some(radius))
            }
            (_, None) if self.values.base_radius.is_some() => Ok(self.values.base_radius),
            (_, None) => Err(ReadFault::roll_length(abscissa)),
        }
    }

    /// State of filtering, with its cut-offs in `metadata`.
    fn filter_state(&self, metadata: &mut Metadata, warnings: &mut Vec<Warning>) -> FilterState {
        let state = match self.values.filter {
            Some(filter) => {
                (metadata.lambda_c, metadata.lambda_s) = (filter.lambda_c, filter.lambda_s);
                filter.state
            }
            None => header::filter_state(self.name, self.header),
        };
        if state == FilterState::Roughness {
            warnings.push(Warning::AlreadyFiltered);
        }
        state
    }

    fn assemble(self, text: &mut TextSource<'_>, rows: Rows) -> Result<Trace, ReadFault> {
        let name = self.name;
        let Rows {
            mut x,
            mut z,
            empty,
        } = rows;
        let mut warnings = self.doubts_of_columns(empty);
        grid::unmark(&mut z);
        let abscissa = self.abscissa();
        let base_radius = self.base_radius(abscissa, &mut warnings)?;
        if let (Some(x), Some(radius)) = (&mut x, base_radius) {
            roll_length::roll_lengths(x, abscissa, radius);
        }
        let count = z.len();
        let special = match x {
            None if self.stated_spacing().is_some() => Special::delimited(),
            None => single_column::interpret(
                text,
                self.first,
                !self.header.is_empty(),
                &mut z,
                self.options,
                &mut warnings,
            )?,
            Some(_) => Special::delimited(),
        };
        let header_numbers = count - z.len();
        warnings.extend(stated_count::check(special.format, self.header, z.len())?);
        let mut place =
            |row: usize| rows::place(text, self.first, self.before + row + header_numbers);
        grid::enough(z.len())?;
        let mut column = None;
        // With a stated spacing x is not required and not checked.
        if let (Some(x), None) = (&mut x, self.options.spacing()) {
            let spacing = grid::spacing(x, &mut place)?;
            if spacing.falls {
                z.reverse();
                warnings.push(Warning::Reversed);
            }
            column = Some(spacing);
        }
        let falls = column.as_ref().is_some_and(|spacing| spacing.falls);
        let first = |row: usize| {
            let row = if falls { count - 1 - row } else { row };
            if !self.is_listed {
                return Ok((None, grid::node(row, self.options, None)));
            }
            let (line, text) = place(row)?;
            Ok((Some(line), format!("reads \"{text}\"")))
        };
        let gaps = self.options.gaps;
        let unevenness = column.as_ref().and_then(|spacing| spacing.unevenness);
        let mut left_out = 0;
        if let (Some(x), true) = (&mut x, unevenness.is_some() || base_radius.is_some()) {
            left_out = grid::leave_out(x, &mut z, gaps, &mut warnings)?;
        }
        let (heights, filled) = grid::heights(z, gaps, first, &mut warnings)?;
        let measured = self.measure(x.as_deref(), &heights, column, &special, &mut warnings)?;
        let mut metadata = self.metadata();
        let positions = match (x, measured.x_unit, base_radius, unevenness) {
            (Some(x), Some(unit), Some(base_radius), _) => {
                let x = found::metres(x, unit)?;
                let x = roll_length::along_involute(x, base_radius)?;
                metadata.arc_from_base = x.first().copied().map(Length::from_si);
                own(x, unevenness.unwrap_or_default())
            }
            (Some(x), Some(unit), None, Some(unevenness)) => {
                own(found::metres(x, unit)?, unevenness)
            }
            _ => Positions::Even {
                spacing: Length::from_si(measured.spacing),
            },
        };
        let filter_state = self.filter_state(&mut metadata, &mut warnings);
        Ok(Trace {
            name: name.to_owned(),
            positions,
            heights: found::metres(heights, measured.z_unit)?,
            format: self.format(special.format),
            encoding: Some(self.encoding),
            table: Some(TableLayout {
                separator: self.sniffed.dialect.separator,
                decimal: self.sniffed.dialect.decimal,
                columns: self.chosen.columns(),
            }),
            x_unit: measured.x_unit,
            z_unit: measured.z_unit,
            spacing_source: measured.source,
            filter_state,
            gaps_filled: filled + left_out,
            cut: None,
            metadata,
            warnings,
            scaled: false,
            roll: base_radius.map(|radius| (abscissa, radius)),
        })
    }

    /// Meaning of the x column: as stated, or by its label.
    fn abscissa(&self) -> Abscissa {
        let labelled = self.chosen.x.and_then(|x| self.labels.get(x)?.role);
        match (self.options.abscissa, labelled) {
            _ if self.chosen.x.is_none() || self.options.spacing().is_some() => Abscissa::Distance,
            (Some(stated), _) => stated,
            (None, Some(Role::Roll(abscissa))) => abscissa,
            (None, _) => Abscissa::Distance,
        }
    }

    /// The unit of a column: as stated, or of the file or its format, with a warning if the two differ.
    fn unit(
        &self,
        axis: Axis,
        column: usize,
        of_format: Option<LengthUnit>,
        warnings: &mut Vec<Warning>,
    ) -> Result<Option<LengthUnit>, ReadFault> {
        // Roll angles have been converted to roll lengths in metres.
        let is_angle = matches!(
            self.abscissa(),
            Abscissa::RollDegrees | Abscissa::RollRadians
        );
        if axis == Axis::Trace && is_angle {
            return Ok(Some(LengthUnit::Metre));
        }
        let of_header = match axis {
            Axis::Trace => None,
            Axis::Height => self.values.z_unit.as_ref(),
        };
        let label = self.labels.get(column);
        let found = label.and_then(|label| label.unit.as_ref()).or(of_header);
        let found = header::unit_of_file(found, axis, self.options)?.or(of_format);
        let stated = self.options.unit(axis);
        let both = stated.zip(found);
        warnings
            .extend(both.and_then(|(stated, found)| lengths::unit_overridden(axis, stated, found)));
        Ok(stated.or(found))
    }

    /// Spacing and units: as stated, from the header, or the only possible ones.
    fn measure(
        &self,
        x: Option<&[f64]>,
        heights: &[f64],
        column: Option<Spacing>,
        special: &Special,
        warnings: &mut Vec<Warning>,
    ) -> Result<MeasuredSpacing, ReadFault> {
        let (low, high) = extremes(heights);
        let span = high - low;
        let extent = |spacing: f64| Extent {
            length: spacing * (heights.len() - 1) as f64,
            span,
            slope: root_mean_square_step(heights) / spacing,
        };
        let no_spacing = |hint| Err(ReadFault::no_spacing(hint));
        let z_stated = self.unit(Axis::Height, self.chosen.z, special.unit, warnings)?;
        if let Some(dx) = self.options.spacing() {
            warnings.extend(x.and_then(|x| self.overridden(x, dx)));
            let source = SpacingSource::Stated;
            return without_x(dx.si(), source, z_stated, extent(dx.si()), warnings);
        }
        if let (Some(spacing), Some(z_unit)) = (special.spacing, z_stated) {
            return Ok(MeasuredSpacing {
                spacing,
                source: SpacingSource::FirstLine,
                x_unit: Some(LengthUnit::Micrometre),
                z_unit,
            });
        }
        if let (None, Some(spacing)) = (x, self.values.spacing) {
            let not_used = |stated| Warning::UnitNotUsed {
                axis: Axis::Trace,
                stated,
            };
            warnings.extend(self.options.x_unit.map(not_used));
            let source = SpacingSource::Header;
            return without_x(spacing, source, z_stated, extent(spacing), warnings);
        }
        let (Some(x), Some(x_column), Some(column)) = (x, self.chosen.x, column) else {
            return no_spacing(SpacingHint::None);
        };
        let x_stated = self.unit(Axis::Trace, x_column, None, warnings)?;
        if x_stated.is_none() && (self.has_pixels || grid::counts_points(x)) {
            return no_spacing(SpacingHint::XCounts);
        }
        let extent = extent(column.mean);
        let found = units::pair(extent, x_stated, z_stated);
        let (x_unit, z_unit) = found.ok_or_else(|| match z_stated {
            None => ReadFault::no_unit(Axis::Height, span),
            Some(_) => ReadFault::no_unit(Axis::Trace, extent.length),
        })?;
        for (axis, stated, unit) in [
            (Axis::Trace, x_stated, x_unit),
            (Axis::Height, z_stated, z_unit),
        ] {
            if stated.is_none() {
                warnings.push(Warning::UnitAssumed { axis, unit });
            }
        }
        // x has rounding errors; the header of a file of this program states the spacing.
        let from_column = x_unit.metres(column.mean);
        let used = Length::from_si(from_column);
        let agrees = |dx: &f64| common_spacing(Length::from_si(*dx), used).is_some();
        let (spacing, source) = match self.values.spacing {
            Some(dx) if agrees(&dx) => (dx, SpacingSource::Header),
            Some(dx) if (dx / from_column - 1.0).abs() > HEADER_DIGITS => {
                warnings.push(Warning::HeaderDisagrees {
                    what: "spacing".into(),
                    stated: Length::from_si(dx),
                    used,
                    reason: "as the x column gives it".into(),
                });
                (from_column, SpacingSource::XColumn)
            }
            _ => (from_column, SpacingSource::XColumn),
        };
        Ok(MeasuredSpacing {
            spacing,
            source,
            x_unit: Some(x_unit),
            z_unit,
        })
    }

    /// Warning that a stated spacing differs from the spacing of the x column, if it has a unit.
    fn overridden(&self, x: &[f64], stated: Length) -> Option<Warning> {
        let unit = self.unit(Axis::Trace, self.chosen.x?, None, &mut Vec::new());
        let unit = unit.ok().flatten()?;
        let (first, last) = (x.first()?, x.last()?);
        let column = Length::from_si(unit.metres((last - first).abs() / (x.len() - 1) as f64));
        found::overridden(stated, column)
    }

    /// Formats that are tables, recognised by their name or header.
    fn format(&self, found: Format) -> Format {
        let starts = |text: &str| self.header.iter().any(|line| line.text.starts_with(text));
        match () {
            () if found != Format::DelimitedText => found,
            () if self.format != Format::DelimitedText => self.format,
            () if extension(self.name) == "hfm" => Format::HommelHfm,
            () if starts("Meta Data") && starts("Lateral") => Format::DektakCsv,
            () => found,
        }
    }

    /// Values of header lines of the form "name, value" or "name = value".
    fn metadata(&self) -> Metadata {
        let mut metadata = Metadata::default();
        for line in self.header {
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

    /// The spacing of the header, which is used without an x column unless another one is stated.
    fn stated_spacing(&self) -> Option<f64> {
        self.values.spacing.filter(|_| self.options.dx.is_none())
    }
}

/// Spacing \[m\] of heights without x, with their unit: as stated, or the only possible one.
fn without_x(
    spacing: f64,
    source: SpacingSource,
    z_stated: Option<LengthUnit>,
    extent: Extent,
    warnings: &mut Vec<Warning>,
) -> Result<MeasuredSpacing, ReadFault> {
    let z_unit = z_stated.or_else(|| units::heights_only(extent));
    let z_unit = z_unit.ok_or_else(|| ReadFault::no_unit(Axis::Height, extent.span))?;
    if z_stated.is_none() {
        warnings.push(Warning::UnitAssumed {
            axis: Axis::Height,
            unit: z_unit,
        });
    }
    Ok(MeasuredSpacing {
        spacing,
        source,
        x_unit: None,
        z_unit,
    })
}
