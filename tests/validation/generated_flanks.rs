//! Loss of generated flanks against flanks left out: a table of `docs/records/generated-profiles.md`.
//!
//! `cargo test -p asperity-tests --test validation -- --ignored --nocapture generated_flanks`

use std::path::Path;

use asperity::LoadedCase;
use asperity::pipeline::losses;
use asperity::roughness::generate::{Like, truncated};
use asperity::roughness::preparation::prepare;
use asperity::roughness::relocation::{Bounds, relocate};
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

/// Prints losses of the pairs of both groups of traces as a row.
fn row(name: &str, torque: &str, left_out: &[Profile], made: &[Profile]) {
    let case = e_drive(torque);
    let [left_out, made] = [left_out, made].map(|traces| {
        let losses = losses_of(&case, traces);
        (mean(losses.iter().copied()), deviation(&losses).unwrap())
    });
    let error = |deviation: f64| deviation / (PAIRS as f64).sqrt();
    let errors = error(left_out.1).hypot(error(made.1));
    println!(
        "| {name} | {torque} | {:.2} ± {:.2} | {:.2} ± {:.2} | {:.1} | {:.2} |",
        left_out.0,
        error(left_out.1),
        made.0,
        error(made.1),
        (made.0 - left_out.0) / errors,
        made.1 / left_out.1
    );
}

#[test]
#[ignore = "many minutes; docs/records/generated-profiles.md has its table"]
fn losses_of_generated_flanks() {
    for finish in FINISHES {
        let all = traces(finish, GIVEN + 2 * PAIRS, seed_of(1));
        let (given, left_out) = all.split_at(GIVEN);
        let (_, made) = made_like(given, 2 * PAIRS);
        for torque in TORQUES {
            row(finish.0, torque, left_out, &made);
        }
    }
}

#[test]
#[ignore = "minutes; docs/records/generated-profiles.md has its table"]
fn losses_of_states() {
    for finish in [FINISHES[0], FINISHES[4]] {
        let all = traces(finish, GIVEN + 2 * PAIRS, seed_of(1));
        let pairs = all.iter().map(|before| {
            let after = truncated(before, 0.2).unwrap().0;
            [before.clone(), after.slice(200..before.len()).unwrap()]
        });
        let pairs: Vec<[Profile; 2]> = pairs.collect();
        let (given, left_out) = pairs.split_at(GIVEN);
        let left_out = left_out.iter().map(|[before, after]| {
            let found = relocate(before, after, Bounds::default()).unwrap();
            (found.before, found.after)
        });
        let left_out: Vec<_> = left_out.collect();
        for state in [0.0, 0.5, 1.0] {
            let between = |(before, after): &(Profile, Profile)| {
                let both = before.heights().iter().zip(after.heights());
                let heights = both.map(|(before, after)| before - state * (before - after));
                Profile::new(given[0][0].spacing(), heights.collect()).unwrap()
            };
            let kept: Vec<Profile> = left_out.iter().map(between).collect();
            let like = Like::of_pairs(&given[0], &given[1..], state).unwrap();
            let made = |seed| like.generate(seed).unwrap().generated.profile;
            let made: Vec<Profile> = (1..=2 * PAIRS as u64).map(made).collect();
            row(
                &format!("{}, state {state}", finish.0),
                "50 N m",
                &kept,
                &made,
            );
        }
    }
}
