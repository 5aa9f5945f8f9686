//! Errors in reading a file: where, what was seen, what was expected, what to do.

use asperity_core::quantity::Length;
use asperity_core::remedy::{Remedy, Setting, Value};

use super::format::Format;
use super::layout::Dialect;
use super::options::{Abscissa, Axis, DecimalSign, LengthUnit, Separator};
use super::steepness::Steepness;

/// A file that was refused. [`code`](Self::code) is stable; the text names file, line, what was seen and what
/// was expected; [`remedy`](Self::remedy) says what can be done, as data.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// A cell that is not a number.
    #[error("{file}:{line}: cannot read \"{text}\" as a number; the file looks like {dialect}")]
    UnreadableNumber {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// The cell.
        text: String,
        /// Look of the rest of the file.
        dialect: Dialect,
        /// Advice.
        remedy: CellRemedy,
    },
    /// No line holds a row of numbers.
    #[error("{file}: no rows of numbers found in {lines} lines{first}")]
    NoData {
        /// Name of the file.
        file: String,
        /// Lines seen.
        lines: usize,
        /// The first line, as `, which start with "..."`; empty for an empty file.
        first: FirstLine,
    },
    /// The file could not be opened or read.
    #[error("{file}: the file cannot be read ({source})")]
    NotReadable {
        /// Name of the file.
        file: String,
        /// Reason the system gave.
        source: std::io::Error,
    },
    /// No unit, and the values do not single one out.
    #[error("{file}: no unit found and {axis} span {span}")]
    NoUnit {
        /// Name of the file.
        file: String,
        /// Column.
        axis: Axis,
        /// Largest minus smallest value, in the unit of the file.
        span: f64,
    },
    /// x turns back.
    #[error("{file}:{line}: x goes from {previous} to {next}, against the direction of the trace")]
    NotMonotone {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// x before, in the unit of the file.
        previous: f64,
        /// x on this line.
        next: f64,
    },
    /// Too few points for any roughness parameter.
    #[error("{file}: {points} points; a roughness profile needs at least {needed}")]
    TooFewPoints {
        /// Name of the file.
        file: String,
        /// Points found.
        points: usize,
        /// Least number.
        needed: usize,
    },
    /// Points without a height.
    #[error("{file}:{line}: {missing} of {points} points have no height, the first reads \"{text}\"{}", if *fillable { "" } else { ": too many to interpolate" })]
    MissingPoints {
        /// Name of the file.
        file: String,
        /// Line of the first.
        line: usize,
        /// Text of the first one.
        text: String,
        /// Number of missing points.
        missing: usize,
        /// Number of rows.
        points: usize,
        /// Whether [`Gaps::Interpolate`](super::Gaps::Interpolate) would take them.
        fillable: bool,
    },
    /// A known format that this version does not read.
    #[error("{file}: {format} is not read by this version")]
    FormatNotRead {
        /// Name of the file.
        file: String,
        /// The format.
        format: Format,
    },
    /// Points that do not lie on an even grid.
    #[error(
        "{file}:{line}: uneven spacing, x = {x} (unit of the file) is {off:.3} spacings away from an even grid of {spacing:.4}"
    )]
    UnevenSpacing {
        /// Name of the file.
        file: String,
        /// Line of the worst point.
        line: usize,
        /// Its x, in the unit of the file.
        x: f64,
        /// Its distance from the grid in spacings.
        off: f64,
        /// Mean spacing.
        spacing: Length,
    },
    /// Neighbours so far apart that points must be missing.
    #[error(
        "{file}: no points between x = {from:.6} and {to:.6}, {steps:.1} mean steps: they are missing, and resampling would draw a straight line there"
    )]
    GapInPositions {
        /// Name of the file.
        file: String,
        /// Position before.
        from: Length,
        /// Position after.
        to: Length,
        /// Their distance over the mean step.
        steps: f64,
    },
    /// Heights only.
    #[error("{file}: the heights have no x column to give the spacing{hint}")]
    NoSpacing {
        /// Name of the file.
        file: String,
        /// Statement of the file about it.
        hint: SpacingHint,
    },
    /// A row with too few or too many columns.
    #[error("{file}:{line}: {found} columns where other rows have {expected}: \"{text}\"")]
    RaggedRow {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// The line.
        text: String,
        /// Columns found.
        found: usize,
        /// Columns expected.
        expected: usize,
    },
    /// Several columns, and no telling which are x and height.
    #[error(
        "{file}: {columns} columns and no header that names x and height (or columns that do not exist)"
    )]
    ColumnsUnclear {
        /// Name of the file.
        file: String,
        /// Columns found.
        columns: usize,
    },
    /// Commas that may separate or be decimal signs.
    #[error("{file}:{line}: \"{text}\": commas may separate columns or be decimal signs")]
    AmbiguousComma {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// The line.
        text: String,
    },
    /// A unit that is not a known length.
    #[error(
        "{file}: the header gives the {axis} in \"{unit}\", which is not one of m, mm, um, nm, angstrom, inch, mil, uin"
    )]
    UnknownUnit {
        /// Name of the file.
        file: String,
        /// Column.
        axis: Axis,
        /// The unit seen.
        unit: String,
    },
    /// The stated separator, decimal sign or encoding does not fit.
    #[error("{file}: the file cannot be read with separator {separator}")]
    SeparatorDoesNotFit {
        /// Name of the file.
        file: String,
        /// As stated.
        separator: Separator,
    },
    /// A file that breaks the rules of its own format.
    #[error("{file}: not a valid {format} file: {what}{}", if seen.is_empty() { String::new() } else { format!(" (\"{seen}\")") })]
    Damaged {
        /// Name of the file.
        file: String,
        /// Its format.
        format: Format,
        /// Fault.
        what: &'static str,
        /// Value seen, empty when there is nothing to show.
        seen: String,
    },
    /// More bytes than a profile has.
    #[error("{file}: {what} has {bytes} bytes, more than the {most} allowed")]
    TooLarge {
        /// Name of the file.
        file: String,
        /// Part that is too large.
        what: &'static str,
        /// Its size.
        bytes: u64,
        /// The largest size read.
        most: u64,
    },
    /// Several profiles in one file.
    #[error("{file}: the file holds {rows} profiles of {points} points{}", if *asked == 0 { String::new() } else { format!(", row {asked} is not among them") })]
    SeveralProfiles {
        /// Name of the file.
        file: String,
        /// Profiles in the file.
        rows: usize,
        /// Points of each.
        points: usize,
        /// The row asked for, 0 for none.
        asked: usize,
    },
    /// A file of a known format that holds something else than heights.
    #[error("{file}: the file ({format}) holds {content}")]
    NotHeights {
        /// Name of the file.
        file: String,
        /// Its format.
        format: Format,
        /// Content of it.
        content: &'static str,
    },
    /// Several arrays, and no telling which holds the heights.
    #[error("{file}: the file holds several arrays and none is named z: {names}")]
    SeveralArrays {
        /// Name of the file.
        file: String,
        /// Their names.
        names: String,
    },
    /// An x column of an involute checker, without the base radius that converts it.
    #[error(
        "{file}: x is a {abscissa} from a gear inspection machine, not the distance along the flank, and the base radius needed to convert it is not known"
    )]
    RollLength {
        /// Name of the file.
        file: String,
        /// Meaning of x.
        abscissa: Abscissa,
    },
    /// Heights that no flank has.
    #[error("{file}: {steepness}")]
    ImplausibleHeights {
        /// Name of the file.
        file: String,
        /// Slopes and what they point at.
        steepness: Steepness,
    },
    /// Numbers that make no profile: beyond the range of numbers, or no extent.
    #[error("{file}: {what} is {value} {unit}, which no profile has")]
    Impossible {
        /// Name of the file.
        file: String,
        /// Title.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Unit it was read in.
        unit: LengthUnit,
    },
}

impl ReadError {
    /// Name of the file and, where one is to blame, the line in it, from 1.
    pub fn place(&self) -> (&str, Option<usize>) {
        match self {
            Self::UnreadableNumber { file, line, .. }
            | Self::NotMonotone { file, line, .. }
            | Self::MissingPoints { file, line, .. }
            | Self::UnevenSpacing { file, line, .. }
            | Self::RaggedRow { file, line, .. }
            | Self::AmbiguousComma { file, line, .. } => (file, Some(*line)),
            Self::NoData { file, .. }
            | Self::NotReadable { file, .. }
            | Self::NoUnit { file, .. }
            | Self::TooFewPoints { file, .. }
            | Self::FormatNotRead { file, .. }
            | Self::GapInPositions { file, .. }
            | Self::NoSpacing { file, .. }
            | Self::ColumnsUnclear { file, .. }
            | Self::UnknownUnit { file, .. }
            | Self::SeparatorDoesNotFit { file, .. }
            | Self::Damaged { file, .. }
            | Self::TooLarge { file, .. }
            | Self::SeveralProfiles { file, .. }
            | Self::NotHeights { file, .. }
            | Self::SeveralArrays { file, .. }
            | Self::RollLength { file, .. }
            | Self::ImplausibleHeights { file, .. }
            | Self::Impossible { file, .. } => (file, None),
        }
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
        match self {
            Self::UnreadableNumber { remedy, .. } => remedy.remedy(),
            Self::NoData { .. } => {
                Remedy::act("export the profile as text with an x and a height column")
            }
            Self::NotReadable { .. } => Remedy::act("check name and access rights"),
            Self::NoUnit { axis, .. } => {
                Remedy::set(axis.setting(), Value::OneOf("um | nm | mm".into()))
            }
            Self::NotMonotone { .. } => Remedy::act("remove the repeated part")
                .or_set(Setting::Columns, Value::Any)
                .because("if x is another column"),
            Self::TooFewPoints { .. } => Remedy::act("export the whole trace"),
            Self::MissingPoints { fillable: true, .. } => {
                Remedy::set(Setting::Gaps, Value::This("interpolate".into()))
                    .because("to fill them")
            }
            Self::MissingPoints { .. } => Remedy::act("measure again"),
            Self::FormatNotRead { format, .. } => Remedy::act(format.remedy()),
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
                    _ => spacing,
                }
            }
            Self::RaggedRow { .. } => Remedy::act("correct or remove this line"),
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
                Remedy::set(Setting::Row, Value::OneOf(format!("1 .. {rows}").into()))
                    .or_set(Setting::Line, Value::This("mean".into()))
                    .because("for the mean of all")
            }
            Self::NotHeights { .. } => Remedy::act("export the heights"),
            Self::SeveralArrays { .. } => {
                Remedy::act("save the heights alone, or under the name z")
            }
            Self::Impossible { .. } => Remedy::act("check the unit and the columns"),
        }
    }

    /// The code under which the message is explained.
    pub fn code(&self) -> &'static str {
        match self {
            Self::UnreadableNumber { .. } => "E101",
            Self::NoData { .. } => "E102",
            Self::NotReadable { .. } => "E103",
            Self::NoUnit { .. } => "E104",
            Self::NotMonotone { .. } => "E105",
            Self::TooFewPoints { .. } => "E106",
            Self::MissingPoints { .. } => "E107",
            Self::FormatNotRead { .. } => "E108",
            Self::UnevenSpacing { .. } => "E109",
            Self::NoSpacing { .. } => "E110",
            Self::RaggedRow { .. } => "E111",
            Self::ColumnsUnclear { .. } => "E112",
            Self::AmbiguousComma { .. } => "E113",
            Self::UnknownUnit { .. } => "E114",
            Self::SeparatorDoesNotFit { .. } => "E115",
            Self::Impossible { .. } => "E116",
            Self::Damaged { .. } => "E117",
            Self::TooLarge { .. } => "E118",
            Self::SeveralProfiles { .. } => "E119",
            Self::RollLength { .. } => "E130",
            Self::GapInPositions { .. } => "E136",
            Self::NotHeights { .. } => "E320",
            Self::SeveralArrays { .. } => "E321",
            Self::ImplausibleHeights { .. } => "E131",
        }
    }
}

/// Treatment of a cell that is not a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum CellRemedy {
    /// The file is written with this decimal sign.
    Decimal(DecimalSign),
    /// The separator that was stated is not that of the file.
    Separator,
    /// Nothing but the line is wrong.
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

/// Statement of a file without an x column about its spacing.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SpacingHint {
    /// Nothing.
    None,
    /// The x column counts the points.
    XCounts,
    /// Line 1 is written unlike the others: a spacing in an unstated unit, as in NPL text profiles.
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
                "; line 1 reads {value} and is written differently from the rest, like the spacing of an NPL text profile (um) or a length"
            ),
            Self::NominalLength { length, points } => write!(
                f,
                "; this is a Surfcom text profile, whose header gives the nominal length {length} and {points} points. If the trace was not aborted the spacing is {:.4} um (see the .tx3 file)",
                length.si() * 1e6 / points as f64
            ),
        }
    }
}
