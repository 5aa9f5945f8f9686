//! Any bytes under the name of this format are read or refused.

#![no_main]

use asperity_roughness::read::{ReadOptions, read_bytes};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(reading) = read_bytes("a.csv", bytes, &ReadOptions::default()) {
        assert!(reading.profile.heights().iter().all(|z| z.is_finite()));
    }
});
