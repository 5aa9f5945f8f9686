//! The defaults that a case uses.

use std::borrow::Cow;

use asperity_oil::Assumption;
use serde::{Deserialize, Serialize};

/// A default in use, written as in the case file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DefaultUsed {
    /// Key of the case file: `gears.helix`.
    pub key: Cow<'static, str>,
    /// The value, written as in the case file.
    pub value: String,
    /// Source of the value, if it is an estimate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<Cow<'static, str>>,
}

/// The defaults used so far.
#[derive(Debug, Default)]
pub(crate) struct Defaults(Vec<DefaultUsed>);

impl Defaults {
    /// The value stated, or the default, which is listed.
    pub(crate) fn take<T: Serialize>(
        &mut self,
        key: impl Into<Cow<'static, str>>,
        stated: Option<T>,
        default: T,
    ) -> T {
        self.take_from(key, stated, default, None)
    }

    /// Lists `value` as the default of `key`.
    pub(crate) fn note<T: Serialize>(&mut self, key: impl Into<Cow<'static, str>>, value: &T) {
        self.list(key.into(), value, None);
    }

    /// The value stated, or that of a preset or a relation, which is listed with its source.
    pub(crate) fn take_from<T: Serialize>(
        &mut self,
        key: impl Into<Cow<'static, str>>,
        stated: Option<T>,
        value: T,
        source: Option<String>,
    ) -> T {
        stated.unwrap_or_else(|| {
            self.list(key.into(), &value, source);
            value
        })
    }

    /// Lists an assumption about the oil.
    pub(crate) fn assume(&mut self, assumption: &Assumption) {
        self.0.push(DefaultUsed {
            key: format!("lubricant.{}", assumption.key).into(),
            value: assumption.value.clone(),
            source: Some(assumption.source.into()),
        });
    }

    /// Replaces the assumption about a property of the oil, if it is listed.
    pub(crate) fn assume_instead(&mut self, assumption: &Assumption) {
        let key = format!("lubricant.{}", assumption.key);
        for used in self.0.iter_mut().filter(|used| used.key == key) {
            used.value.clone_from(&assumption.value);
            used.source = Some(assumption.source.into());
        }
    }

    fn list<T: Serialize>(&mut self, key: Cow<'static, str>, value: &T, source: Option<String>) {
        self.0.push(DefaultUsed {
            key,
            value: serde_json::to_string(value).unwrap_or_default(),
            source: source.map(Cow::Owned),
        });
    }

    pub(crate) fn into_list(self) -> Vec<DefaultUsed> {
        self.0
    }
}
