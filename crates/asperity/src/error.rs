//! Why a run has no result.

use asperity_contact::ContactError;
use asperity_core::DomainError;

/// Why a mesh position has no solution.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum PositionError {
    /// The gear geometry refuses the position.
    #[error(transparent)]
    Gear(#[from] asperity_gear::GearError),
    /// The rough contact has no solution, or did not converge.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// Film or regime refuse the numbers.
    #[error(transparent)]
    Regime(#[from] asperity_ehl_regime::RegimeError),
    /// Friction refuses the numbers.
    #[error(transparent)]
    Friction(#[from] asperity_tribo_friction::FrictionError),
    /// The film's pressure refuses the numbers.
    #[error(transparent)]
    Film(#[from] asperity_ns_film::FilmError),
    /// Roughness parameters of the window cannot be had.
    #[error(transparent)]
    Roughness(#[from] asperity_roughness::RoughnessError),
    /// The oil has no state at the temperature asked for.
    #[error(transparent)]
    Lubricant(#[from] asperity_core::lubricant::LubricantError),
    /// The flash temperature fed back into the oil does not settle.
    #[error(
        "the flash temperature did not settle in {passes} passes (last {flash_kelvin:.1} K); leave model.flash_feedback out"
    )]
    FlashNotSettled {
        /// Last flash temperature \[K\].
        flash_kelvin: f64,
        /// Passes made.
        passes: usize,
    },
    /// Losses cannot be summed.
    #[error(transparent)]
    Efficiency(#[from] asperity_efficiency::EfficiencyError),
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The points are too far apart for the contact.
    #[error(
        "dx {spacing_um:.3} um gives {points:.1} points per Hertz half-width (at least {least} needed)"
    )]
    TooCoarse {
        /// Spacing \[µm\].
        spacing_um: f64,
        /// Points per half width.
        points: f64,
        /// Least points needed.
        least: f64,
    },
    /// The prepared trace does not cover the window.
    #[error(
        "the prepared trace of {available_um:.0} um is shorter than the contact window of {needed_um:.0} um; \
         measure longer, choose a shorter cut-off, or reduce model.window"
    )]
    TraceTooShort {
        /// Prepared length \[µm\].
        available_um: f64,
        /// Window \[µm\].
        needed_um: f64,
    },
    /// The rough contact presses measured profiles together and a flank has none.
    #[error(
        "the rough contact presses two measured profiles together; give surface.pinion.file (and surface.wheel.file)"
    )]
    NoProfile,
    /// Marching did not meet the load.
    #[error(
        "lowering the surfaces step by step left a load error of {} % after {steps} steps (allowed {} %)",
        digits(*load_error_percent), digits(*allowed_percent)
    )]
    Marching {
        /// Load error \[%\].
        load_error_percent: f64,
        /// Allowed load error \[%\].
        allowed_percent: f64,
        /// Steps made.
        steps: usize,
    },
    /// A rough contact without solution, with the gap that it had to close.
    #[error(transparent)]
    Unsolved(Box<UnsolvedContact>),
}

/// The rough contact that was not solved, to be looked at.
#[derive(Debug, Clone, thiserror::Error)]
#[error("{source}")]
pub struct UnsolvedContact {
    /// Position across the contact, 0 at its middle \[m\].
    pub x: Vec<f64>,
    /// Undeformed gap of the flanks \[m\].
    pub gap: Vec<f64>,
    /// Why it has no solution.
    pub source: PositionError,
}

impl PositionError {
    /// The same error with the gap \[m\] at the points `x` \[m\], where it is about one that was not closed.
    pub(crate) fn keeping(self, x: &[f64], gap: &[f64]) -> Self {
        match self {
            Self::Contact(ContactError::NotConverged { .. }) => {
                Self::Unsolved(Box::new(UnsolvedContact {
                    x: x.to_vec(),
                    gap: gap.to_vec(),
                    source: self,
                }))
            }
            other => other,
        }
    }

    /// The reason, without what was kept to look at.
    fn reason(&self) -> &Self {
        match self {
            Self::Unsolved(kept) => kept.source.reason(),
            other => other,
        }
    }
}

/// Why a run has no result.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RunError {
    /// A mesh position failed; nothing is reported.
    #[error("position {number} of {count}: {source}{}", advice(source))]
    Position {
        /// Number of the position from A, counted from 1.
        number: usize,
        /// How many positions there are.
        count: usize,
        /// Why.
        source: Box<PositionError>,
    },
    /// The sums over the path failed.
    #[error(transparent)]
    Whole(#[from] Box<PositionError>),
}

/// Digits that mean something, however small the value.
fn digits(value: f64) -> String {
    if value >= 0.01 {
        format!("{value:.2}")
    } else {
        format!("{value:.1e}")
    }
}

fn advice(source: &PositionError) -> &'static str {
    match source.reason() {
        PositionError::Contact(ContactError::NotConverged { .. })
        | PositionError::FlashNotSettled { .. }
        | PositionError::Marching { .. } => ". No efficiency is reported",
        _ => "",
    }
}

impl RunError {
    fn source(&self) -> &PositionError {
        match self {
            Self::Position { source, .. } | Self::Whole(source) => source,
        }
    }

    /// The rough contact that was not solved, where that is the reason.
    pub fn unsolved(&self) -> Option<&UnsolvedContact> {
        match self.source() {
            PositionError::Unsolved(kept) => Some(kept),
            _ => None,
        }
    }

    /// Stable code of the message.
    pub fn code(&self) -> &'static str {
        match self.source().reason() {
            PositionError::TooCoarse { .. } => "E121",
            PositionError::TraceTooShort { .. } => "E122",
            PositionError::NoProfile => "E303",
            PositionError::Marching { .. } => "E304",
            PositionError::FlashNotSettled { .. } => "E301",
            PositionError::Contact(ContactError::NotConverged { .. }) => "E301",
            PositionError::Contact(ContactError::LimitBelowMeanPressure { .. }) => "E302",
            _ => "E305",
        }
    }
}
