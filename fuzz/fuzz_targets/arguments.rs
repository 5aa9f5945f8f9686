//! Any text, one argument a line, is a command line or refused: finishes of a comparison, keys to set, quantities.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    asperity_cli::fuzzing::arguments(text);
});
