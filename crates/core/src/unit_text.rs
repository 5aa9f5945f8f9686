//! Number and unit as text, without losing a digit: "1.3 mm" is exactly 0.0013.

/// Splits "285 N m" into the number "285" and the unit "N m" (trimmed, either may be empty).
pub(crate) fn split(text: &str) -> (&str, &str) {
    let text = text.trim();
    let mut end = 0;
    let bytes = text.as_bytes();
    while end < bytes.len() {
        let accepted = match bytes[end] {
            b'0'..=b'9' | b'.' | b'+' | b'-' | b'_' | b',' => true,
            b'e' | b'E' => {
                let next = bytes.get(end + 1).copied();
                let after = bytes.get(end + 2).copied();
                let digit = |b: Option<u8>| b.is_some_and(|b| b.is_ascii_digit());
                end > 0 && (digit(next) || (matches!(next, Some(b'+' | b'-')) && digit(after)))
            }
            _ => false,
        };
        if !accepted {
            break;
        }
        end += 1;
    }
    (&text[..end], text[end..].trim())
}

/// A unit reduced to letters: blanks, dots, stars, brackets and carets dropped, micro signs to
/// `u`, superscripts to digits, the degree sign to `deg`.
pub(crate) fn normalise(unit: &str) -> String {
    let mut out = String::with_capacity(unit.len());
    for c in unit.chars() {
        match c {
            ' ' | '\u{a0}' | '\u{202f}' | '·' | '⋅' | '*' | '(' | ')' | '^' => {}
            'µ' | 'μ' => out.push('u'),
            '²' => out.push('2'),
            '³' => out.push('3'),
            '¹' => out.push('1'),
            '⁻' | '−' => out.push('-'),
            '°' | 'º' => out.push_str("deg"),
            other => out.push(other),
        }
    }
    out
}

/// `number`·10^`shift`, rounded once: the shift moves the decimal exponent of the text.
pub(crate) fn parse_shifted(number: &str, shift: i32) -> Option<f64> {
    let number = number.replace('_', "");
    let (mantissa, exponent) = match number.find(['e', 'E']) {
        Some(at) => (&number[..at], number[at + 1..].parse::<i32>().ok()?),
        None => (number.as_str(), 0),
    };
    let value: f64 = format!("{mantissa}e{}", exponent.checked_add(shift)?)
        .parse()
        .ok()?;
    value.is_finite().then_some(value)
}

/// `value`/10^`shift` as the shortest text that [`parse_shifted`] reads back to the same bits.
pub(crate) fn format_shifted(value: f64, shift: i32) -> String {
    if value == 0.0 {
        let sign = if value.is_sign_negative() { "-" } else { "" };
        return format!("{sign}0");
    }
    let text = format!("{value:e}");
    let Some((mantissa, exponent)) = text.split_once('e') else {
        return text;
    };
    let Ok(exponent) = exponent.parse::<i32>() else {
        return text;
    };
    let exponent = exponent - shift;
    if !(-4..=14).contains(&exponent) {
        return format!("{mantissa}e{exponent}");
    }
    let (sign, mantissa) = match mantissa.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", mantissa),
    };
    let digits: String = mantissa.chars().filter(|c| *c != '.').collect();
    let point = 1 + exponent;
    let body = if point <= 0 {
        format!("0.{}{digits}", "0".repeat(point.unsigned_abs() as usize))
    } else if point as usize >= digits.len() {
        format!("{digits}{}", "0".repeat(point as usize - digits.len()))
    } else {
        format!(
            "{}.{}",
            &digits[..point as usize],
            &digits[point as usize..]
        )
    };
    format!("{sign}{body}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decimal_shift_is_exact() {
        assert_eq!(parse_shifted("1.3", -3), Some(0.0013));
        assert_eq!(parse_shifted("97.5", -3), Some(0.0975));
        assert_eq!(parse_shifted("2e-8", 0), Some(2e-8));
        assert_eq!(format_shifted(0.0013, -3), "1.3");
        assert_eq!(format_shifted(-0.25, 0), "-0.25");
        assert_eq!(format_shifted(210e9, 9), "210");
        assert_eq!(format_shifted(0.0, -2), "0");
    }

    #[test]
    fn number_and_unit_part_at_the_unit() {
        assert_eq!(split("285 N m"), ("285", "N m"));
        assert_eq!(split("2e-8 1/Pa"), ("2e-8", "1/Pa"));
        assert_eq!(split("-40 °C"), ("-40", "°C"));
        assert_eq!(split("mm"), ("", "mm"));
        assert_eq!(split("5 eV"), ("5", "eV"));
    }
}
