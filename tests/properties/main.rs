//! Balances, scalings and monotonicities that hold for every case.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

mod balance;
mod cases;
mod geometry;
mod monotone;
mod traces;
