//! Errors of a call-out.

use asperity::result::loss_band::rounded;
use asperity_core::Code;
use asperity_core::DomainError;
use asperity_roughness::RoughnessError;

/// Uncertainty of a printed loss over it: the lots of the curve.
const CURVE_ERROR: f64 = 0.01;

/// A loss with the digits that the number of simulated pairs leaves.
pub(super) fn watts(loss_w: f64) -> String {
    format!("{} W", rounded(loss_w, CURVE_ERROR * loss_w))
}

/// Error of a call-out.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CallOutError {
    /// The case has no loss.
    #[error(transparent)]
    Case(#[from] asperity::Error),
    /// A setting is outside its domain.
    #[error(transparent)]
    Setting(#[from] DomainError),
    /// No recipe can be fitted to the traces, or a flank of it has no parameter.
    #[error("the recipe of the flanks: {0}")]
    Recipe(#[from] RoughnessError),
    /// Smooth flanks lose more than the stated loss.
    #[error(
        "no finish reaches {}: smooth flanks (Ra 0.01 um) lose {}. State a higher loss, or change oil, speed or gears",
        watts(*.loss_w), watts(*.smooth_w)
    )]
    BelowSmooth {
        /// Stated loss \[W\].
        loss_w: f64,
        /// Loss of smooth flanks \[W\].
        smooth_w: f64,
    },
    /// The roughest flanks lose less than the stated loss.
    #[error(
        "no limit is needed for {}: flanks of this recipe with Ra {:.1} um, the roughest considered, lose {}, and smooth ones {}. \
         State a loss between these",
        watts(*.loss_w), .ra_um, watts(*.rough_w), watts(*.smooth_w)
    )]
    AboveRough {
        /// Stated loss \[W\].
        loss_w: f64,
        /// Loss of the roughest flanks \[W\].
        rough_w: f64,
        /// Their Ra \[µm\].
        ra_um: f64,
        /// Loss of smooth flanks \[W\].
        smooth_w: f64,
    },
}

impl CallOutError {
    /// Stable code of the message.
    #[must_use]
    pub fn code(&self) -> Code {
        match self {
            Self::Case(error) => error.code(),
            Self::Setting(_) => Code::E209,
            Self::Recipe(_) => Code::E120,
            Self::BelowSmooth { .. } | Self::AboveRough { .. } => Code::E323,
        }
    }
}
