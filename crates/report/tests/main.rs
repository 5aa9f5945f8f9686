//! The tests of this crate as one program, which is linked only once.

mod columns;
mod examples;
mod round_trip;
