//! Any bytes are a gap or refused.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    asperity_cli::fuzzing::gap(bytes);
});
