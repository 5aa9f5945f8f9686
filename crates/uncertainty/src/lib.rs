//! Draws of the loss of a gear mesh over its uncertain constants.
//!
//! It is used by `asperity`, which evaluates the losses. It does not know how a loss is computed.
//!
//! | step | type |
//! |---|---|
//! | uncertain constants of a case with their distributions | [`UncertainParameter`], [`Ranged`] |
//! | even draws of all of them, the same for every case | [`Draw`], [`latin_hypercube`] |
//! | a surface through evaluations of the loss | [`QuadraticSurface`] |
//! | the loss of every draw, its median and quantiles | [`Predictive`], [`Quantiles`] |
//! | its interval as a further measurement would leave it | [`Expected`] |
//!
//! No loss is evaluated here: the crate `asperity` does that, fills [`Predictive`], and re-exports what a result needs. This crate
//! is apart because the draws are arithmetic on some 16 000 values, and are compiled for speed in every profile.
//!
#![doc = include_str!("../README.md")]

mod draw;
mod expected;
mod hypercube;
mod parameters;
mod predictive;
mod quantiles;
mod relief;
mod sampling_error;
mod surface;

pub use asperity_case::case::{Measured, UncertainParameter};
pub use draw::{Common, Draw, FlankDraw, flank_draws};
pub use expected::{Expected, Measurement, MeshDraws};
pub use hypercube::{StudentOfNormal, latin_hypercube, permutation};
pub use parameters::{Ranged, deviation_of_curves, is_stated, parameters, range};
pub use predictive::{
    COMPARED, Component, DrawnLoss, FilmLaw, InnerBoundary, MODEL_LENGTHS, OtherLaw,
    PATCH_GAP_ERROR, PatchFlowError, Predictive, RecordedRule, model_correlation, model_deviation,
};
pub use quantiles::{ENDS, PROBABILITIES, Quantiles, Watts, median_with_ends, sorted_quantiles};
pub use relief::ReliefFactors;
pub use sampling_error::SamplingError;
pub use surface::{QuadraticSurface, least_squares};
