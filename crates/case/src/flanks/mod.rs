//! Measured flanks: their traces, the places of these, and the windows in contact at a mesh position.

pub mod flank_form;
pub mod flank_lay;
pub mod local_roughness;
pub mod placement;
pub mod surfaces;
pub mod surrogate_record;
pub mod trace_pairs;
mod window_pair;

pub use local_roughness::Roughness;
pub use surfaces::{Surfaces, Texture};
pub use window_pair::{LEAST_POINTS_PER_HALF_WIDTH, WindowPair, window_places};

pub use window_pair::{AVERAGING_WIDTH, Window, is_substituted};
