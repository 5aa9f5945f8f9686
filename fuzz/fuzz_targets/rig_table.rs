//! Any text is the table of a rig or refused.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    asperity_cli::fuzzing::rig_table(text);
});
