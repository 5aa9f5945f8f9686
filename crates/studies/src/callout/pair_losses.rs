//! Losses of lots from the loss of one pair of each.

use asperity_core::cite;
use asperity_core::numerics::mean;
use nalgebra::{DMatrix, DVector};

use super::lots::{Lot, PAIRS, Values};

/// Constants of the regression.
const CONSTANTS: usize = 4;
/// Variance of the logarithm of a parameter below which it does not differ.
const LEAST: f64 = 1e-9;

/// A lot whose first pair was run.
pub(super) struct RunLot {
    pub lot: Lot,
    /// Loss of the pair at the height of the curve \[W\].
    pub loss_w: f64,
    /// Its loss at the height of the recipe \[W\], of some lots.
    pub present_w: Option<f64>,
}

/// ℓ_k1 = a + b·f_k1 + e_k,  L_k = a + b·⟨f_k⟩ + √(K/(K − 4)) e_k/√16                    `[Call-out-pairs]`
///
/// ℓ_k1 \[W\] is the loss of the first pair of lot k, f_kp the logarithms of Rpk, Rq and Rdq of its pair p (root mean squares of
/// both flanks), ⟨f_k⟩ their mean over the 16 pairs, and a, b the regression over the K lots by least squares. The rest e_k of one
/// pair stands for the mean over the rests of 16: it has √16 times its standard deviation, and 4 constants are fitted.
///
/// Returns the mean loss of the pairs of each lot, L_k, and the standard deviation of the e_k \[W\].
pub(super) fn losses_of_lots(run: &[RunLot]) -> (Vec<f64>, f64) {
    cite!("Call-out-pairs");
    let count = run.len() as f64;
    let first: Vec<Values> = run.iter().map(|run| run.lot.pairs[0]).collect();
    let centre = [0, 1, 2].map(|k| mean(first.iter().map(|values| values[k])));
    let row = |values: Values| {
        let [b, c, d] = [0, 1, 2].map(|k| values[k] - centre[k]);
        [1.0, b, c, d]
    };
    let rows = DMatrix::from_fn(run.len(), CONSTANTS, |k, i| row(first[k])[i]);
    let losses = DVector::from_iterator(run.len(), run.iter().map(|run| run.loss_w));
    let normal = rows.tr_mul(&rows).symmetric_eigen();
    // Parameters that do not differ have no coefficient.
    let inverse = |value: f64| {
        if value > LEAST * count {
            value.recip()
        } else {
            0.0
        }
    };
    let along = normal.eigenvectors.tr_mul(&rows.tr_mul(&losses));
    let constants = &normal.eigenvectors * normal.eigenvalues.map(inverse).component_mul(&along);
    let rests = &losses - rows * &constants;
    let fitted = (count / (count - CONSTANTS as f64)).sqrt();
    let of_lot = |(run, rest): (&RunLot, &f64)| {
        let means = [0, 1, 2].map(|k| mean(run.lot.pairs.iter().map(|values| values[k])));
        let predicted = row(means).into_iter().zip(&constants).map(|(z, b)| z * b);
        predicted.sum::<f64>() + fitted * rest / (PAIRS as f64).sqrt()
    };
    let found = run.iter().zip(&rests).map(of_lot).collect();
    (found, fitted * (rests.norm_squared() / count).sqrt())
}

#[cfg(test)]
mod tests {
    use asperity_core::numerics::{deviation, standard_normal_quantile};

    use super::*;
    use crate::sweep::{stream, uniform};

    impl RunLot {
        /// A lot without inspected traces.
        fn new(pairs: Vec<Values>, loss_w: f64) -> Self {
            let inspected = Vec::new();
            Self {
                lot: Lot { inspected, pairs },
                loss_w,
                present_w: None,
            }
        }
    }

    #[test]
    fn a_loss_of_the_parameters_and_a_rest_is_the_mean_of_all_pairs_within_its_error() {
        const REST: f64 = 4.0;
        let (mut off, mut ratios) = (Vec::new(), Vec::new());
        for seed in 0..40 {
            let mut random = stream(seed, 0, false);
            let mut normal = || standard_normal_quantile(uniform(&mut random));
            let (mut run, mut exact) = (Vec::new(), Vec::new());
            for _ in 0..100 {
                let of_lot = [0, 1, 2].map(|_| 0.1 * normal());
                let pairs: Vec<Values> = (0..PAIRS)
                    .map(|_| of_lot.map(|of_lot| of_lot + 0.1 * normal()))
                    .collect();
                let mut loss = |f: &Values| 500.0 + 90.0 * f[0] - 40.0 * f[2] + REST * normal();
                let losses: Vec<f64> = pairs.iter().map(&mut loss).collect();
                run.push(RunLot::new(pairs, losses[0]));
                exact.push(mean(losses));
            }
            let (found, rest) = losses_of_lots(&run);
            let scatters = [&found, &exact].map(|losses| deviation(losses).unwrap());
            ratios.push(scatters[0] / scatters[1]);
            assert!((rest / REST - 1.0).abs() < 0.3, "{rest}");
            off.push((mean(found) - mean(exact)) / (rest * (0.9375_f64 / 100.0).sqrt()));
        }
        // The scatter of the lots is that of the means over all pairs, to the 3 % of a slope by 100 lots over the root of 40.
        let ratio = mean(ratios);
        assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
        // Standard deviation of 40 standardised errors: 1 within three standard errors of 0.11.
        let spread = deviation(&off).unwrap();
        assert!(
            (spread - 1.0).abs() < 0.34 && mean(off).abs() < 0.5,
            "{spread}"
        );
    }

    #[test]
    fn parameters_that_do_not_differ_leave_the_mean() {
        let lot = |_| RunLot::new(vec![[0.5, 1.0, -2.0]; PAIRS], 500.0);
        let run: Vec<RunLot> = (0..20).map(lot).collect();
        let (found, error) = losses_of_lots(&run);
        assert!(error < 1e-9 && found.iter().all(|loss| (loss - 500.0).abs() < 1e-9));
    }
}
