//! The load over the teeth in runs: laws, relief, helix, rings, planetary sets.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use asperity::Run;
use std::path::{Path, PathBuf};

use asperity::case::{CaseInput, LoadedCase, Train, load};
use asperity::pipeline::Kept;
use asperity::result::gear_report::gear_report;
use asperity::result::{Losses, RunResult};

fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures")
}

/// A shipped case with other keys.
fn shipped(name: &str, keys: &[(&str, &str)]) -> LoadedCase {
    let path = fixtures().join("cases").join(name).with_extension("toml");
    changed(&load(&path, None).unwrap(), keys)
}

/// All keys at once: one without the other may be refused.
fn changed(case: &LoadedCase, keys: &[(&str, &str)]) -> LoadedCase {
    let set = |input: &mut CaseInput| {
        for (key, value) in keys {
            input.set(key, value).unwrap();
        }
    };
    case.with(set).unwrap()
}

fn losses(case: &LoadedCase) -> Losses {
    crate::runs::losses(case).unwrap()
}

fn run(case: &LoadedCase) -> RunResult {
    asperity::Run::new(case)
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
        .result
}

#[track_caller]
fn close(actual: f64, expected: f64, tolerance: f64) {
    assert!(
        (actual - expected).abs() <= tolerance * expected.abs(),
        "{actual} is not {expected} within {tolerance}"
    );
}

/// Full contact of the traces needs many offsets; two tell the same of the load.
const FEW: (&str, &str) = ("model.offsets", "2");

#[test]
fn a_helix_of_a_thousandth_of_a_degree_is_none() {
    for name in ["e-drive", "fzg-c"] {
        let with = |helix| losses(&shipped(name, &[FEW, ("gears.helix", helix)]));
        let [spur, helical] = ["0 deg", "0.001 deg"].map(with);
        let [a, b] = [&spur, &helical].map(|losses| losses.summary.loss_factor_local);
        assert!((a - b).abs() < 1e-4, "{name}: H_V {a} and {b}");
        close(helical.summary.loss_w, spur.summary.loss_w, 1e-3);
    }
}

/// Linear relief of both tips over the double contact of e-drive, with the steel of the reference values.
fn relieved(amount: &str, torque: &str) -> LoadedCase {
    let plain = shipped("e-drive", &[FEW, ("material.pinion.young", "206 GPa")]);
    let path = plain.case.gears.path();
    let length = (path.eps_alpha - 1.0) * path.base_pitch.si() * 1e3;
    let relief = format!("{{ amount = \"{amount}\", length = \"{length} mm\" }}");
    changed(
        &plain,
        &[
            ("operation.torque", torque),
            ("gears.amounts", "normal"),
            ("gears.pinion.tip_relief", &relief),
            ("gears.wheel.tip_relief", &relief),
        ],
    )
}

#[test]
fn ten_micrometres_of_relief_take_a_quarter_of_the_loss_factor_and_more_at_part_load() {
    // MESH values with 206 GPa: 0.1503, 0.1119 and at a tenth of the torque 0.0611; 64 cells of the face are
    // good to 5e-3 with relief.
    let factor = |case: &LoadedCase| losses(case).summary.loss_factor_local;
    let plain = shipped("e-drive", &[FEW, ("material.pinion.young", "206 GPa")]);
    close(factor(&plain), 0.1503, 1e-3);
    close(factor(&relieved("10 um", "145 N m")), 0.1119, 5e-3);
    close(factor(&relieved("10 um", "14.5 N m")), 0.0611, 5e-3);
}

#[test]
fn relief_that_takes_contact_off_stops_no_run() {
    let case = relieved("20 um", "40 N m");
    let result = run(&case);
    let path = result.gears.path();
    let ends = [&result.path[0], result.path.last().unwrap()];
    assert!(ends[0].s_mm > 1e3 * path.a.si() && ends[1].s_mm < 1e3 * path.e.si());
    // A and E carry nothing and are not shown; the cells span the loaded part alone.
    let points: Vec<_> = result.points.iter().map(|row| &*row.point).collect();
    assert!(
        !points.contains(&"A") && !points.contains(&"E"),
        "{points:?}"
    );
    let length: f64 = result.path.iter().map(|row| row.weight_m).sum();
    assert!(length < result.gears.mean_contact_length().si());
    let noted = |code| result.warnings.iter().any(|warning| warning.code == code);
    assert!(!noted("W421"), "relieved tips need no note on their edges");
    assert!(result.summary.loss_w > 0.0 && result.summary.efficiency < 1.0);
}

#[test]
fn cells_that_the_traces_do_not_resolve_are_counted_and_stop_no_run() {
    let result = run(&relieved("15 um", "145 N m"));
    let note = result
        .warnings
        .iter()
        .find(|warning| warning.code == "W422");
    let unresolved = |row: &&asperity::result::PositionRow| row.half_width_um < 20.0 * 0.5;
    let count = result.path.iter().filter(unresolved).count();
    match note {
        Some(note) => assert!(note.text.starts_with(&format!("{count} of ")), "{note}"),
        None => assert_eq!(count, 0),
    }
}

#[test]
fn the_classical_laws_together_keep_their_loss() {
    // 1132 W on 16 other windows; 1090 W on 256 of these. Every choice is named, whatever its default.
    let loss = losses(&shipped(
        "e-drive",
        &[
            ("model.load_distribution", "mean-length"),
            ("model.positions", "32"),
            ("model.offsets", "16"),
            ("model.film_friction", "xu"),
            ("model.load_share", "lambda-star"),
            ("model.film", "dowson-toyoda"),
            ("model.thermal", "gupta"),
            ("model.boundary_friction", "0.1"),
            ("model.lay", "0"),
            ("model.hysteresis", "0 %"),
        ],
    ));
    close(loss.summary.loss_w, 1132.0, 0.04);
    close(loss.summary.loss_factor_local, 0.1485, 5e-4);
}

#[test]
fn constant_friction_is_exact_over_any_number_of_cells() {
    for positions in ["5", "16", "40"] {
        let summary = losses(&shipped(
            "e-drive",
            &[
                FEW,
                ("model.positions", positions),
                ("model.film_friction", "{ constant = 0.05 }"),
                ("model.load_share", "lambda-star"),
                ("model.boundary_friction", "0.05"),
            ],
        ))
        .summary;
        let expected = 0.05 * summary.loss_factor_local * summary.power_in_w;
        close(summary.sliding_w, expected, 1e-12);
    }
}

/// Sun, planet and ring of 1.5 mm at 40 N m.
fn pair(teeth: &str, helix: &str) -> LoadedCase {
    shipped(
        "fzg-c",
        &[
            FEW,
            ("gears.profile_shift", "[0.0, 0.0]"),
            ("gears.teeth", teeth),
            ("gears.module", "1.5 mm"),
            ("gears.face_width", "20 mm"),
            ("gears.helix", helix),
            ("operation.torque", "40 N m"),
            ("material.pinion.young", "206 GPa"),
        ],
    )
}

#[test]
fn ring_pairs_run_and_have_the_loss_factors_of_the_reference() {
    // Elastic H_V of the reference, 206 GPa.
    for (teeth, helix, expected) in [
        ("[27, 24]", "0 deg", 0.165_14),
        ("[24, -75]", "0 deg", 0.078_55),
        ("[27, 24]", "15 deg", 0.1958),
        ("[24, -75]", "15 deg", 0.0816),
    ] {
        let result = run(&pair(teeth, helix));
        close(result.summary.loss_factor_local, expected, 1.5e-3);
        assert!(result.path.iter().all(|row| row.radius_mm > 0.0));
        assert!((0.9..1.0).contains(&result.summary.efficiency));
    }
}

/// The contact runs from the root to the tip of the pinion, and from the tip to the root of a wheel and of a ring.
#[test]
fn a_trace_from_the_root_is_read_from_its_other_end_on_a_wheel_and_on_a_ring() {
    for teeth in ["[27, 24]", "[24, -75]"] {
        let case = pair(teeth, "0 deg");
        let tip = case.case.gears.tip_radius[1].si().abs() * 1e3;
        for (from, mirrored) in [("root", true), ("tip", false)] {
            // The last point of a trace from the root, and the first point of one from the tip, are at the tip.
            let x = if from == "tip" { "0 mm" } else { "3 mm" };
            let file = fixtures().join("profiles/ground_wheel.csv");
            let wheel = format!(
                "{{ file = {file:?}, from = \"{from}\", at = {{ radius = \"{tip} mm\", x = \"{x}\" }} }}"
            );
            let result = run(&changed(&case, &[("surface.wheel", &wheel)]));
            let flank = &result.flanks[1];
            assert_eq!(flank.mirrored, mirrored, "{teeth} from {from}");
            // From the tip inwards on a wheel, outwards on a ring.
            let base = case.case.gears.base_radius[1].si() * 1e3;
            let roll = (tip.powi(2) - base.powi(2)).sqrt();
            let inwards = if case.case.gears.internal { -1.0 } else { 1.0 };
            let inside = |length: &f64| inwards * (roll - *length) > -1e-9;
            let lengths = flank.roll_lengths_mm.unwrap();
            assert!(
                lengths.iter().all(inside),
                "{teeth} from {from}: {lengths:?}, tip {roll}"
            );
        }
    }
}

/// A stated module is the normal one, and a positive profile shift brings the teeth of a ring towards its axis.
#[test]
fn keys_of_gears_say_which_module_and_which_sign_of_a_ring() {
    let page = asperity::case::markdown().unwrap();
    let meaning = |key: &str| {
        let row = format!("| `{key}` |");
        let line = page.lines().find(|line| line.starts_with(&row));
        line.unwrap_or_else(|| panic!("{key}"))
    };
    let says = "Normal module m_n; the transverse one with `module_plane = \"transverse\"`.";
    assert!(meaning("gears.module").contains(says));
    let gears = |keys: &[(&str, &str)]| {
        changed(&pair("[24, -75]", "15 deg"), keys)
            .case
            .gears
            .clone()
    };
    let [normal, stated, transverse] = [
        gears(&[]),
        gears(&[("gears.module_plane", "normal")]),
        gears(&[("gears.module_plane", "transverse")]),
    ]
    .map(|gears| gears.base_radius[0].si());
    assert_eq!(normal, stated);
    assert!(transverse < 0.97 * normal, "{transverse} {normal}");
    let said = meaning("gears.profile_shift");
    assert!(said.contains("A positive one brings the teeth of a ring gear towards its axis."));
    let tip = |shift: &str| {
        let gears = gears(&[("gears.profile_shift", shift)]);
        gears.tip_radius[1].si().abs() * 1e3
    };
    // A tenth of 1.5 mm, but for the tips that keep their clearance.
    let [outwards, none, inwards] = ["[0.0, -0.1]", "[0.0, 0.0]", "[0.0, 0.1]"].map(tip);
    assert!(
        inwards < none - 0.1 && none < outwards - 0.1,
        "{inwards} {none} {outwards}"
    );
}

#[test]
fn rings_that_cannot_mesh_are_refused_with_their_reason() {
    let case = pair("[24, -75]", "0 deg");
    let refusal = |key: &str, value: &str| case.with_key(key, value).unwrap_err().to_string();
    let said = refusal("gears.teeth", "[24, -24]");
    assert!(said.contains("ring") || said.contains("teeth"), "{said}");
    let said = refusal("gears.teeth", "[-75, 24]");
    assert!(said.contains("only the wheel may be a ring"), "{said}");
}

const SET: &str = r#"
title = "a set"
[planetary]
teeth = [27, 24, -75]
planets = 3
module = "1.5 mm"
face_width = ["20 mm", "20 mm", "20 mm"]
sun.tip_relief = "none"
planet.tip_relief = "none"
ring.tip_relief = "none"
[material.sun]
young = "206 GPa"
[operation]
torque = "120 N m"
speed = "3000 1/min"
bulk_temperature = "90 °C"
[lubricant]
oil = "m100"
[surface]
sun = { rq = "0.3 um" }
[model]
offsets = 1
"#;

#[test]
fn a_planetary_set_is_the_run_of_its_two_meshes() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("set.toml");
    std::fs::write(&file, SET).unwrap();
    let set = Train::load(&file).unwrap();
    let outcome = Run::new(&set)
        .pictures(Kept::All)
        .interval(false)
        .execute()
        .unwrap();
    let result = &outcome.whole;
    let [sun, ring] = &result.meshes[..] else {
        panic!("{} meshes", result.meshes.len())
    };
    assert_eq!(sun.torque_nm, 40.0);
    close(ring.torque_nm, 35.556, 1e-4);
    close(ring.speed_rad_per_s, 259.874, 1e-5);
    close(sun.loss_factor_local, 0.165_14, 1.5e-3);
    close(result.loss_w, 3.0 * (sun.loss_w + ring.loss_w), 1e-12);
    // The carrier turns at 27/102 of the sun; nothing else drives.
    close(
        result.power_in_w,
        120.0 * 100.0 * std::f64::consts::PI,
        1e-12,
    );
    let speeds = result.set.as_ref().unwrap();
    close(
        speeds.carrier_rad_per_s,
        speeds.sun_rad_per_s * 27.0 / 102.0,
        1e-12,
    );
    assert!(result.efficiency > sun.efficiency * ring.efficiency);
    let pair = Train::load(&fixtures().join("cases/fzg-c.toml")).unwrap();
    assert!(pair.only().is_some() && set.only().is_none());
    // What takes one mesh does not take the set.
    let error = load(&file, None).unwrap_err();
    assert_eq!(error.code(), "E205");
    assert!(
        error
            .to_string()
            .contains("has several meshes: \"sun and planet\"")
    );
    for (train, says) in [(&pair, "has a single mesh"), (&set, "has no mesh \"m1\"")] {
        let error = train.of_mesh("m1").unwrap_err();
        assert_eq!(error.code(), "E205");
        assert!(error.to_string().contains(says), "{error}");
    }
    let only = set.of_mesh("sun and planet").unwrap();
    let torques = [&only, &set].map(|train| train.cases().next().unwrap().case.torque);
    assert_eq!(torques[0], torques[1]);
}

#[test]
fn a_planetary_set_that_does_not_fit_is_refused_with_its_reason() {
    let folder = tempfile::tempdir().unwrap();
    let refusal = |from: &str, to: &str| {
        let file = folder.path().join("set.toml");
        std::fs::write(&file, SET.replace(from, to)).unwrap();
        Train::load(&file).unwrap_err()
    };
    let error = refusal("planets = 3", "planets = 12");
    assert!(
        error.to_string().contains("12 planets do not fit"),
        "{error}"
    );
    assert_eq!(error.code(), "E206");
    let error = refusal("planets = 3", "planetss = 3");
    assert_eq!(error.code(), "E203");
}

#[test]
fn a_mesh_of_a_planetary_set_names_the_keys_of_the_set_also_after_a_change() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("set.toml");
    let rough = r#"sun = { rq = "30 um" }"#;
    std::fs::write(&file, SET.replace(r#"sun = { rq = "0.3 um" }"#, rough)).unwrap();
    let set = Train::load(&file).unwrap();
    let mesh = &set.mesh("sun and planet").unwrap().case;
    let changed = mesh.with(|input| input.model.offsets = Some(2)).unwrap();
    for case in [mesh, &changed] {
        let unusual = case.warnings.iter().filter(|found| found.code == "W201");
        let texts: Vec<&str> = unusual.map(|found| found.text.as_str()).collect();
        // A sun with more teeth than its planets is usual.
        assert!(
            matches!(texts[..], [text] if text.starts_with("surface.sun.rq = 30 um is unusual")),
            "{texts:?}"
        );
    }
    let error = mesh
        .with_key("surface.pinion.rq", "-1 um")
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("(mesh of the sun, its pinion, and a planet): surface.pinion.rq"),
        "{error}"
    );
}

#[test]
fn the_gear_report_tells_every_law() {
    let found = gear_report(&shipped("e-drive", &[]).case).unwrap();
    let factor = |law: &str| {
        let mut rows = found.loss_factors.iter();
        rows.find(|row| row.law == law).unwrap()
    };
    close(
        factor("elastic").loss_factor.unwrap(),
        found.loss_factor_local,
        1e-12,
    );
    close(factor("uniform").loss_factor.unwrap(), 0.148_29, 2e-4);
    close(factor("mean-length").loss_factor.unwrap(), 0.1485, 5e-4);
    assert!(
        factor("trapezoid")
            .refused
            .as_ref()
            .unwrap()
            .contains("spur")
    );
    let band = found.band.unwrap();
    assert!(band.whole.low < found.loss_factor_local && found.loss_factor_local < band.whole.high);
    let error = found.transmission_error.unwrap();
    // 206 GPa: 11.4 um; the steel of the case has 210 GPa.
    close(error.mean.si(), 11.4e-6, 0.03);
    close(found.iso_mesh_stiffness_n_per_mm_um.unwrap(), 18.2, 5e-3);
}

#[test]
fn relief_is_told_by_its_length_or_by_its_start_and_not_by_both() {
    let case = shipped("e-drive", &[FEW]);
    let refusal = |value: &str| {
        let error = case.with_key("gears.pinion.tip_relief", value).unwrap_err();
        (error.code(), error.to_string())
    };
    for value in [
        "{ amount = \"10 um\" }",
        "{ amount = \"10 um\", length = \"1 mm\", start_diameter = \"45 mm\" }",
    ] {
        let (code, text) = refusal(value);
        assert!(code == "E205" && text.contains("start_diameter"), "{text}");
    }
    let (code, text) = refusal("{ amount = \"10 um\", length = \"1 mm\", power = 3 }");
    assert!(code == "E205" && text.contains("parabolic"), "{text}");
    let uniform = case.with_key("model.load_distribution", "uniform").unwrap();
    let relief = "{ amount = \"10 um\", length = \"1 mm\" }";
    let error = uniform
        .with_key("gears.pinion.tip_relief", relief)
        .unwrap_err();
    assert!(error.to_string().contains("has no deflections"), "{error}");
}
