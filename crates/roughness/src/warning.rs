//! Warnings about a profile that was prepared and evaluated all the same.

use asperity_core::quantity::Length;
use asperity_core::remedy::{Remedy, Setting, Value};
use serde::{Deserialize, Serialize};

/// A note that goes with a result, under a stable code.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::Warning;
/// let note = Warning::FewSections {
///     sections: 2,
///     lambda_c: Length::from_si(2.5e-3),
///     length: Length::from_si(5e-3),
/// };
/// assert_eq!(note.code(), "W114");
/// assert_eq!(note.to_string(), "2 sampling lengths of 2.5 mm in 5 mm; five are usual");
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, thiserror::Error)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Warning {
    /// The trace still has its form.
    #[error(
        "form not removed (parabola of {sag:.4} over {length:.4}); Ra {ra:.4} is not roughness"
    )]
    FormNotRemoved {
        /// Height of the parabola between its apex and the ends.
        sag: Length,
        /// Length it was fitted over.
        length: Length,
        /// Arithmetic mean height of what was left.
        ra: Length,
    },
    /// The grid is too coarse for the short-wave filter.
    #[error(
        "spacing {spacing:.4} is more than a fifth of lambda_s {lambda_s}: the filter is poorly sampled"
    )]
    CoarseForLambdaS {
        /// Spacing of the profile.
        spacing: Length,
        /// Cut-off of the short-wave filter.
        lambda_s: Length,
    },
    /// Fewer sampling lengths than the five that ISO 4288 takes as normal.
    #[error("{sections} sampling lengths of {lambda_c} in {length:.4}; five are usual")]
    FewSections {
        /// Sections evaluated.
        sections: usize,
        /// Sampling length.
        lambda_c: Length,
        /// Evaluation length.
        length: Length,
    },
    /// Outliers were replaced.
    #[error(
        "{points} points were replaced as outliers by straight lines, at most {longest} in a row, up to {farthest:.4} from the running median"
    )]
    OutliersReplaced {
        /// Points replaced.
        points: usize,
        /// Longest run of them.
        longest: usize,
        /// Largest distance from the running median.
        farthest: Length,
    },
    /// The involute that came off is not that of the trace.
    #[error(
        "a parabola or cubic of {form:.3} root mean square is left after the involute, over {roughness:.3} of roughness: the flank is crowned, or its base radius or roll length is another. With this base radius a roll length of {fitted:.4} fits best, not {given:.4}"
    )]
    InvoluteLeft {
        /// Root mean square of the parabola and cubic left.
        form: Length,
        /// Root mean square of the rest.
        roughness: Length,
        /// Height of the parabola between its apex and the ends.
        parabola: Length,
        /// Roll length that was given.
        given: Length,
        /// Roll length that fits best with the base radius given.
        fitted: Length,
    },
}

impl Warning {
    /// Remedy; empty where only a better measurement helps.
    pub fn remedy(&self) -> Remedy {
        match self {
            Self::FormNotRemoved { .. } => Remedy::set(Setting::Form, Value::This("poly2".into())),
            Self::CoarseForLambdaS { .. } => Remedy::act("measure finer")
                .or_set(Setting::NoiseCutoff, Value::Any)
                .because("to a longer lambda_s"),
            Self::InvoluteLeft { .. } => {
                Remedy::act("check base radius and roll length").or_do("take it as crowning")
            }
            _ => Remedy::none(),
        }
    }

    /// The code under which the message is explained.
    pub fn code(&self) -> &'static str {
        match self {
            Self::FormNotRemoved { .. } => "W112",
            Self::CoarseForLambdaS { .. } => "W113",
            Self::FewSections { .. } => "W114",
            Self::InvoluteLeft { .. } => "W128",
            Self::OutliersReplaced { .. } => "W130",
        }
    }
}
