//! Tractions of line contacts with Coulomb friction.
//!
//! Closed forms of Cattaneo, Mindlin and Carter for smooth cylinders, and for any profile the
//! partial slip of similar materials and the full sliding of dissimilar ones, both on the normal
//! solver. Plane strain; traction q > 0 acts towards +x on the body below.

mod carter;
mod mindlin;
mod partial_slip;
mod sliding;

pub use carter::{carter_creepage, carter_traction};
pub use mindlin::{mindlin_traction, stick_half_width};
pub use partial_slip::{PartialSlip, partial_slip};
pub use sliding::{Sliding, SlidingSettings, dundurs, sliding_pressure, solve_sliding};
