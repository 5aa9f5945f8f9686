//! Decimal numbers from bytes, correctly rounded.
//!
//! value = m·10^e, with m the digits read as a whole number and e the exponent less the number of decimals.
//! Where m ≤ 2⁵³ and |e| ≤ 22 both m and 10^|e| are exact in binary, so that the one multiplication or
//! division rounds once, as it should (Clinger, How to read floating point numbers accurately, 1990).
//! All other numbers are left to the standard library, which reads the same text to the same bits.

/// Powers of ten that are exact in binary.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];
/// Powers of ten by which up to eight digits move the digits before them.
const TENS: [u64; 9] = [
    1,
    10,
    100,
    1_000,
    10_000,
    100_000,
    1_000_000,
    10_000_000,
    100_000_000,
];
/// Whole numbers up to here are exact in binary.
const MOST_EXACT: u64 = 1 << 53;
/// Digits that always fit 64 bits.
const MOST_DIGITS: usize = 19;

/// The number at the start of `bytes` with the decimal sign `point`, and how many bytes it takes.
#[inline]
pub(super) fn prefix(bytes: &[u8], point: u8) -> Option<(f64, usize)> {
    let negative = bytes.first() == Some(&b'-');
    let first = usize::from(negative || bytes.first() == Some(&b'+'));
    let (mut mantissa, mut at) = digits(bytes, first, 0);
    let (mut count, mut exponent) = (at - first, 0);
    if bytes.get(at) == Some(&point) {
        let after = at + 1;
        (mantissa, at) = decimals(bytes, after, mantissa);
        count += at - after;
        exponent = -((at - after) as i64);
    }
    if count == 0 {
        return None;
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let (power, end) = power(bytes, at + 1)?;
        exponent = exponent.saturating_add(power);
        at = end;
    }
    let scale = POWERS.get(exponent.unsigned_abs() as usize);
    let value = match scale {
        Some(scale) if count <= MOST_DIGITS && mantissa <= MOST_EXACT => {
            let m = mantissa as f64;
            let m = if negative { -m } else { m };
            if exponent < 0 { m / scale } else { m * scale }
        }
        _ => by_std(&bytes[..at], point)?,
    };
    Some((value, at))
}

/// The number that `text` is from end to end.
pub(super) fn whole(text: &str, point: u8) -> Option<f64> {
    let (value, used) = prefix(text.as_bytes(), point)?;
    (used == text.len()).then_some(value)
}

/// Appends the digits from `at` on to `mantissa`; with it the place after them.
fn digits(bytes: &[u8], mut at: usize, mut mantissa: u64) -> (u64, usize) {
    while let Some(digit) = bytes.get(at).map(|byte| byte.wrapping_sub(b'0'))
        && digit < 10
    {
        // Wraps beyond the digits that fit, which is then not used.
        mantissa = mantissa.wrapping_mul(10).wrapping_add(digit.into());
        at += 1;
    }
    (mantissa, at)
}

/// As [`digits`], up to eight at a time, for the many after a decimal sign.
#[inline]
fn decimals(bytes: &[u8], mut at: usize, mut mantissa: u64) -> (u64, usize) {
    while let Some(&word) = bytes.get(at..).and_then(|rest| rest.first_chunk::<8>()) {
        // Digits become 0 to 9; adding 0x76 sets the highest bit of what is more.
        let word = u64::from_le_bytes(word) ^ 0x3030_3030_3030_3030;
        let more = ((word & 0x7f7f_7f7f_7f7f_7f7f) + 0x7676_7676_7676_7676) | word;
        let count = (more & 0x8080_8080_8080_8080).trailing_zeros() / 8;
        if count == 0 {
            return (mantissa, at);
        }
        let value = eight_digits(word << (64 - 8 * count));
        mantissa = mantissa
            .wrapping_mul(TENS[count as usize])
            .wrapping_add(value);
        at += count as usize;
        if count < 8 {
            return (mantissa, at);
        }
    }
    digits(bytes, at, mantissa)
}

/// The number of eight digits, one a byte, the first in the lowest: pairs, then fours, then all.
fn eight_digits(word: u64) -> u64 {
    const EACH_FOURTH: u64 = 0x0000_00ff_0000_00ff;
    let pairs = word.wrapping_mul(10).wrapping_add(word >> 8);
    let first = (pairs & EACH_FOURTH).wrapping_mul(100 + (1_000_000 << 32));
    let second = ((pairs >> 16) & EACH_FOURTH).wrapping_mul(1 + (10_000 << 32));
    first.wrapping_add(second) >> 32
}

/// The power of ten after an "e", and the place after it.
fn power(bytes: &[u8], at: usize) -> Option<(i64, usize)> {
    let negative = bytes.get(at) == Some(&b'-');
    let first = at + usize::from(negative || bytes.get(at) == Some(&b'+'));
    let (value, end) = digits(bytes, first, 0);
    let value = if end - first <= MOST_DIGITS - 1 {
        value as i64
    } else {
        i64::MAX
    };
    (end > first).then_some((if negative { -value } else { value }, end))
}

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
        if !text.contains(',') {
            let comma = whole(&text.replace('.', ","), b',');
            prop_assert_eq!(comma.map(f64::to_bits), found.map(f64::to_bits), "{}", text);
        }
        Ok(())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

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
        assert_eq!(prefix(b"1,25;3", b','), Some((1.25, 4)));
        assert_eq!(prefix(b"-0.5\r\n", b'.'), Some((-0.5, 4)));
        assert_eq!(prefix(b"5,1", b'.'), Some((5.0, 1)));
        assert_eq!(
            prefix(b"9007199254740993", b'.'),
            Some((9_007_199_254_740_992.0, 16))
        );
        for none in ["", "-", ".", "e5", "1e", "1e+", "nan", "inf"] {
            assert_eq!(prefix(none.as_bytes(), b'.'), None, "{none}");
        }
        assert_eq!(
            whole("-0", b'.').map(f64::to_bits),
            Some((-0.0_f64).to_bits())
        );
    }
}
