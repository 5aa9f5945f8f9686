//! Plans of Fourier transforms.
//!
//! The code of a plan is generic, so every crate that makes one compiles it. Other crates take their plans from here,
//! where that happens once.

use std::sync::Arc;

use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftNum, FftPlanner};

/// Transform of `points` real values, and its inverse without the factor 1/`points`.
///
/// ```
/// let (forward, inverse) = asperity_core::numerics::real_transforms(4);
/// let (mut values, mut spectrum) = (vec![1.0, 2.0, 3.0, 4.0], forward.make_output_vec());
/// forward.process(&mut values, &mut spectrum)?;
/// inverse.process(&mut spectrum, &mut values)?;
/// assert_eq!(values, [4.0, 8.0, 12.0, 16.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn real_transforms(
    points: usize,
) -> (Arc<dyn RealToComplex<f64>>, Arc<dyn ComplexToReal<f64>>) {
    let mut planner = RealFftPlanner::new();
    let forward = planner.plan_fft_forward(points);
    (forward, planner.plan_fft_inverse(points))
}

/// Number type whose transforms are compiled here.
pub trait FourierNumber: FftNum {
    /// Transform of `points` complex values.
    fn forward(planner: &mut FftPlanner<Self>, points: usize) -> Arc<dyn Fft<Self>>;
}

impl FourierNumber for f64 {
    fn forward(planner: &mut FftPlanner<Self>, points: usize) -> Arc<dyn Fft<Self>> {
        planner.plan_fft_forward(points)
    }
}

impl FourierNumber for f32 {
    fn forward(planner: &mut FftPlanner<Self>, points: usize) -> Arc<dyn Fft<Self>> {
        planner.plan_fft_forward(points)
    }
}

/// Inverse transform of `points` complex values, without the factor 1/`points`.
pub fn complex_inverse(points: usize) -> Arc<dyn Fft<f64>> {
    FftPlanner::new().plan_fft_inverse(points)
}
