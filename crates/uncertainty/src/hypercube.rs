//! Latin hypercube: draws that fill the range of every factor evenly.

use asperity_core::cite;
use asperity_core::numerics::student_t_quantile;
use chacha20::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};

/// `draws` points of the unit cube of `dimensions`: along each axis one in the middle of each of as many even strata,
/// the strata in random order. Equal arguments give equal points.
///
/// ```text
/// u_jk = (π_k(j) + 1/2)/N,  j = 0 .. N − 1                                    [Latin-hypercube]
/// ```
pub fn latin_hypercube(draws: usize, dimensions: usize, seed: u64) -> Vec<Vec<f64>> {
    let axes = permutations(draws, dimensions, seed);
    let point = |j: usize| {
        let place = |axis: &Vec<usize>| (axis[j] as f64 + 0.5) / draws as f64;
        axes.iter().map(place).collect()
    };
    (0..draws).map(point).collect()
}

/// A random order of the strata along each axis.
fn permutations(draws: usize, dimensions: usize, seed: u64) -> Vec<Vec<usize>> {
    cite!("Latin-hypercube");
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    (0..dimensions)
        .map(|_| shuffled(draws, &mut random))
        .collect()
}

/// A random order of `draws` strata along the axis called `name`, which has a stream of its own: the order depends on no other axis.
pub fn permutation(draws: usize, seed: u64, name: &str) -> Vec<usize> {
    cite!("Latin-hypercube");
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    random.set_stream(stream(name));
    shuffled(draws, &mut random)
}

/// Number of the stream of a name: FNV-1a.
fn stream(name: &str) -> u64 {
    const BASIS: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0100_0000_01b3;
    let bytes = name.bytes();
    bytes.fold(BASIS, |sum, byte| {
        (sum ^ u64::from(byte)).wrapping_mul(PRIME)
    })
}

fn shuffled(draws: usize, random: &mut ChaCha8Rng) -> Vec<usize> {
    let mut order: Vec<usize> = (0..draws).collect();
    for j in (1..draws).rev() {
        let other = (uniform(random) * (j + 1) as f64) as usize;
        order.swap(j, other.min(j));
    }
    order
}

/// Even over 0 ≤ u < 1, by the upper 53 bits.
fn uniform(random: &mut ChaCha8Rng) -> f64 {
    const STEPS: f64 = (1_u64 << 53) as f64;
    (random.next_u64() >> 11) as f64 / STEPS
}

/// Quantiles of Student's t distribution where the standard normal one has its quantiles z.
///
/// The ratio t/z is smooth, so that a table of it over z is interpolated.
pub struct StudentOfNormal {
    ratios: Vec<f64>,
}

impl StudentOfNormal {
    /// Step of the table in z.
    const STEP: f64 = 0.125;
    /// Entries of the table.
    const ENTRIES: usize = 33;

    /// The table for `freedom` degrees of freedom.
    pub fn new(freedom: f64) -> Self {
        let ratio = |k: usize| {
            // The limit at 0 is close to the ratio at a small z.
            let z = Self::STEP * (k as f64).max(0.01);
            let within = libm::erf(z / std::f64::consts::SQRT_2);
            student_t_quantile(within, freedom) / z
        };
        Self {
            ratios: (0..Self::ENTRIES).map(ratio).collect(),
        }
    }

    /// t at the probability of `z`.
    pub fn at(&self, z: f64) -> f64 {
        let place = z.abs() / Self::STEP;
        let k = (place as usize).min(Self::ENTRIES - 2);
        let (low, high) = (self.ratios[k], self.ratios[k + 1]);
        z * (low + (place - k as f64) * (high - low))
    }
}
