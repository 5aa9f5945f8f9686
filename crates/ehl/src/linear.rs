//! Linear systems of Newton's method: two-level GMRES on even grids, dense factors on graded ones.

mod band_matrix;
mod coarse_level;
#[cfg(feature = "oracle")]
mod dense_system;
mod fine_level;
mod fourier_system;
mod gmres;
mod small_lu;
mod system;

#[cfg(feature = "oracle")]
pub(crate) use dense_system::DenseSystem;
pub(crate) use fourier_system::FourierSystem;
pub(crate) use system::{ElasticSystem, Linearised};
