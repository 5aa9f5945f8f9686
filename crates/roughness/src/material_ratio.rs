//! Material ratio (Abbott) curve and the Rk parameters.
//!
//! Source: ISO 13565-2:1996, without the height classes of instrument makers (whose values differ by 1 to 4 % from each
//! other). Quantised heights are first distributed over their steps.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | s_k | heights in descending order, k = 0 .. N−1 | m |
//! | Mr_k | material ratio at s_k, (k + ½)/N | % |
//! | m | 40 % of the points, round(0.4 N) | - |
//! | c(Mr) | the equivalent straight line | m |

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;
use crate::quantised::spread;

/// Fraction of the curve for the equivalent line (ISO 13565-2).
const WINDOW: f64 = 0.4;

/// Fit of the equivalent line through the flattest 40 % of the curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum Line {
    /// Least-squares line, as in the standard.
    #[default]
    LeastSquares,
    /// Line through the two end points, as in some instruments.
    Secant,
}

/// The Rk parameters.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct RkParameters {
    /// Core height.
    pub rk: Length,
    /// Reduced peak height.
    pub rpk: Length,
    /// Reduced pit depth.
    pub rvk: Length,
    /// Material ratio at the upper end of the core `[%]`.
    pub mr1: f64,
    /// Material ratio at the lower end of the core `[%]`.
    pub mr2: f64,
    /// Area of the peaks above the core, per length of the trace `[m]`.
    pub a1: Length,
    /// Area of the pits below the core, per length of the trace `[m]`.
    pub a2: Length,
    /// Height of the upper end of the core, c(0 %).
    pub upper: Length,
    /// Height of the lower end of the core, c(100 %).
    pub lower: Length,
    /// Material ratio at the start of the 40 % window `[%]`.
    pub window_start: f64,
    /// Fit of the line.
    pub line: Line,
}

/// The Rk parameters of `heights` `[m]` with the least-squares line.
///
/// # Errors
/// As [`rk_parameters_with`].
///
/// ```
/// use asperity_roughness::material_ratio::rk_parameters;
/// // A triangular profile has a straight curve without peaks and pits.
/// let heights: Vec<f64> = (0..2000).map(|i| f64::from(i) * 1e-9).collect();
/// let parameters = rk_parameters(&heights)?;
/// assert!((parameters.rk.si() - 2e-6).abs() < 1e-14);
/// assert!(parameters.rpk.si() < 1e-14 && parameters.rvk.si() < 1e-14);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn rk_parameters(heights: &[f64]) -> Result<RkParameters, RoughnessError> {
    rk_parameters_with(heights, Line::LeastSquares)
}

/// Rk = c(0) − c(100),  Rpk = 2 A₁/Mr1,  Rvk = 2 A₂/(100 − Mr2)                   [Rk-1]
///
/// c is the line through the 40 % of the curve with the smallest secant slope (the first such window); Mr1 and Mr2 are
/// the intersections of c(0) and c(100) with the curve; A₁ = (100/N) Σ max(s − c(0), 0), A₂ = (100/N) Σ max(c(100) − s,
/// 0).
///
/// # Errors
/// When there are fewer than ten heights, or one is not finite.
///
/// ```
/// use asperity_roughness::material_ratio::{Line, rk_parameters_with};
/// let heights: Vec<f64> = (0..1000).map(|i| (f64::from(i) * 0.1).sin() * 1e-6).collect();
/// let secant = rk_parameters_with(&heights, Line::Secant)?;
/// assert!(secant.rk.si() > 1.6e-6 && secant.mr2 < 80.0);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn rk_parameters_with(heights: &[f64], line: Line) -> Result<RkParameters, RoughnessError> {
    cite!("Rk-1");
    Ok(rk_of_curve(&curve(heights)?, line))
}

/// The Rk parameters with the least-squares line and with the secant.
pub(crate) fn rk_of_both_lines(heights: &[f64]) -> Result<[RkParameters; 2], RoughnessError> {
    let s = curve(heights)?;
    Ok([Line::LeastSquares, Line::Secant].map(|line| rk_of_curve(&s, line)))
}

/// The material ratio curve of at least ten heights; quantised heights are distributed over their steps.
pub(crate) fn curve(heights: &[f64]) -> Result<Vec<f64>, RoughnessError> {
    const MIN_POINTS: usize = 10;
    RoughnessError::at_least(heights.len(), MIN_POINTS, "the material ratio curve")?;
    Ok(spread(abbott_curve(heights)?))
}

/// The Rk parameters of a material ratio curve of at least ten points.
fn rk_of_curve(s: &[f64], line: Line) -> RkParameters {
    cite!("Rk-1");
    let n = s.len();
    let ratio = |k: usize| (k as f64 + 0.5) / n as f64 * 100.0;
    let m = (WINDOW * n as f64).round() as usize;
    let start = flattest_window(s, m);
    let (c0, c100) = equivalent_line(s, start, m, line);
    let share = 100.0 / n as f64;
    // Areas in height times percent; a triangle of base Mr1 and height Rpk has the area A₁.
    let above = s.iter().map(|s| s - c0).take_while(|s| *s > 0.0);
    let below = s.iter().rev().map(|s| c100 - s).take_while(|s| *s > 0.0);
    let a1 = share * above.fold(0.0, |sum, s| sum + s);
    let a2 = share * below.fold(0.0, |sum, s| sum + s);
    let mr1 = cut(s, c0, ratio);
    let mr2 = cut(s, c100, ratio);
    let reduced = |area: f64, base: f64| if base > 0.0 { 2.0 * area / base } else { 0.0 };
    RkParameters {
        rk: Length::from_si(c0 - c100),
        rpk: Length::from_si(reduced(a1, mr1)),
        rvk: Length::from_si(reduced(a2, 100.0 - mr2)),
        mr1,
        mr2,
        a1: Length::from_si(a1 / 100.0),
        a2: Length::from_si(a2 / 100.0),
        upper: Length::from_si(c0),
        lower: Length::from_si(c100),
        window_start: ratio(start),
        line,
    }
}

/// Material ratio curve: the heights `[m]` in falling order.
///
/// ```text
/// Mr_k = (k + ½)/N at the k-th highest point                                             [Rk-2]
/// ```
///
/// # Errors
/// When a height is not finite.
///
/// ```
/// let curve = asperity_roughness::material_ratio::abbott_curve(&[0.0, 2.0, 1.0])?;
/// assert_eq!(curve, [2.0, 1.0, 0.0]);
/// # Ok::<(), asperity_core::DomainError>(())
/// ```
pub fn abbott_curve(heights: &[f64]) -> Result<Vec<f64>, DomainError> {
    cite!("Rk-2");
    if let Some(&bad) = heights.iter().find(|z| !z.is_finite()) {
        return Err(DomainError {
            name: "height",
            value: bad,
            unit: "m",
            rule: "every height must be finite",
        });
    }
    Ok(falling(heights))
}

/// Material ratio (Rk-2) at the point `k` of a curve of `points` points \[%\].
///
/// ```
/// use asperity_roughness::material_ratio::material_ratio_percent;
/// assert_eq!([0, 1].map(|k| material_ratio_percent(k, 2)), [25.0, 75.0]);
/// ```
#[must_use]
pub fn material_ratio_percent(k: usize, points: usize) -> f64 {
    100.0 * (k as f64 + 0.5) / points as f64
}

/// Heights in descending order. They are sorted as integers of the same order, which takes half the time.
fn falling(heights: &[f64]) -> Vec<f64> {
    let mut keys: Vec<i64> = heights
        .iter()
        .map(|z| ordered(z.to_bits() as i64))
        .collect();
    keys.sort_unstable();
    let height = |key: i64| f64::from_bits(ordered(key) as u64);
    keys.into_iter().rev().map(height).collect()
}

/// Integer with the order of the number that has these bits; the mapping is its own inverse.
fn ordered(bits: i64) -> i64 {
    // The bits below the sign of negative numbers are flipped.
    bits ^ (((bits >> 63) as u64) >> 1) as i64
}

/// Places of the values from the lowest to the highest. They are sorted with the values as integers, which takes a third of
/// the time of a sort that looks each value up.
pub(crate) fn ascending(values: impl Iterator<Item = f64>) -> Vec<usize> {
    let key = |(place, z): (usize, f64)| (ordered(z.to_bits() as i64), place as u32);
    let mut keys: Vec<(i64, u32)> = values.enumerate().map(key).collect();
    keys.sort_unstable();
    keys.into_iter().map(|(_, place)| place as usize).collect()
}

/// i* = argmin (s_i − s_i+m), the first of several that are equal within rounding errors.
fn flattest_window(s: &[f64], m: usize) -> usize {
    // The curve of a symmetric profile has two windows that are equal within rounding errors.
    const TIE: f64 = 1e-12;
    let tie = TIE * (s[0] - s[s.len() - 1]);
    let (mut best, mut least) = (0, f64::INFINITY);
    for (i, (upper, lower)) in s.iter().zip(&s[m..]).enumerate() {
        let fall = upper - lower;
        if fall < least - tie {
            (best, least) = (i, fall);
        }
    }
    best
}

/// c(0 %) and c(100 %).
fn equivalent_line(s: &[f64], start: usize, m: usize, line: Line) -> (f64, f64) {
    let n = s.len() as f64;
    let window = &s[start..=start + m];
    let (slope, through, at) = match line {
        Line::LeastSquares => {
            let count = window.len() as f64;
            let middle = 0.5 * m as f64;
            let mean = window.iter().sum::<f64>() / count;
            let product: f64 = window
                .iter()
                .enumerate()
                .map(|(k, s)| (k as f64 - middle) * (s - mean))
                .sum();
            // Σ (k − m/2)² over k = 0 .. m.
            let square = count * (count * count - 1.0) / 12.0;
            (product / square, mean, start as f64 + middle)
        }
        Line::Secant => ((s[start + m] - s[start]) / m as f64, s[start], start as f64),
    };
    // Per point, from 0 % (half a point before the first) to 100 % (half a point after the last).
    (
        through + slope * (-0.5 - at),
        through + slope * (n - 0.5 - at),
    )
}

/// The material ratio at which the curve intersects `level`; 0 or 100 if it does not.
pub(crate) fn cut(s: &[f64], level: f64, ratio: impl Fn(usize) -> f64) -> f64 {
    let above = s.partition_point(|s| *s > level);
    if above == 0 {
        return 0.0;
    }
    if above == s.len() {
        return 100.0;
    }
    let (high, low) = (s[above - 1], s[above]);
    ratio(above - 1) + (high - level) / (high - low) * (ratio(above) - ratio(above - 1))
}
