//! Traces as a profilometer would write them.

use std::fmt::Write;

/// A two-column file in micrometres of `heights`, `spacing` apart, both in metres.
pub fn trace_csv(spacing: f64, heights: &[f64]) -> String {
    let mut text = String::from("x [um],z [um]\n");
    for (i, z) in heights.iter().enumerate() {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:.6},{:.9}", i as f64 * spacing * 1e6, z * 1e6);
    }
    text
}
