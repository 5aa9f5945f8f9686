//! A small planetary set on the shipped traces.

use std::path::Path;

use asperity::case::Train;

const SET: &str = r#"
title = "small set"
[planetary]
teeth = [27, 24, -75]
planets = 3
module = "1.5 mm"
face_width = ["20 mm", "20 mm", "20 mm"]
[operation]
torque = "120 N m"
speed = "3000 1/min"
bulk_temperature = "90 °C"
[lubricant]
oil = "m100"
[surface]
cutoff = "0.25 mm"
sun = { file = "ground_pinion.csv" }
planet = { file = "ground_wheel.csv", mirrored = true }
[model]
positions = 6
offsets = 2
depths = 0
"#;

/// The set, loaded.
///
/// # Panics
/// When it is refused.
pub fn planetary_set() -> Train {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("set.toml");
    std::fs::write(&file, SET).unwrap();
    for flank in ["ground_pinion.csv", "ground_wheel.csv"] {
        let profiles = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/profiles");
        std::fs::copy(profiles.join(flank), folder.path().join(flank)).unwrap();
    }
    Train::load(&file).unwrap()
}
