//! Circular convolution of grid functions with even kernels, and loops over ranges of a grid.

mod column_kernel;
mod even_filter;
mod index_ranges;
mod plane_filter;
#[cfg(test)]
mod tests;

pub(crate) use asperity_core::numerics::{Lanes, vectorised};
pub(crate) use even_filter::{Buffers, Convolution, EvenFilter, fast_length};
pub(crate) use index_ranges::{Run, extend, listed, parts};
pub(crate) use plane_filter::PlaneFilter;
