//! Load over the flanks during a mesh cycle, f(ξ, y), with the loss factor and the transmission error.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ξ | (s − A)/p_et, profile coordinate, 0 to ε_α | - |
//! | y | position across the face, 0 to b | m |
//! | φ | mesh phase; pair j is in contact where ξ = φ + j + ε_β y/b is on the path | - |
//! | f | load per length of contact line, normal to the flank | N/m |
//! | dl | length of contact line, dy/cos β_b | m |
//! | F_bn | force normal to the flanks | N |
//!
//! Over a mesh cycle every (ξ, y) is in contact once, so the mean of Σ g dl is (1/cos β_b)·∫∫ g dy dξ with the load at
//! the phase of that contact. The formula holds for spur, helical, external and internal pairs.
//!
//! Limits: prismatic teeth on massive bodies; no shaft bending (use a lead slope instead), no
//! friction in the force balance, no dynamics.

mod cells;
mod conditions;
mod coupled;
mod deflection;
mod every_law;
mod grid;
mod law;
mod line_load_table;
mod map;
mod own_law;
mod phases;
mod rigid;

pub use cells::LoadCell;
pub use conditions::LoadConditions;
pub use deflection::TransmissionError;
pub use law::{LoadLaw, LoadMapSettings};
pub use map::{LoadMap, LoadMapEvidence, LoadSample};
