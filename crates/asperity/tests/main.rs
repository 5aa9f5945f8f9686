//! The tests of this crate as one program, which is linked only once.

mod calibrated_draws;
mod cases;
mod draws;
mod examples;
mod findings;
mod flanks;
mod keys;
mod loss_tables;
mod mesh_load;
mod messages;
mod oil_files;
mod patches;
mod ranges;
mod records;
mod rows;
mod run_in;
mod running_in_key;
mod runs;
mod several_traces;
mod surrogates;
mod symbols;
