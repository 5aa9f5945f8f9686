//! Names of temperatures in file and variable names.

/// Name of a temperature: "60c", "m30c", "62p5c".
pub(super) fn degrees(temperature_c: f64) -> String {
    let size = format!("{}", temperature_c.abs()).replace('.', "p");
    let sign = if temperature_c < 0.0 { "m" } else { "" };
    format!("{sign}{size}c")
}
