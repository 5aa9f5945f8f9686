//! Defaults, each written down when it is used.

use std::borrow::Cow;

use asperity_oil::Assumption;
use serde::{Deserialize, Serialize};

/// A default that was used, as it would be written in the case file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DefaultUsed {
    /// Key of the case file: `gears.helix`.
    pub key: Cow<'static, str>,
    /// The value, as it would be written.
    pub value: String,
    /// Source of the value, if it is an estimate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<Cow<'static, str>>,
}

/// The defaults used so far.
#[derive(Debug, Default)]
pub(super) struct Defaults(Vec<DefaultUsed>);

impl Defaults {
    /// The given value, or the default, which is written down.
    pub(super) fn take<T: Serialize>(
        &mut self,
        key: &'static str,
        given: Option<T>,
        default: T,
    ) -> T {
        given.unwrap_or_else(|| {
            self.note(key, &default);
            default
        })
    }

    /// Writes down that `value` was used for `key`.
    pub(super) fn note<T: Serialize>(&mut self, key: &'static str, value: &T) {
        let value = serde_json::to_string(value).unwrap_or_default();
        self.0.push(DefaultUsed {
            key: key.into(),
            value,
            source: None,
        });
    }

    /// The given value, or that of a preset or a relation, which is written down with its source.
    pub(super) fn take_from<T: Serialize>(
        &mut self,
        key: &'static str,
        given: Option<T>,
        value: T,
        source: Option<String>,
    ) -> T {
        given.unwrap_or_else(|| {
            let text = serde_json::to_string(&value).unwrap_or_default();
            self.0.push(DefaultUsed {
                key: key.into(),
                value: text,
                source: source.map(Cow::Owned),
            });
            value
        })
    }

    /// Writes down what was assumed of the oil.
    pub(super) fn assume(&mut self, assumption: &Assumption) {
        self.0.push(DefaultUsed {
            key: format!("lubricant.{}", assumption.key).into(),
            value: assumption.value.clone(),
            source: Some(assumption.source.into()),
        });
    }

    pub(super) fn into_list(self) -> Vec<DefaultUsed> {
        self.0
    }
}
