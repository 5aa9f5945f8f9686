//! Sampling error of the loss: over windows of a trace, and over pairs of teeth.

mod pairs;
mod windows;

pub use pairs::pair_sampling;
pub use windows::{Independent, independent_windows, window_sampling};

pub(crate) use pairs::{means_of_pairs, sampling_of_teeth, wider_like_measured};
pub(crate) use windows::{LossScatter, length_for, travel_sampling, windows_of_traces};
