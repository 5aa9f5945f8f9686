//! The work that an estimate counts. How close it is to the time taken is measured by `benches/benches/estimate.rs`.

#![allow(clippy::unwrap_used, reason = "tests may panic")]

use std::path::Path;

use asperity::Run;
use asperity::case::{CaseInput, LoadedCase, load};
use asperity::core::task::on_threads;
use asperity::pipeline::Kept;
use asperity_studies::estimate::{Cost, estimate, measured};

const KEPT: Kept = Kept::Highest;

/// The e-drive with 4 offsets and 12 positions, and further keys.
fn with(keys: &[(&str, &str)]) -> LoadedCase {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases/e-drive.toml");
    let few = [("model.offsets", "4"), ("model.positions", "12")];
    let set = |input: &mut CaseInput| {
        for (key, value) in few.iter().chain(keys) {
            input.set(key, value).unwrap();
        }
    };
    load(&file, None).unwrap().with(set).unwrap()
}

/// The estimate on one thread, whatever the machine has.
fn alone(case: &LoadedCase) -> Cost {
    on_threads(1, || estimate([case], &KEPT).unwrap()).unwrap()
}

#[test]
fn the_contacts_counted_are_the_contacts_solved() {
    for offsets in [1, 4] {
        let case = with(&[
            ("model.offsets", &offsets.to_string()),
            ("model.positions", "6"),
        ]);
        let solved = Run::new(&case).contacts().unwrap().swap_remove(0);
        // One of each position and offset.
        assert_eq!(solved.len(), 6 * offsets);
        assert_eq!(alone(&case).contacts, solved.len());
    }
}

#[test]
fn more_work_takes_longer() {
    let reference = alone(&with(&[]));
    let more = |keys: &[(&str, &str)]| alone(&with(keys));
    let fourfold = more(&[("model.offsets", "16")]);
    assert_eq!(fourfold.contacts, 4 * reference.contacts);
    assert!((fourfold.points / reference.points - 4.0).abs() < 1e-12);
    assert!(fourfold.seconds > 1.5 * reference.seconds);
    // The contacts of the further offsets are stored.
    assert!(fourfold.bytes > reference.bytes);
    let bulk = r#"{ law = "iso", lubrication = "jet" }"#;
    for keys in [
        &[("operation.running_in", "true")][..],
        &[
            ("operation.oil_temperature", "90 °C"),
            ("operation.bulk", bulk),
        ],
        &[("model.depths", "200")],
        &[("model.load_share", "ehl")],
    ] {
        let found = more(keys).seconds / reference.seconds;
        assert!(found > 1.2, "{keys:?}: {found}");
    }
    let table = more(&[("model.load_share", "lambda-star")]);
    assert!(table.seconds < reference.seconds);
}

#[test]
fn a_measured_estimate_computes_no_records() {
    let case = with(&[
        ("model.load_share", "ehl"),
        ("model.ehl", r#"{ cache = "off" }"#),
    ]);
    let found = measured([&case], &KEPT).unwrap();
    // Solving a contact or a record would have changed the time.
    assert_eq!(found, estimate([&case], &KEPT).unwrap());
    assert!(found.seconds > 1.0, "{found:?}");
}
