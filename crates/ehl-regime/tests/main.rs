//! The tests of this crate as one program, which is linked only once.

mod examples;
mod light_load;
mod limits;
mod micropitting;
mod patches;
mod properties;
mod reference_case;
mod rough_inlet;
mod starvation;
mod steady_film;
mod validation;
