//! Warnings about a file that was read.

use std::borrow::Cow;

use asperity_core::Code;
use asperity_core::message::columns_not_read;
use asperity_core::number;
use asperity_core::quantity::Length;
use asperity_core::remedy::{Remedy, Setting, Value};
use serde::{Deserialize, Serialize};

use crate::read::options::{Abscissa, Axis, LengthUnit};
use crate::read::steepness::Steepness;

/// A warning about a file, with a stable code.
///
/// ```
/// use asperity_profile_io::{Warning, read::{Axis, LengthUnit}};
/// let note = Warning::UnitAssumed { axis: Axis::Height, unit: LengthUnit::Micrometre };
/// assert_eq!(note.code(), "W111");
/// assert_eq!(note.to_string(), "no unit found for the heights; taken as um because no other unit gives a possible trace");
/// assert_eq!(note.remedy().to_string(), "Set z_unit to um to confirm");
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, thiserror::Error)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Warning {
    /// A unit was determined by elimination.
    #[error(
        "no unit found for the {axis}; taken as {unit} because no other unit gives a possible trace"
    )]
    UnitAssumed {
        /// Column.
        axis: Axis,
        /// The assumed unit.
        unit: LengthUnit,
    },
    /// Missing points were interpolated on request.
    #[error(
        "{filled} missing points interpolated (longest run {longest}), {cut} cut off at the ends"
    )]
    GapsFilled {
        /// Number of interpolated points.
        filled: usize,
        /// Longest run of missing points.
        longest: usize,
        /// Number of missing points dropped at the ends.
        cut: usize,
    },
    /// The trace was stored backwards.
    #[error("x decreases along the file; the trace was reversed")]
    Reversed,
    /// The stated spacing overrides the spacing of the file.
    #[error("spacing {stated:.6} was stated, the file says {column:.4}; the stated one is used")]
    SpacingOverridden {
        /// Stated spacing.
        stated: Length,
        /// Spacing of the file.
        column: Length,
    },
    /// The file holds the output of a roughness filter.
    #[error(
        "the heights are stated to be an already filtered roughness profile; filtering them again changes them"
    )]
    AlreadyFiltered,
    /// A checksum in the file differs from the checksum of its content.
    #[error(
        "the {what} checksum {stated} is not that of the content, {found}: the file was changed, or its writer counts differently"
    )]
    ChecksumDiffers {
        /// Name of the checksum.
        what: Cow<'static, str>,
        /// Checksum stated in the file.
        stated: String,
        /// Checksum of the content.
        found: String,
    },
    /// The trace is shorter than stated in the header.
    #[error(
        "the header says {nominal:.4} but {traced:.4} were traced: the trace was aborted; the spacing follows from what was traced"
    )]
    TraceAborted {
        /// As stated in the header.
        nominal: Length,
        /// Evaluation length.
        traced: Length,
    },
    /// Fewer heights than the header states.
    #[error(
        "the header states {stated} points and {heights} were read: the trace was aborted, or the file cut off"
    )]
    FewerHeights {
        /// As stated in the header.
        stated: usize,
        /// Number of heights.
        heights: usize,
    },
    /// The header names columns that are neither the position nor the height.
    #[error("{}", columns_not_read("the trace", columns))]
    ColumnsNotRead {
        /// The columns as the header names them.
        columns: Vec<String>,
    },
    /// The first line is assumed to be the spacing.
    #[error("line 1 reads {value} and is taken as the spacing in um, as in NPL text profiles", value = number(*value))]
    SpacingFromFirstLine {
        /// The number.
        value: f64,
    },
    /// The spacing follows from a length printed with few digits.
    #[error("the spacing follows from an evaluation length printed as {length:.6}: it is known to {:.4} % only", 100.0 * uncertainty)]
    LengthRounded {
        /// The length.
        length: Length,
        /// Relative uncertainty of the spacing.
        uncertainty: f64,
    },
    /// Implausible heights, which [`Reading::check_heights`](crate::read::Reading::check_heights) refuses.
    #[error("{steepness}")]
    ImplausibleHeights {
        /// Slopes with their likely cause.
        steepness: Steepness,
    },
    /// No roughness was measured.
    #[error("all heights are equal: the trace is a perfectly smooth flank")]
    EqualHeights,
    /// Slightly uneven points are treated as even.
    #[error(
        "x is up to {:.1} % of a spacing off an even grid, so slopes are off by up to {:.1} %", 100.0 * off, 100.0 * slopes
    )]
    UnevenSpacing {
        /// Largest distance from the even grid divided by the spacing.
        off: f64,
        /// Largest relative difference of a single step from the spacing.
        slopes: f64,
    },
    /// An uneven trace was resampled on request.
    #[error(
        "x was up to {:.1} % of a spacing off an even grid; resampled linearly to {spacing:.4}, which moves the heights at the points of the file by {rms:.3} (root mean square), at most {most:.3}", 100.0 * off
    )]
    Resampled {
        /// Largest distance from the even grid divided by the spacing.
        off: f64,
        /// Spacing after resampling.
        spacing: Length,
        /// Root mean square distance of the original points from the lines between the new ones.
        rms: Length,
        /// Largest distance of the original points from these lines.
        most: Length,
    },
    /// An uneven trace was written with the positions of its points.
    #[error("x is up to {:.1} % of a spacing off an even grid; every point keeps its x", 100.0 * off)]
    PositionsKept {
        /// Largest distance from the even grid over the spacing.
        off: f64,
    },
    /// The trace is the mean of the lines of a surface.
    #[error(
        "the trace is the mean of {lines} lines of a surface: roughness that does not run across all of them is averaged out"
    )]
    MeanLine {
        /// Number of averaged lines.
        lines: usize,
    },
    /// According to the file a replica was measured.
    #[error("the file says that a replica was measured: its peaks are the valleys of the flank")]
    Replica,
    /// Values that the file names depths or distances from a sensor were turned into heights.
    #[error(
        "the file names its values depths or distances from a sensor; they were turned, so that heights point out of the material"
    )]
    DepthsTurned,
    /// A value of the header differs from the value that is used.
    #[error("the header states a {what} of {stated:.6}, but {used:.6} is used, {reason}")]
    HeaderDisagrees {
        /// Name of the value.
        what: Cow<'static, str>,
        /// As stated in the header.
        stated: Length,
        /// As used.
        used: Length,
        /// Origin of the value that is used.
        reason: Cow<'static, str>,
    },
    /// Rows without position and height were left out.
    #[error("{rows} rows hold neither a position nor a height and were left out")]
    EmptyRows {
        /// Number of rows.
        rows: usize,
    },
    /// The stated unit overrides the unit of the file.
    #[error("{stated} was stated for the {axis}, the file says {found}; the stated unit is used")]
    UnitOverridden {
        /// Column.
        axis: Axis,
        /// As stated.
        stated: LengthUnit,
        /// Unit of the file.
        found: LengthUnit,
    },
    /// A unit was stated for lengths that the file scales itself.
    #[error(
        "{stated} was stated for the {axis}, but the file has its own scale and unit; the stated one is not used"
    )]
    UnitNotUsed {
        /// Column.
        axis: Axis,
        /// As stated.
        stated: LengthUnit,
    },
    /// x was a roll length or angle and was converted to the distance along the involute.
    #[error(
        "x is a {abscissa}; converted with the base radius {base_radius:.6} to the distance along the involute and resampled to {spacing:.4}"
    )]
    RollLengthConverted {
        /// Meaning of x.
        abscissa: Abscissa,
        /// Base radius.
        base_radius: Length,
        /// Spacing along the involute after the conversion.
        spacing: Length,
    },
}

impl Warning {
    /// Remedy; empty if none is required.
    pub fn remedy(&self) -> Remedy {
        let dx = |why| Remedy::state(Setting::Spacing).because(why);
        let invert = |to: &'static str, why| {
            Remedy::set(Setting::Invert, Value::This(to.into())).because(why)
        };
        match self {
            Self::UnitAssumed { axis, unit } => {
                Remedy::set(axis.setting(), Value::This(unit.to_string().into()))
                    .because("to confirm")
            }
            Self::AlreadyFiltered => Remedy::set(Setting::Cutoff, Value::This("0 mm".into())),
            Self::SpacingFromFirstLine { .. } => dx("to be sure"),
            Self::LengthRounded { .. } => dx("to be exact"),
            Self::UnevenSpacing { .. } => {
                Remedy::set(Setting::Uneven, Value::This("resample".into()))
            }
            Self::ImplausibleHeights { steepness } => steepness.suspicion.remedy(),
            Self::HeaderDisagrees { what, .. } if what == "spacing" => dx("to choose"),
            Self::UnitNotUsed { axis, .. } => Remedy::omit(axis.setting()),
            Self::Replica => invert("true", "to turn the heights"),
            Self::DepthsTurned => invert("false", "if they point out of the material"),
            _ => Remedy::none(),
        }
    }

    /// Code of the explanation of the message.
    pub fn code(&self) -> Code {
        match self {
            Self::UnitAssumed { .. } => Code::W111,
            Self::GapsFilled { .. } => Code::W115,
            Self::Reversed => Code::W116,
            Self::SpacingOverridden { .. } => Code::W117,
            Self::AlreadyFiltered => Code::W118,
            Self::ChecksumDiffers { .. } => Code::W120,
            Self::TraceAborted { .. } => Code::W121,
            Self::FewerHeights { .. } => Code::W131,
            Self::SpacingFromFirstLine { .. } => Code::W122,
            Self::LengthRounded { .. } => Code::W123,
            Self::ImplausibleHeights { .. } => Code::W124,
            Self::UnevenSpacing { .. } => Code::W125,
            Self::Resampled { .. } => Code::W126,
            Self::RollLengthConverted { .. } => Code::W127,
            Self::MeanLine { .. } => Code::W320,
            Self::Replica => Code::W321,
            Self::UnitOverridden { .. } => Code::W322,
            Self::UnitNotUsed { .. } => Code::W323,
            Self::PositionsKept { .. } => Code::W324,
            Self::HeaderDisagrees { .. } => Code::W325,
            Self::EmptyRows { .. } => Code::W326,
            Self::EqualHeights => Code::W327,
            Self::DepthsTurned => Code::W328,
            Self::ColumnsNotRead { .. } => Code::W454,
        }
    }
}
