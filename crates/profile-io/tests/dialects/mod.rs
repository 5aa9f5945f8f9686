//! Every dialect of delimited text that labs send, made in memory and read back.

#![allow(clippy::unwrap_used, clippy::panic)]

mod measured;
mod refused;
mod table;
mod written;
