//! Numbers in messages.

use crate::unit_text::format_shifted;

/// Significant digits of a number in a message.
const DIGITS: usize = 6;

/// A number in a message: at most six significant digits without zeros at the end, with an exponent where plain digits would
/// be many.
///
/// ```
/// use asperity_core::number;
/// assert_eq!(number(110_736.657_664), "110737");
/// assert_eq!(number(0.1 + 0.2), "0.3");
/// assert_eq!(number(-2.220_446e-16), "-2.22045e-16");
/// assert_eq!(number(1e300), "1e300");
/// assert_eq!(number(-0.0), "0");
/// ```
pub fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value);
    if rounded.is_finite() {
        // Minus zero is zero.
        format_shifted(rounded + 0.0, 0)
    } else {
        rounded.to_string()
    }
}

/// A number in a message with its unit, if it has one.
///
/// ```
/// use asperity_core::number_with_unit;
/// assert_eq!(number_with_unit(0.0025, "m"), "0.0025 m");
/// assert_eq!(number_with_unit(2.0, "-"), "2");
/// ```
pub fn number_with_unit(value: f64, unit: &str) -> String {
    match unit {
        "" | "-" => number(value),
        unit => format!("{} {unit}", number(value)),
    }
}

/// A number with `places` decimals, and with three digits if it is so small that these would leave fewer.
///
/// ```
/// use asperity_core::by_size;
/// assert_eq!([0.2823, 0.0123, 0.000_282_3, 0.0, -2e-9].map(|x| by_size(x, 4)), ["0.2823", "0.0123", "0.000282", "0.0000", "-2.00e-9"]);
/// ```
pub fn by_size(value: f64, places: usize) -> String {
    /// Most decimals.
    const MOST: usize = 7;
    let size = value.abs().log10().floor();
    match value {
        0.0 => decimals(value, places),
        _ if size + (places as f64) >= 2.0 => decimals(value, places),
        _ if 2.0 - size <= MOST as f64 => format!("{value:.*}", (2.0 - size) as usize),
        _ => format!("{value:.2e}"),
    }
}

/// A number in a message with `places` decimals, as long as they and the digits before them are few; no minus zero.
///
/// ```
/// use asperity_core::decimals;
/// assert_eq!(decimals(12.345, 1), "12.3");
/// assert_eq!(decimals(-0.01, 1), "0.0");
/// assert_eq!(decimals(1e300, 1), "1e300");
/// ```
pub fn decimals(value: f64, places: usize) -> String {
    /// Size from which a number has no decimals.
    const LARGE: f64 = 1e7;
    if value.abs() >= LARGE || !value.is_finite() {
        return number(value);
    }
    let text = format!("{value:.places$}");
    let is_zero = text.trim_matches(['-', '0', '.']).is_empty();
    match text.strip_prefix('-') {
        Some(size) if is_zero => size.to_owned(),
        _ => text,
    }
}
