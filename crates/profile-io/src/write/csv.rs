//! Profiles as comma-separated text.

use std::fmt::Write as _;

use asperity_core::Profile;

use super::field::field;
use crate::read::metadata::Metadata;

/// x and height in metres under a header with the spacing.
pub(super) fn write(profile: &Profile, metadata: &Metadata) -> Vec<u8> {
    let dx = profile.spacing().si();
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
    let _ = writeln!(text, "# dx = {dx:e} m\nx_m,z_m");
    for (i, z) in profile.heights().iter().enumerate() {
        let _ = writeln!(text, "{:e},{z:e}", i as f64 * dx);
    }
    text.into_bytes()
}
