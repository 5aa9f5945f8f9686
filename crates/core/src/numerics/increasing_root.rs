//! Root of an increasing function by Newton's or the secant method inside a bracket.
//!
//! For roots whose bracket is known beforehand: the ends are never evaluated, and a step that leaves
//! the bracket is replaced by bisection.

use serde::Serialize;

use super::RootError;

/// Largest number of evaluations: even pure bisection narrows any bracket of doubles to rounding with fewer than
/// this.
const MAX_EVALUATIONS: usize = 1100;
/// Evaluations after which every other step is a bisection: on a kink the steps may alternate without end.
const PLAIN_EVALUATIONS: usize = 30;

/// A solution with its evidence.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Solved {
    /// The solution.
    pub value: f64,
    /// The function at the last point evaluated, from which `value` is one step away: an upper
    /// bound of the residual that the step leaves.
    pub residual: f64,
    /// Evaluations of the function.
    pub iterations: usize,
}

/// Root of an increasing function by Newton's method, safeguarded by its bracket.
///
/// `function` returns value and slope. The function must not fall between `low` and `high` and must have
/// its root there. Ends when a step is at most `tolerance` of the value; Newton's error is then of the
/// order of the square of it.
///
/// # Errors
/// When the function is not a number, or bisection has not found the root.
///
/// ```
/// use asperity_core::numerics::newton_root;
/// let root = newton_root(|x| (x * x - 2.0, 2.0 * x), [0.0, 2.0], 2.0, 1e-8)?;
/// assert!((root.value - 2f64.sqrt()).abs() < 1e-15 && root.iterations <= 6);
/// # Ok::<(), asperity_core::numerics::RootError>(())
/// ```
pub fn newton_root(
    mut function: impl FnMut(f64) -> (f64, f64),
    bracket: [f64; 2],
    start: f64,
    tolerance: f64,
) -> Result<Solved, RootError> {
    search(|x, _| function(x), bracket, start, tolerance)
}

/// Root of an increasing function by the secant method, safeguarded by its bracket.
///
/// As [`newton_root`], with the slope from the last two points, at first `slope`.
///
/// # Errors
/// As [`newton_root`].
///
/// ```
/// use asperity_core::numerics::secant_root;
/// let root = secant_root(|x| x * x - 2.0, [0.0, 2.0], 1.5, 3.0, 1e-12)?;
/// assert!((root.value - 2f64.sqrt()).abs() < 1e-15 && root.iterations <= 7);
/// # Ok::<(), asperity_core::numerics::RootError>(())
/// ```
pub fn secant_root(
    mut function: impl FnMut(f64) -> f64,
    bracket: [f64; 2],
    start: f64,
    slope: f64,
    tolerance: f64,
) -> Result<Solved, RootError> {
    let mut slope = slope;
    let step = |x: f64, last: Option<(f64, f64)>| {
        let value = function(x);
        if let Some((before, at_before)) = last {
            let secant = (value - at_before) / (x - before);
            if secant.is_finite() && secant > 0.0 {
                slope = secant;
            }
        }
        (value, slope)
    };
    search(step, bracket, start, tolerance)
}

fn search(
    mut function: impl FnMut(f64, Option<(f64, f64)>) -> (f64, f64),
    [mut low, mut high]: [f64; 2],
    start: f64,
    tolerance: f64,
) -> Result<Solved, RootError> {
    let mut x = start.clamp(low.min(high), high.max(low));
    let mut last = None;
    let (mut is_low_seen, mut is_high_seen) = (false, false);
    for iterations in 1..=MAX_EVALUATIONS {
        let (residual, slope) = function(x, last);
        let failed = RootError::NotConverged {
            value: x,
            width: high - low,
            evaluations: iterations,
        };
        if residual.is_nan() {
            return Err(failed);
        }
        if residual == 0.0 {
            return Ok(Solved {
                value: x,
                residual,
                iterations,
            });
        }
        if residual < 0.0 {
            (low, is_low_seen) = (x, true);
        } else {
            (high, is_high_seen) = (x, true);
        }
        last = Some((x, residual));
        let newton = x - residual / slope;
        let is_slow = iterations > PLAIN_EVALUATIONS && iterations % 2 == 0;
        let is_inside = newton >= low && newton <= high && !is_slow;
        let next = if is_inside {
            newton
        } else {
            0.5 * (low + high)
        };
        let small = tolerance.max(2.0 * f64::EPSILON) * next.abs();
        if (next - x).abs() <= small || high - low <= small {
            // Bisection into an end that was never evaluated: the root lies beyond it, by more than rounding.
            let is_beyond = newton < low - small || newton > high + small;
            if is_beyond && !(is_low_seen && is_high_seen) {
                return Err(failed);
            }
            return Ok(Solved {
                value: next,
                residual,
                iterations,
            });
        }
        x = next;
    }
    Err(RootError::NotConverged {
        value: x,
        width: high - low,
        evaluations: MAX_EVALUATIONS,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steep_flat_and_kinked_functions_keep_to_the_bracket() {
        // Newton alone leaves for infinity in the first two.
        let steep = newton_root(
            |x: f64| (x.atan(), 1.0 / (1.0 + x * x)),
            [-50.0, 40.0],
            39.0,
            1e-9,
        )
        .unwrap();
        assert!(steep.value.abs() < 1e-12, "{steep:?}");
        let flat = newton_root(
            |x: f64| (x.powi(7) - 1e-7, 7.0 * x.powi(6)),
            [0.0, 1.0],
            0.0,
            1e-9,
        );
        assert!((flat.unwrap().value - 0.1).abs() < 1e-12);
        let kink = secant_root(
            |x: f64| if x < 0.3 { x - 0.3 } else { 50.0 * (x - 0.3) },
            [0.0, 1.0],
            1.0,
            1.0,
            1e-12,
        );
        assert!((kink.unwrap().value - 0.3).abs() < 1e-12);
    }

    #[test]
    fn steps_that_lead_to_and_fro_over_a_kink_end() {
        // √|x| with its sign: Newton's step from x leads to −x.
        let root = |x: f64| (x.signum() * x.abs().sqrt(), 0.5 / x.abs().sqrt());
        let computed = newton_root(|x| root(x - 0.3), [0.0, 1.0], 0.5, 1e-8).unwrap();
        assert!((computed.value - 0.3).abs() < 1e-8, "{computed:?}");
        assert!(computed.iterations < 150);
    }

    #[test]
    fn a_root_beyond_the_bracket_is_an_error() {
        assert!(newton_root(|x| (x - 2.0, 1.0), [0.0, 1.0], 0.5, 1e-9).is_err());
        assert!(secant_root(|x| x + 0.1, [0.0, 1.0], 0.5, 1.0, 1e-9).is_err());
    }

    #[test]
    fn a_function_without_value_is_an_error() {
        assert!(newton_root(|_| (f64::NAN, 1.0), [0.0, 1.0], 0.5, 1e-9).is_err());
    }
}
