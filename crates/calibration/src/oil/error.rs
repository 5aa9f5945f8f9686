//! Errors of traction curves, each with a code.

use asperity::case::STEEPEST_FALL;
use asperity::mixed_film::LoadShareError;
use asperity::oil::LubricantError;
use asperity_core::{Code, Fault};
use asperity_core::{decimals, number};

use crate::error::CalibrationError;

/// Error of a traction curve.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OilError {
    /// The base oil is incomplete, or has no state at a temperature.
    #[error("{name}: {source}")]
    Oil {
        /// Name of the oil.
        name: String,
        /// Cause.
        source: LubricantError,
    },
    /// The viscosity is known at one temperature only.
    #[error(
        "{name}: the viscosity is known at one temperature only; traction over temperature needs it at two (law astm-d341 or vogel)"
    )]
    OneViscosity {
        /// Name of the oil.
        name: String,
    },
    /// The friction of the film has no shear stress law.
    #[error("{name}: the film friction of the case is not computed from a shear stress")]
    NoShearLaw {
        /// Name of the case.
        name: String,
    },
    /// A Stribeck curve without the time of rubbing.
    #[error(
        "{file}:{line}: the time of rubbing before the reading is not stated; boundary friction may double by rubbing. Give a column rubbing_s, 0 for new specimens, or a time of rubbing for each file"
    )]
    NoRubbing {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
    },
    /// A Stribeck curve of new specimens only.
    #[error("all readings are of new specimens; measure again after rubbing")]
    NotRubbed,
    /// Too few points in boundary lubrication.
    #[error(
        "{kept} of {points} set points after rubbing have a film of at most {ratio} times the roughness (thinnest: {thinnest} times) and a slide-to-roll ratio of at least 0.5 %; at least {least} at two speeds are needed", ratio = number(*ratio), thinnest = decimals(*thinnest, 2))]
    FewBoundary {
        /// Such points.
        kept: usize,
        /// Set points after rubbing.
        points: usize,
        /// Largest film over roughness.
        ratio: f64,
        /// Smallest film over roughness.
        thinnest: f64,
        /// Fewest points.
        least: usize,
    },
    /// Friction that still depends on the speed.
    #[error(
        "the friction of the {points} points in boundary lubrication changes by {percent:+.0} % per decade of speed; at most 10 % are accepted"
    )]
    Sloping {
        /// Points in boundary lubrication.
        points: usize,
        /// Change of the friction over a decade of speed \[%\].
        percent: f64,
    },
    /// A table of readings that is not valid.
    #[error(transparent)]
    Table(CalibrationError),
    /// A text without a traction curve.
    #[error(
        "{file}: no table has the columns Ball Load (N), Rolling Speed (mm/s), SRR (%), Traction Coeff (-) and a temperature"
    )]
    NoTable {
        /// Name of the file.
        file: String,
    },
    /// A row of a text that is not valid.
    #[error("{file}:{line}: {rule}")]
    Row {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// The value and the rule that it violates.
        rule: String,
    },
    /// A probe of the oil that reads air.
    #[error(
        "{file}:{line}: the probe of the oil reads {lube} °C where the pot has {pot} °C: it reads air. Take the temperature of the pot, if it is the one of the oil", lube = number(*lube), pot = number(*pot))]
    Air {
        /// Name of the file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Temperature of the probe \[°C\].
        lube: f64,
        /// Temperature of the pot \[°C\].
        pot: f64,
    },
    /// Too few points for a fit.
    #[error("{kept} of {points} set points can be used; at least 6 are needed{dropped}")]
    FewPoints {
        /// Points that can be used.
        kept: usize,
        /// Set points.
        points: usize,
        /// Points dropped by each rule, in parentheses; empty if there are none.
        dropped: String,
    },
    /// A pressure that does not stiffen the oil.
    #[error("the largest Hertz pressure is {gpa} GPa; at least 0.4 GPa are needed", gpa = decimals(*gpa, 2))]
    LowPressure {
        /// Largest pressure \[GPa\].
        gpa: f64,
    },
    /// Curves that no law of pressure explains.
    #[error(
        "no law explains the curves: squares of the residuals per point {per_point}, at most 3 are accepted; largest: {worst}", per_point = decimals(*per_point, 1))]
    Unexplained {
        /// Squares of the residuals per point of the better law.
        per_point: f64,
        /// Points with the largest residuals.
        worst: String,
    },
    /// A nuisance term of no calibrated machine.
    #[error(
        "for the fit to hold, {text}: {deviations:+.1} standard deviations, at most 3 are accepted; even so the largest residuals are {worst}"
    )]
    Nuisance {
        /// The term in words.
        text: String,
        /// Standard deviations of its prior.
        deviations: f64,
        /// Points with the largest residuals.
        worst: String,
    },
    /// A constant of no known oil.
    #[error("{name} = {value} {unit} is the one of no known oil: {low} to {high} {unit}", low = number(*low), high = number(*high), value = decimals(*value, 4))]
    NoOil {
        /// The constant.
        name: String,
        /// Its value.
        value: f64,
        /// Its unit.
        unit: String,
        /// Least value.
        low: f64,
        /// Largest value.
        high: f64,
    },
    /// A fall of the limiting shear stress that no case takes.
    #[error(
        "the 95 % band of the fall of the limiting shear stress, {:.4} to {:.4} 1/K, leaves {} to {STEEPEST_FALL} 1/K, where a film has a single temperature: no case takes it",
        band[0], band[1], -STEEPEST_FALL
    )]
    TooSteep {
        /// The band \[1/K\].
        band: [f64; 2],
    },
    /// The fit did not converge, or the model has no solution.
    #[error(transparent)]
    Fit(CalibrationError),
    /// A number outside its domain, or no solution.
    #[error(transparent)]
    Contact(#[from] LoadShareError),
}

impl OilError {
    /// Stable code of the error.
    #[must_use]
    pub fn code(&self) -> Code {
        match self {
            Self::Oil { .. } | Self::OneViscosity { .. } => Code::E208,
            Self::NoShearLaw { .. } => Code::E205,
            Self::Contact(_) => Code::E209,
            Self::Table(CalibrationError::Open(error)) => error.code(),
            Self::Table(_) | Self::NoTable { .. } | Self::Row { .. } | Self::Air { .. } => {
                Code::E317
            }
            Self::FewPoints { .. } | Self::LowPressure { .. } => Code::E318,
            Self::Unexplained { .. }
            | Self::Nuisance { .. }
            | Self::NoOil { .. }
            | Self::TooSteep { .. } => Code::E319,
            Self::NoRubbing { .. }
            | Self::NotRubbed
            | Self::FewBoundary { .. }
            | Self::Sloping { .. } => Code::E322,
            Self::Fit(error) => error.code(),
        }
    }
}

impl From<OilError> for Fault {
    fn from(error: OilError) -> Self {
        Self::of(error.code(), error)
    }
}
