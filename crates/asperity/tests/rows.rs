//! Rows and warnings of a result agree with each other.

#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::path::Path;

use asperity::case::load;
use asperity::prelude::RunResult;
use asperity::result::{OutsideInput, PositionRow};

fn result(positions: usize) -> RunResult {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases/e-drive.toml");
    let case = load(&file, None).unwrap().with(|input| {
        input.model.positions = Some(positions);
        input.model.offsets = Some(2);
        input.operation.running_in = None;
    });
    asperity::Run::new(&case.unwrap())
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
        .result
}

fn close(value: f64, expected: f64) {
    assert!((value / expected - 1.0).abs() < 1e-12, "{value} {expected}");
}

#[test]
fn the_loss_of_a_position_is_friction_times_load_times_sliding() {
    // The load over the face and the sliding vary within the cell that a position stands for, the less the more
    // cells there are; in that with the pitch point sliding changes its sign.
    let farthest = |positions| {
        let ratio = |row: &PositionRow| {
            let load = 1e3 * row.line_load_n_per_mm;
            row.sliding_w_per_m / (row.mu * load * row.sliding_m_per_s.abs())
        };
        let rows = result(positions).path;
        let fast = rows.iter().filter(|row| row.slide_to_roll.abs() > 0.1);
        fast.map(|row| (ratio(row) - 1.0).abs()).fold(0.0, f64::max)
    };
    let [coarse, fine] = [6, 24].map(farthest);
    assert!(coarse < 0.3 && fine < 0.3 * coarse, "{coarse} {fine}");
    for row in result(6).path {
        let load = 1e3 * row.sliding_load_n_per_mm;
        let again = row.mu * load * row.sliding_m_per_s.abs();
        close(row.sliding_w_per_m, again);
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
    // The contacts of the ground flanks flow and pass the elastic limit nearly everywhere.
    let flows = text("W409").unwrap();
    let flowing = result
        .path
        .iter()
        .filter(|row| row.plastic_work_j_per_m > Some(0.0));
    let said = format!("at {} of 6 positions", flowing.count());
    assert!(flows.contains(&said), "{flows}");
    let strained = text("W410").unwrap();
    assert!(strained.contains(" of 12 contacts"), "{strained}");
}

#[test]
fn losses_name_what_left_its_range_as_a_run_does() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases/e-drive.toml");
    let few = |temperature: &str| {
        let case = load(&file, None).unwrap().with(|input| {
            input.model.positions = Some(4);
            input.model.offsets = Some(2);
        });
        case.unwrap()
            .with_key("operation.bulk_temperature", temperature)
            .unwrap()
    };
    let named = |temperature: &str| crate::runs::losses(&few(temperature)).unwrap().outside;
    let outside = named("90 °C");
    assert!(
        outside
            .iter()
            .all(|input| input.to_string().starts_with("W40")),
        "{outside:?}"
    );
    let warnings = asperity::Run::new(&few("90 °C"))
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
        .result
        .warnings;
    let ranges = warnings.iter().filter(|found| found.code == "W401");
    let mut said = 0;
    for warning in ranges {
        assert!(
            outside.iter().any(|outside| {
                let input = outside.input.unwrap();
                warning.text.starts_with(&format!("{input} "))
            }),
            "{outside:?} {}",
            warning.text
        );
        said += 1;
    }
    assert!(said > 0);
    // Hot oil is thinner than Gold's fit reaches.
    let thin = |names: &[OutsideInput]| {
        names.iter().any(|name| {
            name.to_string() == "W401 Gold's pressure-viscosity fit: kinematic viscosity"
        })
    };
    assert!(thin(&outside) && !thin(&named("40 °C")), "{outside:?}");
}
