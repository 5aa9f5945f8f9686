//! Latin hypercube: draws that fill every parameter's range evenly with few runs.

use asperity_core::cite;
use rand_chacha::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};

/// Seed of the draws: the same in every run and for every case, so that two finishes differ by their flanks.
const SEED: u64 = 3;

/// `draws` points of the unit cube of `dimensions`: along each axis one in each of as many even strata, at an
/// even place in it, the strata in random order.
///
/// ```text
/// u_jk = (π_k(j) + r_jk)/N,  j = 0 .. N − 1                                   [Latin-hypercube]
/// ```
pub(crate) fn latin_hypercube(draws: usize, dimensions: usize) -> Vec<Vec<f64>> {
    cite!("Latin-hypercube");
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let mut points = vec![vec![0.0; dimensions]; draws];
    for k in 0..dimensions {
        let mut order: Vec<usize> = (0..draws).collect();
        for j in (1..draws).rev() {
            let other = (uniform(&mut random) * (j + 1) as f64) as usize;
            order.swap(j, other.min(j));
        }
        for (point, stratum) in points.iter_mut().zip(order) {
            point[k] = (stratum as f64 + uniform(&mut random)) / draws as f64;
        }
    }
    points
}

/// Even over 0 ≤ u < 1, by the upper 53 bits.
fn uniform(random: &mut ChaCha8Rng) -> f64 {
    const STEPS: f64 = (1_u64 << 53) as f64;
    (random.next_u64() >> 11) as f64 / STEPS
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_stratum_of_every_axis_is_drawn_once() {
        let points = latin_hypercube(24, 5);
        for k in 0..5 {
            let mut strata: Vec<usize> = points.iter().map(|p| (24.0 * p[k]) as usize).collect();
            strata.sort_unstable();
            assert_eq!(strata, (0..24).collect::<Vec<_>>());
        }
        assert_eq!(points, latin_hypercube(24, 5));
    }

    #[test]
    fn axes_are_not_drawn_in_the_same_order() {
        let points = latin_hypercube(24, 5);
        for (a, b) in [(0, 1), (1, 2), (3, 4)] {
            let product = |p: &Vec<f64>| (p[a] - 0.5) * (p[b] - 0.5);
            let correlation = points.iter().map(product).sum::<f64>() / 24.0 * 12.0;
            assert!(correlation.abs() < 0.5, "{a} {b} {correlation}");
        }
    }
}
