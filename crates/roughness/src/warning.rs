//! Warnings of the preparation and evaluation of a profile.

use asperity_core::quantity::Length;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, number};
use serde::{Deserialize, Serialize};

use crate::gaussian_filter::shortest_noise_cutoff;

/// A warning with a stable code.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::Warning;
/// let warning = Warning::FewSections {
///     sections: 2,
///     lambda_c: Length::from_si(2.5e-3),
///     length: Length::from_si(5e-3),
/// };
/// assert_eq!(warning.code(), "W114");
/// assert_eq!(warning.to_string(), "2 sampling lengths of 2.5 mm in 5 mm; five are usual");
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, thiserror::Error)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Warning {
    /// The form of the trace was not removed.
    #[error(
        "form not removed (parabola of {sag:.4} over {length:.4}); Ra {ra:.4} is not roughness"
    )]
    FormNotRemoved {
        /// Height of the parabola between its apex and the ends.
        sag: Length,
        /// Length of the trace.
        length: Length,
        /// Arithmetic mean height of the result.
        ra: Length,
    },
    /// The grid is too coarse for the short-wave filter.
    #[error(
        "spacing {spacing:.4} is more than a fifth of lambda_s {lambda_s:.6}: the filter is poorly sampled"
    )]
    CoarseForLambdaS {
        /// Spacing of the profile.
        spacing: Length,
        /// Cut-off of the short-wave filter.
        lambda_s: Length,
    },
    /// Fewer sampling lengths than the standard five (ISO 4288).
    #[error("{sections} sampling lengths of {lambda_c:.6} in {length:.4}; five are usual")]
    FewSections {
        /// Number of sections.
        sections: usize,
        /// Sampling length.
        lambda_c: Length,
        /// Evaluation length.
        length: Length,
    },
    /// Traces or surfaces are made of pieces of a single one.
    #[error(
        "all pieces are of one trace or surface of {length:.4}: how flanks differ from each other is not in them"
    )]
    OneTrace {
        /// Length of the trace, or of a row of the surface.
        length: Length,
    },
    /// Heights differ as between finishes.
    #[error(
        "Rq of the traces is {from:.4} to {to:.4}, as of several finishes; what is generated is a mixture"
    )]
    HeightsDiffer {
        /// Least Rq.
        from: Length,
        /// Greatest Rq.
        to: Length,
    },
    /// Slopes differ as between finishes.
    #[error(
        "the root mean square slope of the traces is {from} to {to}, as of several finishes; what is generated is a mixture",
        from = number(*from), to = number(*to)
    )]
    SlopesDiffer {
        /// Least slope.
        from: f64,
        /// Greatest slope.
        to: f64,
    },
    /// Outliers were replaced.
    #[error(
        "{points} points were replaced as outliers by straight lines, at most {longest} in a row, up to {farthest:.4} from the running median"
    )]
    OutliersReplaced {
        /// Number of replaced points.
        points: usize,
        /// Longest run of replaced points.
        longest: usize,
        /// Largest distance from the running median.
        farthest: Length,
    },
    /// A few sections are much higher than the others: a groove, a step or an edge.
    #[error(
        "a groove, a step or an edge between {from:.4} and {to:.4} of the trace dominates it: Rz is up to {highest:.3}, at {at:.4}, and above {OUTSIDE} times the median of {median:.3} in {count} of {sections} sections of {section:.6}; before the roughness filter the heights there span {span:.3}"
    )]
    SectionsDominate {
        /// Number of sections above the limit.
        count: usize,
        /// Number of sections.
        sections: usize,
        /// Length of a section.
        section: Length,
        /// Distance of the first one from the first point of the trace.
        from: Length,
        /// Distance of the end of the last one from the first point of the trace.
        to: Length,
        /// Median height of a section, Rz.
        median: Length,
        /// Largest height of a section, Rz1max.
        highest: Length,
        /// Distance of the extreme of the highest section from the first point of the trace.
        at: Length,
        /// Highest minus lowest point of the primary profile between `from` and `to`.
        span: Length,
        /// Longest stretch of the trace without such a section.
        sound: [Length; 2],
    },
    /// The removed involute does not fit the trace.
    #[error(
        "a parabola or cubic of {form:.3} root mean square is left after the involute, over {roughness:.3} of roughness: the flank is crowned, or its base radius or roll length is another. With this base radius a roll length of {fitted:.4} fits best, not {given:.4}"
    )]
    InvoluteLeft {
        /// Root mean square of the remaining parabola and cubic.
        form: Length,
        /// Root mean square of the residual.
        roughness: Length,
        /// Height of the parabola between its apex and the ends.
        parabola: Length,
        /// Given roll length.
        given: Length,
        /// Best-fit roll length with the given base radius.
        fitted: Length,
    },
}

/// Height of a section over the median of all from which it is outside of the texture of the others.
pub(crate) const OUTSIDE: f64 = 3.0;

impl Warning {
    /// Remedy; empty if only a better measurement helps.
    pub fn remedy(&self) -> Remedy {
        match self {
            Self::FormNotRemoved { .. } => Remedy::set(Setting::Form, Value::This("poly2".into())),
            Self::CoarseForLambdaS { spacing, .. } => Remedy::act("measure finer").or_set(
                Setting::NoiseCutoff,
                Value::This(shortest_noise_cutoff(*spacing).to_string().into()),
            ),
            Self::InvoluteLeft { .. } => {
                Remedy::act("check base radius and roll length").or_do("take it as crowning")
            }
            Self::SectionsDominate { sound, .. } => {
                // To 10 µm, which is far below a cut-off, and inwards.
                let [from, to] = [(sound[0].si() * 1e5).ceil(), (sound[1].si() * 1e5).floor()];
                let range = format!("{} mm .. {} mm", from / 100.0, to / 100.0);
                Remedy::set(Setting::Range, Value::This(range.into()))
                    .or_do("keep it if the whole flank has such features")
            }
            Self::OneTrace { .. } => Remedy::act("give several traces, each of another tooth"),
            Self::HeightsDiffer { .. } | Self::SlopesDiffer { .. } => {
                Remedy::act("give traces of one finish")
            }
            _ => Remedy::none(),
        }
    }

    /// The warning with places on a trace that was read from its other end and is of `length`, if `turned`, and that begins
    /// `start` behind the first point measured.
    #[must_use]
    pub fn on_trace(mut self, turned: bool, length: Length, start: Length) -> Self {
        if let Self::SectionsDominate {
            from,
            to,
            at,
            sound,
            ..
        } = &mut self
        {
            let placed = |x: Length| start + if turned { length - x } else { x };
            let ends = |[a, b]: [Length; 2]| {
                if turned {
                    [placed(b), placed(a)]
                } else {
                    [placed(a), placed(b)]
                }
            };
            *sound = ends(*sound);
            [*from, *to] = ends([*from, *to]);
            *at = placed(*at);
        }
        self
    }

    /// Code of the explanation of the message.
    pub fn code(&self) -> Code {
        match self {
            Self::FormNotRemoved { .. } => Code::W112,
            Self::CoarseForLambdaS { .. } => Code::W113,
            Self::FewSections { .. } => Code::W114,
            Self::InvoluteLeft { .. } => Code::W128,
            Self::OutliersReplaced { .. } => Code::W130,
            Self::SectionsDominate { .. } => Code::W132,
            Self::OneTrace { .. } => Code::W461,
            Self::HeightsDiffer { .. } | Self::SlopesDiffer { .. } => Code::W462,
        }
    }
}
