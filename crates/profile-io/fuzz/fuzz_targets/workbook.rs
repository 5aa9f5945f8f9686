//! Any bytes under the name of this format are read or refused.

#![no_main]

mod common;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| common::reads_or_refuses("a.xlsx", bytes));
