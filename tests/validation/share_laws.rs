//! Asperity share over the film ratio: the solved share, and published laws for comparison.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::OnceLock;

use asperity_report::chart::{Axis, Chart, Dress, Line, Series};
use asperity_tests::picture::hold_picture;

use crate::load_share::{FEW, losses};
use crate::measured_cases::kept;

/// erf to 1.5e-7 (Abramowitz and Stegun 7.1.26).
pub fn erf(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.327_591_1 * x);
    let coefficients = [
        1.061_405_429,
        -1.453_152_027,
        1.421_413_741,
        -0.284_496_736,
        0.254_829_592,
    ];
    let sum = coefficients.iter().fold(0.0, |sum, c| sum * t + c);
    1.0 - sum * t * (-x * x).exp()
}

/// One speed of the ground e-drive flanks: the film ratio, the solved share and those of published laws.
struct ShareRow {
    lambda: f64,
    solved: f64,
    laws: BTreeMap<&'static str, f64>,
}

const LAWS: [&str; 3] = ["lambda-star", "zhu-hu", "masjedi-khonsari"];

/// Asperity shares over the film ratio, by the speed.
fn shares() -> &'static [ShareRow] {
    static SHARES: OnceLock<Vec<ShareRow>> = OnceLock::new();
    SHARES.get_or_init(|| {
        let kept = kept("e-drive", &FEW);
        let speeds = [100, 300, 1000, 3000, 9000, 25_000];
        let mut rows: Vec<ShareRow> = Vec::new();
        let colder = [9000, 25_000];
        for (temperature, speeds) in [
            ("90 °C", &speeds[..]),
            ("40 °C", &colder),
            ("15 °C", &colder),
        ] {
            for speed in speeds {
                let speed = format!("{speed} 1/min");
                let keys = [
                    ("operation.speed", &*speed),
                    ("operation.bulk_temperature", temperature),
                ];
                let case = kept.with(&keys);
                let found = kept.at(&keys).losses;
                let ratios = found.path.iter().filter_map(|row| row.film_ratio);
                let lambda = ratios.sum::<f64>() / found.path.len() as f64;
                let of = |law: &str| {
                    let case = case.with_key("model.load_share", law).unwrap();
                    losses(&case).summary.asperity_share
                };
                let mut laws: BTreeMap<_, _> = LAWS.map(|law| (law, of(law))).into();
                laws.insert("1 - erf(lambda)", 1.0 - erf(lambda));
                laws.insert("(1 - lambda/2)^2", (1.0 - 0.5 * lambda).max(0.0).powi(2));
                rows.push(ShareRow {
                    lambda,
                    solved: found.summary.asperity_share,
                    laws,
                });
            }
        }
        rows.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
        rows
    })
}

/// Asperity shares over the film ratio.
pub fn share_table() -> String {
    let mut names: Vec<&str> = shares()[0].laws.keys().copied().collect();
    names.sort_unstable();
    let mut text = format!("| lambda | solved | {} |\n", names.join(" | "));
    let _ = writeln!(text, "|---{}|", "|---".repeat(1 + names.len()));
    for row in shares() {
        let laws = names.iter().map(|name| format!("{:.3}", row.laws[name]));
        let laws: Vec<String> = laws.collect();
        let _ = writeln!(
            text,
            "| {:.2} | {:.3} | {} |",
            row.lambda,
            row.solved,
            laws.join(" | ")
        );
    }
    text.push_str("\nTest: `the_solved_share_falls_as_the_film_ratio_rises`.\n");
    text
}

/// The same as a picture.
fn share_picture() -> String {
    let lambda: Vec<f64> = shares().iter().map(|row| row.lambda).collect();
    let solved: Vec<f64> = shares().iter().map(|row| row.solved).collect();
    let axes = [
        Axis::new("film ratio h_min/Rq", "-").log(),
        Axis::new("share of the load on asperities", "-"),
    ];
    let [x, y] = axes;
    let title = "Asperity share of the e-drive's ground flanks, and published laws";
    let mut chart = Chart::new("load-share", title, "mixed-film.md", x, y);
    chart = chart.with(Series::new("solved", Line::Dots, &lambda, &solved));
    for name in shares()[0].laws.keys() {
        let of: Vec<f64> = shares().iter().map(|row| row.laws[name]).collect();
        chart = chart.with(Series::new(name, Line::Dashed, &lambda, &of));
    }
    chart.svg(Dress::Alone)
}

#[test]
fn the_solved_share_falls_as_the_film_ratio_rises() {
    println!("{}", share_table());
    let solved: Vec<f64> = shares().iter().map(|row| row.solved).collect();
    assert!(solved.is_sorted_by(|a, b| a >= b), "{solved:?}");
}

#[test]
fn the_picture_of_the_shares_is_drawn() {
    hold_picture("figures/load_share.svg", &share_picture());
}
