//! The error of the orchestrator: why a case cannot be run, or a run has no result.

use asperity_core::Code;
use asperity_core::Fault;
use asperity_core::{DomainError, decimals, number};
use std::sync::Arc;

use asperity_contact::ContactError;
use asperity_core::cancel::Cancelled;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_efficiency::EfficiencyError;
use asperity_ehl::EhlError;

use crate::balance::Unbalanced;
use crate::case::{CaseError, Place, Source};
use asperity_mixed_film::LoadShareError;

/// Errors at a mesh position.
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
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The load share has no solution.
    #[error(transparent)]
    LoadShare(#[from] LoadShareError),
    /// The lubricated contact has no solution, or did not converge.
    #[error(transparent)]
    Ehl(#[from] asperity_ehl::EhlError),
    /// Traces that lie outside of the contact.
    #[error(
        "the traces cover {:.0} % of the loss along the path of contact where they are placed, at least 30 % are needed",
        100.0 * coverage
    )]
    NotCovered {
        /// Share of the loss at places that both traces cover.
        coverage: f64,
    },
    /// One contact asked of several traces.
    #[error("the case has {} pairs of teeth, and this looks at one pair of traces", teeth[0] * teeth[1])]
    SeveralTraces {
        /// Teeth of pinion and wheel.
        teeth: [usize; 2],
    },
    /// A loss whose gradient over the heights is not known.
    #[error(
        "the loss over the heights of the traces cannot be computed with {differs}; leave it out"
    )]
    NoGradient {
        /// Choice that differs from the default model.
        differs: &'static str,
    },
    /// Contact tables of other gears, flanks or loads.
    #[error("the contact tables were made for another {differs}")]
    OtherTables {
        /// Quantity that differs.
        differs: &'static str,
    },
    /// The film's pressure refuses the numbers.
    #[error(transparent)]
    Film(#[from] asperity_ns_film::FilmError),
    /// Roughness parameters of the window cannot be had.
    #[error(transparent)]
    Roughness(#[from] asperity_roughness::RoughnessError),
    /// The oil has no state at the requested temperature.
    #[error(transparent)]
    Lubricant(#[from] asperity_oil::LubricantError),
    /// The flash temperature fed back into the oil does not settle.
    #[error("the flash temperature did not settle in {passes} passes (last {flash_kelvin} K)", flash_kelvin = decimals(*flash_kelvin, 1))]
    FlashNotSettled {
        /// Last flash temperature \[K\].
        flash_kelvin: f64,
        /// Passes made.
        passes: usize,
    },
    /// Losses that lower the torques of the following meshes do not settle.
    #[error("the torques of the gear train do not settle (last change {change:.1e})")]
    TorquesNotSettled {
        /// Last change of a torque, relative to it.
        change: f64,
    },
    /// A part of the gearbox has no loss.
    #[error("gearbox: {part}: {source}")]
    GearboxPart {
        /// Its name.
        part: String,
        /// Cause.
        source: Box<PositionError>,
    },
    /// Losses cannot be summed.
    #[error(transparent)]
    Efficiency(#[from] EfficiencyError),
    /// A number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The points are too far apart for the contact.
    #[error(
        "dx {spacing_um} um gives {points} points per Hertz half-width (at least {least} needed)", least = number(*least), spacing_um = decimals(*spacing_um, 3), points = decimals(*points, 1))]
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
        "the prepared trace of {available_um} um is shorter than the {needed_um} um that the windows of the contact need", available_um = decimals(*available_um, 0), needed_um = decimals(*needed_um, 0))]
    TraceTooShort {
        /// Prepared length \[µm\].
        available_um: f64,
        /// Window, with several of them the way that they need to differ \[µm\].
        needed_um: f64,
    },
    /// The rough contact presses measured profiles together and a flank has none.
    #[error("the rough contact presses two measured profiles together, and a flank has none")]
    NoProfile,
    /// Marching did not reach the load.
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
    /// A state that is beyond physical sense.
    #[error(
        "{name} of {value:.3e} {unit} is beyond physical sense ({rule}{})",
        limit.map(|limit| format!(" {limit:e} {unit}")).unwrap_or_default()
    )]
    Impossible {
        /// Name of the quantity.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// Rule.
        rule: &'static str,
        /// The limit, where it is a number.
        limit: Option<f64>,
    },
    /// A rough contact without solution, with the gap that it had to close.
    #[error(transparent)]
    Unsolved(Box<UnsolvedContact>),
    /// Numbers of the result that cannot be, or cannot be together.
    #[error(transparent)]
    Unbalanced(#[from] Unbalanced),
}

/// The rough contact that was not solved.
#[derive(Debug, Clone, thiserror::Error)]
#[error("{source}")]
pub struct UnsolvedContact {
    /// Position across the contact, 0 at its middle \[m\].
    pub x: Vec<f64>,
    /// Undeformed gap of the flanks \[m\].
    pub gap: Vec<f64>,
    /// Reason why it has no solution.
    pub source: PositionError,
}

impl PositionError {
    /// The same error with the gap \[m\] at the points `x` \[m\], where it is about one that was not closed.
    pub fn keeping(self, x: &[f64], gap: &[f64]) -> Self {
        match self {
            Self::Contact(ContactError::NotConverged { .. })
            | Self::LoadShare(LoadShareError::Contact(ContactError::NotConverged { .. })) => {
                Self::Unsolved(Box::new(UnsolvedContact {
                    x: x.to_vec(),
                    gap: gap.to_vec(),
                    source: self,
                }))
            }
            other => other,
        }
    }

    /// Whether the work was cancelled ([`asperity_core::cancel`]), and nothing failed.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        matches!(
            self.reason(),
            Self::Cancelled(_)
                | Self::Contact(ContactError::Cancelled(_))
                | Self::LoadShare(LoadShareError::Contact(ContactError::Cancelled(_)))
                | Self::Ehl(EhlError::Cancelled(_) | EhlError::Hertz(ContactError::Cancelled(_)))
        )
    }

    /// The reason, without the stored contact.
    fn reason(&self) -> &Self {
        match self {
            Self::Unsolved(kept) => kept.source.reason(),
            Self::GearboxPart { source, .. } => source.reason(),
            other => other,
        }
    }
}

/// Errors of a case or a run.
///
/// [`code`](Self::code) is stable; [`place`](Self::place) and [`remedy`](Self::remedy) are data, so that a
/// command line, a page or another language can put them in words of its own.
///
/// ```
/// use asperity_case::case::from_text;
/// let error = from_text("case.toml", "gears = 3", &|_| Ok(Vec::new())).unwrap_err();
/// assert_eq!(error.code(), "E204");
/// assert_eq!(error.place().and_then(|place| place.line), Some(1));
/// assert!(error.to_string().starts_with("case.toml:1: gears: "));
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The case cannot be run.
    #[error(transparent)]
    Case(#[from] Box<CaseError>),
    /// The case cannot be run, and its text is at hand to show the place.
    #[error("{error}")]
    CaseText {
        /// Cause.
        error: Box<CaseError>,
        /// The text of the case.
        text: Arc<Source>,
    },
    /// A mesh position failed; nothing is reported.
    #[error("position {number} of {count}: {source}{}", advice(source))]
    Position {
        /// Number of the position from A, counted from 1.
        number: usize,
        /// Number of positions.
        count: usize,
        /// Cause.
        source: Box<PositionError>,
    },
    /// The sums over the path failed.
    #[error(transparent)]
    Whole(#[from] Box<PositionError>),
}

impl From<EfficiencyError> for Error {
    fn from(error: EfficiencyError) -> Self {
        Self::Whole(Box::new(error.into()))
    }
}

impl From<Cancelled> for Error {
    fn from(cancelled: Cancelled) -> Self {
        Self::Whole(Box::new(cancelled.into()))
    }
}

impl From<CaseError> for Error {
    fn from(error: CaseError) -> Self {
        Self::Case(Box::new(error))
    }
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
        | PositionError::Impossible { .. }
        | PositionError::Ehl(_)
        | PositionError::FlashNotSettled { .. }
        | PositionError::TorquesNotSettled { .. }
        | PositionError::Marching { .. } => ". No efficiency is reported",
        _ => "",
    }
}

impl Error {
    /// A case error with the text that it is about, which the errors of a case share.
    pub fn in_text(error: CaseError, text: impl Into<Arc<Source>>) -> Self {
        Self::CaseText {
            error: Box::new(error),
            text: text.into(),
        }
    }

    /// The error of the case, where the case is to blame.
    pub fn case(&self) -> Option<&CaseError> {
        match self {
            Self::Case(error) | Self::CaseText { error, .. } => Some(error),
            Self::Position { .. } | Self::Whole(_) => None,
        }
    }

    /// The error of a mesh position, where one is to blame.
    pub fn position(&self) -> Option<&PositionError> {
        match self {
            Self::Position { source, .. } | Self::Whole(source) => Some(source),
            Self::Case(_) | Self::CaseText { .. } => None,
        }
    }

    /// The rough contact that was not solved, where that is the reason.
    pub fn unsolved(&self) -> Option<&UnsolvedContact> {
        match self.position()? {
            PositionError::Unsolved(kept) => Some(kept),
            _ => None,
        }
    }

    /// Stable code of the message.
    pub fn code(&self) -> Code {
        match (self.case(), self.position()) {
            (Some(error), _) => error.code(),
            (None, Some(error)) => error.code(),
            (None, None) => Code::E501,
        }
    }

    /// Place in the case, if the error is about one.
    pub fn place(&self) -> Option<&Place> {
        self.case()?.place()
    }

    /// The text of the case, where it came from a text; [`place`](Self::place) gives the span in it.
    pub fn text(&self) -> Option<&Arc<Source>> {
        match self {
            Self::CaseText { text, .. } => Some(text),
            _ => None,
        }
    }

    /// Remedy of this error; empty where no more is known than its code says.
    pub fn remedy(&self) -> Remedy {
        match (self.case(), self.position()) {
            (Some(error), _) => error.remedy(),
            (None, Some(error)) => error.remedy(),
            (None, None) => Remedy::none(),
        }
    }

    /// The general advice of the code.
    pub fn advice(&self) -> &'static str {
        self.code().explain().remedy
    }
}

impl PositionError {
    /// Stable code of the message.
    pub fn code(&self) -> Code {
        match self.reason() {
            reason if reason.is_cancelled() => Code::E502,
            Self::TooCoarse { .. } => Code::E121,
            Self::TraceTooShort { .. } => Code::E122,
            Self::NotCovered { .. } => Code::E123,
            Self::SeveralTraces { .. } => Code::E312,
            Self::NoGradient { .. } => Code::E205,
            Self::NoProfile => Code::E303,
            Self::Impossible { .. } => Code::E308,
            Self::Unbalanced(error) => error.code(),
            Self::Marching { .. } => Code::E304,
            Self::FlashNotSettled { .. } | Self::TorquesNotSettled { .. } => Code::E301,
            Self::Contact(ContactError::NotConverged { .. })
            | Self::LoadShare(
                LoadShareError::Contact(ContactError::NotConverged { .. })
                | LoadShareError::NoRoot { .. },
            ) => Code::E301,
            Self::Contact(ContactError::LimitBelowMeanPressure { .. })
            | Self::LoadShare(LoadShareError::Contact(ContactError::LimitBelowMeanPressure {
                ..
            })) => Code::E302,
            Self::LoadShare(LoadShareError::FlowPressureTooLow { .. }) => Code::E306,
            Self::Ehl(error) if error.is_unconverged() => Code::E307,
            Self::Efficiency(EfficiencyError::BulkNotSettled { .. }) => Code::E311,
            Self::Efficiency(EfficiencyError::NotInTable { .. }) => Code::E313,
            _ => Code::E305,
        }
    }

    /// Remedy of this error; empty where no more is known than its code says.
    pub fn remedy(&self) -> Remedy {
        let key = Setting::Key;
        match self.reason() {
            Self::TraceTooShort { .. } => Remedy::act("measure a longer trace")
                .or_set(Setting::Cutoff, Value::Any)
                .because("to a shorter one")
                .or_set(key("model.window"), Value::Any)
                .because("to fewer half-widths"),
            Self::Ehl(error) if error.is_unconverged() => {
                Remedy::state(key("model.ehl.cells")).because("to more cells across the film")
            }
            Self::FlashNotSettled { .. } => Remedy::omit(key("model.flash_feedback")),
            Self::TorquesNotSettled { .. } => Remedy::omit(key("train.losses")),
            Self::LoadShare(LoadShareError::FlowPressureTooLow { .. }) => {
                Remedy::state(key("material.pinion.flow_pressure"))
                    .because("to the indentation hardness, 6 to 8 GPa for case-hardened steel")
            }
            Self::SeveralTraces { .. } => {
                Remedy::act("name one trace of each flank, as surface.pinion.file")
            }
            Self::NoProfile => Remedy::act("give surface.pinion.file and surface.wheel.file"),
            Self::Marching { .. } => Remedy::state(key("model.delta_step"))
                .because("to a smaller one")
                .or_set(key("model.numerical_error"), Value::Any)
                .because("to a larger one"),
            _ => Remedy::none(),
        }
    }
}

impl From<Error> for Fault {
    fn from(error: Error) -> Self {
        let fault = Self::new(error.code(), error.to_string()).with(error.remedy());
        let fault = match error.place() {
            Some(place) => fault.at(place.clone()),
            None => fault,
        };
        fault.caused_by(error)
    }
}

impl From<PositionError> for Fault {
    fn from(error: PositionError) -> Self {
        Error::Whole(Box::new(error)).into()
    }
}
