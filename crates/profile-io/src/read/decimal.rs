//! Decimal numbers from bytes, correctly rounded.
//!
//! value = m·10^e, where m are the digits as a whole number and e is the exponent minus the number of decimals. If m ≤
//! 2⁵³ and |e| ≤ 22, both m and 10^|e| are exact in binary, so the single multiplication or division is correctly
//! rounded (Clinger, How to read floating point numbers accurately, 1990). Other numbers are parsed by the standard
//! library, with identical results.

/// Powers of ten that are exact in binary.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];
/// Whole numbers up to here are exact in binary.
const MOST_EXACT: u64 = 1 << 53;
/// Digits that always fit 64 bits.
const MOST_DIGITS: usize = 19;

/// The number at the start of `bytes` with the decimal sign `point`, and the rest.
///
/// A decimal comma must be followed by a digit: "1," is the start of "1, 2".
#[inline(always)]
pub(super) fn prefix(bytes: &[u8], point: u8) -> Option<(f64, &[u8])> {
    let (negative, unsigned) = signed(bytes);
    let (mut mantissa, mut rest) = digits(unsigned, 0);
    let mut count = unsigned.len() - rest.len();
    let mut exponent = 0;
    if let [sign, decimals @ ..] = rest
        && *sign == point
    {
        (mantissa, rest) = digits(decimals, mantissa);
        let places = decimals.len() - rest.len();
        if places == 0 && point == b',' {
            return None;
        }
        count += places;
        exponent = -(places as i64);
    }
    if count == 0 {
        return None;
    }
    if let [b'e' | b'E', power @ ..] = rest {
        let (power, after) = whole_number(power)?;
        exponent = exponent.saturating_add(power);
        rest = after;
    }
    let value = match POWERS.get(exponent.unsigned_abs() as usize) {
        Some(scale) if count <= MOST_DIGITS && mantissa <= MOST_EXACT => {
            let m = mantissa as f64;
            let m = if negative { -m } else { m };
            if exponent < 0 { m / scale } else { m * scale }
        }
        _ => by_std(&bytes[..bytes.len() - rest.len()], point)?,
    };
    Some((value, rest))
}

/// The number in the whole of `text`.
pub(super) fn whole(text: &str, point: u8) -> Option<f64> {
    let (value, rest) = prefix(text.as_bytes(), point)?;
    rest.is_empty().then_some(value)
}

/// Whether there is a minus sign, and the rest after an optional sign.
#[inline]
fn signed(bytes: &[u8]) -> (bool, &[u8]) {
    match bytes {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, bytes),
    }
}

/// `mantissa` with the digits at the start of `bytes` appended, and the rest. It wraps on overflow and is then not
/// used.
#[inline]
fn digits(mut bytes: &[u8], mut mantissa: u64) -> (u64, &[u8]) {
    while let [digit @ b'0'..=b'9', rest @ ..] = bytes {
        mantissa = mantissa
            .wrapping_mul(10)
            .wrapping_add((digit - b'0').into());
        bytes = rest;
    }
    (mantissa, bytes)
}

/// The exponent at the start of `bytes`, and the rest.
fn whole_number(bytes: &[u8]) -> Option<(i64, &[u8])> {
    let (negative, unsigned) = signed(bytes);
    let (value, rest) = digits(unsigned, 0);
    let count = unsigned.len() - rest.len();
    let fits = i64::try_from(value).ok().filter(|_| count <= MOST_DIGITS);
    let value = fits.unwrap_or(i64::MAX);
    (count > 0).then_some((if negative { -value } else { value }, rest))
}

#[cold]
#[inline(never)]
fn by_std(bytes: &[u8], point: u8) -> Option<f64> {
    let text = std::str::from_utf8(bytes).ok()?;
    match point {
        b'.' => text.parse().ok(),
        _ => text.replacen(char::from(point), ".", 1).parse().ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn same(text: &str) -> Result<(), TestCaseError> {
        // Words for infinity and none are no numbers here.
        let expected: Option<f64> = text.parse().ok().filter(|v: &f64| !v.is_nan());
        let expected = expected.filter(|_| !text.contains(['i', 'n', 'I', 'N']));
        let found = whole(text, b'.');
        prop_assert_eq!(
            found.map(f64::to_bits),
            expected.map(f64::to_bits),
            "{}",
            text
        );
        let (comma, digits) = (text.replace('.', ","), text.split(['e', 'E']).next());
        if !text.contains(',') && !digits.is_some_and(|digits| digits.ends_with('.')) {
            prop_assert_eq!(
                whole(&comma, b',').map(f64::to_bits),
                found.map(f64::to_bits),
                "{}",
                text
            );
        }
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10_000))]

        #[test]
        fn numbers_read_to_the_last_bit_as_the_standard_library_reads_them(
            text in "[-+]?[0-9]{0,22}(\\.[0-9]{0,22})?([eE][-+]?[0-9]{0,4})?",
        ) {
            same(&text)?;
        }

        #[test]
        fn what_is_printed_reads_back_to_the_last_bit(bits in any::<u64>(), decimals in 0..20_usize) {
            let value = f64::from_bits(bits);
            prop_assume!(value.is_finite());
            same(&format!("{value}"))?;
            same(&format!("{value:e}"))?;
            same(&format!("{value:.decimals$e}"))?;
            same(&format!("{:.decimals$}", value % 1e6))?;
        }

        #[test]
        fn text_that_is_no_number_for_the_standard_library_is_none(text in "[-+0-9eE.,x ]{0,8}") {
            same(&text)?;
        }
    }

    #[test]
    fn a_number_ends_where_its_digits_end() {
        assert_eq!(prefix(b"1,25;3", b','), Some((1.25, b";3".as_slice())));
        assert_eq!(prefix(b"-0.5\r\n", b'.'), Some((-0.5, b"\r\n".as_slice())));
        assert_eq!(prefix(b"5,1", b'.'), Some((5.0, b",1".as_slice())));
        assert_eq!(
            whole("9007199254740993", b'.'),
            Some(9_007_199_254_740_992.0)
        );
        assert_eq!((whole("5.", b'.'), whole("5,", b',')), (Some(5.0), None));
        for none in ["", "-", ".", "e5", "1e", "1e+", "nan", "inf"] {
            assert_eq!(prefix(none.as_bytes(), b'.'), None, "{none}");
        }
        assert_eq!(
            whole("-0", b'.').map(f64::to_bits),
            Some((-0.0_f64).to_bits())
        );
    }
}
