//! The tests of this crate as one program, which is linked only once.

mod common;
mod golden;
mod properties;
mod thin_films;
mod validation;
