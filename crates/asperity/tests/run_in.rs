//! Flanks that run in, and what the mesh then loses.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use std::path::Path;

use asperity::case::{LoadedCase, RunningInPlan, load};
use asperity::core::task::on_threads;
use asperity::flanks::surfaces::{Surfaces, Texture};
use asperity::pipeline::{HistorySettings, history};
use asperity::quantity::{Length, Torque};
use asperity::result::{Losses, RunInFlanks};
use asperity::running_in::{RanIn, limits, run_in};
use asperity_core::Profile;

fn with(name: &str, keys: &[(&str, &str)]) -> LoadedCase {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases");
    let case = load(&folder.join(format!("{name}.toml")), None).unwrap();
    let few = [("model.positions", "8"), ("model.offsets", "2")];
    few.iter().chain(keys).fold(case, |case, (key, value)| {
        case.with_key(key, value).unwrap()
    })
}

fn losses(case: &LoadedCase) -> Losses {
    crate::runs::losses(case).unwrap()
}

/// The flanks of a case run in at a torque in N m over a number of engagements.
fn ran_in(case: &LoadedCase, torque: f64, engagements: f64) -> RanIn {
    let plan = RunningInPlan {
        torque: Torque::from_si(torque),
        engagements: Some(engagements),
    };
    run_in(&case.case, &case.surfaces, &plan, &|_| {}).unwrap()
}

fn removed(of: &RanIn) -> [f64; 2] {
    of.steps.last().unwrap().removed_nm
}

fn summary_run_in(name: &str, keys: &[(&str, &str)]) -> (f64, RunInFlanks) {
    let keys = [keys, &[("operation.running_in", "{ engagements = 64 }")]].concat();
    let losses = losses(&with(name, &keys));
    (losses.summary.loss_w, losses.run_in.unwrap())
}

/// Fails on windows that fit side by side into a trace, as flanks ran in before.
#[test]
fn more_load_and_more_engagements_remove_more() {
    let case = with("fzg-c", &[]);
    // Engagements lower and never raise: exactly.
    let long = ran_in(&case, 302.0, 64.0);
    for body in 0..2 {
        let each = long.steps.iter().map(|step| step.removed_nm[body]);
        assert!(each.is_sorted_by(|a, b| a < b), "{:?}", long.steps);
    }
    // One window of this trace pressed at 1000 N m flattens less than at 94 N m.
    let at = [30.0, 94.1, 302.0, 535.0, 1000.0].map(|torque| removed(&ran_in(&case, torque, 48.0)));
    for body in 0..2 {
        assert!(at.is_sorted_by(|a, b| 1.05 * a[body] < b[body]), "{at:?}");
    }
}

/// Fails on windows that fit side by side into a trace, as flanks ran in before.
#[test]
fn rq_after_48_engagements_is_that_of_an_independent_program_but_for_the_engagements_of_the_wheel()
{
    // It let the wheel engage as often as the pinion: its mean of both is met, and the pinion flows more, the wheel less. Its Rq is
    // from the mean line of the fresh flank.
    let case = with("fzg-c", &[("model.positions", "16")]);
    for (torque, [pinion, wheel]) in [
        (30.0, [0.276, 0.296]),
        (94.1, [0.258, 0.275]),
        (302.0, [0.237, 0.251]),
        (535.0, [0.233, 0.242]),
        (1000.0, [0.234, 0.248]),
    ] {
        let found = ran_in(&case, torque, 48.0);
        let (rq, down) = (found.heights[1].rq_um, removed(&found).map(|nm| 1e-3 * nm));
        let [of_pinion, of_wheel] = [0, 1].map(|body| rq[body].hypot(down[body]));
        let both = (of_pinion + of_wheel) / (pinion + wheel);
        assert!((both - 1.0).abs() < 0.03, "{torque}: {both}");
        assert!(
            (of_pinion / pinion - 1.0).abs() < 0.085,
            "{torque}: {of_pinion}"
        );
        assert!(
            (of_wheel / wheel - 1.0).abs() < 0.045,
            "{torque}: {of_wheel}"
        );
        assert!(down[0] > 1.3 * down[1]);
    }
}

/// Fails on flanks as they ran in before by the mean line; a guard for the valleys.
#[test]
fn valleys_that_nothing_touches_stay_and_the_mean_line_goes_down() {
    let case = with("fzg-c", &[]);
    let found = ran_in(&case, 94.1, 32.0);
    let of_bodies = removed(&found).map(|nm| 1e-9 * nm);
    for (body, down) in of_bodies.into_iter().enumerate() {
        let [before, after] = [&case.surfaces, &found.surfaces]
            .map(|surfaces| surfaces.traces().unwrap()[body].heights());
        let mut sorted = before.to_vec();
        sorted.sort_by(f64::total_cmp);
        let deepest = sorted[before.len() / 200];
        // The mean line goes down: all heights from it rise by the same, exactly but for the rounding of a sum.
        let lowered = |(z, after): (&f64, &f64)| z + down - after;
        let pairs = || before.iter().zip(after);
        let valleys = pairs().filter(|(z, _)| **z <= deepest);
        assert!(valleys.map(lowered).all(|by| by.abs() < 1e-20));
        assert!(pairs().map(lowered).all(|by| by > -1e-20));
        let mean = |z: &[f64]| z.iter().sum::<f64>() / z.len() as f64;
        assert!((mean(after) - mean(before)).abs() < 1e-18);
        let squares: Vec<f64> = after.iter().map(|z| (z - mean(after)).powi(2)).collect();
        let rq = 1e6 * mean(&squares).sqrt();
        assert!((found.heights[1].rq_um[body] / rq - 1.0).abs() < 1e-3);
    }
}

/// Fails on windows that fit side by side into a trace, as flanks ran in before.
#[test]
fn a_trace_appended_to_itself_or_turned_round_runs_in_alike() {
    let case = with("fzg-c", &[]);
    let traces = case.surfaces.traces().unwrap();
    let on = |change: &dyn Fn(&[f64]) -> Vec<f64>| {
        let texture = |trace: &Profile| {
            Texture::Trace(Profile::new(trace.spacing(), change(trace.heights())).unwrap())
        };
        let flanks = Surfaces::new([texture(traces[0]), texture(traces[1])], None, false);
        let other = case.with_surfaces(flanks);
        ran_in(&other, 302.0, 64.0)
    };
    let own = on(&|z| z.to_vec());
    for change in [&|z: &[f64]| [z, z].concat(), &|z: &[f64]| {
        z.iter().rev().copied().collect::<Vec<_>>()
    }] as [&dyn Fn(&[f64]) -> Vec<f64>; 2]
    {
        let other = on(change);
        for body in 0..2 {
            let ratio = removed(&other)[body] / removed(&own)[body];
            assert!((ratio - 1.0).abs() < 0.08, "{ratio}");
            let rq = other.heights[1].rq_um[body] / own.heights[1].rq_um[body];
            assert!((rq - 1.0).abs() < 0.03, "{rq}");
        }
    }
}

/// A guard: it held of windows side by side, too.
#[test]
fn flanks_that_do_not_flow_do_not_run_in() {
    for (name, keys) in [
        ("e-drive-superfinished", &[][..]),
        (
            "e-drive",
            &[("material.pinion.flow_pressure", "40 GPa")][..],
        ),
    ] {
        let (measured, found) = summary_run_in(name, keys);
        assert_eq!(found.summary.loss_w, measured, "{name}");
        assert_eq!(found.measured, found.run_in);
        assert_eq!(found.steps.last().unwrap().removed_nm, [0.0; 2]);
        assert_eq!(found.steps.last().unwrap().engagements, 8.0);
    }
}

#[test]
fn running_in_takes_height_and_loss_off_ground_flanks() {
    let (measured, found) = summary_run_in("e-drive", &[]);
    let change = found.summary.loss_w / measured - 1.0;
    assert!((-0.25..-0.08).contains(&change), "{change}");
    for body in 0..2 {
        assert!(found.run_in.rpk_um[body] < found.measured.rpk_um[body]);
        let rq = found.steps.iter().map(|step| step.heights.rq_um[body]);
        assert!(rq.is_sorted_by(|a, b| a >= b));
    }
    // Hardly anything flows in an engagement of run-in flanks.
    assert!(found.running_in.first_pass_w < 0.1 * measured);
}

#[test]
fn the_softer_flank_runs_in_more() {
    // Softer still, both flow so far that Rq no longer follows the displacement.
    let soft = [("material.wheel.flow_pressure", "5 GPa")];
    let of = |keys: &[(&str, &str)]| {
        let [pinion, wheel] = summary_run_in("e-drive", keys)
            .1
            .steps
            .last()
            .unwrap()
            .removed_nm;
        wheel / pinion
    };
    assert!(of(&soft) > 1.3 * of(&[]), "{} {}", of(&soft), of(&[]));
}

/// A guard: it held of windows side by side, too.
#[test]
fn running_in_is_the_same_on_one_and_two_threads_and_for_kept_contacts() {
    let keys = [
        ("model.positions", "4"),
        ("operation.running_in", "{ engagements = 16 }"),
    ];
    let case = with("e-drive", &keys);
    let on = |threads: usize| on_threads(threads, || losses(&case)).unwrap();
    let one = on(1);
    assert_eq!(one.run_in, on(2).run_in);
    let tables = crate::runs::contacts(&case).unwrap();
    let kept = crate::runs::losses_with(&tables, &case).unwrap();
    assert_eq!(kept.run_in, one.run_in);
    let without = case.with_key("operation.running_in", "false").unwrap();
    let plain = losses(&without);
    assert!(plain.run_in.is_none() && plain.summary == one.summary);
}

#[test]
fn flanks_of_several_teeth_run_in_as_they_meet() {
    let case = with("e-drive", &[]);
    let one = ran_in(&case, 145.0, 16.0);
    let traces = case.surfaces.traces().unwrap().map(Clone::clone);
    let [pinion, wheel] = traces.each_ref().map(|trace| trace.heights().to_vec());
    let held: Vec<(std::path::PathBuf, Profile)> =
        [("p1", &pinion), ("p2", &pinion), ("w1", &wheel)]
            .into_iter()
            .map(|(name, z)| {
                (
                    name.into(),
                    Profile::new(traces[0].spacing(), z.clone()).unwrap(),
                )
            })
            .collect();
    let several = case.holding(&held).with(|input| {
        let file = |name: &str| asperity::case::TraceInput {
            file: name.into(),
            ..Default::default()
        };
        input.surface.cutoff = Some(Length::from_si(0.0));
        input.surface.noise_cutoff = Some(Length::from_si(0.0));
        input.surface.form = Some(asperity::roughness::form::Form::None);
        input.surface.put_measured(
            asperity::gear::Gear::Pinion,
            case.case.torque,
            vec![file("p1"), file("p2")],
        );
        input.surface.put_measured(
            asperity::gear::Gear::Wheel,
            case.case.torque,
            vec![file("w1")],
        );
    });
    let several = several.unwrap();
    let both = ran_in(&several, 145.0, 16.0);
    assert_eq!(both.surfaces.teeth(), Some([2, 1]));
    for body in 0..2 {
        // Two equal teeth of the pinion have had as many engagements each.
        let ratio = removed(&both)[body] / removed(&one)[body];
        assert!((ratio - 1.0).abs() < 0.1, "{body}: {ratio}");
    }
    let pinions =
        [0, 1].map(|tooth| both.surfaces.of_teeth([tooth, 0], 0).traces().unwrap()[0].heights());
    assert!(pinions[0] != pinions[1]);
}

#[test]
fn wear_goes_on_where_flow_ends() {
    let case = with("fzg-c", &[]);
    let settings = HistorySettings {
        plan: RunningInPlan {
            torque: Torque::from_si(302.0),
            engagements: Some(64.0),
        },
        limit: limits(&case.case).unwrap()[1],
        worn: 1e-12,
        least: None,
    };
    let found = history(&case.at_stated().unwrap(), &settings, &|_| {}).unwrap();
    assert!(
        found
            .states
            .is_sorted_by(|a, b| a.engagements <= b.engagements && a.worn <= b.worn)
    );
    let last = found.states.last().unwrap();
    assert!(last.worn == 1e-12 && last.loss_w < found.states[0].loss_w);
    for body in 0..2 {
        let each = found.states.iter().map(|state| state.removed[body]);
        assert!(each.is_sorted());
    }
    assert!(last.asperity_share < 0.6 * found.states[0].asperity_share);
}

#[test]
fn the_limit_of_the_pressure_lies_between_first_yield_and_no_friction() {
    let [low, middle, high] = limits(&with("e-drive", &[]).case).unwrap();
    assert!((low.si() / 4.3e9 - 1.0).abs() < 1e-12);
    assert!((high.si() / (7e9 * 4.0 / 27.0_f64.sqrt()) - 1.0).abs() < 1e-12);
    assert!(low < middle && middle < high);
    // More flows at the lower limit.
    let case = with("e-drive", &[]);
    let of = |limit| {
        let plan = RunningInPlan {
            torque: case.case.torque,
            engagements: Some(16.0),
        };
        let settings = HistorySettings {
            plan,
            limit,
            worn: 0.0,
            least: None,
        };
        history(&case.at_stated().unwrap(), &settings, &|_| {})
            .unwrap()
            .states
            .last()
            .unwrap()
            .removed
    };
    let [at_low, at_high] = [of(low), of(high)];
    assert!((0..2).all(|body| at_low[body] > 1.2 * at_high[body]));
}

#[test]
fn running_in_needs_both_traces() {
    let case = with("e-drive", &[("operation.running_in", "true")]);
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
