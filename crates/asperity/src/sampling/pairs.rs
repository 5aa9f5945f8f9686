//! Mean over all pairs of sampled teeth, and its standard error.
//!
//! Variance components of two crossed random factors, each pair seen once; degrees of freedom after Satterthwaite 1946.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | P_ij | loss of tooth i of the pinion on tooth j of the wheel | W |
//! | n₁, n₂ | teeth sampled of pinion and wheel | - |
//! | V₁, V₂ | variance of the row means and of the column means | W² |
//! | M | mean square of the residuals P_ij − P_i· − P_·j + P_·· | W² |
//! | d | degrees of freedom | - |
//! | SE, SE_g | standard error of the mean over the pairs, and of generated flanks | W |
//! | s₁, s₂ | standard deviations between teeth, √max(V₁ − M/n₂, 0) and √max(V₂ − M/n₁, 0) | W |
//!
//! Where one flank has a single trace, its part is not in the error, which is then a lower bound.

use asperity_case::flanks::surfaces::{LikeMeasured, Surfaces};
use asperity_core::cite;
use asperity_core::numerics::student_t_quantile;

use crate::result::PairSampling;

/// Confidence of the interval of the mean.
const CONFIDENCE: f64 = 0.95;

/// Standard error of the mean of `losses`, tooth by tooth of the pinion, each on all `teeth[1]` of the wheel.
///
/// ```text
/// SE² = max(V₁ − M/n₂, 0)/n₁ + max(V₂ − M/n₁, 0)/n₂ + M/(n₁ n₂)              [Between-traces]
/// d = (V₁/n₁ + V₂/n₂)²/[(V₁/n₁)²/(n₁ − 1) + (V₂/n₂)²/(n₂ − 1)],  ± t(0.95, d) SE
/// ```
///
/// With n₂ = 1 these are V₁/n₁ and n₁ − 1. None unless there are n₁·n₂ losses and one n is at least 2.
///
/// ```
/// use asperity::uncertainty::pair_sampling;
/// let found = pair_sampling(&[1.0, 3.0, 5.0, 7.0], [2, 2]);
/// // Row means 2 and 6, column means 3 and 5, nothing left over: SE² = 8/2 + 2/2.
/// assert!(found.is_some_and(|found| (found.standard_error_w - 5.0_f64.sqrt()).abs() < 1e-12));
/// ```
#[must_use]
pub fn pair_sampling(losses: &[f64], teeth: [usize; 2]) -> Option<PairSampling> {
    cite!("Between-traces");
    let [n1, n2] = teeth;
    if n1.max(n2) < 2 || losses.len() != n1 * n2 || losses.is_empty() {
        return None;
    }
    let [rows, columns] = [n1 as f64, n2 as f64];
    // Differences from one of them: equal losses leave exactly nothing.
    let first = losses[0];
    let at = |i: usize, j: usize| losses[i * n2 + j] - first;
    let row: Vec<f64> = (0..n1)
        .map(|i| (0..n2).map(|j| at(i, j)).sum::<f64>() / columns)
        .collect();
    let column: Vec<f64> = (0..n2)
        .map(|j| (0..n1).map(|i| at(i, j)).sum::<f64>() / rows)
        .collect();
    let mean = row.iter().sum::<f64>() / rows;
    let residual = if n1 > 1 && n2 > 1 {
        let squares = (0..n1).flat_map(|i| (0..n2).map(move |j| (i, j)));
        let squares = squares.map(|(i, j)| (at(i, j) - row[i] - column[j] + mean).powi(2));
        squares.sum::<f64>() / ((rows - 1.0) * (columns - 1.0))
    } else {
        0.0
    };
    let [v1, v2] = [variance(&row, mean), variance(&column, mean)];
    let parts = [
        (v1 - residual / columns).max(0.0),
        (v2 - residual / rows).max(0.0),
    ];
    let square = parts[0] / rows + parts[1] / columns + residual / (rows * columns);
    let standard_error_w = square.sqrt();
    let freedom = freedom([v1 / rows, v2 / columns], teeth);
    let half_width_w = if standard_error_w > 0.0 {
        student_t_quantile(CONFIDENCE, freedom) * standard_error_w
    } else {
        0.0
    };
    Some(PairSampling {
        traces: teeth,
        mean_w: first + mean,
        between_w: parts.map(f64::sqrt),
        interaction_w: residual.sqrt(),
        standard_error_w,
        freedom,
        half_width_w,
        misplaced_w: None,
    })
}

/// Standard error of the mean over the pairs of `surfaces` of `values`, one at each offset. Flanks that were generated like as many
/// measured traces scatter about these, which are themselves a sample of the finish: what they have in common adds up in the
/// sum over both flanks where both are like the same traces.
///
/// ```text
/// SE_g² = SE² + (s₁/√n₁ + s₂/√n₂)² like the same traces,
/// SE_g² = SE² + Σ s_b²/n_b over generated flanks b otherwise                  [Given-traces]
/// ```
pub(crate) fn sampling_of_teeth(values: &[f64], surfaces: &Surfaces) -> Option<PairSampling> {
    let found = pair_sampling(&means_of_pairs(values, surfaces.pairs()), surfaces.teeth()?)?;
    let LikeMeasured { flanks, is_same } = surfaces.like();
    if flanks == [false; 2] {
        return Some(found);
    }
    cite!("Given-traces");
    let errors =
        [0, 1].map(|body: usize| found.between_w[body] / (found.traces[body] as f64).sqrt());
    let square = if is_same {
        (errors[0] + errors[1]).powi(2)
    } else {
        let of_given = errors.iter().zip(flanks).filter(|(_, is_made)| *is_made);
        of_given.map(|(error, _)| error * error).sum()
    };
    let standard_error_w = (found.standard_error_w.powi(2) + square).sqrt();
    let wider = if found.standard_error_w > 0.0 {
        standard_error_w / found.standard_error_w
    } else {
        1.0
    };
    Some(PairSampling {
        standard_error_w,
        half_width_w: wider * found.half_width_w,
        ..found
    })
}

/// Factor on the standard error over the windows of one generated trace of each flank, for equal parts of both.
pub(crate) fn wider_like_measured(surfaces: &Surfaces) -> f64 {
    let LikeMeasured { flanks, is_same } = surfaces.like();
    let generated = flanks.into_iter().filter(|is_made| *is_made).count() as f64;
    let of_given = if is_same { 2.0 } else { 0.5 * generated };
    f64::sqrt(1.0 + of_given)
}

/// Means of `values`, one at each offset, over the offsets of each of `pairs` pairs.
pub(crate) fn means_of_pairs(values: &[f64], pairs: usize) -> Vec<f64> {
    let each = (values.len() / pairs.max(1)).max(1);
    let means = values.chunks(each);
    means
        .map(|part| part.iter().sum::<f64>() / part.len() as f64)
        .collect()
}

/// Sample variance about `mean`; zero of a single value.
fn variance(values: &[f64], mean: f64) -> f64 {
    if values.len() < 2 {
        return 0.0;
    }
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    squares / (values.len() - 1) as f64
}

/// d of the two parts of the error; where neither varies the fewest that there are.
fn freedom(parts: [f64; 2], teeth: [usize; 2]) -> f64 {
    let spare = teeth.map(|n| n as f64 - 1.0);
    let fourth: f64 = (parts.iter().zip(spare))
        .filter(|(part, _)| **part > 0.0)
        .map(|(part, spare)| part * part / spare)
        .sum();
    let sum = parts[0] + parts[1];
    if fourth > 0.0 {
        return sum * sum / fourth;
    }
    let sampled = spare.into_iter().filter(|spare| *spare > 0.0);
    sampled.fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use asperity_case::flanks::surfaces::{PairsOfTeeth, Texture};
    use asperity_core::numerics::standard_normal_quantile;
    use chacha20::ChaCha8Rng;
    use rand_core::{Rng, SeedableRng};

    use super::*;

    fn found(losses: &[f64], teeth: [usize; 2]) -> PairSampling {
        pair_sampling(losses, teeth).unwrap()
    }

    #[test]
    fn losses_that_add_up_have_no_interaction() {
        // P_ij = a_i + b_j, a = 0, 3, 6, b = 10, 14.
        let losses = [10.0, 14.0, 13.0, 17.0, 16.0, 20.0];
        let sampling = found(&losses, [3, 2]);
        assert!((sampling.mean_w - 15.0).abs() < 1e-12);
        assert!((sampling.between_w[0] - 3.0).abs() < 1e-12);
        assert!((sampling.between_w[1] - 8.0_f64.sqrt()).abs() < 1e-12);
        assert!(sampling.interaction_w < 1e-12);
        // SE² = 9/3 + 8/2, d = 7²/(3²/2 + 4²/1).
        assert!((sampling.standard_error_w - 7.0_f64.sqrt()).abs() < 1e-12);
        assert!((sampling.freedom - 49.0 / 20.5).abs() < 1e-12);
    }

    #[test]
    fn a_table_with_interaction_has_the_parts_found_by_hand() {
        let losses = [0.0, 3.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 8.0];
        let sampling = found(&losses, [3, 3]);
        // Row means 5/3, 4, 22/3, column means 3, 5, 5: V1 = 73/9, V2 = 4/3; residuals in thirds, M = 1/3.
        assert!((sampling.between_w[0].powi(2) - 8.0).abs() < 1e-12);
        assert!((sampling.between_w[1].powi(2) - 11.0 / 9.0).abs() < 1e-12);
        assert!((sampling.interaction_w.powi(2) - 1.0 / 3.0).abs() < 1e-12);
        assert!((sampling.standard_error_w.powi(2) - 28.0 / 9.0).abs() < 1e-12);
    }

    #[test]
    fn one_trace_of_the_wheel_leaves_the_spread_of_the_pinion() {
        let sampling = found(&[1.0, 2.0, 6.0], [3, 1]);
        // Variance 7, SE² = 7/3, d = 2.
        assert!((sampling.standard_error_w.powi(2) - 7.0 / 3.0).abs() < 1e-12);
        assert_eq!(sampling.freedom, 2.0);
        assert_eq!(sampling.bound(), ", a lower bound (W450)");
        assert_eq!(found(&[1.0, 2.0, 6.0], [1, 3]).bound(), sampling.bound());
        assert_eq!(found(&[1.0, 2.0, 6.0, 3.0], [2, 2]).bound(), "");
    }

    #[test]
    fn equal_losses_have_no_error_at_all() {
        let sampling = found(&[0.1 + 0.2; 6], [2, 3]);
        assert_eq!(sampling.mean_w, 0.1 + 0.2);
        assert_eq!(sampling.between_w, [0.0; 2]);
        assert_eq!((sampling.interaction_w, sampling.half_width_w), (0.0, 0.0));
    }

    #[test]
    fn the_order_of_the_traces_changes_nothing() {
        let losses = [4.0, 1.5, 9.0, 2.5, 3.0, 7.0];
        let (a, b) = (
            found(&losses, [2, 3]),
            found(&[2.5, 7.0, 3.0, 4.0, 9.0, 1.5], [2, 3]),
        );
        assert!((a.standard_error_w - b.standard_error_w).abs() < 1e-12);
        assert!((a.half_width_w / b.half_width_w - 1.0).abs() < 1e-12);
        // Pinion and wheel change places.
        let turned = found(&[4.0, 2.5, 1.5, 3.0, 9.0, 7.0], [3, 2]);
        assert!((a.standard_error_w - turned.standard_error_w).abs() < 1e-12);
        assert!((a.between_w[0] - turned.between_w[1]).abs() < 1e-12);
    }

    /// A standard normal deviate.
    fn normal(random: &mut ChaCha8Rng) -> f64 {
        standard_normal_quantile(((random.next_u64() >> 11) as f64 + 0.5) / (1_u64 << 53) as f64)
    }

    /// Flanks scatter about the mean of `n` traces, which scatter about 0: the losses of all pairs of `n` flanks each, like the same
    /// traces or like others.
    fn share_of_intervals_that_hold_the_finish(n: usize, is_same: bool) -> [f64; 2] {
        const REPEATS: usize = 2000;
        let values = Texture::Values {
            rq: 1e-6,
            ra: 1e-6,
            rz: 1e-6,
            rpk: None,
            asperity_radius: None,
        };
        let one = Surfaces::new([values.clone(), values], None, false);
        let like = LikeMeasured {
            flanks: [true; 2],
            is_same,
        };
        let surfaces = [LikeMeasured::default(), like].map(|like| {
            let met = vec![vec![one.clone().like_measured(like)]; n * n];
            let teeth = Some([n, n]);
            Surfaces::of_pairs(PairsOfTeeth { teeth, met }).unwrap()
        });
        let mut random = ChaCha8Rng::seed_from_u64(20261128);
        let mut held = [0.0; 2];
        for _ in 0..REPEATS {
            let mut flanks =
                |about: f64| -> Vec<f64> { (0..n).map(|_| about + normal(&mut random)).collect() };
            let given = flanks(0.0);
            let of_pinion = given.iter().sum::<f64>() / n as f64;
            let other = flanks(0.0);
            let of_wheel = if is_same {
                of_pinion
            } else {
                other.iter().sum::<f64>() / n as f64
            };
            let (rows, columns) = (flanks(of_pinion), flanks(of_wheel));
            let pairs = rows
                .iter()
                .flat_map(|row| columns.iter().map(move |column| row + column));
            let losses: Vec<f64> = pairs.collect();
            for (held, surfaces) in held.iter_mut().zip(&surfaces) {
                let found = sampling_of_teeth(&losses, surfaces).unwrap();
                *held += f64::from(u8::from(found.mean_w.abs() <= found.half_width_w));
            }
        }
        held.map(|held| held / REPEATS as f64)
    }

    /// Without the error of the traces given, more than one in nine intervals of 95 % does not hold the mean of the finish.
    #[test]
    fn intervals_of_generated_flanks_hold_the_mean_of_the_finish() {
        for (n, is_same) in [(4, true), (6, true), (6, false)] {
            let [without, with] = share_of_intervals_that_hold_the_finish(n, is_same);
            assert!((0.93..0.985).contains(&with), "{n} {is_same}: {with}");
            assert!(without < 0.89, "{n} {is_same}: {without}");
        }
    }

    #[test]
    fn a_table_that_is_not_full_has_no_error() {
        assert!(pair_sampling(&[1.0, 2.0, 3.0], [2, 2]).is_none());
        assert!(pair_sampling(&[1.0], [1, 1]).is_none());
        assert!(pair_sampling(&[], [0, 2]).is_none());
    }
}
