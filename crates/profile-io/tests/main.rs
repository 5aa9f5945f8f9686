//! The tests of this crate as one program, which is linked only once.

mod dialects;
#[path = "common/drops.rs"]
mod drops;
mod formats;
mod properties;
mod streaming;
mod trust;
mod uneven;
mod variants;
