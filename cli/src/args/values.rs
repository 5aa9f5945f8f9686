//! Parsers of option values.

use asperity_core::quantity::{Length, QuantityError};

/// Reads a choice by its name in the case file.
pub fn choice<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, serde::de::value::Error> {
    use serde::de::IntoDeserializer;
    T::deserialize(text.into_deserializer())
}

/// Reads a cut-off; `none` is a cut-off of zero.
pub fn cutoff(text: &str) -> Result<Length, QuantityError> {
    if text.trim() == "none" {
        return Ok(Length::from_si(0.0));
    }
    text.parse()
}

/// The name of a choice in the case file.
pub fn name_of<T: serde::Serialize>(choice: &T) -> String {
    match serde_json::to_value(choice) {
        Ok(serde_json::Value::String(name)) => name,
        Ok(other) => other.to_string(),
        Err(_) => String::new(),
    }
}
