//! Numbers between 0 and 1 for the inputs of a sample. Each depends only on its index, so that any shard can draw it.

use chacha20::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};

use super::study_input::Method;

/// Largest number of points of Sobol's sequence.
pub(super) const LONGEST: usize = 1 << 16;
/// Largest number of inputs of Sobol's sequence.
pub(super) const DIMENSIONS: usize = 256;

/// Draws of a sample.
#[derive(Debug, Clone)]
pub struct Draws {
    method: Method,
    count: usize,
    seed: u64,
    /// Layers of a Latin hypercube, by input.
    layers: Vec<Vec<usize>>,
}

impl Draws {
    /// Makes the draws of `count` points of `inputs` numbers.
    #[must_use]
    pub fn new(method: Method, count: usize, inputs: usize, seed: u64) -> Self {
        let layers = match method {
            Method::LatinHypercube => (0..inputs)
                .map(|input| shuffled(count, stream(seed, input as u64, true)))
                .collect(),
            _ => Vec::new(),
        };
        Self {
            method,
            count,
            seed,
            layers,
        }
    }

    /// Number of an input at a point, 0 < u < 1.
    ///
    /// ```
    /// use asperity_studies::sweep::{Draws, Method};
    /// let draws = Draws::new(Method::LatinHypercube, 8, 1, 1);
    /// let mut layers: Vec<usize> = (0..8).map(|k| (8.0 * draws.at(k, 0)) as usize).collect();
    /// layers.sort();
    /// assert_eq!(layers, [0, 1, 2, 3, 4, 5, 6, 7]);
    /// ```
    #[must_use]
    pub fn at(&self, point: usize, input: usize) -> f64 {
        match self.method {
            Method::Sobol | Method::List => {
                /// Half a step of the sequence, which begins at 0.
                const HALF: f64 = 1.0 / (1_u64 << 25) as f64;
                let seed = self.seed as u32 ^ (self.seed >> 32) as u32;
                f64::from(sobol_burley::sample(point as u32, input as u32, seed)) + HALF
            }
            Method::LatinHypercube => {
                let layer = self.layers.get(input).and_then(|layers| layers.get(point));
                let layer = layer.copied().unwrap_or_default() as f64;
                (layer + self.random(point, input)) / self.count as f64
            }
            Method::Random => self.random(point, input),
        }
    }

    fn random(&self, point: usize, input: usize) -> f64 {
        let mut random = stream(self.seed, point as u64, false);
        let mut number = 0.5;
        for _ in 0..=input {
            number = uniform(&mut random);
        }
        number
    }
}

/// Random stream of the seed: one per point, and separate ones for all points together.
pub(crate) fn stream(seed: u64, number: u64, of_all: bool) -> ChaCha8Rng {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(2 * number + u64::from(of_all));
    random
}

/// Uniform on 0 < u < 1, from the upper 53 bits.
pub(crate) fn uniform(random: &mut ChaCha8Rng) -> f64 {
    const STEPS: f64 = (1_u64 << 53) as f64;
    ((random.next_u64() >> 11) as f64 + 0.5) / STEPS
}

/// Random number generator of a seed, for resampling.
pub(super) fn random_of(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

/// Random permutation of the numbers below `count` (Fisher and Yates).
fn shuffled(count: usize, mut random: ChaCha8Rng) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    for last in (1..count).rev() {
        let other = (uniform(&mut random) * (last + 1) as f64) as usize;
        order.swap(last, other.min(last));
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_draw_is_the_same_for_ever_and_for_every_shard() {
        let random = Draws::new(Method::Random, 4, 2, 7);
        assert_eq!(
            random.at(3, 1),
            Draws::new(Method::Random, 9, 2, 7).at(3, 1)
        );
        assert!(random.at(3, 1) != random.at(2, 1) && random.at(3, 1) != random.at(3, 0));
    }

    #[test]
    fn sobol_points_are_balanced() {
        let draws = Draws::new(Method::Sobol, 256, 3, 1);
        for input in 0..3 {
            let mut cells = [0; 16];
            for point in 0..256 {
                cells[(16.0 * draws.at(point, input)) as usize] += 1;
            }
            assert_eq!(cells, [16; 16]);
        }
    }
}
