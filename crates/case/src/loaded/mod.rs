//! A case with its flanks, ready for a run.

pub mod builder;
pub mod flank_inputs;
pub mod flank_sample;
pub mod flank_trace;
pub mod flanks;
mod generated;
pub mod lay;
pub mod loaded_case;
mod named_traces;
pub mod operating_case;
mod scan_choice;
pub mod scans;
pub mod sheets;
pub mod surrogates;
pub mod trace;
