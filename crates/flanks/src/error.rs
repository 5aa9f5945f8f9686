//! Reasons for which a mesh position has no result.

use asperity_contact::ContactError;
use asperity_core::cancel::Cancelled;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, DomainError, Fault, decimals, number};
use asperity_efficiency::EfficiencyError;
use asperity_ehl::EhlError;
use asperity_mixed_film::LoadShareError;

/// Narrowest window of a contact in Hertz half-widths.
pub const NARROWEST_WINDOW: f64 = 1.5;

/// Errors at a mesh position.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum PositionError {
    /// The rough contact has no solution, or did not converge.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The load share has no solution.
    #[error(transparent)]
    LoadShare(#[from] LoadShareError),
    /// The lubricated contact has no solution, or did not converge.
    #[error(transparent)]
    Ehl(#[from] asperity_ehl::EhlError),
    /// The prepared trace does not cover the window.
    #[error(
        "the prepared trace of {available_um} um is shorter than the {needed_um} um that the windows of the contact need", available_um = decimals(*available_um, 0), needed_um = decimals(*needed_um, 0))]
    TraceTooShort {
        /// Prepared length \[µm\].
        available_um: f64,
        /// The same with the ends that filtering dropped \[µm\].
        whole_um: f64,
        /// Window, with several of them the way that they need to differ \[µm\].
        needed_um: f64,
        /// Most half-widths to each side for which it is long enough.
        half_widths: f64,
    },
    /// A rough contact without solution, with the gap that it had to close.
    #[error(transparent)]
    Unsolved(Box<UnsolvedContact>),
    /// An error that no caller distinguishes from others.
    #[error(transparent)]
    Fault(#[from] Fault),
}

impl PositionError {
    /// Traces that lie outside of the contact.
    pub fn not_covered(coverage: f64) -> Self {
        Self::Fault(Fault::new(
            Code::E123,
            format!(
                "the traces cover {:.0} % of the loss along the path of contact where they are placed, at least 30 % are needed",
                100.0 * coverage
            ),
        ))
    }

    /// A part of the gearbox has no loss.
    pub fn gearbox_part(part: &str, error: Self) -> Self {
        let (code, remedy) = (error.code(), error.remedy());
        let fault = Fault::from_cause(code, error).with(remedy);
        Self::Fault(fault.about(format!("gearbox: {part}")))
    }

    /// One contact asked of several traces.
    pub fn several_traces(teeth: [usize; 2]) -> Self {
        Self::Fault(
            Fault::new(
                Code::E312,
                format!(
                    "the case has {} pairs of teeth; one pair of traces is needed here",
                    teeth[0] * teeth[1]
                ),
            )
            .with(Remedy::act(
                "name one trace of each flank, as surface.pinion.file",
            )),
        )
    }

    /// A loss whose gradient over the heights is not known.
    pub fn no_gradient(differs: &str) -> Self {
        Self::Fault(Fault::new(
            Code::E205,
            format!(
                "the loss over the heights of the traces cannot be computed with {differs}; leave it out"
            ),
        ))
    }

    /// Patches where heights of traces are changed.
    pub fn of_patches() -> Self {
        let text = "this is computed for traces, and both flanks are scans that are taken whole: state surface.contact = \"lines\", or a row of each scan";
        Self::Fault(Fault::new(Code::E205, text.to_owned()))
    }

    /// Contact tables of other gears, flanks or loads.
    pub fn other_tables(differs: &'static str) -> Self {
        Self::Fault(Fault::new(
            Code::E305,
            format!("the contact tables were made for another {differs}"),
        ))
    }

    /// The flash temperature fed back into the oil does not settle.
    pub fn flash_not_settled(flash_kelvin: f64, passes: usize) -> Self {
        Self::Fault(Fault::new(Code::E301, format!("the flash temperature did not settle in {passes} passes (last {flash_kelvin} K)", flash_kelvin = decimals(flash_kelvin, 1))).with(Remedy::omit(Setting::Key("model.flash_feedback"))))
    }

    /// Losses that lower the torques of the following meshes do not settle.
    pub fn torques_not_settled(change: f64) -> Self {
        Self::Fault(
            Fault::new(
                Code::E301,
                format!("the torques of the gear train do not settle (last change {change:.1e})"),
            )
            .with(Remedy::omit(Setting::Key("train.losses"))),
        )
    }

    /// The points are too far apart for the contact.
    pub fn too_coarse(spacing_um: f64, points: f64, least: f64) -> Self {
        Self::Fault(Fault::new(
            Code::E121,
            format!(
                "dx {spacing_um} um gives {points} points per Hertz half-width (at least {least} needed)",
                least = number(least),
                spacing_um = decimals(spacing_um, 3),
                points = decimals(points, 1)
            ),
        ))
    }

    /// The rough contact presses measured profiles together and a flank has none.
    pub fn no_profile() -> Self {
        Self::Fault(
            Fault::new(
                Code::E303,
                "the rough contact presses two measured profiles together, and a flank has none",
            )
            .with(Remedy::act(
                "give surface.pinion.file and surface.wheel.file",
            )),
        )
    }

    /// A state that is beyond physical sense.
    pub fn impossible(
        name: &'static str,
        value: f64,
        unit: &'static str,
        rule: &'static str,
        limit: Option<f64>,
    ) -> Self {
        Self::Fault(Fault::new(
            Code::E308,
            format!(
                "{name} of {value:.3e} {unit} is beyond physical sense ({rule}{})",
                limit
                    .map(|limit| format!(" {limit:e} {unit}"))
                    .unwrap_or_default()
            ),
        ))
    }
}

macro_rules! outside_the_model {
    ($($cause:ty),+) => {
        $(impl From<$cause> for PositionError {
            fn from(error: $cause) -> Self {
                Self::Fault(Fault::from_cause(Code::E305, error))
            }
        })+
    };
}

outside_the_model!(
    asperity_gear::GearError,
    asperity_ehl_regime::RegimeError,
    asperity_tribo_friction::FrictionError,
    asperity_ns_film::FilmError,
    asperity_roughness::RoughnessError,
    asperity_oil::LubricantError,
    DomainError
);

/// Losses cannot be summed.
impl From<EfficiencyError> for PositionError {
    fn from(error: EfficiencyError) -> Self {
        let fault = Fault::from(error);
        Self::Fault(match fault.code() {
            Code::E311 | Code::E313 => fault,
            _ => fault.coded(Code::E305),
        })
    }
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
                | Self::Ehl(EhlError::Cancelled(_))
        )
    }

    /// The reason, without the stored contact.
    #[must_use]
    pub fn reason(&self) -> &Self {
        match self {
            Self::Unsolved(kept) => kept.source.reason(),
            other => other,
        }
    }
}

impl PositionError {
    /// Stable code of the message.
    pub fn code(&self) -> Code {
        match self.reason() {
            reason if reason.is_cancelled() => Code::E502,
            Self::Fault(fault) => fault.code(),
            Self::TraceTooShort { .. } => Code::E122,
            Self::Contact(ContactError::NotConverged { .. })
            | Self::LoadShare(LoadShareError::Contact(ContactError::NotConverged { .. })) => {
                Code::E301
            }
            Self::LoadShare(LoadShareError::Fault(fault)) if fault.code() == Code::E301 => {
                Code::E301
            }
            Self::Contact(ContactError::LimitBelowMeanPressure { .. })
            | Self::LoadShare(LoadShareError::Contact(ContactError::LimitBelowMeanPressure {
                ..
            })) => Code::E302,
            Self::LoadShare(LoadShareError::FlowPressureTooLow { .. }) => Code::E306,
            Self::Ehl(error) if error.is_unconverged() => Code::E307,
            _ => Code::E305,
        }
    }

    /// Remedy of this error; empty where no more is known than its code says.
    pub fn remedy(&self) -> Remedy {
        let key = Setting::Key;
        match self.reason() {
            Self::TraceTooShort {
                whole_um,
                needed_um,
                half_widths,
                ..
            } => {
                let longer = Remedy::act("measure a longer trace");
                // Filters can give back no more than the ends that they drop.
                let with_ends = if whole_um >= needed_um {
                    longer
                        .or_set(Setting::Cutoff, Value::Any)
                        .because("to a shorter one")
                        .or_set(key("surface.ends"), Value::This("reg1".into()))
                        .because("to keep the ends that the filter drops")
                } else {
                    longer
                };
                // Rounded down: so many fit.
                let fitting = (half_widths * 100.0).floor() / 100.0;
                if fitting >= NARROWEST_WINDOW {
                    with_ends
                        .or_set(key("model.window"), Value::This(fitting.to_string().into()))
                        .because("half-widths")
                } else {
                    with_ends
                }
            }
            Self::Ehl(error) if error.is_unconverged() => {
                Remedy::state(key("model.ehl.cells")).because("to more cells across the film")
            }
            Self::LoadShare(LoadShareError::FlowPressureTooLow { .. }) => {
                Remedy::state(key("material.pinion.flow_pressure"))
                    .because("to the indentation hardness, 6 to 8 GPa for case-hardened steel")
            }
            Self::Fault(fault) => fault.remedy().clone(),
            _ => Remedy::none(),
        }
    }
}

impl From<PositionError> for Fault {
    fn from(error: PositionError) -> Self {
        let fault = Self::new(error.code(), error.to_string()).with(error.remedy());
        fault.caused_by(error)
    }
}
