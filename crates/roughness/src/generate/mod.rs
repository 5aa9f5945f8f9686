//! Synthetic profiles from a seed, for worked cases, tests and studies.
//!
//! A recipe is plain data with its seed: the same recipe gives the same profile on every machine, except for rounding
//! errors of the transforms. Generate the mating flank with [`Profile::mirrored`](asperity_core::Profile::mirrored) or
//! another seed.

mod achieved;
mod damage;
mod fitted;
mod fitted_surface;
mod ground;
mod like;
mod non_gaussian;
mod periodic;
mod pieces;
mod plateau;
mod pores;
mod random;
pub(crate) use random::Random;
mod recipe;
mod scaling;
mod self_affine;
mod state;
mod surface_like;
mod surface_pieces;
mod surrogate;
mod teeth;

pub use achieved::{Achieved, Generated};
pub use damage::{Pits, Scratches};
pub use fitted::Fitted;
pub use fitted_surface::FittedSurface;
pub use ground::Ground;
pub use like::{Like, LikeSurface, MadeLike, MadeSurface, Method};
pub use non_gaussian::{HeightDistribution, NonGaussian};
pub use periodic::stretched;
pub use pieces::{LONG_WAVES, Piece, Pieced, Pieces};
pub use plateau::{PlateauHoned, lower_envelope, truncated};
pub use pores::Pores;
pub use recipe::{Recipe, Surface};
pub use self_affine::{Amplitudes, SelfAffine};
pub use state::{State, state_words};
pub use surface_like::surface_like;
pub use surface_pieces::{PiecedSurface, SurfacePiece, SurfacePieces};
pub use surrogate::{Finish, LAMBDA_S, Surrogate};
pub use teeth::Teeth;
