//! Plans of Fourier transforms.
//!
//! It is used by `core`. It does not know what is transformed.
//!
//! The code of a plan is generic: every crate that makes a plan or a planner compiles all of it, which costs more than the
//! rest of most crates. The others take plans and planners from this crate, which is compiled once.
//!
#![doc = include_str!("../README.md")]

use std::sync::{Arc, Mutex, PoisonError};

use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::{Fft, FftNum, FftPlanner};

/// Transform of real values, and its inverse without the factor one over their number.
pub type RealTransforms<T> = (Arc<dyn RealToComplex<T>>, Arc<dyn ComplexToReal<T>>);

/// Transform of `points` real values, and its inverse without the factor 1/`points`.
///
/// ```
/// let (forward, inverse) = asperity_fourier::real_transforms(4);
/// let (mut values, mut spectrum) = (vec![1.0, 2.0, 3.0, 4.0], forward.make_output_vec());
/// forward.process(&mut values, &mut spectrum)?;
/// inverse.process(&mut spectrum, &mut values)?;
/// assert_eq!(values, [4.0, 8.0, 12.0, 16.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn real_transforms(points: usize) -> RealTransforms<f64> {
    static LAST: LastPlans<RealTransforms<f64>> = Mutex::new(Vec::new());
    of_last(&LAST, points, f64::real_transforms)
}

/// Inverse transform of `points` complex values, without the factor 1/`points`.
pub fn complex_inverse(points: usize) -> Arc<dyn Fft<f64>> {
    static LAST: LastPlans<Arc<dyn Fft<f64>>> = Mutex::new(Vec::new());
    of_last(&LAST, points, |points| {
        f64::planner().plan_fft_inverse(points)
    })
}

/// The plans that were used last, by their number of points, the latest at the end.
type LastPlans<T> = Mutex<Vec<(usize, T)>>;

/// The plan of `points` among the last ones, or made.
///
/// A plan costs as much as several transforms, and the traces of a study have few lengths. Long ones are not kept: their plans
/// are large.
fn of_last<T: Clone>(last: &LastPlans<T>, points: usize, make: impl Fn(usize) -> T) -> T {
    const KEPT: usize = 8;
    const LONGEST: usize = 1 << 16;
    if points > LONGEST {
        return make(points);
    }
    let mut last = last.lock().unwrap_or_else(PoisonError::into_inner);
    let plan = match last.iter().position(|(of, _)| *of == points) {
        Some(i) => last.remove(i).1,
        None => make(points),
    };
    if last.len() == KEPT {
        last.remove(0);
    }
    last.push((points, plan.clone()));
    plan
}

/// Number type whose transforms are compiled here.
pub trait FourierNumber: FftNum {
    /// A planner without plans.
    fn planner() -> FftPlanner<Self>;

    /// Transform of `points` complex values.
    fn forward(planner: &mut FftPlanner<Self>, points: usize) -> Arc<dyn Fft<Self>>;

    /// Transform of `points` real values, and its inverse without the factor 1/`points`.
    fn real_transforms(points: usize) -> RealTransforms<Self>;
}

macro_rules! fourier_number {
    ($($number:ty)*) => {$(
        impl FourierNumber for $number {
            fn planner() -> FftPlanner<Self> {
                FftPlanner::new()
            }

            fn forward(planner: &mut FftPlanner<Self>, points: usize) -> Arc<dyn Fft<Self>> {
                planner.plan_fft_forward(points)
            }

            fn real_transforms(points: usize) -> RealTransforms<Self> {
                let mut planner = RealFftPlanner::new();
                let forward = planner.plan_fft_forward(points);
                (forward, planner.plan_fft_inverse(points))
            }
        }
    )*};
}

fourier_number!(f32 f64);
