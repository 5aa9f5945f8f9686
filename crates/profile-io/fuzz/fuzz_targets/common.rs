//! Property of any bytes under any name.

#[path = "../../tests/common/drops.rs"]
mod drops;

use std::io::Cursor;

use asperity_profile_io::read::{
    Positions, ReadOptions, TraceLine, read_bytes, read_stream, read_surface_bytes,
    read_trace_bytes,
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

/// The bytes are read to finite heights at rising positions or refused, and in the same way when they come in drops.
#[allow(dead_code)]
pub fn reads_or_refuses(name: &str, bytes: &[u8]) {
    let options = ReadOptions::default();
    let whole = read_bytes(name, bytes, &options);
    if let Ok(reading) = &whole {
        assert!(reading.profile.heights().iter().all(|z| z.is_finite()));
    }
    if let Ok(trace) = read_trace_bytes(name, bytes, &options) {
        assert!(trace.heights.iter().all(|z| z.is_finite()));
        if let Positions::Own { x, .. } = &trace.positions {
            assert_eq!(x.len(), trace.heights.len());
            assert!(x.windows(2).all(|pair| pair[0] < pair[1]));
        }
        if let Ok(even) = trace.resampled(trace.spacing()) {
            assert!(even.most.si().is_finite() && even.rms <= even.most);
        }
    }
    let drops = read_stream(name, Drops(Cursor::new(bytes)), &options);
    match (whole, drops) {
        (Ok(whole), Ok(drops)) => assert_eq!(whole, drops),
        (Err(whole), Err(drops)) => assert_eq!(whole.to_string(), drops.to_string()),
        (whole, drops) => panic!("{whole:?} at once, {drops:?} in drops"),
    }
}
