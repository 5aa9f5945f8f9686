//! Exponential and logarithm without branches, calls or tables: a loop over many of them compiles to vector lanes, and gives the same
//! numbers on every machine.
//!
//! Both are within two units of the last digit of the exact values. The system's functions cost a call each and forbid lanes; the
//! library of vectors that the workspace uses has neither. Reduction by two parts of ln 2: Cody and Waite 1980.

use std::f64::consts::LOG2_E;

/// ln 2 in two parts: products of the first with whole numbers below 2²⁰ are exact.
const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
/// 1.5 · 2⁵²: added to a number it leaves the nearest whole number in the last bits.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// Range outside of which eˣ is its value at the end: 3e-308 and 8e307.
const EXPONENTS: [f64; 2] = [-708.0, 709.0];

/// eˣ of −708 ≤ x ≤ 709, the value at the end beyond; NaN of NaN.
///
/// ```text
/// eˣ = 2ⁿ eʳ,  n = ⌊x/ln 2⌉,  eʳ = Σ rᵏ/k!, k ≤ 13
/// ```
///
/// ```
/// use asperity_core::numerics::elementary::exp;
/// assert!((exp(1.0) / std::f64::consts::E - 1.0).abs() < 4e-16);
/// ```
#[inline(always)]
#[must_use]
pub fn exp(x: f64) -> f64 {
    /// 1/k! from k = 2 to 13.
    const SERIES: [f64; 12] = [
        0.5,
        1.0 / 6.0,
        1.0 / 24.0,
        1.0 / 120.0,
        1.0 / 720.0,
        1.0 / 5_040.0,
        1.0 / 40_320.0,
        1.0 / 362_880.0,
        1.0 / 3_628_800.0,
        1.0 / 39_916_800.0,
        1.0 / 479_001_600.0,
        1.0 / 6_227_020_800.0,
    ];
    let x = x.clamp(EXPONENTS[0], EXPONENTS[1]);
    let rounded = x * LOG2_E + ROUND;
    let n = rounded - ROUND;
    let r = (x - n * LN_2_HIGH) - n * LN_2_LOW;
    let power = 1.0 + (r + r * r * polynomial(&SERIES, r));
    // The last bits of the sum are n: into the exponent.
    f64::from_bits(power.to_bits().wrapping_add(rounded.to_bits() << 52))
}

/// ln x of a positive normal number; of others a number without meaning.
///
/// ```text
/// x = 2ⁿ m,  √½ ≤ m < √2,  ln m = 2 artanh s,  s = (m − 1)/(m + 1)
/// ```
///
/// ```
/// use asperity_core::numerics::elementary::ln;
/// assert!((ln(10.0) / std::f64::consts::LN_10 - 1.0).abs() < 4e-16);
/// ```
#[inline(always)]
#[must_use]
pub fn ln(x: f64) -> f64 {
    /// 2/(2 k + 1) from k = 1 to 10, of artanh, then nothing.
    const SERIES: [f64; 12] = [
        2.0 / 3.0,
        2.0 / 5.0,
        2.0 / 7.0,
        2.0 / 9.0,
        2.0 / 11.0,
        2.0 / 13.0,
        2.0 / 15.0,
        2.0 / 17.0,
        2.0 / 19.0,
        2.0 / 21.0,
        0.0,
        0.0,
    ];
    /// Bits of √½, and of 1 less √½: the sum of x with the second has the exponent bits of 2ⁿ.
    const ROOT: u64 = 0x3fe6_a09e_667f_3bcd;
    const TO_EXPONENT: u64 = 0x3ff0_0000_0000_0000 - ROOT;
    const MANTISSA: u64 = 0x000f_ffff_ffff_ffff;
    /// Bits of [`ROUND`], less the 1023 that the exponent bits of 1 are.
    const NUMBER: u64 = 0x4338_0000_0000_0000 - 1023;
    let shifted = x.to_bits().wrapping_add(TO_EXPONENT);
    let n = f64::from_bits((shifted >> 52).wrapping_add(NUMBER)) - ROUND;
    let m = f64::from_bits((shifted & MANTISSA).wrapping_add(ROOT));
    let f = m - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let sum = polynomial(&SERIES, z);
    // ln m = f − s (f − s² Σ): the largest term is exact.
    n * LN_2_HIGH + (f - (s * (f - z * sum) - n * LN_2_LOW))
}

/// Σ cₖ xᵏ, in pairs (Estrin): a processor adds several at a time, where Horner's scheme waits for each.
#[inline(always)]
fn polynomial(c: &[f64; 12], x: f64) -> f64 {
    let square = x * x;
    let fourth = square * square;
    let of_four = |k: usize| (c[k] + c[k + 1] * x) + (c[k + 2] + c[k + 3] * x) * square;
    of_four(0) + (of_four(4) + of_four(8) * fourth) * fourth
}

/// ln(1 + x) of x ≥ 0 below 10³⁰⁰, exact to its last digits for small x, too.
#[inline(always)]
#[must_use]
pub fn ln_1p(x: f64) -> f64 {
    let sum = 1.0 + x;
    // What rounding took from the sum.
    ln(sum) + (x - (sum - 1.0)) / sum
}

/// arsinh x of 0 ≤ x ≤ 10¹⁵⁰, with `root` = √(1 + x²).
#[inline(always)]
#[must_use]
pub fn arsinh(x: f64, root: f64) -> f64 {
    ln_1p(x + x * x / (1.0 + root))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_agree_with_the_standard_library_to_the_last_digits() {
        let close = |found: f64, expected: f64, at: f64| {
            let error = (found - expected).abs() / expected.abs().max(f64::MIN_POSITIVE);
            assert!(error < 5e-16, "{at}: {found} {expected}");
        };
        for k in -70_800..=70_900 {
            let x = 0.01 * f64::from(k) + 1e-3 * f64::from(k).sin();
            let x = x.clamp(EXPONENTS[0], EXPONENTS[1]);
            close(exp(x), x.exp(), x);
            let y = x.exp();
            if (x.abs() > 1e-3) && y.is_normal() {
                close(ln(y), y.ln(), y);
            }
        }
        for k in -30_000..=30_000 {
            // Next to 1, where the logarithm vanishes.
            let x = 1.0 + 1e-5 * f64::from(k);
            let error = (ln(x) - x.ln()).abs();
            assert!(error <= 3e-16 * x.ln().abs(), "{x}");
            let y = 10_f64.powf(0.01 * f64::from(k) - 5.0).min(1e299);
            if y > 1e-300 {
                close(ln_1p(y), y.ln_1p(), y);
            }
            if (1e-300..1e150).contains(&y) {
                close(arsinh(y, (1.0 + y * y).sqrt()), y.asinh(), y);
            }
        }
        assert_eq!((exp(0.0), ln(1.0), ln_1p(0.0)), (1.0, 0.0, 0.0));
        assert!(exp(f64::NAN).is_nan());
        assert!(exp(-1e9) < 1e-307 && exp(1e9) > 1e307 && exp(1e9).is_finite());
    }
}
