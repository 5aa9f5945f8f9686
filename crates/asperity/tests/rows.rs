//! Rows and warnings of a result agree with each other.

#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::path::Path;

use asperity::case::load;
use asperity::prelude::RunResult;

fn result(positions: usize) -> RunResult {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases/e-drive.toml");
    let case = load(&file, None).unwrap().with(|input| {
        input.model.positions = Some(positions);
        input.model.offsets = Some(2);
        input.model.run_in = Some(false);
    });
    asperity::run(&case.unwrap(), &|_, _| ()).unwrap().result
}

fn close(value: f64, expected: f64) {
    assert!((value / expected - 1.0).abs() < 1e-12, "{value} {expected}");
}

#[test]
fn the_loss_of_a_position_is_the_sum_of_its_parts() {
    for row in result(6).path {
        let parts = row.film_w_per_m + row.lubricated_asperity_w_per_m + row.boundary_w_per_m;
        close(row.sliding_w_per_m, parts);
        close(
            row.entrainment_m_per_s,
            0.5 * (row.u1_m_per_s + row.u2_m_per_s),
        );
    }
}

#[test]
fn warnings_count_the_positions_and_contacts_that_they_are_about() {
    let result = result(6);
    let text = |code: &str| {
        let found = result.warnings.iter().find(|warning| warning.code == code);
        found.map(|warning| warning.text.clone())
    };
    // The contacts of the ground flanks flow and pass the elastic limit everywhere.
    let flows = text("W409").unwrap();
    assert!(flows.contains("at 6 of 6 positions"), "{flows}");
    let strained = text("W410").unwrap();
    assert!(strained.contains("in 12 of 12 contacts"), "{strained}");
}
