//! Profiles as comma-separated text.

use std::fmt::Write as _;

use super::field::field;
use super::places::Places;
use crate::read::metadata::Metadata;

/// Writes x and height in metres, with the spacing of even points in the header.
pub(super) fn write(places: Places<'_>, heights: &[f64], metadata: &Metadata) -> Vec<u8> {
    let mut text = String::new();
    let mut comment = |name: &str, value: &Option<String>| {
        if let Some(value) = value {
            let _ = writeln!(text, "# {name} = {}", field(value));
        }
    };
    comment("title", &metadata.title);
    comment("instrument", &metadata.instrument);
    comment("date", &metadata.date);
    // Writing into a string cannot fail.
    if let Places::Even(dx) = places {
        let _ = writeln!(text, "# dx = {dx:e} m");
    }
    text += "x_m,z_m\n";
    for (i, z) in heights.iter().enumerate() {
        let x = match places {
            Places::Even(dx) => i as f64 * dx,
            Places::Own(x) => x[i],
        };
        let _ = writeln!(text, "{x:e},{z:e}");
    }
    text.into_bytes()
}
