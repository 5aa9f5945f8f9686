//! The estimate of a run against the time that it takes, once per case: a ratio to the estimate, not a time to repeat.
//!
//! Times are processor times of one thread, so that other work of the machine does not count, and compared with those of a
//! reference case in the same process.
#![allow(
    clippy::disallowed_methods,
    reason = "the system counts processor time in a file without a size"
)]

use std::path::Path;
use std::time::Instant;

use asperity::Run;
use asperity::case::{CaseInput, LoadedCase, load_with};
use asperity::core::Profile;
use asperity::core::quantity::Length;
use asperity::core::task::on_threads;
use asperity::pipeline::Kept;
use asperity_benches::WORKSPACE;
use asperity_studies::estimate::estimate;

/// The e-drive with few offsets, changed.
fn e_drive(change: &dyn Fn(&mut CaseInput)) -> LoadedCase {
    let file = Path::new(WORKSPACE).join("fixtures/cases/e-drive.toml");
    load_with(&file, &|input| {
        input.model.offsets = Some(4);
        input.model.positions = Some(12);
        change(input);
    })
    .unwrap()
}

/// Set by a key of the case.
fn with(keys: &[(&str, &str)]) -> LoadedCase {
    e_drive(&|input| {
        for (key, value) in keys {
            input.set(key, value).unwrap();
        }
    })
}

/// Processor time of this thread, or the time of day where the system does not tell it.
fn seconds(begin: Instant) -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| begin.elapsed().as_secs_f64(), |found| found / 1e9)
}

/// Time of the case over its estimate, both on one thread.
fn taken_over_estimated(name: &str, make: &(dyn Fn() -> LoadedCase + Sync)) -> f64 {
    on_threads(1, || {
        let clock = Instant::now();
        let begin = seconds(clock);
        let case = make();
        Run::new(&case)
            .pictures(Kept::Highest)
            .interval(true)
            .execute()
            .unwrap()
            .into_only()
            .unwrap();
        let taken = seconds(clock) - begin;
        let estimated = estimate([&case], &Kept::Highest).unwrap();
        println!("{name}: {taken:.2} s, estimated {:.2} s", estimated.seconds);
        taken / estimated.seconds
    })
    .unwrap()
}

/// A rough trace of `points` points, half a micrometre apart.
fn long_trace(points: usize, seed: f64) -> Profile {
    let height = |i: usize| {
        let waves = (0..12).map(|k| {
            let length = 8e-6 * 1.4_f64.powi(k);
            let size = 0.12e-6 * (length / 100e-6).powf(0.5);
            let phase = seed * f64::from(k * k + 1);
            size * (std::f64::consts::TAU * 0.5e-6 * i as f64 / length + phase).sin()
        });
        waves.sum()
    };
    let heights = (0..points).map(height).collect();
    Profile::new(Length::from_si(0.5e-6), heights).unwrap()
}

/// The e-drive on traces of `points` points.
fn on_long_traces(points: usize) -> LoadedCase {
    let traces =
        [("a", 0.37), ("b", 0.71)].map(|(name, seed)| (name.into(), long_trace(points, seed)));
    let held = with(&[]).holding(&traces);
    held.with(|input| {
        input.surface.pinion.file = Some("a".into());
        input.surface.wheel.as_mut().unwrap().file = Some("b".into());
    })
    .unwrap()
}

/// Prints the ratio of time to estimate for each case, and over that of the reference.
fn main() {
    asperity_paper_2022::register();
    let reference = taken_over_estimated("reference", &|| with(&[]));
    type Make<'a> = &'a (dyn Fn() -> LoadedCase + Sync);
    let cases: [(&str, Make<'_>); 10] = [
        ("16 offsets", &|| with(&[("model.offsets", "16")])),
        ("running-in", &|| with(&[("operation.running_in", "true")])),
        ("share by Lambda*", &|| {
            with(&[("model.load_share", "lambda-star")])
        }),
        ("bulk temperature", &|| {
            with(&[
                ("operation.oil_temperature", "90 °C"),
                ("operation.bulk", r#"{ law = "iso", lubrication = "jet" }"#),
            ])
        }),
        ("200 depths", &|| with(&[("model.depths", "200")])),
        ("traces of 16 000 points", &|| on_long_traces(16_000)),
        ("traces of 500 000 points", &|| on_long_traces(500_000)),
        ("traces of 1 000 000 points", &|| on_long_traces(1_000_000)),
        ("records", &|| {
            with(&[
                ("model.load_share", "ehl"),
                (
                    "model.ehl",
                    r#"{ records = 2, cells = 192, travel = 4.0, cache = "off" }"#,
                ),
            ])
        }),
        ("paper", &|| {
            with(&[("formulation", "paper"), ("paper.delta_step", "50 nm")])
        }),
    ];
    for (name, make) in cases {
        let ratio = taken_over_estimated(name, make);
        println!(
            "  {:.2} times the ratio of the reference",
            ratio / reference
        );
    }
}
