//! Composite Gauss-Legendre integration over segments on which the integrand is smooth.

use std::num::NonZeroUsize;

use asperity_core::numerics;

/// Relative width below which a segment is a rounding error.
const MIN_SEGMENT: f64 = 1e-9;

/// Nodes and weights of the Gauss-Legendre rule on 0..1, in ascending order.
pub(crate) fn gauss_legendre(order: NonZeroUsize) -> Vec<(f64, f64)> {
    let rule = numerics::gauss_legendre(order);
    rule.iter()
        .map(|(node, weight)| (0.5 * (1.0 + node), 0.5 * weight))
        .collect()
}

/// `low`, `high` and the points of `inner` between them, in ascending order without duplicates.
pub(crate) fn breakpoints(low: f64, high: f64, inner: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let gap = MIN_SEGMENT * (high - low);
    let mut inner: Vec<f64> = inner
        .into_iter()
        .filter(|&x| x > low + gap && x < high - gap)
        .collect();
    inner.sort_by(f64::total_cmp);
    inner.dedup_by(|next, previous| *next - *previous < gap);
    let mut all = vec![low];
    all.extend(inner);
    all.push(high);
    all
}

/// ∫ f over the segments between neighbouring `breaks`, with `rule` on each.
pub(crate) fn integrate(
    breaks: &[f64],
    rule: &[(f64, f64)],
    mut function: impl FnMut(f64) -> f64,
) -> f64 {
    let mut sum = 0.0;
    for ends in breaks.windows(2) {
        let width = ends[1] - ends[0];
        for &(node, weight) in rule {
            sum += weight * width * function(ends[0] + width * node);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kink_at_a_breakpoint_costs_no_accuracy() {
        let breaks = breakpoints(-1.0, 2.0, [0.3, 5.0, 0.3, -1.0]);
        assert_eq!(breaks, [-1.0, 0.3, 2.0]);
        let rule = gauss_legendre(NonZeroUsize::MIN.saturating_add(1));
        let value = integrate(&breaks, &rule, |x| (x - 0.3).abs());
        // Two nodes are exact for cubics; round-off only.
        assert!((value - 0.5 * (1.3f64.powi(2) + 1.7f64.powi(2))).abs() < 1e-15);
    }
}
