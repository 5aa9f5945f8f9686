//! Metadata in the file of an instrument.

use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use super::decimal;
use super::options::LengthUnit;

/// Facts about a measurement stated in its file.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Metadata {
    /// Maker, model or program that wrote the file.
    pub instrument: Option<String>,
    /// Date and time of the measurement, as written.
    pub date: Option<String>,
    /// Name of the part or the trace.
    pub title: Option<String>,
    /// Nominal length of the trace; an aborted trace is shorter.
    pub nominal_length: Option<Length>,
    /// Roughness cut-off of the instrument.
    pub lambda_c: Option<Length>,
    /// Short-wave cut-off of the instrument.
    pub lambda_s: Option<Length>,
    /// Radius of the stylus tip.
    pub stylus_radius: Option<Length>,
    /// Distance along the involute from the base circle to the first point, for files with roll lengths or roll angles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arc_from_base: Option<Length>,
    /// Results of the instrument in the file.
    pub printed: Vec<PrintedParameter>,
}

/// A result of the instrument.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PrintedParameter {
    /// Name as printed, `Ra`.
    pub name: String,
    /// Value in the printed unit.
    pub value: f64,
    /// Unit as printed; empty for a number without one.
    pub unit: String,
    /// Number of printed decimals.
    pub decimals: usize,
}

impl PrintedParameter {
    /// Parses `value` with an optional unit: "0.018" or "0.0180um".
    pub(super) fn parse(name: &str, value: &str, unit: &str) -> Option<Self> {
        const LONGEST_NAME: usize = 16;
        let end = value
            .find(|c: char| !(c.is_ascii_digit() || "+-.,eE".contains(c)))
            .unwrap_or(value.len());
        let (digits, rest) = value.split_at(end);
        let digits = digits.replacen(',', ".", 1);
        let fits = !name.is_empty() && name.chars().count() <= LONGEST_NAME;
        let parsed: f64 = digits
            .parse()
            .ok()
            .filter(|v: &f64| v.is_finite() && fits)?;
        let unit = if rest.trim().is_empty() { unit } else { rest };
        Some(Self {
            name: name.to_owned(),
            value: parsed,
            unit: short(unit).unwrap_or_default(),
            decimals: digits.split_once('.').map_or(0, |(_, after)| after.len()),
        })
    }
}

/// Text of a file for display: trimmed, without control characters, at most eighty characters.
pub(super) fn short(text: &str) -> Option<String> {
    const MOST: usize = 80;
    let shown = text.trim().chars().filter(|c| !c.is_control()).take(MOST);
    let shown: String = shown.collect();
    (!shown.is_empty()).then_some(shown)
}

/// A number with a decimal point or comma.
pub(super) fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let parsed = decimal::whole(text, b'.').or_else(|| decimal::whole(text, b','));
    parsed.filter(|value| value.is_finite())
}

/// A length written as "0.8mm", "2.5 µm" or "25.0um".
pub(super) fn length(text: &str) -> Option<Length> {
    let text = text.trim();
    let at = text.find(|c: char| c.is_alphabetic() && c != 'e' && c != 'E')?;
    let unit: LengthUnit = text[at..].trim().parse().ok()?;
    Some(Length::from_si(unit.metres(number(&text[..at])?)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn printed_values_keep_their_digits_and_unit() {
        let found = PrintedParameter::parse("Ra", "0.0180um", "").unwrap();
        assert_eq!((found.value, found.decimals), (0.018, 4));
        assert_eq!(found.unit, "um");
        assert_eq!(PrintedParameter::parse("Ra", "*.*******um", ""), None);
    }

    #[test]
    fn lengths_read_with_and_without_a_blank() {
        assert_eq!(length("0.08mm"), Some(Length::from_si(0.08e-3)));
        assert_eq!(length("2,5 µm"), Some(Length::from_si(2.5e-6)));
        assert_eq!(length("none"), None);
    }
}
