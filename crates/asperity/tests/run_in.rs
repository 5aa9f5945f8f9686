//! Flanks that run in, and what the mesh then loses.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use std::path::Path;

use asperity::case::{LoadedCase, load};
use asperity::result::{Losses, RunInFlanks};

fn with(name: &str, keys: &[(&str, &str)]) -> LoadedCase {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases");
    let case = load(&folder.join(format!("{name}.toml")), None).unwrap();
    let few = [
        ("model.positions", "8"),
        ("model.offsets", "2"),
        ("operation.running_in", "true"),
    ];
    few.iter().chain(keys).fold(case, |case, (key, value)| {
        case.with_key(key, value).unwrap()
    })
}

fn losses(case: &LoadedCase) -> Losses {
    asperity::losses(case).unwrap()
}

fn run_in(name: &str, keys: &[(&str, &str)]) -> (f64, RunInFlanks) {
    let losses = losses(&with(name, keys));
    (losses.summary.loss_w, losses.run_in.unwrap())
}

#[test]
fn running_in_takes_height_and_loss_off_ground_flanks() {
    let (measured, found) = run_in("e-drive", &[]);
    // Every window of one flank meets every window of the other in a cycle.
    assert!(
        found
            .cycles
            .iter()
            .all(|cycle| cycle.passes == found.cycles[0].passes)
    );
    let change = found.summary.loss_w / measured - 1.0;
    assert!((-0.25..-0.08).contains(&change), "{change}");
    // Measured: Sq to -17 %.
    let rq = found.run_in.rq_um[0] / found.measured.rq_um[0] - 1.0;
    assert!((-0.15..-0.09).contains(&rq), "{rq}");
    for body in 0..2 {
        assert!(found.run_in.rpk_um[body] < found.measured.rpk_um[body]);
        let rq = found.cycles.iter().map(|cycle| cycle.rq_um[body]);
        assert!(rq.is_sorted_by(|a, b| a >= b));
    }
    // Every cycle flows less, but for the luck of its windows: the last quarter does a tenth of the first.
    let work: Vec<f64> = found
        .cycles
        .iter()
        .map(|cycle| cycle.plastic_work_j_per_m)
        .collect();
    let quarter = work.len() / 4;
    let sum = |part: &[f64]| part.iter().sum::<f64>();
    assert!(
        sum(&work[work.len() - quarter..]) < 0.25 * sum(&work[..quarter]),
        "{work:?}"
    );
    // Hardly anything flows in an engagement of run-in flanks.
    assert!(found.running_in.first_pass_w < 0.1 * measured);
}

#[test]
fn a_limit_of_seven_gigapascals_gives_the_roughness_of_an_independent_program() {
    // It found Rq 0.299 -> 0.283 um after 400 passes at 7 GPa, here the shakedown limit of a hardness of 10.09 GPa.
    let hard = [("material.pinion.flow_pressure", "10.09 GPa")];
    let (_, found) = run_in("e-drive", &hard);
    let [before, after] = [found.measured.rq_um[0], found.run_in.rq_um[0]];
    assert!(
        (before - 0.299).abs() < 1e-3 && (after - 0.283).abs() < 3e-3,
        "{after}"
    );
}

#[test]
fn flanks_that_do_not_flow_do_not_run_in() {
    for (name, keys) in [
        ("e-drive-superfinished", &[][..]),
        (
            "e-drive",
            &[("material.pinion.flow_pressure", "40 GPa")][..],
        ),
    ] {
        let (measured, found) = run_in(name, keys);
        assert_eq!(found.summary.loss_w, measured, "{name}");
        assert_eq!(found.measured, found.run_in);
        assert_eq!(found.cycles.len(), 1);
        assert_eq!(found.cycles[0].plastic_work_j_per_m, 0.0);
    }
}

#[test]
fn the_softer_flank_runs_in_more() {
    // Softer still, both flow so far that Rq no longer follows the displacement.
    let soft = [("material.wheel.flow_pressure", "5 GPa")];
    let (_, found) = run_in("e-drive", &soft);
    let lost = |body: usize| {
        let square = |rq: f64| rq * rq;
        square(found.measured.rq_um[body]) - square(found.run_in.rq_um[body])
    };
    assert!(lost(1) > 1.1 * lost(0), "{} {}", lost(0), lost(1));
}

#[test]
fn running_in_is_the_same_on_one_and_two_threads_and_for_kept_contacts() {
    let case = with("e-drive", &[("model.positions", "4")]);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| losses(&case))
    };
    let one = on(1);
    assert_eq!(one.run_in, on(2).run_in);
    let tables = asperity::pipeline::contacts(&case).unwrap();
    let kept = asperity::pipeline::losses_with(&tables, &case).unwrap();
    assert_eq!(kept.run_in, one.run_in);
    let without = case.with_key("operation.running_in", "false").unwrap();
    let plain = losses(&without);
    assert!(plain.run_in.is_none() && plain.summary == one.summary);
}

#[test]
fn running_in_needs_both_traces() {
    let case = with("e-drive", &[]);
    let values = case.with(|input| {
        input.surface.wheel = Some(asperity::case::FlankInput {
            rq: "0.3 um".parse().ok(),
            ..Default::default()
        });
    });
    let error = values.unwrap_err();
    assert_eq!(error.code(), "E205");
    assert!(
        error.to_string().contains("operation.running_in"),
        "{error}"
    );
}
