//! The tests of this crate as one program, which is linked only once.

mod examples;
mod gearbox;
mod limits;
mod properties;
mod swept;
mod validation;
