//! Nodes and weights of the Gauss-Legendre rule.

use std::borrow::Cow;
use std::f64::consts::PI;
use std::num::NonZeroUsize;
use std::sync::OnceLock;

/// Highest order whose rule is stored.
const STORED: usize = 64;

/// Steps of Newton's method to round-off, from estimates with an error below a tenth of the distance of the nodes.
const STEPS: usize = 6;

/// Nodes and weights of the Gauss-Legendre rule on −1..1, in ascending order (Abramowitz and Stegun 25.4.29).
///
/// ```text
/// P_n(x_k) = 0,  w_k = 2/((1 − x_k²) P_n′(x_k)²)
/// ```
///
/// ```
/// use asperity_core::numerics::gauss_legendre;
/// let three = gauss_legendre(3.try_into()?);
/// let fourth_moment: f64 = three.iter().map(|(x, weight)| weight * x.powi(4)).sum();
/// assert!((fourth_moment - 0.4).abs() < 1e-15);
/// # Ok::<(), std::num::TryFromIntError>(())
/// ```
pub fn gauss_legendre(order: NonZeroUsize) -> Cow<'static, [(f64, f64)]> {
    static RULES: [OnceLock<Vec<(f64, f64)>>; STORED] = [const { OnceLock::new() }; STORED];
    match RULES.get(order.get() - 1) {
        Some(rule) => Cow::Borrowed(rule.get_or_init(|| computed(order.get()))),
        None => Cow::Owned(computed(order.get())),
    }
}

fn computed(n: usize) -> Vec<(f64, f64)> {
    let pair = |k: usize| {
        // The leading term of the node for large n.
        let mut x = -(PI * (k as f64 + 0.75) / (n as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..STEPS {
            let value;
            [value, slope] = legendre(n, x);
            x -= value / slope;
        }
        (x, 2.0 / ((1.0 - x) * (1.0 + x) * slope * slope))
    };
    (0..n).map(pair).collect()
}

/// Legendre polynomial P_n and its derivative at `x`, inside −1..1.
fn legendre(n: usize, x: f64) -> [f64; 2] {
    let (mut before, mut value) = (0.0, 1.0);
    for k in 0..n {
        let k = k as f64;
        let next = ((2.0 * k + 1.0) * x * value - k * before) / (k + 1.0);
        (before, value) = (value, next);
    }
    let slope = n as f64 * (before - x * value) / ((1.0 - x) * (1.0 + x));
    [value, slope]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_rule_is_exact_for_the_powers_that_it_has_nodes_for() {
        for order in [1, 2, 5, 16, 64, 65] {
            let rule = gauss_legendre(NonZeroUsize::new(order).unwrap());
            assert!(rule.is_sorted_by(|a, b| a.0 < b.0));
            for power in (0..2 * order as i32).step_by(2) {
                let terms = rule.iter().map(|(x, weight)| weight * x.powi(power));
                let moment = 2.0 / f64::from(power + 1);
                assert!((terms.sum::<f64>() - moment).abs() < 1e-14);
            }
        }
    }
}
