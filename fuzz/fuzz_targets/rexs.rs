//! Any file is a REXS gearbox or refused.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    asperity_cli::fuzzing::rexs(bytes);
});
