//! Any bytes under the name of this format are read or refused, as a profile and as a table.

#![no_main]

mod common;

use asperity_profile_io::read::table_text;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    common::reads_or_refuses("a.xlsx", bytes);
    let _ = table_text("a.xlsx", bytes);
});
