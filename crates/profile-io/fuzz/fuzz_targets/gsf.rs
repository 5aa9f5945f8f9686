//! Any bytes under the name of this format are a surface or refused.

#![no_main]

mod common;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| common::is_a_surface_or_refused("a.gsf", bytes));
