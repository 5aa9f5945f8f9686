//! The paper's reading, on its own case.

use std::path::{Path, PathBuf};

use asperity::case::load;
use asperity::result::{MeshOutcome, Regime};
use asperity_tests::{CaseText, assert_close, run, table_2, trace_csv};

use crate::comparison::{Comparison, Table};

fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures")
}

fn table_2_with_its_trace() -> MeshOutcome {
    let file = fixtures().join("cases/table2.toml");
    let loaded = load(&file, Some(asperity_paper_2022::register())).unwrap();
    run(&loaded)
}

#[test]
fn marching_is_flat_while_the_flanks_are_apart_and_rises_after_touch() {
    // The paper's Fig. 13.
    let outcome = table_2_with_its_trace();
    let target = outcome.result.path[0].line_load_n_per_mm * 1e3;
    let mut history = outcome.fields[0].history.clone();
    // A step past the load is taken back and halved; by approach the history is one curve.
    history.sort_by(|a, b| a.approach.total_cmp(&b.approach));
    let (apart, touching): (Vec<_>, Vec<_>) = history.iter().partition(|step| step.approach <= 0.0);
    assert!(apart.len() >= 4 && touching.len() > 20);
    for step in &apart {
        assert_eq!(step.load_solid, 0.0);
        // The pressure across the film is some kilopascals.
        assert!(step.load_fluid < 1e-4 * target, "{step:?}");
    }
    // Where all that touches flows, a step may add nothing.
    for pair in touching.windows(2) {
        assert!(
            pair[0].load_solid <= pair[1].load_solid * (1.0 + 1e-9),
            "{pair:?}"
        );
    }
    let last = touching.last().unwrap().load_solid;
    assert!(touching[0].load_solid < 0.01 * last && last > 0.99 * target);
}

#[test]
fn marching_stops_within_the_error_asked_for() {
    let outcome = table_2_with_its_trace();
    let history = &outcome.fields[0].history;
    let (last, before) = history.split_last().unwrap();
    assert!(last.load_error < 0.01 && before.iter().all(|step| step.load_error >= 0.01));
    assert_eq!(outcome.result.path[0].load_error, last.load_error);
    let target = outcome.result.path[0].line_load_n_per_mm * 1e3;
    let carried = last.load_solid + last.load_fluid;
    assert!((carried - target).abs() < 0.01 * target);
    // Solids with the friction of metal on metal carry nearly all of it.
    let mu = outcome.result.path[0].mu;
    assert_close("mu", mu, 0.3 * last.load_solid / target, 1e-3);
}

#[test]
fn superfinished_flanks_take_the_branch_of_full_film() {
    let profile = |name: &str| {
        let file = fixtures().join("profiles").join(name);
        toml::toml! { file = (file.display().to_string()) }
    };
    let outcome = table_2()
        .with("formulation", "paper")
        .with("surface.cutoff", "0.25 mm")
        .with("surface.pinion", profile("superfinished.csv"))
        .with("surface.wheel", profile("superfinished_wheel.csv"))
        .with("paper.position", 0.2557)
        .run();
    let row = &outcome.result.path[0];
    assert_eq!((row.regime, row.film_share), (Regime::FullFilm, 1.0));
    assert!(row.lambda_star.unwrap() > 1.0);
    assert!(outcome.fields[0].history.is_empty() && row.contact_fraction.is_none());
    // Friction is summed over the points of the window: that of Hertz's pressure to 1e-3.
    assert_close("mu", row.mu, row.mu_film, 1e-3);
    // Lighter friction than metal on metal, by far.
    let rough = table_2_with_its_trace().result.summary.sliding_w;
    assert!(outcome.result.summary.sliding_w < 0.2 * rough);
}

/// Smooth flanks of Table 2 at C, traced with the paper's step of 80 nm.
fn smooth_at_c() -> MeshOutcome {
    let folder = tempfile::tempdir().unwrap();
    let zeros = vec![0.0; 12_001];
    std::fs::write(folder.path().join("flat.csv"), trace_csv(80e-9, &zeros)).unwrap();
    let flat = || toml::toml! { file = "flat.csv" };
    let case: CaseText = table_2()
        .with("formulation", "paper")
        .with("surface.cutoff", "0 mm")
        .with("surface.noise_cutoff", "0 um")
        .with("surface.pinion", flat())
        .with("surface.wheel", flat());
    run(&case.load_in(folder.path()))
}

pub fn printed_deformation() -> Table {
    let summary = smooth_at_c().result.summary;
    Table {
        name: "printed-deformation",
        test: "the_printed_deformation_loss_is_a_tenth_of_a_microwatt",
        rows: vec![Comparison::new(
            "(P19) as printed, smooth flanks at C, both surfaces, cells of 80 nm",
            "µW",
            // Trapezoids over 3001 points of Hertz's pressure, whose von Mises stress at the surface is 1 - 2 nu of it.
            0.4 * 0.212_886_72,
            summary.deformation_in_contact_w.iter().sum::<f64>() * 1e6,
            1e-4,
        )],
    }
}

#[test]
fn the_printed_deformation_loss_is_a_tenth_of_a_microwatt() {
    printed_deformation().hold();
    // Nothing flows, so nothing is left after contact, and nothing is lost.
    assert_eq!(smooth_at_c().result.summary.deformation_w, [0.0; 2]);
}

#[test]
fn both_pies_of_the_papers_fig_12_have_their_deformation() {
    let summary = table_2_with_its_trace().result.summary;
    for body in 0..2 {
        let after = summary.deformation_w[body];
        let within = summary.deformation_in_contact_w[body];
        // In contact the elastic displacement is added to the plastic one.
        assert!(after > 0.0 && within > after, "{within} {after}");
    }
    // Which is nothing beside friction, as printed.
    assert!(summary.deformation_w[0] < 1e-6 * summary.sliding_w);
}

#[test]
fn the_papers_trace_meets_itself_symmetrically_unless_it_is_reflected_across_the_contact() {
    let contact = |mirrored: bool| {
        let file = fixtures().join("cases/table2.toml");
        let loaded = load(&file, Some(asperity_paper_2022::register())).unwrap();
        let loaded = loaded.with_key("surface.wheel.mirrored", &mirrored.to_string());
        let outcome = run(&loaded.unwrap());
        let fields = &outcome.fields[0];
        let pressure = &fields.pressure_solid;
        let pairs = pressure.iter().zip(pressure.iter().rev());
        let asymmetry = pairs.map(|(a, b)| 1e-6 * (a - b).abs()).fold(0.0, f64::max);
        let plastic = 1e6 * fields.plastic_pinion.iter().copied().fold(0.0, f64::max);
        (asymmetry, plastic, outcome.result.summary.efficiency)
    };
    let (asymmetry, plastic, efficiency) = contact(true);
    // The two transforms of the contact round differently at mirrored points.
    assert!(asymmetry < 1e-3, "{asymmetry} MPa");
    assert_close("plastic", plastic, 1.835, 1e-3);
    assert_close("efficiency", efficiency, 0.97653, 1e-5);
    let (asymmetry, plastic, efficiency) = contact(false);
    assert!(asymmetry > 1000.0, "{asymmetry} MPa");
    assert_close("plastic", plastic, 3.385, 1e-3);
    assert_close("efficiency", efficiency, 0.97662, 1e-5);
}

#[test]
fn the_printed_deformation_counts_plastic_displacement_once() {
    let summary = table_2_with_its_trace().result.summary;
    let parts = summary.sliding_w + summary.rolling_w + summary.deformation_w.iter().sum::<f64>();
    // The parts differ from the total by the rounding of kilowatts.
    assert!((parts - summary.loss_w).abs() < 1e-11 * summary.loss_w);
    // Both flanks after contact: 1.2e-6 W each; with the displacement in contact added it was 2.7e-6 W.
    for after in summary.deformation_w {
        assert!((1.1e-6..1.3e-6).contains(&after), "{after}");
    }
}

#[test]
fn at_the_pitch_point_nothing_slides() {
    // Rolling as the paper prints it: F_r V_e on one surface over the mean contact length,
    // 209.154 N/m at 4.567909 m/s over 82.28644 mm.
    let summary = smooth_at_c().result.summary;
    assert_eq!(summary.sliding_w, 0.0);
    assert_close(
        "rolling",
        summary.rolling_w,
        209.153_685 * 4.567_908_85 * 82.286_440e-3,
        1e-6,
    );
}
