//! Losses of Petry-Johnson's gears compared with an independent computation, and films of cold oil.

use std::fmt::Write as _;
use std::sync::OnceLock;

use asperity_tests::petry_johnson;

use crate::load_share::{FEW, few};
use crate::measured_cases::{Kept, kept};

/// Speeds 1/min of the Petry-Johnson gears and the losses \[W\] of the independent computation.
const PETRY_JOHNSON: [(u32, f64); 5] = [
    (2000, 152.0),
    (4000, 326.0),
    (6000, 505.0),
    (8000, 683.0),
    (10_000, 859.0),
];

#[test]
fn the_load_share_gives_what_was_computed_elsewhere() {
    // The independent computation has a trapezoid, and a limiting shear stress of 0.04 instead of 0.035.
    let trapezoid = toml::toml! { load_distribution = "trapezoid" };
    let trapezoid = Kept::new(petry_johnson().with("model", trapezoid).load());
    for (speed, independent) in PETRY_JOHNSON {
        let found = trapezoid.at(&[("operation.speed", &format!("{speed} 1/min"))]);
        let seen = found.losses.summary.loss_w;
        assert!(
            (seen / independent - 1.0).abs() < 0.12,
            "{speed}: {seen} for {independent}"
        );
    }
}

#[test]
fn superfinishing_pays_on_hot_thin_oil_and_not_in_thick_films() {
    let change = |keys: &[(&str, &str)]| {
        let loss = |name: &str| few(name, keys).loss_w;
        loss("e-drive-superfinished") / loss("e-drive") - 1.0
    };
    let [cold, hot] = ["40 °C", "120 °C"].map(|t| change(&[("operation.bulk_temperature", t)]));
    assert!(hot < cold && cold < 0.0, "{hot} {cold}");
    assert!(few("e-drive", &[]).boundary_w > few("e-drive-superfinished", &[]).boundary_w);
}

/// Superfinished flanks in cold oil.
pub fn cold_table() -> String {
    static TABLE: OnceLock<String> = OnceLock::new();
    let made = TABLE.get_or_init(|| {
        let mut text = String::from(
            "| oil at | factor over the path | sliding W | rolling W | film friction | central gap um |\n\
             |---|---|---|---|---|---|\n",
        );
        let fine = kept("e-drive-superfinished", &FEW);
        for temperature in ["-20 °C", "-30 °C"] {
            let found = fine.at(&[("operation.bulk_temperature", temperature)]).losses;
            let span = |of: fn(&asperity::result::PositionRow) -> f64| {
                let values = || found.path.iter().map(of);
                [values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max)]
            };
            let [low, high] = span(|row| row.thermal_reduction);
            let [thin, thick] = span(|row| row.film_central_um);
            let [_, friction] = span(|row| row.mu_film);
            let _ = writeln!(
                text,
                "| {temperature} | {low:.3} to {high:.3} | {:.0} | {:.0} | at most {friction:.4} | {thin:.2} to {thick:.2} |",
                found.summary.sliding_w, found.summary.rolling_w,
            );
        }
        text.push_str("\nTest: `a_film_of_cold_oil_rubs_with_its_limiting_stress_at_most`.\n");
        text
    });
    made.clone()
}
