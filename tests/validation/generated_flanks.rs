//! Loss of generated flanks against flanks left out: a table of `docs/records/generated-profiles.md`.
//!
//! `cargo test -p asperity-tests --test validation -- --ignored --nocapture generated_flanks`

use std::path::Path;

use asperity::LoadedCase;
use asperity::pipeline::losses;
use asperity::roughness::preparation::prepare;
use asperity_core::Profile;
use asperity_core::numerics::{deviation, mean};

use self::finishes::{FINISHES, made_like, seed_of, traces};

#[path = "../../crates/roughness/tests/common/finishes.rs"]
mod finishes;

/// Traces to generate others like.
const GIVEN: usize = 6;
/// Pairs of generated traces, and of traces left out.
const PAIRS: usize = 20;
const TORQUES: [&str; 3] = ["20 N m", "50 N m", "145 N m"];

/// Loss of the e-drive with each pair of traces \[W\].
fn losses_of(case: &LoadedCase, traces: &[Profile]) -> Vec<f64> {
    let pairs = traces.as_chunks::<2>().0;
    pairs.iter().map(|pair| loss(case, pair)).collect()
}

fn loss(case: &LoadedCase, [pinion, wheel]: &[Profile; 2]) -> f64 {
    let prepared = |trace: &Profile| prepare(trace, &case.case.preparation).unwrap().profile;
    let mut case = case.clone();
    case.surfaces = case
        .surfaces
        .with_traces([prepared(pinion), prepared(wheel)]);
    losses(&case).unwrap().summary.loss_w
}

fn e_drive(torque: &str) -> LoadedCase {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases/e-drive.toml");
    let set = |input: &mut asperity::case::CaseInput| {
        input.operation.torque = torque.parse().unwrap();
    };
    asperity::case::load_with(&file, &set).unwrap()
}

#[test]
#[ignore = "many minutes; docs/records/generated-profiles.md has its table"]
fn losses_of_generated_flanks() {
    println!(
        "| finish | torque | left out, W | generated, W | difference, standard errors | ratio of the standard deviations |"
    );
    println!("|---|---|---|---|---|---|");
    for finish in FINISHES {
        let all = traces(finish, GIVEN + 2 * PAIRS, seed_of(1));
        let (given, left_out) = all.split_at(GIVEN);
        let (_, made) = made_like(given, 2 * PAIRS);
        for torque in TORQUES {
            let case = e_drive(torque);
            let [left_out, made] = [left_out, &made].map(|traces| {
                let losses = losses_of(&case, traces);
                (mean(losses.iter().copied()), deviation(&losses).unwrap())
            });
            let error = |deviation: f64| deviation / (PAIRS as f64).sqrt();
            let errors = error(left_out.1).hypot(error(made.1));
            println!(
                "| {} | {torque} | {:.2} ± {:.2} | {:.2} ± {:.2} | {:.1} | {:.2} |",
                finish.0,
                left_out.0,
                error(left_out.1),
                made.0,
                error(made.1),
                (made.0 - left_out.0) / errors,
                made.1 / left_out.1
            );
        }
    }
}
