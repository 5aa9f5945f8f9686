//! Synthetic profiles from a seed, for worked cases, tests and studies.
//!
//! Every recipe is plain data that carries its seed: the recipe is the record, and the same recipe
//! gives the same profile on every machine up to the rounding of the transforms. The flank that meets a
//! generated one is made with [`Profile::mirrored`](asperity_core::Profile::mirrored) or another seed.

mod achieved;
mod damage;
mod ground;
mod non_gaussian;
mod plateau;
mod pores;
mod random;
mod recipe;
mod scaling;
mod self_affine;

pub use achieved::{Achieved, Generated};
pub use damage::{Pits, Scratches};
pub use ground::Ground;
pub use non_gaussian::{HeightDistribution, NonGaussian};
pub use plateau::{PlateauHoned, lower_envelope, truncated};
pub use pores::Pores;
pub use recipe::{Recipe, Surface};
pub use self_affine::{Amplitudes, SelfAffine};
