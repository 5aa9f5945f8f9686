//! The little numerics that is not physics: transforms, convolution, factors, roots, sums, statistics, elliptic integrals, Student's t.

mod cholesky;
mod convolution;
pub mod elementary;
mod elliptic;
mod fft_length;
mod gauss_legendre;
mod increasing_root;
mod interpolation;
mod lanes;
mod normal;
mod root;
mod statistics;
mod student_t;
mod sums;
mod vectors;

pub use asperity_fourier::{FourierNumber, complex_inverse, real_transforms};
pub use cholesky::Cholesky;
pub use convolution::SymmetricToeplitz;
pub use elliptic::CompleteElliptic;
pub use fft_length::good_fft_length;
pub use gauss_legendre::gauss_legendre;
pub use increasing_root::{Solved, newton_root, secant_root};
pub use interpolation::{NodeInterval, interpolate, interpolate_between};
pub use lanes::Lanes;
pub use normal::{Z_75, Z_95, Z_975, standard_normal_below, standard_normal_quantile};
pub use root::{Root, RootError, find_root};
pub use statistics::{correlation, deviation, distinct, mean, median, median_in_place};
pub use student_t::{student_t_below, student_t_quantile, student_t_within};
pub use sums::{add_times, dot, extreme_places, extremes, range, sum};
pub use vectors::{VECTOR_WIDTH, vectorised};

/// ∫ y dx by the trapezoidal rule over points `x`, `y` of equal number (fewer than two give 0).
pub fn trapezoid(x: &[f64], y: &[f64]) -> f64 {
    x.windows(2)
        .zip(y.windows(2))
        .map(|(x, y)| 0.5 * (x[1] - x[0]) * (y[0] + y[1]))
        .sum()
}

/// The golden section (√5 − 1)/2, whose multiples are spread evenly over 0 to 1 by their fractions.
///
/// ```
/// use asperity_core::numerics::GOLDEN_SECTION;
/// assert_eq!(GOLDEN_SECTION, 0.5 * (5.0_f64.sqrt() - 1.0));
/// ```
pub const GOLDEN_SECTION: f64 = 0.618_033_988_749_894_9;
