//! The tests of this crate as one program, which is linked only once.

mod rig_tables;
mod simulated_rigs;
mod traction_curves;
