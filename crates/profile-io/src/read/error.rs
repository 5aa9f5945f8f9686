//! Why a file was not read: where, what was seen, what was expected, what to do.

use asperity_core::quantity::Length;

use super::format::Format;
use super::layout::Dialect;
use super::options::{Abscissa, Axis, LengthUnit, Separator};
use super::steepness::Steepness;

/// A file that was refused. [`code`](Self::code) is stable; the text names file, line and remedy.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// A cell that is not a number.
    #[error(
        "{file}:{line}: cannot read \"{text}\" as a number; the file looks like {dialect}. {remedy}"
    )]
    UnreadableNumber {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// The cell.
        text: String,
        /// What the rest of the file looks like.
        dialect: Dialect,
        /// What to do.
        remedy: &'static str,
    },
    /// No line holds a row of numbers.
    #[error(
        "{file}: no rows of numbers found in {lines} lines{first}. Export the profile as text with an x and a height column"
    )]
    NoData {
        /// Name of the file.
        file: String,
        /// Lines seen.
        lines: usize,
        /// The first line, as `, which start with "..."`; empty for an empty file.
        first: FirstLine,
    },
    /// The file could not be opened or read.
    #[error("{file}: the file cannot be read ({source}). Check name and access rights")]
    NotReadable {
        /// Name of the file.
        file: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// No unit, and the values do not single one out.
    #[error("{file}: no unit found and {axis} span {span}. Say {} um | nm | mm", axis.option())]
    NoUnit {
        /// Name of the file.
        file: String,
        /// Which column.
        axis: Axis,
        /// Largest minus smallest value, in the unit of the file.
        span: f64,
    },
    /// x turns back.
    #[error(
        "{file}:{line}: x goes from {previous} to {next}, against the direction of the trace. Remove the doubled part, or say --columns if x is another column"
    )]
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
    #[error(
        "{file}: {points} points; a roughness profile needs at least {needed}. Export the whole trace"
    )]
    TooFewPoints {
        /// Name of the file.
        file: String,
        /// Points found.
        points: usize,
        /// Least number.
        needed: usize,
    },
    /// Points without a height.
    #[error("{file}:{line}: {missing} of {points} points have no height, the first reads \"{text}\". {}", if *fillable { "Say --gaps interpolate to fill them" } else { "These are too many to interpolate; measure again" })]
    MissingPoints {
        /// Name of the file.
        file: String,
        /// Line of the first.
        line: usize,
        /// How the first reads.
        text: String,
        /// Number of missing points.
        missing: usize,
        /// Number of rows.
        points: usize,
        /// Whether `--gaps interpolate` would take them.
        fillable: bool,
    },
    /// A known format that this version does not read.
    #[error("{file}: {format} is not read by this version. {}", format.remedy())]
    FormatNotRead {
        /// Name of the file.
        file: String,
        /// The format.
        format: Format,
    },
    /// Points that do not lie on an even grid.
    #[error(
        "{file}:{line}: uneven spacing, x = {x} is {off:.3} spacings away from an even grid of {spacing} (unit of the file). Pass --uneven resample to resample it by straight lines"
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
        /// Mean spacing, in the unit of the file.
        spacing: f64,
    },
    /// Heights only.
    #[error(
        "{file}: the heights come without an x column that gives a spacing{hint}. Say --dx, as --dx 0.5um"
    )]
    NoSpacing {
        /// Name of the file.
        file: String,
        /// What the file says about it.
        hint: SpacingHint,
    },
    /// A row with too few or too many columns.
    #[error(
        "{file}:{line}: {found} columns where other rows have {expected}: \"{text}\". Correct or remove this line"
    )]
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
        "{file}: {columns} columns and no header that names x and height (or columns that do not exist). Say --columns 1,2"
    )]
    ColumnsUnclear {
        /// Name of the file.
        file: String,
        /// Columns found.
        columns: usize,
    },
    /// Commas that may separate or be decimal signs.
    #[error(
        "{file}:{line}: \"{text}\": commas may separate columns or be decimal signs. Say --separator and --decimal, or export with ';'"
    )]
    AmbiguousComma {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// The line.
        text: String,
    },
    /// A unit that is not a known length.
    #[error("{file}: the header gives the {axis} in \"{unit}\", which is not one of m, mm, um, nm, inch, mil, uin. Convert the file, or say {} if the header is wrong", axis.option())]
    UnknownUnit {
        /// Name of the file.
        file: String,
        /// Which column.
        axis: Axis,
        /// The unit seen.
        unit: String,
    },
    /// The stated separator, decimal sign or encoding does not fit.
    #[error(
        "{file}: the file does not read with separator {separator}. Leave --separator away, or say what separates the columns"
    )]
    SeparatorDoesNotFit {
        /// Name of the file.
        file: String,
        /// As stated.
        separator: Separator,
    },
    /// A file that breaks the rules of its own format.
    #[error("{file}: not a sound {format} file: {what}{}. Export it again, or as text", if seen.is_empty() { String::new() } else { format!(" (\"{seen}\")") })]
    Damaged {
        /// Name of the file.
        file: String,
        /// Its format.
        format: Format,
        /// What is wrong.
        what: &'static str,
        /// What was seen, empty when there is nothing to show.
        seen: String,
    },
    /// More bytes than a profile has.
    #[error(
        "{file}: {what} has {bytes} bytes, more than the {most} allowed. Export a single profile"
    )]
    TooLarge {
        /// Name of the file.
        file: String,
        /// What is too large.
        what: &'static str,
        /// Its size.
        bytes: u64,
        /// The largest size read.
        most: u64,
    },
    /// Several profiles in one file.
    #[error("{file}: the file holds {rows} profiles of {points} points{}. Say --row 1 .. {rows}", if *asked == 0 { String::new() } else { format!(", row {asked} is not among them") })]
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
    /// An x column of an involute checker, without the base radius that converts it.
    #[error(
        "{file}: x is a {abscissa} of an involute checker and not the distance along the flank. Pass the base radius of the gear, as --base-radius 50mm"
    )]
    RollLength {
        /// Name of the file.
        file: String,
        /// What x is.
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
    #[error(
        "{file}: {what} is {value} {unit}, which no profile has. Check the unit and the columns"
    )]
    Impossible {
        /// Name of the file.
        file: String,
        /// What it is.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Unit it was read in.
        unit: LengthUnit,
    },
}

impl ReadError {
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
            Self::ImplausibleHeights { .. } => "E131",
        }
    }
}

/// How an unreadable file starts.
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

/// What a file without an x column says about its spacing.
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
        /// As the header says.
        length: Length,
        /// Points.
        points: usize,
    },
}

impl std::fmt::Display for SpacingHint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match *self {
            Self::None => Ok(()),
            Self::XCounts => write!(f, " (x counts the points; if it is a length say --x-unit)"),
            Self::FirstLine(value) => write!(
                f,
                "; line 1 reads {value} and is written unlike the rest, as the spacing in an NPL text profile (um) or a length is"
            ),
            Self::NominalLength { length, points } => write!(
                f,
                "; this is a Surfcom text profile, whose header gives the nominal length {length} and {points} points. If the trace was not aborted the spacing is {:.4} um (the .tx3 file tells)",
                length.si() * 1e6 / points as f64
            ),
        }
    }
}
