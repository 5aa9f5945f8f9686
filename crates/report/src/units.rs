//! Factors from SI to the units of the tables.

/// Micrometres per metre.
pub const MICRO: f64 = 1e6;
/// Megapascals per pascal.
pub(crate) const MEGA: f64 = 1e-6;
