//! Inputs outside the range of a correlation.

use std::fmt;

use asperity_core::Code;
use serde::{Serialize, Serializer};

/// An input outside the range of a correlation or of lubricated steel. It is written as code, correlation and input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct OutsideInput {
    /// Code of the warning about it.
    pub code: Code,
    /// Name of the correlation.
    pub correlation: &'static str,
    /// Name of the input; `None` where the correlation has one only.
    pub input: Option<&'static str>,
}

impl fmt::Display for OutsideInput {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.code, self.correlation)?;
        match self.input {
            Some(input) => write!(f, ": {input}"),
            None => Ok(()),
        }
    }
}

impl Serialize for OutsideInput {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
