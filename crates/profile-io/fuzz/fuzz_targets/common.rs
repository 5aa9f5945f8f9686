//! Property of any bytes under any name.

#[path = "../../tests/common/drops.rs"]
mod drops;

use std::io::Cursor;

use asperity_profile_io::read::{
    ReadOptions, TraceLine, read_bytes, read_stream, read_surface_bytes,
};
use drops::Drops;

/// The bytes are read to heights where the mask says so or refused, and so is the mean of their rows.
#[allow(dead_code)]
pub fn is_a_surface_or_refused(name: &str, bytes: &[u8]) {
    let options = ReadOptions {
        z_unit: "um".parse().ok(),
        dx: "0.5 um".parse().ok(),
        ..ReadOptions::default()
    };
    if let Ok(surface) = read_surface_bytes(name, bytes, &options) {
        assert_eq!(surface.z.len(), surface.columns * surface.rows);
        let agree = |(z, known): (&f64, &bool)| z.is_finite() == *known;
        assert!(surface.z.iter().zip(&surface.mask).all(agree));
    }
    let mean = ReadOptions {
        line: TraceLine::Mean,
        ..options
    };
    if let Ok(reading) = read_bytes(name, bytes, &mean) {
        assert!(reading.profile.heights().iter().all(|z| z.is_finite()));
    }
}

/// The bytes are read to finite heights or refused, and in the same way when they come in drops.
#[allow(dead_code)]
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
