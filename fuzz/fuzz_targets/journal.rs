//! Whatever the journal of a dead process says, clearing up after it changes nothing outside of its draft.

#![no_main]

#[path = "../../tests/src/parsers.rs"]
#[allow(dead_code)]
mod parsers;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    parsers::journal(bytes);
});
