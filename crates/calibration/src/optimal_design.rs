//! D-optimal choice of points by exchange (Fedorov).

use asperity_core::cite;
use asperity_core::numerics::Cholesky;
use nalgebra::DMatrix;

use crate::information::information;

/// Indices of `count` candidates that are D-optimal for the first `interest` variables, each at most `repeats` times.
///
/// ```text
/// max ln det (I_11 − I_12 I_22⁻¹ I_21),  I = I_prior + Σ J_kᵀ J_k             [D-optimal]
/// ```
///
/// A candidate holds the derivatives of its measurements in standard deviations, one row per measurement; the other
/// variables are nuisance terms. Points are added one by one and then exchanged until no exchange of a single point
/// improves the design (Fedorov).
///
/// ```
/// use asperity_calibration::optimal_design::d_optimal;
/// use nalgebra::DMatrix;
/// // A straight line over -1 .. 1: half of the points at either end.
/// let row = |t: f64| DMatrix::from_row_slice(1, 2, &[1.0, t]);
/// let candidates: Vec<_> = (0..=20).map(|k| row(-1.0 + 0.1 * f64::from(k))).collect();
/// let mut chosen = d_optimal(&candidates, 6, 6, 2, &DMatrix::zeros(2, 2));
/// chosen.sort();
/// assert_eq!(chosen, [0, 0, 0, 20, 20, 20]);
/// ```
#[must_use]
pub fn d_optimal(
    candidates: &[DMatrix<f64>],
    count: usize,
    repeats: usize,
    interest: usize,
    prior: &DMatrix<f64>,
) -> Vec<usize> {
    cite!("D-optimal");
    /// Gain of an exchange that is only round-off.
    const LEAST_GAIN: f64 = 1e-9;
    /// Largest number of rounds of exchanges; a few are usual.
    const MOST_ROUNDS: usize = 50;
    if candidates.is_empty() {
        return Vec::new();
    }
    let information_of: Vec<DMatrix<f64>> = candidates.iter().map(information).collect();
    let size = prior.nrows();
    // The first points leave variables undetermined: a weak prior makes the determinant finite and ranks them.
    let whiff = 1e-9
        * information_of
            .iter()
            .map(DMatrix::trace)
            .fold(f64::MIN_POSITIVE, f64::max);
    let base = prior + DMatrix::identity(size, size) * whiff;
    let value = |whole: &DMatrix<f64>| log_determinant(whole, interest);
    let best = |whole: &DMatrix<f64>, uses: &[usize]| {
        let free = (0..information_of.len()).filter(|k| uses[*k] < repeats);
        let ranked = free.map(|k| (k, value(&(whole + &information_of[k]))));
        ranked.max_by(|a, b| a.1.total_cmp(&b.1))
    };
    let mut whole = base;
    let mut chosen = Vec::with_capacity(count);
    let mut uses = vec![0; information_of.len()];
    while let Some((k, _)) = best(&whole, &uses).filter(|_| chosen.len() < count) {
        whole += &information_of[k];
        uses[k] += 1;
        chosen.push(k);
    }
    for _ in 0..MOST_ROUNDS {
        let mut has_changed = false;
        for slot in &mut chosen {
            let before = value(&whole);
            let without = &whole - &information_of[*slot];
            uses[*slot] -= 1;
            let better = best(&without, &uses).filter(|(_, after)| *after > before + LEAST_GAIN);
            if let Some((k, _)) = better {
                whole = without + &information_of[k];
                *slot = k;
                has_changed = true;
            }
            uses[*slot] += 1;
        }
        if !has_changed {
            break;
        }
    }
    chosen
}

/// ln det of the information on the first `interest` variables, with the others unknown.
#[must_use]
pub(crate) fn log_determinant(whole: &DMatrix<f64>, interest: usize) -> f64 {
    let (n, elements) = (whole.nrows(), whole.as_slice());
    let others = n - interest;
    // With the nuisance terms first, the other pivots are those of I_11 − I_12 I_22⁻¹ I_21.
    let place = |k: usize| if k < others { k + interest } else { k - others };
    let factor = Cholesky::new(n, |i, j| elements[place(i) + n * place(j)], 0.0);
    factor.map_or(f64::NEG_INFINITY, |factor| {
        let rows = factor.lower().skip(others);
        2.0 * rows.map(|row| row[row.len() - 1].ln()).sum::<f64>()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_is_measured_at_its_ends_and_its_middle() {
        let row = |t: f64| DMatrix::from_row_slice(1, 3, &[1.0, t, t * t]);
        let candidates: Vec<_> = (0..=40).map(|k| row(-1.0 + 0.05 * f64::from(k))).collect();
        let mut chosen = d_optimal(&candidates, 6, 6, 3, &DMatrix::zeros(3, 3));
        chosen.sort_unstable();
        assert_eq!(chosen, [0, 0, 20, 20, 40, 40]);
    }

    #[test]
    fn a_nuisance_offset_makes_a_slope_be_measured_at_both_ends() {
        // Interest in the slope alone; with a known offset any end would do.
        let row = |t: f64| DMatrix::from_row_slice(1, 2, &[t, 1.0]);
        let candidates: Vec<_> = (0..=10).map(|k| row(0.1 * f64::from(k))).collect();
        let mut chosen = d_optimal(&candidates, 4, 4, 1, &DMatrix::zeros(2, 2));
        chosen.sort_unstable();
        assert_eq!(chosen, [0, 0, 10, 10]);
        let known = DMatrix::from_row_slice(2, 2, &[0.0, 0.0, 0.0, 1e9]);
        assert_eq!(d_optimal(&candidates, 2, 2, 1, &known), [10, 10]);
        // Without repeats the next best.
        let mut apart = d_optimal(&candidates, 2, 1, 1, &known);
        apart.sort_unstable();
        assert_eq!(apart, [9, 10]);
        assert!(d_optimal(&[], 2, 2, 1, &known).is_empty());
    }
}
