//! Stated loss of a call-out.

use std::borrow::Cow;
use std::str::FromStr;

use asperity_core::quantity::{Power, Ratio};
use asperity_core::{Code, Fault};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, de};

/// Ways to write a target.
const FORMS: &str = "write a power, \"600 W\", or a change of the loss of flanks like these: \"-10 %\", \"10 % less\", \"60 W less\"";

/// A loss, as a power or as a change of the present one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LossTarget {
    /// The loss itself.
    Of(Power),
    /// Change over the present loss.
    Share(f64),
    /// Change by a power.
    By(Power),
}

impl LossTarget {
    /// The loss where the present one is `present_w` \[W\].
    #[must_use]
    pub fn watts(self, present_w: f64) -> f64 {
        match self {
            Self::Of(power) => power.si(),
            Self::Share(change) => present_w * (1.0 + change),
            Self::By(power) => present_w + power.si(),
        }
    }

    /// The change in words; `None` of a loss itself.
    #[must_use]
    pub fn change(self) -> Option<String> {
        let (size, less) = match self {
            Self::Of(_) => return None,
            Self::Share(change) => (format!("{} %", number(100.0 * change.abs())), change < 0.0),
            Self::By(power) => (
                Power::from_si(power.si().abs()).to_string(),
                power.si() < 0.0,
            ),
        };
        Some(format!("{size} {}", if less { "less" } else { "more" }))
    }
}

/// A percentage without the last digits of its binary form.
fn number(percent: f64) -> String {
    let text = format!("{percent:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Reads a loss as people state it.
///
/// ```
/// use asperity_studies::callout::LossTarget;
/// let of = |text: &str| text.parse::<LossTarget>().map(|target| target.watts(700.0));
/// assert_eq!(of("600 W")?, 600.0);
/// assert!((of("-10 %")? - 630.0).abs() < 1e-9);
/// assert_eq!(of("10 % less")?, of("-10 %")?);
/// assert_eq!(of("70 W less")?, 630.0);
/// assert!(of("10 %").is_err());
/// # Ok::<(), asperity_core::Fault>(())
/// ```
impl FromStr for LossTarget {
    type Err = Fault;

    fn from_str(text: &str) -> Result<Self, Fault> {
        let text = text.trim();
        let refused = |why: String| Fault::new(Code::E204, format!("{why}; {FORMS}"));
        let worded = [("less", -1.0), ("more", 1.0)];
        let mut worded = worded.into_iter();
        let worded = worded.find_map(|(word, sign)| Some((text.strip_suffix(word)?.trim(), sign)));
        let is_signed = text.starts_with(['+', '-', '−']);
        let (size, sign) = match worded {
            Some(_) if is_signed => {
                return Err(refused(format!("\"{text}\" has both a sign and a word")));
            }
            Some(worded) => worded,
            None => (text, 1.0),
        };
        let size = size.replace('−', "-");
        if size.ends_with('%') {
            let share: Ratio = size.parse().map_err(|error| refused(format!("{error}")))?;
            return if is_signed || worded.is_some() {
                Ok(Self::Share(sign * share.value()))
            } else {
                Err(refused(format!("\"{text}\" is neither less nor more")))
            };
        }
        let power: Power = size.parse().map_err(|error| refused(format!("{error}")))?;
        Ok(match worded {
            Some(_) => Self::By(Power::from_si(sign * power.si())),
            None => Self::Of(power),
        })
    }
}

impl<'de> Deserialize<'de> for LossTarget {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        String::deserialize(from)?
            .parse()
            .map_err(de::Error::custom)
    }
}

impl JsonSchema for LossTarget {
    fn schema_name() -> Cow<'static, str> {
        "LossTarget".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "string",
            "description": "a power with its unit, or a change of the present loss: \"-10 %\", \"10 % less\", \"60 W less\"",
        })
    }
}
