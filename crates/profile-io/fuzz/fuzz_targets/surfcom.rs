//! Any bytes under the name of this format are read or refused.

#![no_main]

mod common;

use asperity_profile_io::read::{ReadOptions, read_with_conditions};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    common::reads_or_refuses("a.tx1", bytes);
    // The last quarter stands for the conditions that lie beside the profile.
    let (profile, conditions) = bytes.split_at(bytes.len() - bytes.len() / 4);
    let _ = read_with_conditions("a.tx1", profile, Some(conditions), &ReadOptions::default());
});
