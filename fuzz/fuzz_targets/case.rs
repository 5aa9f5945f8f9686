//! Any text is a case, in TOML or in JSON, or refused with a code.

#![no_main]

#[path = "../../tests/src/parsers.rs"]
#[allow(dead_code)]
mod parsers;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let name = if text.starts_with('{') {
        "case.json"
    } else {
        "case.toml"
    };
    parsers::case(name, text);
});
