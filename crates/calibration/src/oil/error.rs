//! Errors of traction curves, each with a code.

use asperity::mixed_film::LoadShareError;
use asperity::oil::LubricantError;

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
    /// A number outside its domain, or no solution.
    #[error(transparent)]
    Contact(#[from] LoadShareError),
}

impl OilError {
    /// Stable code of the error.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Oil { .. } | Self::OneViscosity { .. } => "E208",
            Self::NoShearLaw { .. } => "E205",
            Self::Contact(_) => "E209",
        }
    }
}
