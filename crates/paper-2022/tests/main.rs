//! The tests of this crate as one program, which is linked only once.

mod cases;
mod keys;
