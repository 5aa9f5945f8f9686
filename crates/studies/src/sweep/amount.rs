//! Values of a study: numbers, numbers with a unit, and other values of a case file.

use toml::Value;

use super::error::SweepError;

/// Number with an optional unit.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Amount {
    pub value: f64,
    pub unit: String,
}

impl Amount {
    /// Reads `"500 1/min"`, `0.06`.
    pub(super) fn read(key: &str, value: &Value) -> Result<Self, SweepError> {
        let refused = || {
            let rule = format!("{value} is not a number or a number with a unit");
            SweepError::key(key, rule)
        };
        match value {
            Value::Integer(number) => Ok(Self::bare(*number as f64)),
            Value::Float(number) if number.is_finite() => Ok(Self::bare(*number)),
            Value::String(text) => {
                let text = text.trim();
                let end = text
                    .find(|c: char| !(c.is_ascii_digit() || "+-.eE".contains(c)))
                    .unwrap_or(text.len());
                let (number, unit) = text.split_at(end);
                let value: f64 = number.parse().map_err(|_| refused())?;
                value.is_finite().then_some(()).ok_or_else(refused)?;
                Ok(Self {
                    value,
                    unit: unit.trim().to_owned(),
                })
            }
            _ => Err(refused()),
        }
    }

    fn bare(value: f64) -> Self {
        Self {
            value,
            unit: String::new(),
        }
    }

    /// The amounts of a list, which must have one unit.
    pub(super) fn list(key: &str, values: &[Value]) -> Result<(Vec<f64>, String), SweepError> {
        let amounts = values
            .iter()
            .map(|value| Self::read(key, value))
            .collect::<Result<Vec<_>, _>>()?;
        let unit = amounts
            .first()
            .map_or(String::new(), |first| first.unit.clone());
        if amounts.iter().any(|amount| amount.unit != unit) {
            return Err(SweepError::key(key, "all values need the same unit"));
        }
        Ok((amounts.iter().map(|amount| amount.value).collect(), unit))
    }
}

/// A number in the form of a case file.
pub(super) fn text_of(value: f64, unit: &str) -> String {
    match unit {
        // An integer is written without decimals, as some keys require.
        "" => format!("{value}"),
        unit => format!("{value} {unit}"),
    }
}

/// A value in the form of a case file.
pub(crate) fn written(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}
