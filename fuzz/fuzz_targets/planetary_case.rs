//! Any text is a planetary case or refused with codes.

#![no_main]

#[path = "../../tests/src/parsers.rs"]
#[allow(dead_code)]
mod parsers;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    parsers::planetary_case(text);
});
