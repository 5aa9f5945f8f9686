//! Ends of the window of a contact.

use serde::{Deserialize, Serialize};

/// Ends of the window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Boundary {
    /// No load outside of the window: a single line contact.
    #[default]
    FreeEnds,
    /// Window and pressure are periodic; the displacement has no mean.
    Periodic(PeriodicKernel),
}

impl std::fmt::Display for Boundary {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::FreeEnds => "free ends",
            Self::Periodic(PeriodicKernel::Strip) => "periodic ends (strip kernel)",
            Self::Periodic(PeriodicKernel::Spectral) => "periodic ends (spectral kernel)",
        })
    }
}

/// Pressure between the points of a periodic contact. The kernels differ by about the discretisation
/// error.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum PeriodicKernel {
    /// Constant pressure over each cell, summed over all periods.
    #[default]
    Strip,
    /// Band-limited pressure through the points, 2/(E*·|q|) per wave.
    Spectral,
}
