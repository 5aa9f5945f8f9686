//! The tests of this crate as one program, which is linked only once.

mod balance;
mod common;
mod examples;
mod limits;
mod properties;
mod validation;
