//! Errors of reading a file.

use asperity_core::quantity::Length;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, Fault, RepeatedFault, decimals, number};

use super::format::Format;
use super::layout::Dialect;
use super::options::{Abscissa, Axis, DecimalSign, LengthUnit, Separator, TraceRange};
use super::seems::FileDialect;
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

/// Reason why a file cannot be read, without its name.
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
    /// No line holds a row of numbers.
    #[error("no rows of numbers found in {lines} lines{first}")]
    NoData {
        /// Number of lines.
        lines: usize,
        /// The first line, as `, which start with "..."`; empty for an empty file.
        first: FirstLine,
    },
    /// The file could not be opened or read.
    #[error("the file cannot be read ({source})")]
    NotReadable {
        /// Reason given by the system.
        #[from]
        source: std::io::Error,
    },
    /// No unit is stated, and the values do not determine it.
    #[error("no unit found and {axis} span {span}", span = number(*span))]
    NoUnit {
        /// Column.
        axis: Axis,
        /// Largest minus smallest value, in the unit of the file.
        span: f64,
    },
    /// x changes its direction.
    #[error("{}", if previous == next { format!("x repeats {}: two points at one place", number(*next)) } else { format!("x goes from {} to {}, against the direction of the trace", number(*previous), number(*next)) })]
    NotMonotone {
        /// Line, from 1.
        line: usize,
        /// x before, in the unit of the file.
        previous: f64,
        /// x on this line.
        next: f64,
    },
    /// Too few points for any roughness parameter.
    #[error("{points} points; a roughness profile needs at least {needed}")]
    TooFewPoints {
        /// Number of points.
        points: usize,
        /// Minimum number.
        needed: usize,
    },
    /// Points without a height.
    #[error("{missing} of {points} points have no height, the first {first}{}", if *fillable { "" } else { ": too many to interpolate" })]
    MissingPoints {
        /// Line of the first missing point, if the file has one for it.
        line: Option<usize>,
        /// What that line reads, or which point of the trace or surface it is.
        first: String,
        /// Number of missing points.
        missing: usize,
        /// Number of rows.
        points: usize,
        /// Whether [`Gaps::Interpolate`](super::Gaps::Interpolate) would fill them.
        fillable: bool,
    },
    /// A known format that is not supported.
    #[error("{format} is not read by this version")]
    FormatNotRead {
        /// The format.
        format: Format,
    },
    /// A workbook with tables on several sheets.
    #[error("the workbook has numbers on {sheets} sheets")]
    SeveralTables {
        /// Number of these sheets.
        sheets: usize,
    },
    /// A file in place of a table as text.
    #[error("the file ({format}) is not a table as text")]
    NotTable {
        /// Its format.
        format: Format,
    },
    /// The points are not on an even grid.
    #[error(
        "uneven spacing, x = {x} (unit of the file) is {off} spacings away from an even grid of {spacing:.4}", x = number(*x), off = decimals(*off, 3))]
    UnevenSpacing {
        /// Line of the point farthest from the grid.
        line: usize,
        /// Its x, in the unit of the file.
        x: f64,
        /// Its distance from the grid in spacings.
        off: f64,
        /// Mean spacing.
        spacing: Length,
    },
    /// A gap between points: some must be missing.
    #[error(
        "no points between x = {from:.6} and {to:.6}, {steps} mean steps: they are missing, and resampling would draw a straight line there", steps = decimals(*steps, 1))]
    GapInPositions {
        /// Position before the gap.
        from: Length,
        /// Position after the gap.
        to: Length,
        /// Width of the gap in mean steps.
        steps: f64,
    },
    /// A range that ends behind the trace.
    #[error("the range {range} does not lie within the trace, which is {length:.4} long")]
    RangeOutside {
        /// Range as stated.
        range: TraceRange,
        /// Distance from the first point to the last.
        length: Length,
    },
    /// There is no x and no stated spacing.
    #[error("the heights have no x column to give the spacing{hint}")]
    NoSpacing {
        /// Hint in the file on the spacing.
        hint: SpacingHint,
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
    /// The columns of x and height are unclear.
    #[error(
        "{columns} columns{} and no header that names x and height (or columns that do not exist)",
        if labels.is_empty() { String::new() } else { format!(" ({})", labels.join(", ")) }
    )]
    ColumnsUnclear {
        /// Number of columns.
        columns: usize,
        /// Labels of the columns, if they have any.
        labels: Vec<String>,
    },
    /// Commas may be separators or decimal signs.
    #[error("\"{text}\": commas may separate columns or be decimal signs")]
    AmbiguousComma {
        /// Line, from 1.
        line: usize,
        /// The line.
        text: String,
    },
    /// An unknown unit of length.
    #[error(
        "the header gives the {axis} in \"{unit}\", which is not one of m, mm, um, nm, angstrom, inch, mil, uin"
    )]
    UnknownUnit {
        /// Column.
        axis: Axis,
        /// The unit.
        unit: String,
    },
    /// The stated separator, decimal sign or encoding does not fit.
    #[error("the file cannot be read with separator {separator}")]
    SeparatorDoesNotFit {
        /// As stated.
        separator: Separator,
    },
    /// An invalid file of a known format.
    #[error("not a valid {format} file: {what}{}", if seen.is_empty() { String::new() } else { format!(" (\"{seen}\")") })]
    Damaged {
        /// Its format.
        format: Format,
        /// Fault.
        what: &'static str,
        /// The invalid content; may be empty.
        seen: String,
    },
    /// A file, or a part of it, is too large.
    #[error("{what} has {bytes} bytes, more than the {most} allowed")]
    TooLarge {
        /// Part that is too large.
        what: &'static str,
        /// Its size.
        bytes: u64,
        /// Maximum size.
        most: u64,
    },
    /// Several profiles in one file.
    #[error("the file holds {rows} profiles of {points} points{}", if *asked == 0 { String::new() } else { format!(", row {asked} is not among them") })]
    SeveralProfiles {
        /// Number of profiles.
        rows: usize,
        /// Number of points of each.
        points: usize,
        /// The requested row; 0 if none was requested.
        asked: usize,
    },
    /// A file of a known format without heights.
    #[error("the file ({format}) holds {content}")]
    NotHeights {
        /// Its format.
        format: Format,
        /// Content of the file.
        content: &'static str,
    },
    /// Several arrays without the name of an array of heights.
    #[error("the file holds several arrays and none is named z: {names}")]
    SeveralArrays {
        /// Their names.
        names: String,
    },
    /// An x column of an involute checker without the base radius for its conversion.
    #[error(
        "x is a {abscissa} from a gear inspection machine, not the distance along the flank, and the base radius needed to convert it is not known"
    )]
    RollLength {
        /// Meaning of x.
        abscissa: Abscissa,
    },
    /// Implausible heights.
    #[error("{steepness}")]
    ImplausibleHeights {
        /// Slopes with their likely cause.
        steepness: Steepness,
    },
    /// A fault of many rows, which belongs to the file.
    #[error("{first}; {faults}; {seems}")]
    OfFile {
        /// The first of the faults.
        first: Box<ReadFault>,
        /// Their number and lines.
        faults: RepeatedFault,
        /// Dialect that the file seems to have.
        seems: FileDialect,
    },
    /// Points x, y, z of which one place occurs twice.
    #[error("the point x = {x}, y = {y} occurs a second time: another scan seems to begin here", x = number(*x), y = number(*y))]
    RepeatedPoint {
        /// Line, from 1, of the second of them.
        line: usize,
        /// Its x.
        x: f64,
        /// Its y.
        y: f64,
    },
    /// An impossible value, for example of a length or spacing.
    #[error("{what} is {value} {unit}, which no profile has", value = number(*value))]
    Impossible {
        /// Title.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Unit it was read in.
        unit: LengthUnit,
    },
}

impl ReadFault {
    /// The error of a file of `format` that holds `content`.
    pub(crate) fn no_heights(format: Format, content: &'static str) -> Self {
        Self::NotHeights { format, content }
    }

    /// The error of `what` with more `bytes` than `most`.
    pub(crate) fn too_large(what: &'static str, bytes: u64, most: u64) -> Self {
        Self::TooLarge { what, bytes, most }
    }

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
            Self::UnreadableNumber { line, .. }
            | Self::NotMonotone { line, .. }
            | Self::UnevenSpacing { line, .. }
            | Self::RaggedRow { line, .. }
            | Self::RepeatedPoint { line, .. }
            | Self::AmbiguousComma { line, .. } => Some(*line),
            Self::MissingPoints { line, .. } => *line,
            Self::OfFile { first, .. } => first.line(),
            _ => None,
        }
    }

    /// Remedy.
    pub fn remedy(&self) -> Remedy {
        match self {
            Self::UnreadableNumber { remedy, .. } => remedy.remedy(),
            Self::NoData { .. } => {
                Remedy::act("export the profile as text with an x and a height column")
                    .or_set(Setting::Columns, Value::Like("1,2".into()))
                    .because("if other columns hold text")
            }
            Self::NotReadable { .. } => Remedy::act("check name and access rights"),
            Self::NoUnit { axis, .. } => {
                Remedy::set(axis.setting(), Value::OneOf("um | nm | mm".into()))
            }
            Self::NotMonotone { previous, next, .. } if previous == next => {
                Remedy::act("remove one of the two rows")
                    .or_set(Setting::Spacing, Value::Like("0.5 um".into()))
                    .because("if the points are even")
            }
            Self::NotMonotone { .. } => Remedy::act("remove the repeated part")
                .or_set(Setting::Columns, Value::Any)
                .because("if x is another column"),
            Self::TooFewPoints { .. } => Remedy::act("export the whole trace"),
            Self::MissingPoints { fillable: true, .. } => {
                Remedy::set(Setting::Gaps, Value::This("interpolate".into()))
                    .because("to fill them")
            }
            Self::MissingPoints { .. } => Remedy::act("measure again")
                .or_set(Setting::Row, Value::Any)
                .because("to another trace of a surface"),
            Self::FormatNotRead { format, .. } => Remedy::act(format.remedy()),
            Self::SeveralTables { .. } => Remedy::act(SHEET_AS_TEXT),
            Self::NotTable { format } => Remedy::act(match format {
                Format::Excel | Format::ExcelBinary => SHEET_AS_TEXT,
                Format::Matlab => {
                    "write the columns with their names as CSV, in MATLAB with writetable"
                }
                _ => "export the table as CSV, or as text with tabs",
            }),
            Self::UnevenSpacing { .. } => {
                Remedy::set(Setting::Uneven, Value::This("resample".into()))
                    .because("to interpolate linearly onto an even grid")
            }
            Self::GapInPositions { .. } => {
                Remedy::act("export the whole trace, or only its part before or after the gap")
            }
            Self::RollLength { .. } => {
                Remedy::set(Setting::BaseRadius, Value::Like("50 mm".into()))
            }
            Self::ImplausibleHeights { steepness, .. } => steepness.suspicion.remedy(),
            Self::NoSpacing { hint, .. } => {
                let spacing = Remedy::set(Setting::Spacing, Value::Like("0.5 um".into()));
                match hint {
                    SpacingHint::XCounts => spacing
                        .or_set(Setting::XUnit, Value::Any)
                        .because("if x is a length"),
                    SpacingHint::NominalLength { length, points } => {
                        let spacing = format!("{:.4} um", 1e6 * length.si() / *points as f64);
                        Remedy::act("put its .tx3 file under the same name next to it")
                            .or_set(Setting::Spacing, Value::Like(spacing.into()))
                    }
                    _ => spacing,
                }
            }
            Self::RaggedRow { .. } => Remedy::act("correct or remove this line"),
            Self::ColumnsUnclear { columns: 3, .. } => {
                Remedy::set(Setting::Columns, Value::Like("1,2".into()))
                    .or_do("export points x, y, z line by line on a grid")
            }
            Self::ColumnsUnclear { .. } => Remedy::set(Setting::Columns, Value::Like("1,2".into())),
            Self::AmbiguousComma { .. } => {
                Remedy::state_all(&[Setting::Separator, Setting::Decimal]).or_do("export with ';'")
            }
            Self::UnknownUnit { axis, .. } => Remedy::act("convert the file")
                .or_set(axis.setting(), Value::Any)
                .because("if the header is wrong"),
            Self::SeparatorDoesNotFit { .. } => Remedy::omit(Setting::Separator)
                .or_set(Setting::Separator, Value::Any)
                .because("to what separates the columns"),
            Self::Damaged { .. } => Remedy::act("export it again, or as text"),
            Self::TooLarge { .. } => Remedy::act("export a single profile"),
            Self::SeveralProfiles { rows, .. } => {
                let several = Value::This(rows.min(&8).to_string().into());
                Remedy::set(Setting::Row, Value::OneOf(format!("1 .. {rows}").into()))
                    .or_set(Setting::Rows, several)
                    .because("for several of them")
            }
            Self::NotHeights { .. } => Remedy::act("export the heights"),
            Self::SeveralArrays { .. } => {
                Remedy::act("save the heights alone, or under the name z")
            }
            Self::RangeOutside { length, .. } => {
                let all = format!("0 mm .. {}", length);
                Remedy::set(Setting::Range, Value::Like(all.into()))
                    .or_do("check the unit of the positions")
            }
            Self::Impossible { .. } => Remedy::act("check the unit and the columns"),
            Self::OfFile { first, seems, .. } => {
                seems.remedy(first.remedy(), matches!(**first, Self::Damaged { .. }))
            }
            Self::RepeatedPoint { .. } => Remedy::act("export one scan to a file")
                .or_set(Setting::Columns, Value::Like("1,3".into()))
                .because("if the three columns are not x, y and z"),
        }
    }

    /// Code of the explanation of the message.
    pub fn code(&self) -> Code {
        match self {
            Self::UnreadableNumber { .. } => Code::E101,
            Self::NoData { .. } => Code::E102,
            Self::NotReadable { .. } => Code::E103,
            Self::NoUnit { .. } => Code::E104,
            Self::NotMonotone { .. } | Self::RepeatedPoint { .. } => Code::E105,
            Self::TooFewPoints { .. } => Code::E106,
            Self::MissingPoints { .. } => Code::E107,
            Self::FormatNotRead { .. } | Self::NotTable { .. } | Self::SeveralTables { .. } => {
                Code::E108
            }
            Self::UnevenSpacing { .. } => Code::E109,
            Self::NoSpacing { .. } => Code::E110,
            Self::RaggedRow { .. } => Code::E111,
            Self::ColumnsUnclear { .. } => Code::E112,
            Self::AmbiguousComma { .. } => Code::E113,
            Self::UnknownUnit { .. } => Code::E114,
            Self::SeparatorDoesNotFit { .. } => Code::E115,
            Self::Impossible { .. } => Code::E116,
            Self::Damaged { .. } => Code::E117,
            Self::TooLarge { .. } => Code::E118,
            Self::SeveralProfiles { .. } => Code::E119,
            Self::RollLength { .. } => Code::E130,
            Self::GapInPositions { .. } => Code::E136,
            Self::RangeOutside { .. } => Code::E139,
            Self::NotHeights { .. } => Code::E320,
            Self::SeveralArrays { .. } => Code::E321,
            Self::ImplausibleHeights { .. } => Code::E131,
            Self::OfFile { first, .. } => first.code(),
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
            Self::Line => Remedy::act("correct or remove this line"),
        }
    }
}

/// First line of an unreadable file.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstLine(pub Option<String>);

impl std::fmt::Display for FirstLine {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.0 {
            Some(text) => write!(f, ", the first reads \"{text}\""),
            None => Ok(()),
        }
    }
}

/// Hint on the spacing in a file without an x column.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SpacingHint {
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
            Self::None => Ok(()),
            Self::XCounts => write!(f, " (x counts the points)"),
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
        Self::of(error.code(), error).with(remedy)
    }
}
