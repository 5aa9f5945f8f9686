//! Whatever a manifest says, writing its folder anew changes nothing outside of it.

#![no_main]

#[path = "../../tests/src/parsers.rs"]
#[allow(dead_code)]
mod parsers;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    parsers::manifest(bytes);
});
