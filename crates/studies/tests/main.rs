//! The tests of this crate as one program, which is linked only once.

mod energies;
mod estimate;
mod exports;
mod ridges;
mod running_in;
mod trains;
