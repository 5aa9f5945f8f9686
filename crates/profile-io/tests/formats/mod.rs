//! Every instrument format, made in memory as its writers make it, and read back.

#![allow(clippy::unwrap_used, clippy::panic)]

mod archives;
mod areal;
mod areal_files;
mod every;
mod faults;
mod layouts;
mod libraries;
mod marks;
mod named;
mod samples;
mod tables;
mod text;
mod units;
