//! Statements of the user about a file, which override its content.

use std::fmt;
use std::str::FromStr;

use asperity_core::quantity::Length;
use asperity_core::remedy::Setting;
use serde::{Deserialize, Serialize};

/// Minimum number of points of a profile for meaningful roughness parameters.
pub(super) const FEWEST_POINTS: usize = 100;

/// Explicit statements about a file. The default states nothing and refuses gaps.
///
/// ```
/// use asperity_profile_io::read::{LengthUnit, ReadOptions};
/// let options = ReadOptions { z_unit: Some(LengthUnit::Nanometre), ..ReadOptions::default() };
/// assert_eq!(options.z_unit.map(|unit| unit.to_string()).as_deref(), Some("nm"));
/// ```
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields, default)]
pub struct ReadOptions {
    /// Unit of the x column.
    pub x_unit: Option<LengthUnit>,
    /// Unit of the heights.
    pub z_unit: Option<LengthUnit>,
    /// Spacing of the points; an x column is then not needed.
    pub dx: Option<Length>,
    /// Spacing of the rows of a surface.
    pub dy: Option<Length>,
    /// Columns of x and of the heights.
    pub columns: Option<Columns>,
    /// The decimal sign.
    pub decimal: Option<DecimalSign>,
    /// Separator of the columns.
    pub separator: Option<Separator>,
    /// The character encoding.
    pub encoding: Option<Encoding>,
    /// Treatment of missing points.
    pub gaps: Gaps,
    /// Number of the profile in a file that holds several, counted from 1.
    pub row: Option<usize>,
    /// Trace of a surface that is read.
    pub line: TraceLine,
    /// Meaning of the x column.
    pub abscissa: Option<Abscissa>,
    /// Base radius of the gear: an x that is a roll length or angle is converted with it.
    pub base_radius: Option<Length>,
    /// Treatment of an uneven x.
    pub uneven: Uneven,
    /// Part of the trace that is used.
    pub range: Option<TraceRange>,
    /// Whether the values grow into the material, so that the heights are their negatives; by default they do if the file
    /// names them depths.
    pub invert: Option<bool>,
}

impl ReadOptions {
    /// The stated unit of an axis.
    pub(super) fn unit(&self, axis: Axis) -> Option<LengthUnit> {
        match axis {
            Axis::Trace => self.x_unit,
            Axis::Height => self.z_unit,
        }
    }

    /// The stated spacing of the trace that is read: `dy` along y, if it is stated.
    pub(super) fn spacing(&self) -> Option<Length> {
        if self.line.is_along_y() {
            self.dy.or(self.dx)
        } else {
            self.dx
        }
    }
}

/// Text that is not one of the choices.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("\"{text}\" is not one of: {accepted}")]
pub struct UnknownChoice {
    /// The text seen.
    pub text: String,
    /// The choices.
    pub accepted: &'static str,
}

/// Implements the text form of a choice, for command line and case file.
macro_rules! choice {
    ($type:ident, $accepted:literal: $($variant:ident $text:literal),+ $(,)?) => {
        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(match self { $(Self::$variant => $text),+ })
            }
        }

        impl FromStr for $type {
            type Err = UnknownChoice;

            fn from_str(text: &str) -> Result<Self, UnknownChoice> {
                match text.trim().to_lowercase().replace(['µ', 'μ'], "u").as_str() {
                    $($text => Ok(Self::$variant),)+
                    _ => Err(UnknownChoice { text: text.to_owned(), accepted: $accepted }),
                }
            }
        }
    };
}

/// A unit of length that profilometer files use.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum LengthUnit {
    /// 1 m.
    #[serde(rename = "m")]
    Metre,
    /// 10⁻³ m.
    #[serde(rename = "mm")]
    Millimetre,
    /// 10⁻⁶ m.
    #[serde(rename = "um")]
    Micrometre,
    /// 10⁻⁹ m.
    #[serde(rename = "nm")]
    Nanometre,
    /// 10⁻¹⁰ m.
    #[serde(rename = "angstrom")]
    Angstrom,
    /// 0.0254 m.
    #[serde(rename = "inch")]
    Inch,
    /// A thousandth of an inch, 25.4 um.
    #[serde(rename = "mil")]
    Mil,
    /// A millionth of an inch, 25.4 nm.
    #[serde(rename = "uin")]
    Microinch,
}

choice!(LengthUnit, "m, mm, um, nm, angstrom, inch, mil, uin": Metre "m", Millimetre "mm", Micrometre "um", Nanometre "nm", Angstrom "angstrom", Inch "inch", Mil "mil", Microinch "uin");

impl LengthUnit {
    /// `value` of this unit in metres.
    ///
    /// ```
    /// use asperity_profile_io::read::LengthUnit;
    /// assert_eq!(LengthUnit::Millimetre.metres(0.3), 0.3e-3);
    /// assert_eq!(LengthUnit::Microinch.metres(10.0), 254e-9);
    /// ```
    pub fn metres(self, value: f64) -> f64 {
        match self {
            Self::Metre => value,
            Self::Millimetre => value / 1e3,
            Self::Micrometre => value / 1e6,
            Self::Nanometre => value / 1e9,
            Self::Angstrom => value / 1e10,
            // 1 in = 25.4 mm (1959).
            Self::Inch => value * 25.4 / 1e3,
            Self::Mil => value * 25.4 / 1e6,
            Self::Microinch => value * 25.4 / 1e9,
        }
    }
}

/// Quantity that the x column of a file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Abscissa {
    /// Distance along the trace.
    Distance,
    /// Roll length of an involute (radius of curvature, length of action), as exported by involute checkers.
    RollLength,
    /// Roll angle of an involute in degrees.
    RollDegrees,
    /// Roll angle of an involute in radians.
    RollRadians,
}

choice!(Abscissa, "distance, roll-length, roll-degrees, roll-radians": Distance "distance", RollLength "roll-length", RollDegrees "roll-degrees", RollRadians "roll-radians");

/// Treatment of an x column that is not even.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Uneven {
    /// Accept points up to a quarter of a spacing off an even grid, with a warning from 2 %; refuse others.
    #[default]
    Refuse,
    /// Resample linearly to an even grid with the same number of points, and report it.
    Resample,
}

choice!(Uneven, "refuse, resample": Refuse "refuse", Resample "resample");

/// One of the two coordinates of a profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Axis {
    /// x, along the trace.
    Trace,
    /// z, out of the material.
    Height,
}

impl Axis {
    /// The setting that states the unit.
    pub fn setting(self) -> Setting {
        match self {
            Self::Trace => Setting::XUnit,
            Self::Height => Setting::ZUnit,
        }
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Trace => "x values",
            Self::Height => "heights",
        })
    }
}

/// The columns of a table, counted from 1. Reads "1,2" (x, heights) and "2" (heights only).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Columns {
    /// Column of x, if there is one.
    pub x: Option<usize>,
    /// Column of the heights.
    pub z: usize,
}

impl FromStr for Columns {
    type Err = UnknownChoice;

    fn from_str(text: &str) -> Result<Self, UnknownChoice> {
        let number = |part: &str| part.trim().parse().ok().filter(|&n: &usize| n > 0);
        let parsed = match text.split_once(',') {
            None => number(text).map(|z| Self { x: None, z }),
            Some((x, z)) => number(x)
                .zip(number(z))
                .map(|(x, z)| Self { x: Some(x), z }),
        };
        parsed.ok_or_else(|| UnknownChoice {
            text: text.to_owned(),
            accepted: "the numbers of the x and height columns as \"1,2\", or of the height column as \"2\"",
        })
    }
}

/// Decimal sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum DecimalSign {
    /// 0.5
    Point,
    /// 0,5
    Comma,
}

choice!(DecimalSign, "point, comma": Point "point", Comma "comma");

/// Separator between two columns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Separator {
    /// A semicolon.
    Semicolon,
    /// A tab.
    Tab,
    /// A comma.
    Comma,
    /// Any run of blanks or tabs.
    Blank,
    /// Nothing: one column.
    None,
}

choice!(Separator, "semicolon, tab, comma, blank, none": Semicolon "semicolon", Tab "tab", Comma "comma", Blank "blank", None "none");

/// Character encoding of a text file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Encoding {
    /// UTF-8, ASCII included.
    #[serde(rename = "utf-8")]
    Utf8,
    /// UTF-16, low byte first.
    #[serde(rename = "utf-16le")]
    Utf16Le,
    /// UTF-16, high byte first.
    #[serde(rename = "utf-16be")]
    Utf16Be,
    /// Windows code page 1252, which includes Latin-1.
    #[serde(rename = "windows-1252")]
    Windows1252,
}

choice!(Encoding, "utf-8, utf-16le, utf-16be, windows-1252": Utf8 "utf-8", Utf16Le "utf-16le", Utf16Be "utf-16be", Windows1252 "windows-1252");

/// Treatment of missing points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Gaps {
    /// Refuse the file.
    #[default]
    Refuse,
    /// Fill inner gaps linearly, cut off outer ones, and report it.
    Interpolate,
}

choice!(Gaps, "refuse, interpolate": Refuse "refuse", Interpolate "interpolate");

/// Trace that is taken from a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum TraceLine {
    /// One row of points, along x.
    #[default]
    Row,
    /// One column of points, along y.
    Column,
    /// The mean of all rows.
    Mean,
    /// The mean of all columns.
    MeanColumn,
}

choice!(TraceLine, "row, column, mean, mean-column": Row "row", Column "column", Mean "mean", MeanColumn "mean-column");

impl TraceLine {
    /// Whether all rows or all columns are averaged.
    pub fn is_mean(self) -> bool {
        matches!(self, Self::Mean | Self::MeanColumn)
    }

    /// Whether the trace runs along y.
    pub(super) fn is_along_y(self) -> bool {
        matches!(self, Self::Column | Self::MeanColumn)
    }
}

/// Part of a trace between two distances from its first point: "1.2 mm .. 6.4 mm".
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(with = "String"))]
#[serde(try_from = "String", into = "String")]
pub struct TraceRange {
    /// Distance of the begin.
    pub(super) from: Length,
    /// Distance of the end.
    pub(super) to: Length,
}

impl TraceRange {
    /// Distances of begin and end from the first point.
    #[must_use]
    pub const fn ends(&self) -> [Length; 2] {
        [self.from, self.to]
    }
}

impl FromStr for TraceRange {
    type Err = UnknownChoice;

    fn from_str(text: &str) -> Result<Self, UnknownChoice> {
        let parsed = text.split_once("..").and_then(|(from, to)| {
            let [from, to]: [Length; 2] = [from.trim().parse().ok()?, to.trim().parse().ok()?];
            (from.si() >= 0.0 && to > from).then_some(Self { from, to })
        });
        parsed.ok_or_else(|| UnknownChoice {
            text: text.to_owned(),
            accepted: "two distances from the first point, the shorter first, as \"1.2 mm .. 6.4 mm\"",
        })
    }
}

impl TryFrom<String> for TraceRange {
    type Error = UnknownChoice;

    fn try_from(text: String) -> Result<Self, UnknownChoice> {
        text.parse()
    }
}

impl From<TraceRange> for String {
    fn from(range: TraceRange) -> Self {
        range.to_string()
    }
}

impl fmt::Display for TraceRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} .. {}", self.from, self.to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_read_what_they_print() {
        for separator in [
            Separator::Semicolon,
            Separator::Tab,
            Separator::Comma,
            Separator::Blank,
            Separator::None,
        ] {
            assert_eq!(separator.to_string().parse(), Ok(separator));
        }
        assert_eq!("µm".parse(), Ok(LengthUnit::Micrometre));
        assert_eq!("1, 3".parse(), Ok(Columns { x: Some(1), z: 3 }));
        assert!("0".parse::<Columns>().is_err());
    }
}
