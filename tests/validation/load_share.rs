//! The solved load share in whole cases: what moves the loss, what must not, and what was measured.

use std::fmt::Write as _;
use std::path::Path;

use asperity::case::{LoadedCase, load};
use asperity::pipeline::{contact_tables, losses_with};
use asperity::result::{Losses, Summary};
use asperity_tests::{assert_close, petry_johnson};

fn shipped(name: &str) -> LoadedCase {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases");
    load(&folder.join(format!("{name}.toml")), None).unwrap()
}

/// A shipped case with these keys changed.
fn with(name: &str, keys: &[(&str, &str)]) -> LoadedCase {
    keys.iter().fold(shipped(name), |case, (key, value)| {
        case.with_key(key, value).unwrap()
    })
}

fn losses(case: &LoadedCase) -> Losses {
    asperity::losses(case, &|_, _| ()).unwrap()
}

fn summary(name: &str, keys: &[(&str, &str)]) -> Summary {
    losses(&with(name, keys)).summary
}

/// Few offsets, as the reference computation took.
const FEW: [(&str, &str); 2] = [("model.positions", "16"), ("model.offsets", "4")];

fn few(name: &str, keys: &[(&str, &str)]) -> Summary {
    summary(name, &[&FEW[..], keys].concat())
}

#[test]
fn the_shipped_drive_loses_what_the_reference_computation_has() {
    // 32 places weighted to 8, 4 offsets, mean length of the contact lines and another expansion of the oil
    // there: ground 569 W, superfinished 397 W.
    let mean = [("model.load_distribution", "mean-length")];
    let (ground, fine) = (few("e-drive", &mean), few("e-drive-superfinished", &mean));
    assert_close("ground", ground.sliding_w, 569.0, 0.05);
    assert_close("superfinished", fine.sliding_w, 397.0, 0.02);
    let change = fine.loss_w / ground.loss_w - 1.0;
    assert!((-0.40..-0.15).contains(&change), "{change}");
}

#[test]
fn the_parts_add_up_to_the_sliding_loss() {
    for name in ["e-drive", "e-drive-superfinished", "fzg-c"] {
        let found = few(name, &[]);
        let parts = found.film_w + found.lubricated_asperity_w + found.boundary_w;
        assert_close(name, parts, found.sliding_w, 1e-12);
        assert!(found.boundary_share <= found.asperity_share);
    }
}

#[test]
fn the_pressure_at_which_asperities_flow_moves_the_loss() {
    let at = |flow: &str| few("e-drive", &[("material.pinion.flow_pressure", flow)]).sliding_w;
    let (soft, hard) = (at("2.5 GPa"), at("20 GPa"));
    assert!(hard > 1.05 * soft, "{soft} {hard}");
}

#[test]
fn a_flank_that_the_film_alone_makes_flow_is_refused() {
    let soft = with("e-drive", &[("material.pinion.flow_pressure", "1.2 GPa")]);
    let error = asperity::losses(&soft, &|_, _| ()).unwrap_err();
    assert_eq!(error.code(), "E306");
}

#[test]
fn the_tolerance_of_the_contacts_does_not_move_the_loss() {
    let at = |tolerance: &str| few("e-drive", &[("model.tolerance", tolerance)]).loss_w;
    assert_close("loss", at("1e-4"), at("1e-8"), 1e-6);
}

#[test]
fn contacts_made_before_serve_other_oils_speeds_and_temperatures() {
    let case = with("e-drive", &FEW);
    let tables = contact_tables(&case).unwrap();
    assert!(!tables.is_empty());
    for (key, value) in [
        ("operation.temperature", "60 °C"),
        ("operation.speed", "2000 1/min"),
        ("lubricant.base_oil", "ester"),
    ] {
        let other = case.with_key(key, value).unwrap();
        let kept = losses_with(&tables, &other, &|_, _| ()).unwrap();
        assert_eq!(kept.summary, losses(&other).summary, "{key}");
    }
    let heavier = case.with_key("operation.torque", "150 N m").unwrap();
    assert!(losses_with(&tables, &heavier, &|_, _| ()).is_err());
    let softer = case
        .with_key("material.pinion.flow_pressure", "5 GPa")
        .unwrap();
    assert!(losses_with(&tables, &softer, &|_, _| ()).is_err());
}

#[test]
fn the_first_version_is_found_again_by_names() {
    let first = summary(
        "e-drive",
        &[
            ("model.load_share", "lambda-star"),
            ("model.film_friction", "xu"),
            ("model.boundary_friction", "0.1"),
            ("model.hysteresis", "0 %"),
            ("model.load_distribution", "mean-length"),
            ("model.positions", "32"),
        ],
    );
    assert_close("loss", first.loss_w, 1132.0, 0.005);
}

#[test]
fn a_film_of_cold_oil_rubs_with_its_limiting_stress_at_most() {
    for cold in ["-20 °C", "-30 °C"] {
        let case = with(
            "e-drive-superfinished",
            &[&FEW[..], &[("operation.temperature", cold)]].concat(),
        );
        for row in losses(&case).path {
            assert!(row.mu_film < 0.04, "{cold}: {}", row.mu_film);
            assert!(row.film_central_um > 0.0 && row.thermal_reduction > 0.0);
        }
    }
}

#[test]
fn every_law_of_the_load_share_runs_by_its_name() {
    let at = |law: &str| few("e-drive", &[("model.load_share", law)]);
    let solved = at("solved");
    for law in ["lambda-star", "zhu-hu", "masjedi-khonsari", "jgp"] {
        let classical = at(law);
        // All asperity load at the boundary coefficient costs more than lubricated asperities.
        assert!(classical.sliding_w > solved.sliding_w, "{law}");
        assert_eq!(classical.lubricated_asperity_w, 0.0);
    }
}

#[test]
fn the_share_is_the_same_on_one_and_two_threads() {
    let case = with("e-drive", &FEW);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| losses(&case).summary)
    };
    assert_eq!(on(1), on(2));
}

#[test]
fn an_oil_without_a_family_is_refused_or_assumed() {
    let mut case = shipped("e-drive");
    let error = case
        .with(|input| {
            input.lubricant.base_oil = None;
            input.lubricant.pressure_viscosity = "10 1/GPa".parse().ok();
        })
        .unwrap_err();
    assert_eq!(error.code(), "E208");
    case = case
        .with(|input| {
            input.lubricant.base_oil = None;
            input.lubricant.assume_base_oil = Some(asperity::core::lubricant::BaseOil::Mineral);
        })
        .unwrap();
    let mut listed = case.case.defaults.iter();
    assert!(listed.any(|used| used.key.ends_with("base_oil")));
}

/// A gate: what was measured, its rule, what comes out, whether it holds.
struct Gate(&'static str, &'static str, String, bool);

fn gates() -> Vec<Gate> {
    let slow = |mu_b: &str| {
        let mut case = with(
            "fzg-c",
            &[&FEW[..], &[("model.boundary_friction", mu_b)]].concat(),
        );
        // 0.5 m/s on a working pitch radius of 36.6 mm.
        case = case.with_key("operation.speed", "130.5 1/min").unwrap();
        let found = losses(&case).summary;
        found.sliding_w / (found.loss_factor_local * found.power_in_w)
    };
    let (mu, lower) = (slow("0.08"), slow("0.07"));
    let (ground, fine) = (few("e-drive", &[]), few("e-drive-superfinished", &[]));
    let change = fine.loss_w / ground.loss_w - 1.0;
    let cold = |name: &str| {
        few(
            name,
            &[
                ("operation.temperature", "40 °C"),
                ("operation.speed", "20000 1/min"),
            ],
        )
        .loss_w
    };
    let null = cold("e-drive-superfinished") / cold("e-drive") - 1.0;
    let mut rows = vec![
        Gate(
            "T1 FZG C-mod 0.5 m/s (surrogate traces: the ground fixture)",
            "mu 0.055 to 0.068",
            format!("{mu:.4} ({lower:.4} with mu_b 0.07)"),
            (0.055..=0.068).contains(&mu),
        ),
        Gate(
            "T3 superfinishing, e-drive at 90 °C",
            "-20 to -40 %",
            format!("{:.0} %", 100.0 * change),
            (-0.40..=-0.20).contains(&change),
        ),
        Gate(
            "T4 superfinishing of thick films (40 °C, 20 000 1/min)",
            "below 8 %",
            format!("{:.1} %", 100.0 * null),
            null.abs() < 0.08,
        ),
        Gate(
            "T5 limiting shear stress, superfinished at -20 °C",
            "film friction below 0.040",
            {
                let cold = [("operation.temperature", "-20 °C")];
                let case = with("e-drive-superfinished", &[&FEW[..], &cold[..]].concat());
                let most = losses(&case)
                    .path
                    .iter()
                    .map(|row| row.mu_film)
                    .fold(0.0, f64::max);
                format!("{most:.4}")
            },
            true,
        ),
    ];
    if let Some(row) = rows.last_mut() {
        row.3 = row.2.parse::<f64>().is_ok_and(|mu| mu < 0.040);
    }
    rows.extend(SPEEDS.iter().map(|&(speed, [low, high])| {
        let found = petry_johnson_by_default(speed);
        Gate(
            "T2 Petry-Johnson, superfinished 40/40 (grade C)",
            match speed {
                10_000 => "printed beyond 8000 1/min",
                _ => "within 25 % of the measured span",
            },
            format!("{speed} 1/min: {low:.0} to {high:.0} W measured, {found:.0} W"),
            speed > 8000 || (0.75 * low..=1.25 * high).contains(&found),
        )
    }));
    rows
}

const SPEEDS: [(u32, [f64; 2]); 5] = [
    (2000, [166.0, 174.0]),
    (4000, [286.0, 320.0]),
    (6000, [456.0, 499.0]),
    (8000, [606.0, 633.0]),
    (10_000, [472.0, 640.0]),
];

/// The loss \[W\] with the default laws; superfinished flanks known by their Rq, the oil taken as a PAO.
fn petry_johnson_by_default(speed: u32) -> f64 {
    let case = petry_johnson()
        .with("model.film_friction", "eyring")
        .with("model.boundary_friction", 0.08)
        .with("lubricant.base_oil", "pao")
        .with("operation.speed", format!("{speed} 1/min"));
    case.run().result.summary.loss_w
}

/// Gates of measurement, computed with one set of defaults.
pub fn beside_measured() -> String {
    let mut text = String::from("| measured | rule | here | holds |\n|---|---|---|---|\n");
    for Gate(what, rule, found, holds) in gates() {
        let verdict = if holds { "pass" } else { "FAIL" };
        let _ = writeln!(text, "| {what} | {rule} | {found} | {verdict} |");
    }
    text.push_str("\nTest: `most_gates_of_measurement_hold_together`.\n");
    text
}

#[test]
fn most_gates_of_measurement_hold_together() {
    let gates = gates();
    let held = gates.iter().filter(|gate| gate.3).count();
    println!("{}", beside_measured());
    // They are reported, never tuned one by one.
    assert!(2 * held > gates.len(), "{}", beside_measured());
}

/// One key changed on the shipped drive, ground flanks.
const CHANGES: [(&str, &str); 16] = [
    ("model.boundary_friction", "0.065"),
    ("model.boundary_friction", "0.12"),
    ("model.boundary_layer", "5 nm"),
    ("model.boundary_layer", "20 nm"),
    ("model.lay", "0.16666666666666666"),
    ("model.central_film", "gap"),
    ("model.spot_speed", "half-sliding"),
    ("model.asperity_share_factor", "0.5"),
    ("material.pinion.flow_pressure", "2.5 GPa"),
    ("model.film_pressure_law", "roelands"),
    ("model.film_friction", "xu"),
    ("model.load_share", "lambda-star"),
    ("model.load_share", "jgp"),
    ("model.load_distribution", "mean-length"),
    ("lubricant.base_oil", "mineral"),
    ("operation.temperature", "60 °C"),
];

/// Effect of one changed key on the loss.
pub fn one_key_changed() -> String {
    let base = few("e-drive", &[]).loss_w;
    let mut text = format!(
        "| key | value | loss W | change |\n|---|---|---|---|\n| - | defaults | {base:.0} | |\n"
    );
    for (key, value) in CHANGES {
        let loss = few("e-drive", &[(key, value)]).loss_w;
        let change = 100.0 * (loss / base - 1.0);
        let _ = writeln!(text, "| `{key}` | {value} | {loss:.0} | {change:+.0} % |");
    }
    text
}

#[test]
fn every_choice_of_the_load_share_moves_the_loss() {
    println!("{}", one_key_changed());
    let base = few("e-drive", &[]).loss_w;
    for (key, value) in CHANGES {
        let loss = few("e-drive", &[(key, value)]).loss_w;
        assert!((loss / base - 1.0).abs() > 1e-4, "{key} {value}: {loss}");
    }
}
