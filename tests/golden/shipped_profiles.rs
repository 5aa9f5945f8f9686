//! The shipped profiles are those that their recipes make.

use std::path::Path;

use asperity_profile_io::read::{ReadOptions, read_bytes};

/// Heights are written to 0.01 nm; transforms round differently from machine to machine, which can move
/// the last digit by one.
const LAST_DIGIT: f64 = 1.1e-11;

#[test]
fn every_shipped_profile_is_what_its_recipe_makes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/profiles");
    let made = asperity_fixtures::profiles().unwrap();
    let shipped = std::fs::read_dir(&folder).unwrap().count();
    assert_eq!(
        shipped,
        made.len(),
        "profiles without a recipe, or the other way round"
    );
    for file in made {
        let bytes = std::fs::read(folder.join(file.name)).unwrap();
        let options = ReadOptions::default();
        let shipped = read_bytes(file.name, &bytes, &options).unwrap();
        let fresh = read_bytes(file.name, file.content.as_bytes(), &options).unwrap();
        assert_eq!(shipped.format, fresh.format, "{}", file.name);
        assert_eq!(shipped.spacing, fresh.spacing, "{}", file.name);
        let pairs = shipped
            .profile
            .heights()
            .iter()
            .zip(fresh.profile.heights());
        for (i, (a, b)) in pairs.enumerate() {
            assert!(
                (a - b).abs() < LAST_DIGIT,
                "{} point {i}: {a} {b}",
                file.name
            );
        }
    }
}
