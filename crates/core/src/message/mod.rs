//! Codes of errors and warnings with their meaning, and the one kind of error that every program renders.

mod fault;
mod place;
mod table;
mod warning;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

pub use fault::Fault;
pub use place::{IN_MEMORY, Place};
pub use table::{Code, EXPLANATIONS, Explanation};
pub use warning::{
    Subject, Warning, columns_not_read, gravest_first, outside_codes, outside_codes_of_case,
};

/// The explanation of `code`, in upper or lower case.
///
/// ```
/// use asperity_core::message::explain;
/// assert!(explain("w402").is_some());
/// assert!(explain("W999").is_none());
/// ```
pub fn explain(code: &str) -> Option<&'static Explanation> {
    code.parse().ok().map(Code::explain)
}

/// Error of a text that is not the code of a message.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("no message has the code \"{0}\"")]
pub struct UnknownCode(String);

impl Code {
    /// The meaning of the code and its remedy.
    ///
    /// ```
    /// use asperity_core::message::Code;
    /// assert_eq!(Code::E301.explain().exit_status, 3);
    /// assert_eq!("e301".parse(), Ok(Code::E301));
    /// ```
    pub const fn explain(self) -> &'static Explanation {
        &EXPLANATIONS[self as usize]
    }

    /// Exit status of a command that ends with the error.
    pub const fn exit_status(self) -> u8 {
        self.explain().exit_status
    }
}

/// In upper or lower case.
impl std::str::FromStr for Code {
    type Err = UnknownCode;

    fn from_str(text: &str) -> Result<Self, UnknownCode> {
        let is_it = |code: &&Self| code.as_str().eq_ignore_ascii_case(text.trim());
        let known = Self::ALL.iter().find(is_it);
        known.copied().ok_or_else(|| UnknownCode(text.to_owned()))
    }
}

impl std::fmt::Display for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.as_str())
    }
}

impl PartialEq<str> for Code {
    fn eq(&self, text: &str) -> bool {
        self.as_str() == text
    }
}

impl PartialEq<&str> for Code {
    fn eq(&self, text: &&str) -> bool {
        self.as_str() == *text
    }
}

impl Serialize for Code {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.as_str())
    }
}

impl<'de> Deserialize<'de> for Code {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = <std::borrow::Cow<'_, str>>::deserialize(deserializer)?;
        text.parse().map_err(serde::de::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_has_its_row() {
        assert_eq!(Code::ALL.len(), EXPLANATIONS.len());
        for code in Code::ALL {
            assert_eq!(code.explain().code, *code);
            assert_eq!(code.as_str().parse(), Ok(*code));
            let is_error = code.as_str().starts_with('E');
            assert_eq!(code.explain().exit_status > 0, is_error, "{code}");
        }
        assert!(Code::ALL.is_sorted_by_key(|code| code.as_str()));
    }

    #[test]
    fn a_code_is_a_text_in_json() {
        let json = serde_json::to_value(Code::W402).unwrap();
        assert_eq!(json, "W402");
        assert_eq!(serde_json::from_value::<Code>(json).unwrap(), Code::W402);
        assert!(serde_json::from_str::<Code>("\"W999\"").is_err());
    }
}
