//! Displacement of a half-plane by uniform pressure on a strip.
//!
//! Source: Johnson 1985, eq. 2.30; the paper's eq. 2 with its misprint corrected. Plane strain.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | x | distance from the middle of the strip | m |
//! | a | half width of the strip (half a cell) | m |
//! | C | kernel: u = C·p/(π·E*) is the displacement of both bodies together | m |
//! | C₀ | constant of the datum | m |
//! | D | datum distance, at which the displacement by one strip is zero | m |
//! | r = x/a, n, L | distance in half cells, cells in a period, period | -, -, m |
//!
//! The textbook form is a difference of two large numbers and loses log₁₀ r digits; the forms here
//! are accurate at any distance. C is determined up to the constant C₀: without a datum only
//! differences of displacement are defined.

use std::f64::consts::{LN_2, PI};

use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};

use crate::error::ContactError;

/// Distance in half cells below which the textbook form is accurate.
const NEAR: f64 = 1.5;
/// Distance in half cells from which four terms of the series are exact: the fifth is 64⁻¹⁰/55.
const FAR: f64 = 64.0;

/// C(x) = (x−a)·ln[((x−a)/a)²] − (x+a)·ln[((x+a)/a)²] + C₀, here with C₀ = C(0) = 0      `[P2]`
///
/// Evaluated for r = |x|/a ≥ 1.5 as C/a = −4·ln r + 2·[(r−1)·ln(1 − 1/r) − (r+1)·ln(1 + 1/r)].
///
/// # Errors
/// When the half cell is not positive or the position is not finite.
///
/// ```
/// use asperity_contact::strip_kernel::strip_kernel;
/// let kernel = strip_kernel("2 mm".parse()?, "1 mm".parse()?)?;
/// assert!((kernel.si() + 6e-3 * 3f64.ln()).abs() < 1e-17);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn strip_kernel(position: Length, half_cell: Length) -> Result<Length, ContactError> {
    cite!("P2");
    let x = DomainError::finite("position", position)?;
    let a = DomainError::positive("half cell", half_cell)?;
    Ok(Length::from_si(a * strip(x.abs() / a)))
}

/// C₀ = −C(D)                                                                          [Datum-1]
///
/// Constant with which the kernel is zero at the distance D.
///
/// # Errors
/// When the datum distance or the half cell is not positive.
///
/// ```
/// use asperity_contact::strip_kernel::{datum_constant, strip_kernel};
/// let (distance, half_cell) = ("1.2 mm".parse()?, "150 nm".parse()?);
/// let constant = datum_constant(distance, half_cell)?;
/// assert_eq!((strip_kernel(distance, half_cell)? + constant).si(), 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn datum_constant(datum: Length, half_cell: Length) -> Result<Length, ContactError> {
    cite!("Datum-1");
    DomainError::positive("datum distance", datum)?;
    Ok(-strip_kernel(datum, half_cell)?)
}

/// C/a at r = |x|/a half cells, zero at r = 0.
pub(crate) fn strip(r: f64) -> f64 {
    if r < NEAR {
        let term = |s: f64| if s == 0.0 { 0.0 } else { s * (s * s).ln() };
        term(r - 1.0) - term(r + 1.0)
    } else if r < FAR {
        let e = 1.0 / r;
        -4.0 * r.ln() + 2.0 * ((r - 1.0) * (-e).ln_1p() - (r + 1.0) * e.ln_1p())
    } else {
        far_strip(r, r.ln())
    }
}

/// C/a at r ≥ `FAR` half cells; `ln` is the logarithm of r.
fn far_strip(r: f64, ln: f64) -> f64 {
    // The bracket in `strip` is −2 + Σ r^(−2k)/(k·(2k+1)).
    let q = 1.0 / (r * r);
    let series = q * (1.0 / 3.0 + q * (1.0 / 10.0 + q * (1.0 / 21.0 + q / 36.0)));
    -4.0 * ln - 4.0 + 2.0 * series
}

/// C/a at distances of 0, 1, … `points` − 1 cells, with C(0) = 0.
pub(crate) fn strip_column(points: usize) -> Vec<f64> {
    cite!("P2");
    strips(points)
}

fn strips(points: usize) -> Vec<f64> {
    // The logarithm of an even distance is the logarithm of half the distance plus ln 2.
    let mut logarithms = Vec::with_capacity(points / 2 + 1);
    let value = |k: usize| {
        let r = 2.0 * k as f64;
        let ln = match k {
            1.. if k.is_multiple_of(2) => logarithms[k / 2] + LN_2,
            _ => r.ln(),
        };
        if k <= points / 2 {
            logarithms.push(ln);
        }
        if r < FAR { strip(r) } else { far_strip(r, ln) }
    };
    (0..points).map(value).collect()
}

/// Nodes ≥ 0 and weights of the Gauss-Legendre rule of two points on −1..1 (Abramowitz and Stegun 1964,
/// table 25.4).
const GAUSS_2: &[(f64, f64)] = &[(0.577_350_269_189_625_8, 1.0)];
/// Nodes ≥ 0 and weights of the rule of five points.
const GAUSS_5: &[(f64, f64)] = &[
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];

/// Points of a period from which Gauss's rule of five points is exact over a whole cell.
const EXACT_PERIOD: usize = 16;
/// Points of a period from which Gauss's rule of two points is exact: with the half cell ε = π/(2n) of
/// the argument its error is ε⁴/135 times a fourth derivative of at most 2, below 1e-18.
const FINE_PERIOD: usize = 1 << 14;
/// Largest number of points of a column: 800 MB.
const MOST_POINTS: usize = 100_000_000;

/// C(x) = (L/π)·[Cl₂(2π(x+a)/L) − Cl₂(2π(x−a)/L)] at x = k·2a, in units of a       [Periodic-1]
///
/// Kernel of a strip and all its images with period L = `points`·2a, without mean; Cl₂ is Clausen's
/// function. The kernel equals −2·∫ ln|2 sin(πs/L)| ds over the cell. It is evaluated as the kernel of
/// the single strip plus the smooth remainder −2·∫ ln[sin(πs/L)/(πs/L)] ds by Gauss's rule, which
/// avoids the difference of two nearly equal values of Cl₂ and is exact except for round-off: over
/// whole cells from 16 points, over parts of them for shorter periods.
///
/// ```
/// use asperity_contact::strip_kernel::periodic_column;
/// let column = periodic_column(16)?;
/// assert!(column.iter().sum::<f64>().abs() < 1e-12);
/// assert_eq!(column[1], column[15]);
/// assert!(periodic_column(0).is_err());
/// # Ok::<(), asperity_contact::ContactError>(())
/// ```
///
/// # Errors
/// When there is no point, or there are more than 10⁸.
pub fn periodic_column(points: usize) -> Result<Vec<f64>, ContactError> {
    let rule = "must be 1 to 100000000";
    let is_column = (1..=MOST_POINTS).contains(&points);
    DomainError::require(is_column, "points", points as f64, "-", rule)?;
    Ok(column_of_period(points))
}

/// The column of [`periodic_column`] for a valid number of points.
pub(crate) fn column_of_period(points: usize) -> Vec<f64> {
    cite!("Periodic-1");
    let mut column = strips(points / 2 + 1);
    for (k, value) in column.iter_mut().enumerate() {
        *value += periodic_rest(k as f64, points);
    }
    column.extend_from_within(1..points.div_ceil(2));
    column[points / 2 + 1..].reverse();
    column
}

/// Contribution of the images to the kernel at a distance of `cells`, in a period of `points` cells.
pub(crate) fn periodic_rest(cells: f64, points: usize) -> f64 {
    let (n, r) = (points as f64, 2.0 * cells);
    // In short periods the images are near: panels of a 32nd of the period are exact except for round-off.
    let panels = if points < EXACT_PERIOD {
        (2 * EXACT_PERIOD).div_ceil(points)
    } else {
        1
    };
    let rule = if points < FINE_PERIOD {
        GAUSS_5
    } else {
        GAUSS_2
    };
    let width = 1.0 / panels as f64;
    let rest: f64 = (0..panels)
        .map(|panel| {
            let middle = r - 1.0 + width * (2 * panel + 1) as f64;
            width
                * gauss(rule, |node| {
                    ln_sinc(PI * (middle + width * node) / (2.0 * n))
                })
        })
        .sum();
    4.0 - 4.0 * (PI / n).ln() - 2.0 * rest
}

/// ∫ f over −1..1 by a Gauss rule.
fn gauss(rule: &[(f64, f64)], f: impl Fn(f64) -> f64) -> f64 {
    let term = |&(node, weight): &(f64, f64)| {
        weight
            * if node == 0.0 {
                f(0.0)
            } else {
                f(-node) + f(node)
            }
    };
    rule.iter().map(term).sum()
}

fn ln_sinc(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { (x.sin() / x).ln() }
}

/// u_q = 2·p_q/(E*·|q|), in units of a/(π·E*) at wave number q = 2π·`wave`/L; no mean  [Periodic-2]
///
/// ```
/// use asperity_contact::strip_kernel::spectral_symbol;
/// assert_eq!(spectral_symbol(1, 64), 128.0);
/// assert_eq!(spectral_symbol(0, 64), 0.0);
/// ```
pub fn spectral_symbol(wave: usize, points: usize) -> f64 {
    cite!("Periodic-2");
    if wave == 0 {
        0.0
    } else {
        2.0 * points as f64 / wave as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_kernel_has_all_digits_at_any_distance() {
        // Textbook form with 50 digits (mpmath).
        let expected = [
            (0.5, -0.523_248_143_764_547_8),
            (1.0, -2.772_588_722_239_781),
            (2.0, -6.591_673_732_008_658),
            (4.0, -9.502_705_392_332_346),
            (63.0, -20.572_370_924_446_645),
            (64.0, -20.635_369_561_099_706),
            (130.0, -23.470_098_353_390_3),
            (2e4, -43.613_950_208_477_846),
            (2e6, -62.034_630_954_096_71),
        ];
        for (r, value) in expected {
            assert!((strip(r) / value - 1.0).abs() < 4e-16, "{r}: {}", strip(r));
            let there = Length::from_si(-r * 1e-7);
            let kernel = strip_kernel(there, Length::from_si(1e-7)).unwrap();
            assert!((kernel.si() / (value * 1e-7) - 1.0).abs() < 1e-14);
        }
        assert_eq!(strip(0.0), 0.0);
    }

    #[test]
    fn a_column_holds_the_kernel_at_every_distance() {
        for (k, value) in strip_column(70_001).into_iter().enumerate() {
            let expected = strip(2.0 * k as f64);
            assert!((value - expected).abs() <= 2e-15 * expected.abs(), "{k}");
        }
        assert!(strip_column(0).is_empty());
    }

    #[test]
    fn the_kernel_falls_with_the_distance_and_vanishes_at_the_datum() {
        let column = strip_column(100);
        assert!(column.windows(2).all(|pair| pair[1] < pair[0]));
        let (datum, half) = (Length::from_si(1.2e-3), Length::from_si(1.5e-7));
        let constant = datum_constant(datum, half).unwrap();
        assert_eq!((strip_kernel(datum, half).unwrap() + constant).si(), 0.0);
        let nearer = strip_kernel(datum / 2.0, half).unwrap() + constant;
        assert!(nearer.si() > 0.0);
        assert!(datum_constant(Length::from_si(0.0), half).is_err());
        assert!(strip_kernel(Length::from_si(f64::NAN), half).is_err());
        assert!(strip_kernel(datum, Length::from_si(0.0)).is_err());
    }

    #[test]
    fn the_periodic_kernel_is_the_difference_of_clausen_functions() {
        // (2n/π)·[Cl₂(π(2k+1)/n) − Cl₂(π(2k−1)/n)] with 50 digits (mpmath).
        let expected = [
            (16, 0, 10.513_577_599_848_52),
            (16, 1, 3.947_655_705_539_034),
            (16, 2, 1.114_282_076_430_014_3),
            (16, 5, -2.025_031_282_198_960_6),
            (16, 8, -2.766_156_994_042_3),
            (1024, 0, 27.146_968_201_910_69),
            (1024, 1, 20.555_300_744_830_475),
            (1024, 8, 12.059_622_140_424_063),
            (1024, 512, -2.772_587_153_508_04),
            (FINE_PERIOD, 0, 38.237_322_570_001_96),
            (FINE_PERIOD, 1, 31.645_648_862_504_725),
            (FINE_PERIOD, 100, 13.044_314_887_882_581),
            (FINE_PERIOD, 8192, -2.772_588_716_111_924_3),
        ];
        for (points, k, value) in expected {
            // Differences of terms of the size of 4·ln n.
            let column = column_of_period(points);
            assert_eq!(column[k], column[(points - k) % points]);
            let error = column[k] - value;
            assert!(
                error.abs() < 1e-14 * (points as f64).ln(),
                "{points} {k}: {error:e}"
            );
        }
    }

    #[test]
    fn the_shortest_periods_are_exact_too() {
        // (8/π)·G and (12/π)·Cl₂(π/3), with Catalan's constant G = 0.91596… and Cl₂(π/3) = 1.01494…
        let two = 8.0 / PI * 0.915_965_594_177_219;
        let three = 12.0 / PI * 1.014_941_606_409_653_6;
        for (found, expected) in [
            (column_of_period(2), vec![two, -two]),
            (column_of_period(3), vec![three, -0.5 * three, -0.5 * three]),
        ] {
            for (value, exact) in found.iter().zip(&expected) {
                assert!((value - exact).abs() < 4e-15, "{found:?} {expected:?}");
            }
        }
        for points in 4..40 {
            let column = column_of_period(points);
            // The sum over a period is that of the mean, which is zero.
            assert!(column.iter().sum::<f64>().abs() < 1e-13, "{points}");
        }
    }

    #[test]
    fn long_waves_are_as_soft_on_strips_as_on_the_continuum() {
        let points = 512_usize;
        let column = column_of_period(points);
        for (wave, allowed) in [(1, 1e-4), (8, 1e-3), (128, 0.05), (256, 0.17)] {
            let angle = std::f64::consts::TAU * wave as f64 / points as f64;
            let symbol: f64 = (0..points)
                .map(|k| column[k] * (angle * k as f64).cos())
                .sum();
            // The ratio is 0.959 at a quarter of the sampling rate and 1.166 at half of it.
            let ratio = symbol / spectral_symbol(wave, points);
            assert!((ratio - 1.0).abs() < allowed, "{wave}: {ratio}");
        }
        let mean: f64 = column.iter().sum();
        assert!(mean.abs() < 1e-10);
    }

    #[test]
    fn a_column_of_no_point_or_of_more_than_memory_holds_is_refused() {
        for points in [0, MOST_POINTS + 1, usize::MAX] {
            let error = periodic_column(points).unwrap_err().to_string();
            assert!(error.contains("must be 1 to 100000000"), "{error}");
        }
        assert_eq!(periodic_column(1).unwrap().len(), 1);
    }
}
