//! The tests of this crate as one program, which is linked only once.

mod calibrated_draws;
mod cases;
mod draws;
mod examples;
mod keys;
mod mesh_load;
mod records;
mod rows;
mod run_in;
mod several_traces;
mod surrogates;
