//! Factors from SI to the units of the tables.

/// Metres to micrometres.
pub const MICRO: f64 = 1e6;
/// Pascals to megapascals.
pub const MEGA: f64 = 1e-6;
