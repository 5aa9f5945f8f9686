//! Errors of reading a file.

use asperity_core::quantity::Length;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, Fault, RepeatedFault, decimals, number};

use super::format::Format;
use super::layout::Dialect;
use super::options::{
    Abscissa, Axis, DecimalSign, FEWEST_POINTS, LengthUnit, Separator, TraceLine, TraceRange,
};
use super::seems::{FileDialect, WITHOUT_THOUSANDS};
use super::steepness::Steepness;

/// Error of reading a file. The text states file, line, and the actual and expected content; [`code`](Self::code) is
/// stable; [`remedy`](Self::remedy) is the remedy as data.
#[derive(Debug, thiserror::Error)]
#[error("{file}{}: {fault}", fault.line().map_or(String::new(), |line| format!(":{line}")))]
pub struct ReadError {
    /// Name of the file.
    pub file: String,
    /// Why it cannot be read.
    pub fault: ReadFault,
}

impl ReadError {
    /// Name of the file, and the line of the error, from 1, if there is one.
    pub fn place(&self) -> (&str, Option<usize>) {
        (&self.file, self.fault.line())
    }

    /// Remedy.
    ///
    /// ```
    /// use asperity_core::remedy::{Action, Setting};
    /// use asperity_profile_io::read::{ReadOptions, read_bytes};
    /// let heights: String = (0..200).map(|i| format!("{}.5\n", i % 7)).collect();
    /// let options = ReadOptions { z_unit: Some("um".parse()?), ..ReadOptions::default() };
    /// let error = read_bytes("flank.txt", heights.as_bytes(), &options).unwrap_err();
    /// assert_eq!(error.remedy().to_string(), "Set dx, e.g. 0.5 um");
    /// assert!(matches!(
    ///     error.remedy().actions(),
    ///     [Action::Set { settings, .. }] if settings[..] == [Setting::Spacing]
    /// ));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn remedy(&self) -> Remedy {
        self.fault.remedy()
    }

    /// Code of the explanation of the message.
    pub fn code(&self) -> Code {
        self.fault.code()
    }
}

/// Remedy for a workbook whose table is not read.
const SHEET_AS_TEXT: &str = "save the sheet of the table as CSV, or as text with tabs";

/// Reason why a file cannot be read, without its name. The two faults of a row are distinguished, because like faults of
/// many rows are one of the file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadFault {
    /// A cell that is not a number.
    #[error("cannot read \"{text}\" as a number; the file looks like {dialect}")]
    UnreadableNumber {
        /// Line, from 1.
        line: usize,
        /// The cell.
        text: String,
        /// Detected dialect of the file.
        dialect: Dialect,
        /// Advice.
        remedy: CellRemedy,
    },
    /// A row with too few or too many columns.
    #[error("{found} columns where other rows have {expected}: \"{text}\"")]
    RaggedRow {
        /// Line, from 1.
        line: usize,
        /// The line.
        text: String,
        /// Number of columns.
        found: usize,
        /// Expected number of columns.
        expected: usize,
    },
    /// Any other error.
    #[error("{fault}")]
    Fault {
        /// Line, from 1, if the error is of one.
        line: Option<usize>,
        /// The error.
        fault: Fault,
    },
}

impl ReadFault {
    /// The error of `file`.
    pub fn in_file(self, file: &str) -> ReadError {
        ReadError {
            file: file.to_owned(),
            fault: self,
        }
    }

    /// Line of the fault, from 1, if there is one.
    pub fn line(&self) -> Option<usize> {
        match self {
            Self::UnreadableNumber { line, .. } | Self::RaggedRow { line, .. } => Some(*line),
            Self::Fault { line, .. } => *line,
        }
    }

    /// Remedy.
    pub fn remedy(&self) -> Remedy {
        match self {
            Self::UnreadableNumber { remedy, .. } => remedy.remedy(),
            Self::RaggedRow { .. } => Remedy::act("correct or remove this line"),
            Self::Fault { fault, .. } => fault.remedy().clone(),
        }
    }

    /// Code of the explanation of the message.
    pub fn code(&self) -> Code {
        match self {
            Self::UnreadableNumber { .. } => Code::E101,
            Self::RaggedRow { .. } => Code::E111,
            Self::Fault { fault, .. } => fault.code(),
        }
    }

    /// An error of this code and its remedy.
    fn new(code: Code, message: impl Into<String>, remedy: Remedy) -> Self {
        Self::Fault {
            line: None,
            fault: Fault::new(code, message).with(remedy),
        }
    }

    /// The same error at `line`, from 1.
    fn at_line(mut self, number: usize) -> Self {
        if let Self::Fault { line, .. } = &mut self {
            *line = Some(number);
        }
        self
    }

    /// No line of `lines` holds a row of numbers; `first` is the first of them that is not blank.
    pub(super) fn no_data(lines: usize, first: Option<&str>) -> Self {
        let first = first.map(|text| format!(", the first reads \"{text}\""));
        let first = first.unwrap_or_default();
        Self::new(
            Code::E102,
            format!("no rows of numbers found in {lines} lines{first}"),
            Remedy::act("export the profile as text with an x and a height column")
                .or_set(Setting::Columns, Value::Like("1,2".into()))
                .because("if other columns hold text"),
        )
    }

    /// No unit is stated, and values of this span, in the unit of the file, do not determine it. The units that are proposed give
    /// a span that instruments measure.
    pub(super) fn no_unit(axis: Axis, span: f64) -> Self {
        // Spans [m]: a layer of atoms to a contour, a step profiler to a wafer.
        let range = match axis {
            Axis::Height => 1e-9..=0.05,
            Axis::Trace => 1e-6..=0.5,
        };
        use LengthUnit::{Metre, Micrometre, Millimetre, Nanometre};
        let units = [Micrometre, Nanometre, Millimetre, Metre].into_iter();
        let possible = units.filter(|unit| range.contains(&unit.metres(span)));
        let proposed: Vec<String> = possible.map(|unit| unit.to_string()).collect();
        let value = if proposed.is_empty() {
            Value::Any
        } else {
            Value::OneOf(proposed.join(" | ").into())
        };
        Self::new(
            Code::E104,
            format!("no unit found for the {axis}, which span {}", number(span)),
            Remedy::set(axis.setting(), value),
        )
    }

    /// x changes its direction at `line`: from `previous` to `next`, in the unit of the file.
    pub(super) fn not_monotone(line: usize, previous: f64, next: f64) -> Self {
        let fault = if previous == next {
            Self::new(
                Code::E105,
                format!("x repeats {}: two points at one place", number(next)),
                Remedy::act("remove one of the two rows")
                    .or_set(Setting::Spacing, Value::Like("0.5 um".into()))
                    .because("if the points are even"),
            )
        } else {
            let remedy = Remedy::act("remove the repeated part")
                .or_set(Setting::Columns, Value::Any)
                .because("if x is another column");
            // From 999 to 1.000.
            let is_grouped = (1e3 * next / previous - 1.0).abs() < 0.1;
            Self::new(
                Code::E105,
                format!(
                    "x goes from {} to {}, against the direction of the trace",
                    number(previous),
                    number(next)
                ),
                if is_grouped {
                    Remedy::act(WITHOUT_THOUSANDS)
                } else {
                    remedy
                },
            )
        };
        fault.at_line(line)
    }

    /// Points x, y, z of which one place occurs a second time at `line`.
    pub(super) fn repeated_point(line: usize, x: f64, y: f64) -> Self {
        Self::new(
            Code::E105,
            format!(
                "the point x = {}, y = {} occurs a second time: another scan seems to begin here",
                number(x),
                number(y)
            ),
            Remedy::act("export one scan to a file")
                .or_set(Setting::Columns, Value::Like("1,3".into()))
                .because("if the three columns are not x, y and z"),
        )
        .at_line(line)
    }

    /// Too few points for any roughness parameter.
    pub fn too_few_points(points: usize) -> Self {
        Self::new(
            Code::E106,
            format!("{points} points; a roughness profile needs at least {FEWEST_POINTS}"),
            Remedy::act("export the whole trace"),
        )
    }

    /// Lines of `points` points of a surface, of which the lines across them have enough for roughness parameters.
    pub(super) fn lines_too_short(points: usize, across: TraceLine) -> Self {
        let text = format!("{points} points; a roughness profile needs at least {FEWEST_POINTS}");
        let other = Value::This(across.to_string().into());
        let remedy =
            Remedy::set(Setting::Line, other).because("to read the lines across, which have more");
        Self::new(Code::E106, text, remedy)
    }

    /// `missing` of `points` points have no height; `first` is what the line of the first reads, or which point of the trace
    /// or surface it is, and `fillable` whether [`Gaps::Interpolate`](super::Gaps::Interpolate) would fill them.
    pub(super) fn missing_points(
        line: Option<usize>,
        first: &str,
        [missing, points]: [usize; 2],
        fillable: bool,
    ) -> Self {
        let (more, remedy) = if fillable {
            let filled = Value::This("interpolate".into());
            let remedy = Remedy::set(Setting::Gaps, filled).because("to fill them");
            ("", remedy)
        } else {
            let remedy = Remedy::act("measure again")
                .or_set(Setting::Row, Value::Any)
                .because("to another trace of a surface");
            (": too many to interpolate", remedy)
        };
        let text = format!("{missing} of {points} points have no height, the first {first}{more}");
        let fault = Self::new(Code::E107, text, remedy);
        match line {
            Some(line) => fault.at_line(line),
            None => fault,
        }
    }

    /// A known format that is not supported.
    pub(super) fn format_not_read(format: Format) -> Self {
        Self::new(
            Code::E108,
            format!("{format} is not read by this version"),
            Remedy::act(format.remedy()),
        )
    }

    /// A workbook with tables on `sheets` sheets.
    #[cfg(feature = "packed")]
    pub(super) fn several_tables(sheets: usize) -> Self {
        Self::new(
            Code::E108,
            format!("the workbook has numbers on {sheets} sheets"),
            Remedy::act(SHEET_AS_TEXT),
        )
    }

    /// A file instead of a table as text.
    pub(super) fn not_table(format: Format) -> Self {
        Self::new(
            Code::E108,
            format!("the file ({format}) is not a table as text"),
            Remedy::act(match format {
                Format::Excel | Format::ExcelBinary => SHEET_AS_TEXT,
                Format::Matlab => {
                    "write the columns with their names as CSV, in MATLAB with writetable"
                }
                _ => "export the table as CSV, or as text with tabs",
            }),
        )
    }

    /// The points are not on an even grid of `spacing`: `x`, in the unit of the file, is farthest from it, by `off` spacings.
    pub(super) fn uneven_spacing(line: usize, x: f64, off: f64, spacing: Length) -> Self {
        Self::new(
            Code::E109,
            format!(
                "uneven spacing, x = {} (unit of the file) is {} spacings away from an even grid of {spacing:.4}",
                number(x),
                decimals(off, 3)
            ),
            Remedy::set(Setting::Uneven, Value::This("resample".into()))
                .because("to interpolate linearly onto an even grid"),
        )
        .at_line(line)
    }

    /// A gap of `steps` mean steps between two positions: points must be missing.
    pub(super) fn gap_in_positions([from, to]: [Length; 2], steps: f64) -> Self {
        Self::new(
            Code::E136,
            format!(
                "no points between x = {from:.6} and {to:.6}, {} mean steps: they are missing, and resampling would draw a straight line there",
                decimals(steps, 1)
            ),
            Remedy::act("export the whole trace, or only its part before or after the gap"),
        )
    }

    /// A range that ends behind the trace of this length.
    pub(super) fn range_outside(range: TraceRange, length: Length) -> Self {
        let all = format!("0 mm .. {length}");
        Self::new(
            Code::E139,
            format!("the range {range} does not lie within the trace, which is {length:.4} long"),
            Remedy::set(Setting::Range, Value::Like(all.into()))
                .or_do("check the unit of the positions"),
        )
    }

    /// The file has no column of positions, and no spacing is stated.
    pub(super) fn no_spacing(hint: SpacingHint) -> Self {
        let spacing = Remedy::set(Setting::Spacing, Value::Like("0.5 um".into()));
        let remedy = match hint {
            SpacingHint::XCounts => spacing
                .or_set(Setting::XUnit, Value::Any)
                .because("if x is a length"),
            SpacingHint::NominalLength { length, points } => {
                let spacing = format!("{:.4} um", 1e6 * length.si() / points as f64);
                Remedy::act("put its .tx3 file under the same name next to it")
                    .or_set(Setting::Spacing, Value::Like(spacing.into()))
            }
            SpacingHint::None | SpacingHint::FirstLine(_) => spacing,
        };
        let text = match hint {
            SpacingHint::XCounts => "x counts the points, and no spacing of them was found".into(),
            hint => format!("no x column and no spacing of the points was found{hint}"),
        };
        Self::new(Code::E110, text, remedy)
    }

    /// The columns of x and height are unclear; `labels` are those of the columns, if they have any.
    pub(super) fn columns_unclear(columns: usize, labels: &[String]) -> Self {
        let labels = if labels.is_empty() {
            String::new()
        } else {
            format!(" ({})", labels.join(", "))
        };
        let remedy = Remedy::set(Setting::Columns, Value::Like("1,2".into()));
        Self::new(
            Code::E112,
            format!(
                "{columns} columns{labels}: position and height were not both found by their names (or the stated columns do not exist)"
            ),
            match columns {
                3 => remedy.or_do("export points x, y, z line by line on a grid"),
                _ => remedy,
            },
        )
    }

    /// The commas of the line `number` with `text` may be separators or decimal signs.
    pub(super) fn ambiguous_comma(number: usize, text: &str) -> Self {
        Self::new(
            Code::E113,
            format!("\"{text}\": commas may separate columns or be decimal signs"),
            Remedy::state_all(&[Setting::Separator, Setting::Decimal]).or_do("export with ';'"),
        )
        .at_line(number)
    }

    /// An unknown unit of length of a column.
    pub(super) fn unknown_unit(axis: Axis, unit: &str) -> Self {
        Self::new(
            Code::E114,
            format!(
                "the header gives the {axis} in \"{unit}\", which is not one of m, mm, um, nm, angstrom, inch, mil, uin"
            ),
            Remedy::act("convert the file")
                .or_set(axis.setting(), Value::Any)
                .because("if the header is wrong"),
        )
    }

    /// The stated separator does not fit.
    pub(super) fn separator_does_not_fit(separator: Separator) -> Self {
        Self::new(
            Code::E115,
            format!("the file cannot be read with separator {separator}"),
            Remedy::omit(Setting::Separator)
                .or_set(Setting::Separator, Value::Any)
                .because("to what separates the columns"),
        )
    }

    /// A `value` in `unit` that no profile has, for example of a length or spacing.
    pub fn impossible(what: &'static str, value: f64, unit: LengthUnit) -> Self {
        Self::new(
            Code::E116,
            format!("{what} is {} {unit}, which no profile has", number(value)),
            Remedy::act("check the unit and the columns"),
        )
    }

    /// An invalid file of a known format, with the invalid content, which may be empty.
    pub(super) fn damaged(format: Format, what: &'static str, seen: &str) -> Self {
        let seen = if seen.is_empty() {
            String::new()
        } else {
            format!(" (\"{seen}\")")
        };
        Self::new(
            Code::E117,
            format!("not a valid {format} file: {what}{seen}"),
            Remedy::act("export it again, or as text"),
        )
    }

    /// The error of `what` with more `bytes` than `most`.
    pub(crate) fn too_large(what: &'static str, bytes: u64, most: u64) -> Self {
        Self::new(
            Code::E118,
            format!("{what} has {bytes} bytes, more than the {most} allowed"),
            Remedy::act("export a single profile"),
        )
    }

    /// `rows` profiles of `points` points in one file, of which none or another one was `asked` for.
    pub(super) fn several_profiles(rows: usize, points: usize, asked: Option<usize>) -> Self {
        let asked = asked.filter(|row| *row > 0);
        let asked = asked.map(|row| format!(", row {row} is not among them"));
        let several = Value::This(rows.min(8).to_string().into());
        Self::new(
            Code::E119,
            format!(
                "the file holds {rows} profiles of {points} points{}",
                asked.unwrap_or_default()
            ),
            Remedy::set(Setting::Row, Value::OneOf(format!("1 .. {rows}").into()))
                .or_set(Setting::Rows, several)
                .because("for several of them"),
        )
    }

    /// The error of a file of `format` that holds `content`.
    pub(crate) fn no_heights(format: Format, content: &'static str) -> Self {
        Self::new(
            Code::E320,
            format!("the file ({format}) holds {content}"),
            Remedy::act("export the heights"),
        )
    }

    /// Several arrays without the name of an array of heights.
    pub(super) fn several_arrays(names: &str) -> Self {
        Self::new(
            Code::E321,
            format!("the file holds several arrays and none is named z: {names}"),
            Remedy::act("save the heights alone, or under the name z"),
        )
    }

    /// An x column of an involute checker without the base radius for its conversion.
    pub(super) fn roll_length(abscissa: Abscissa) -> Self {
        Self::new(
            Code::E130,
            format!(
                "x is a {abscissa} from a gear inspection machine, not the distance along the flank, and the base radius needed to convert it is not known"
            ),
            Remedy::set(Setting::BaseRadius, Value::Like("50 mm".into())),
        )
    }

    /// Implausible heights.
    pub fn implausible_heights(steepness: Steepness) -> Self {
        let remedy = steepness.suspicion.remedy();
        Self::new(Code::E131, steepness.to_string(), remedy)
    }

    /// The fault of the file, whose rows have `faults` like this one, and its remedy.
    pub(super) fn of_file(
        self,
        faults: &RepeatedFault,
        seems: &FileDialect,
        remedy: Remedy,
    ) -> Self {
        let text = if faults.is_dialect() {
            format!("{self}; {faults}; {seems}")
        } else {
            format!("{self}; {seems}")
        };
        let fault = Self::new(self.code(), text, remedy);
        match self.line() {
            Some(line) => fault.at_line(line),
            None => fault,
        }
    }
}

/// The file could not be opened or read.
impl From<std::io::Error> for ReadFault {
    fn from(source: std::io::Error) -> Self {
        Self::Fault {
            line: None,
            fault: Fault::new(Code::E103, format!("the file cannot be read ({source})"))
                .with(Remedy::act("check name and access rights"))
                .caused_by(source),
        }
    }
}

/// Remedy for a cell that is not a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum CellRemedy {
    /// The file has this decimal sign.
    Decimal(DecimalSign),
    /// The stated separator differs from the separator of the file.
    Separator,
    /// The cell seems to have a thousands separator.
    Thousands,
    /// Only the line is wrong.
    Line,
}

impl CellRemedy {
    fn remedy(self) -> Remedy {
        match self {
            Self::Decimal(sign) => {
                Remedy::set(Setting::Decimal, Value::This(sign.to_string().into()))
            }
            Self::Separator => Remedy::omit(Setting::Separator).or_do("correct this line"),
            Self::Thousands => Remedy::act(WITHOUT_THOUSANDS),
            Self::Line => Remedy::act("correct this line, with NaN for a missing height"),
        }
    }
}

/// Hint on the spacing in a file without an x column.
#[derive(Debug, Clone, Copy)]
pub(super) enum SpacingHint {
    /// Nothing.
    None,
    /// The x column counts the points.
    XCounts,
    /// Line 1 has a different number of decimals: a spacing in an unstated unit, as in NPL text profiles.
    FirstLine(f64),
    /// Surfcom: nominal length and number of points; the length is wrong for an aborted trace.
    NominalLength {
        /// As stated in the header.
        length: Length,
        /// Points.
        points: usize,
    },
}

impl std::fmt::Display for SpacingHint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match *self {
            Self::None | Self::XCounts => Ok(()),
            Self::FirstLine(value) => write!(
                f,
                "; line 1 reads {} and is written differently from the rest, like the spacing of an NPL text profile (um) or a length",
                number(value)
            ),
            Self::NominalLength { length, points } => write!(
                f,
                "; this is a Surfcom text profile, whose header gives the nominal length {length} and {points} points. If the trace was not aborted the spacing is {:.4} um",
                1e6 * length.si() / points as f64
            ),
        }
    }
}

/// At most forty characters of `text`, for a message.
pub(super) fn shortened(text: &str) -> String {
    const MOST: usize = 40;
    let text = text.trim();
    match text.char_indices().nth(MOST) {
        Some((at, _)) => format!("{}…", &text[..at]),
        None => text.to_owned(),
    }
}

impl From<ReadError> for Fault {
    fn from(error: ReadError) -> Self {
        let remedy = error.remedy();
        Self::from_cause(error.code(), error).with(remedy)
    }
}
