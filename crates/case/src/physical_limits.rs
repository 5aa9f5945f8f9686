//! Limits beyond which no state is physical, for the keys of a case and for the states of a run: choices of this project, some
//! powers of ten beyond what was ever measured on gears.

use asperity_core::quantity::Pressure;

/// Pressure that no steel withstands: hardened steel flows at 7 GPa.
pub const HIGHEST_PRESSURE: Pressure = Pressure::from_si(20e9);
/// Speed of a flank \[m/s\]: turbine gears reach 200.
pub const HIGHEST_SPEED: f64 = 1000.0;
