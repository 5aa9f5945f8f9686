//! A bracketed root, with evidence.

use crate::message_number::number;

/// A root with what is known about it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    /// Root of the function, to the requested width.
    pub value: f64,
    /// The function there.
    pub residual: f64,
    /// Evaluations of the function.
    pub evaluations: usize,
}

/// Errors of a root search.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RootError {
    /// The ends have values of the same sign, or one that is not a number.
    #[error("no sign change between {low} (value {at_low}) and {high} (value {at_high})", low = number(*low), at_low = number(*at_low), high = number(*high), at_high = number(*at_high))]
    NotBracketed {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
        /// Function at the lower end.
        at_low: f64,
        /// Function at the upper end.
        at_high: f64,
    },
    /// The evaluations allowed were used up.
    #[error(
        "the root is only known to lie within {width} of {value} after {evaluations} evaluations", width = number(*width), value = number(*value))]
    NotConverged {
        /// Best value.
        value: f64,
        /// Width of the last bracket.
        width: f64,
        /// Evaluations used.
        evaluations: usize,
    },
}

/// The root of `function` between `low` and `high`, to an absolute width of `tolerance`.
///
/// Regula falsi with the Illinois rule, safeguarded by bisection: superlinear on smooth functions,
/// and never slower than bisection by more than a factor two.
///
/// # Errors
/// When the ends do not bracket a root, or 200 evaluations do not suffice.
///
/// ```
/// let root = asperity_core::numerics::find_root(|x| x * x - 2.0, 0.0, 2.0, 1e-14)?;
/// assert!((root.value - 2f64.sqrt()).abs() < 1e-14);
/// # Ok::<(), asperity_core::numerics::RootError>(())
/// ```
pub fn find_root(
    mut function: impl FnMut(f64) -> f64,
    low: f64,
    high: f64,
    tolerance: f64,
) -> Result<Root, RootError> {
    const MOST: usize = 200;
    let (mut a, mut b) = (low, high);
    let (mut fa, mut fb) = (function(a), function(b));
    let mut evaluations = 2;
    for (x, f) in [(a, fa), (b, fb)] {
        if f == 0.0 {
            return Ok(Root {
                value: x,
                residual: 0.0,
                evaluations,
            });
        }
    }
    let is_bracketed = fa * fb < 0.0;
    if !is_bracketed {
        return Err(RootError::NotBracketed {
            low,
            high,
            at_low: fa,
            at_high: fb,
        });
    }
    // `b` is always the latest point; wa, wb are the values with the Illinois halving.
    let (mut wa, mut wb) = (fa, fb);
    let mut bisect = false;
    while evaluations < MOST {
        let width = (b - a).abs();
        if width <= tolerance.max(2.0 * f64::EPSILON * b.abs()) {
            let (value, residual) = if fa.abs() < fb.abs() {
                (a, fa)
            } else {
                (b, fb)
            };
            return Ok(Root {
                value,
                residual,
                evaluations,
            });
        }
        let secant = b - wb * (b - a) / (wb - wa);
        let inside = secant > a.min(b) && secant < a.max(b);
        let mut x = if bisect || !inside {
            0.5 * (a + b)
        } else {
            secant
        };
        // A step shorter than the tolerance would creep; step over the root instead.
        let least = 0.5 * tolerance;
        if (x - b).abs() < least {
            x = b + least.copysign(a - b);
        }
        let fx = function(x);
        evaluations += 1;
        if fx == 0.0 {
            return Ok(Root {
                value: x,
                residual: 0.0,
                evaluations,
            });
        }
        if fx * fb < 0.0 {
            (a, fa, wa) = (b, fb, fb);
        } else {
            wa *= 0.5;
        }
        (b, fb, wb) = (x, fx, fx);
        bisect = (b - a).abs() > 0.5 * width && !bisect;
    }
    Err(RootError::NotConverged {
        value: b,
        width: (b - a).abs(),
        evaluations,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hard_roots_are_found_within_the_width() {
        type Case = (fn(f64) -> f64, f64, f64, f64);
        let cases: [Case; 4] = [
            (|x| x.powi(9), -1.0, 1.5, 0.0),
            (|x| x.exp() - 1e4, 0.0, 100.0, 1e4f64.ln()),
            (
                |x| (x - 0.3).signum() * (x - 0.3).abs().sqrt(),
                0.0,
                1.0,
                0.3,
            ),
            (|x| x.tan() - x - 0.01, 0.0, 1.4, 0.307_4),
        ];
        for (k, (f, low, high, expected)) in cases.into_iter().enumerate() {
            let root = find_root(f, low, high, 1e-12).unwrap();
            let tolerance = if k == 3 { 1e-2 } else { 1e-10 };
            assert!(
                (root.value - expected).abs() < tolerance,
                "case {k}: {root:?}"
            );
            assert!(root.evaluations < 100, "case {k}: {root:?}");
        }
    }

    #[test]
    fn no_sign_change_is_an_error() {
        assert!(find_root(|x| x * x + 1.0, -1.0, 1.0, 1e-9).is_err());
        assert!(find_root(|_| f64::NAN, -1.0, 1.0, 1e-9).is_err());
    }
}
