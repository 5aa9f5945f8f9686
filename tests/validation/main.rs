//! The whole program against numbers from elsewhere, from the case file on.
//!
//! Validation that spans crates; the results of a single crate are proven in that crate. Each module
//! compares reference numbers with ours in tables, which are in `docs/VALIDATION.md`, other documents and
//! `tests/golden/evidence`.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

mod band;
mod britton;
mod close_records;
mod comparison;
mod disc;
mod document;
mod ehl_records;
mod evidence;
mod film_records;
mod fluid_film;
mod full_film_losses;
mod gate;
mod gates;
mod gear_tool;
mod generated_flanks;
mod load_share;
mod measured;
mod measured_cases;
mod oil_file;
mod paper_formulation;
mod paper_statements;
mod parity;
mod petry_johnson;
mod rough_contact;
mod share_laws;
mod shipped_cases;
mod spot_values;
mod steady_films;
mod table_2;
