//! The checks of the uncertainty of a loss that take minutes: intervals over operating points, offsets, and how often the interval
//! contains the loss of flanks of the same recipe. `docs/decisions/uncertainty.md` has the result of November 2026; `--example
//! uncertainty PAIRS POSITIONS` sets the number of pairs of flanks and of positions.

#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "an example prints, and stops when a case does not run"
)]

use asperity::pipeline::Kept;
use std::path::{Path, PathBuf};

use asperity::Run;
use asperity::case::{LoadedCase, load};
use asperity::core::Profile;
use asperity::core::numerics::student_t_quantile;
use asperity::core::quantity::Length;
use asperity::core::task::par_map;
use asperity::result::{SamplingPart, Uncertainty};
use asperity::uncertainty::Predictive;
use asperity_roughness::generate::Ground;

/// Keys and their values.
type Keys<'a> = &'a [(&'a str, &'a str)];

fn shipped(name: &str, keys: Keys<'_>) -> LoadedCase {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases");
    let case = load(&file.join(name), None).unwrap();
    let set = |case: LoadedCase, (key, value): &(&str, &str)| case.with_key(key, value).unwrap();
    keys.iter().fold(case, set)
}

fn drawn(case: &LoadedCase) -> (Uncertainty, Predictive) {
    let (outcome, predictive) = Run::new(case)
        .pictures(Kept::NoPictures)
        .interval(true)
        .execute()
        .unwrap()
        .only_with_draws()
        .unwrap();
    (outcome.result.uncertainty.unwrap(), predictive.unwrap())
}

fn loss(case: &LoadedCase) -> f64 {
    Run::new(case)
        .losses()
        .unwrap()
        .into_only()
        .unwrap()
        .summary
        .loss_w
}

/// The band of each finish and operating point, the median over the run, and losses by other choices, which it holds.
fn cells() {
    println!(
        "| N m | °C | finish | loss W | ln(median/run) | μ_b 0.08, lay 0 | half sliding | step rule |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for torque in ["145", "50", "20"] {
        for temperature in ["60", "90", "120"] {
            for name in ["e-drive.toml", "e-drive-superfinished.toml"] {
                let (torque, temperature) = (format!("{torque} N m"), format!("{temperature} °C"));
                let at = [
                    ("operation.torque", torque.as_str()),
                    ("operation.bulk_temperature", &temperature),
                ];
                let case = shipped(name, &at);
                let (found, predictive) = drawn(&case);
                let [low, high] = found.loss.drawn().ends();
                let other = [("model.boundary_friction", "0.08"), ("model.lay", "0")];
                let other = other.iter().fold(case.clone(), |case, (key, value)| {
                    case.with_key(key, value).unwrap()
                });
                let held = |loss: f64| {
                    let mark = if (low..=high).contains(&loss) {
                        ""
                    } else {
                        " **out**"
                    };
                    format!("{loss:.0}{mark}")
                };
                let of = |name: &str| {
                    let mut rows = found.structures.iter();
                    rows.find(|row| row.name.contains(name))
                        .unwrap()
                        .loss_w
                        .unwrap()
                };
                println!(
                    "| {torque} | {temperature} | {name} | {:.0} ({low:.0}..{high:.0}) | {:+.3} | {} | {} | {} |",
                    found.loss.drawn().value,
                    (found.loss.median_w / predictive.at_medians_w).ln(),
                    held(loss(&other)),
                    held(of("0.6")),
                    held(of("0.9")),
                );
            }
        }
    }
}

/// The loss by the offsets that a case takes, against many.
fn offsets() {
    println!(
        "\n| N m | offsets | loss W | of 512 | deviation | numerical error |\n|---|---|---|---|---|---|"
    );
    for torque in ["145 N m", "50 N m", "20 N m", "10 N m"] {
        let case = shipped("e-drive.toml", &[("operation.torque", torque)]);
        let (found, predictive) = drawn(&case);
        let SamplingPart::Windows(windows) = &found.sampling else {
            continue;
        };
        let many = loss(&case.with_key("model.offsets", "512").unwrap());
        println!(
            "| {torque} | {} | {:.1} | {many:.1} | {:+.2} % | {:.2} % |",
            windows.offsets,
            predictive.at_medians_w,
            100.0 * (predictive.at_medians_w / many - 1.0),
            100.0 * windows.numerical_error,
        );
    }
}

/// A ground trace as long and as rough as the shipped ones.
fn ground(seed: u64) -> Profile {
    let um = |value: f64| Length::from_si(value * 1e-6);
    let recipe = Ground {
        points: 5501,
        spacing: um(0.5),
        rq: um(0.42),
        grit_spacing: um(12.0),
        grit_radius: um(60.0),
        grit_protrusion: um(1.0),
        seed,
    };
    recipe.generate().unwrap()
}

fn with_flanks(case: &LoadedCase, seed: u64) -> LoadedCase {
    let name = |body: u64| PathBuf::from(format!("{body}"));
    let traces = [0, 1].map(|body| (name(body), ground(2 * seed + body)));
    let held = case.holding(&traces).with(|input| {
        input.surface.pinion.file = Some(name(0));
        input.surface.wheel.get_or_insert_default().file = Some(name(1));
    });
    held.unwrap()
}

/// How often the band of a pair of flanks holds the losses of the mean of all pairs, with constants, structure and model
/// error drawn, and the interval of the sampling alone that mean.
fn coverage(pairs: u64, positions: &str) {
    println!(
        "\n| N m | offsets | pairs | scatter of ln loss | whole band | least pair | sampling |\n|---|---|---|---|---|---|---|"
    );
    for (torque, offsets) in [("145 N m", "16"), ("20 N m", "16"), ("20 N m", "64")] {
        let keys = [
            ("operation.torque", torque),
            ("model.offsets", offsets),
            ("model.positions", positions),
        ];
        let case = shipped("e-drive.toml", &keys);
        let found: Vec<(Uncertainty, Predictive)> =
            par_map((0..pairs).collect::<Vec<_>>(), |seed| {
                drawn(&with_flanks(&case, 10 + seed))
            });
        let logs: Vec<f64> = found.iter().map(|(_, of)| of.at_medians_w.ln()).collect();
        let mean = logs.iter().sum::<f64>() / pairs as f64;
        let squares = logs.iter().map(|log| (log - mean).powi(2)).sum::<f64>();
        let scatter = (squares / (pairs - 1) as f64).sqrt();
        // The truth, but for the sampling: the draws of every tenth pair about the common mean, with errors of their own.
        let truths = found.iter().step_by(10).flat_map(|(_, drawn)| {
            let shift = mean.exp() / drawn.at_medians_w;
            let draws = drawn.draws_of_sum_w(1, 0.0).into_iter();
            draws.map(move |loss| shift * loss).collect::<Vec<_>>()
        });
        let truths: Vec<f64> = truths.collect();
        let held = |(of, _): &(Uncertainty, Predictive)| {
            let [low, high] = of.loss.drawn().ends();
            let within = truths.iter().filter(|truth| (low..=high).contains(truth));
            within.count() as f64 / truths.len() as f64
        };
        let held: Vec<f64> = found.iter().map(held).collect();
        let by_sampling = found.iter().zip(&logs).filter(|((of, _), log)| {
            let SamplingPart::Windows(windows) = &of.sampling else {
                return false;
            };
            let t = student_t_quantile(0.90, windows.freedom);
            (**log - mean).abs() <= t * windows.standard_error
        });
        println!(
            "| {torque} | {offsets} | {pairs} | {scatter:.3} | {:.3} | {:.3} | {:.3} |",
            held.iter().sum::<f64>() / pairs as f64,
            held.iter().copied().fold(1.0, f64::min),
            by_sampling.count() as f64 / pairs as f64,
        );
    }
}

fn main() {
    let [pairs, positions] = [1, 2].map(|k| std::env::args().nth(k));
    let pairs = pairs.and_then(|count| count.parse().ok());
    cells();
    offsets();
    coverage(pairs.unwrap_or(400), positions.as_deref().unwrap_or("8"));
}
