//! Property of any bytes under any name.

#[path = "../../tests/common/drops.rs"]
mod drops;

use std::io::Cursor;

use asperity_profile_io::read::{ReadOptions, read_bytes, read_stream};
use drops::Drops;

/// The bytes are read to finite heights or refused, and in the same way when they come in drops.
pub fn reads_or_refuses(name: &str, bytes: &[u8]) {
    let options = ReadOptions::default();
    let whole = read_bytes(name, bytes, &options);
    if let Ok(reading) = &whole {
        assert!(reading.profile.heights().iter().all(|z| z.is_finite()));
    }
    let drops = read_stream(name, Drops(Cursor::new(bytes)), &options);
    match (whole, drops) {
        (Ok(whole), Ok(drops)) => assert_eq!(whole, drops),
        (Err(whole), Err(drops)) => assert_eq!(whole.to_string(), drops.to_string()),
        (whole, drops) => panic!("{whole:?} at once, {drops:?} in drops"),
    }
}
