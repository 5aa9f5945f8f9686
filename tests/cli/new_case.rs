//! `asperity new`: ten questions and the case from their answers.

use std::fs;

use crate::bench::{Bench, trace, with_line};

#[test]
fn ten_answers_make_a_case_that_runs() {
    let bench = Bench::new();
    bench.write("pinion.csv", trace("x_um,z_um", 6000));
    let answers = "23 68\n1.8\n32 mm\n\n\n145\n9000\n\nISO VG 100, VI 95\npinion.csv\n";
    let said = bench.run_with_input(&["new", "case.toml"], answers);
    assert_eq!(said.status, 0, "{said:?}");
    assert!(said.err.contains("10/10 Flanks"), "{}", said.err);
    let case = fs::read_to_string(bench.path("case.toml")).unwrap();
    for line in [
        "teeth = [23, 68]",
        "module = \"1.8 mm\"",
        "helix = \"0 deg\"",
        "speed = \"9000 1/min\"",
        "viscosity = { grade = 100, viscosity_index = 95 }",
    ] {
        assert!(case.contains(line), "{line} is not in {case}");
    }
    let run = [
        "run",
        "case.toml",
        "--json",
        "--no-output",
        "--set",
        "model.offsets=1",
    ];
    let loss = bench.run(&run).json()["summary"]["loss_w"].as_f64();
    assert!(loss.unwrap() > 10.0);
    // What exists is not replaced.
    let again = bench.run_with_input(&["new", "case.toml"], answers);
    assert!(
        again.err.contains("E401") && again.err.contains("exists already"),
        "{}",
        again.err
    );
}

#[test]
fn a_centre_distance_the_temperature_of_the_oil_and_two_traces_make_a_case_that_runs() {
    let bench = Bench::new();
    bench.write_flanks();
    let answers = "25 61\n2\n28 mm\n\n87.5\n120\n4000\noil 80 °C\noil 80 °C dip\nmineral\nm100\npinion.csv, wheel.csv\n";
    let said = bench.run_with_input(&["new", "case.toml"], answers);
    assert_eq!(said.status, 0, "{said:?}");
    assert!(
        said.err.contains("add jet, dip or submerged"),
        "{}",
        said.err
    );
    let case = fs::read_to_string(bench.path("case.toml")).unwrap();
    for line in [
        "oil_temperature = \"80 °C\"",
        "lubrication = \"dip\"",
        "wheel = { file = \"wheel.csv\", mirrored = true }",
    ] {
        assert!(case.contains(line), "{line} is not in {case}");
    }
    let checked = bench.run(&["check", "case.toml", "--explain-defaults"]);
    let checked = checked.well().unwrapped();
    // The division of the shifts as in the validation of the crate of gears.
    assert!(checked.contains("W445 gears.profile_shift: the centre distance gives the sum 0.797, taken as [0.444, 0.352]"), "{checked}");
    assert!(
        checked.contains("gears.profile_shift = [0.4443,0.3523]"),
        "{checked}"
    );
}

#[test]
fn answers_that_cannot_be_read_are_asked_again_and_missing_ones_refused() {
    let bench = Bench::new();
    let answers = "23\n23/68\n1.8 kg\n1.8 mm\n32\n\n\n145\n9000\n\nVG 100\nm100\n0.4\n";
    let said = bench.run_with_input(&["new", "-"], answers);
    assert_eq!(said.status, 0, "{said:?}");
    for part in ["write two numbers", "viscosity index too"] {
        assert!(said.err.contains(part), "{part} is not in {}", said.err);
    }
    assert!(said.out.contains("wheel.ra = \"0.4 um\""), "{}", said.out);
    let said = bench.run_with_input(&["new", "short.toml"], "23 68\n");
    assert!(
        said.err.contains("E204 no answer to question 2"),
        "{}",
        said.err
    );
    assert!(!bench.path("short.toml").exists());
}

#[test]
fn a_grade_with_its_index_gives_both_viscosities() {
    let bench = Bench::new();
    bench.write_flanks();
    let run = |viscosity: &str| {
        bench.write(
            "case.toml",
            with_line("viscosity", &format!("viscosity = {viscosity}")),
        );
        bench.run(&["run", "case.toml", "--json", "--no-output"])
    };
    let loss = |viscosity: &str| run(viscosity).json()["summary"]["loss_w"].as_f64().unwrap();
    let graded = loss("{ grade = \"ISO VG 32\", viscosity_index = 105 }");
    // 32 and 5.4483 mm2/s have the index 105.00.
    let stated = loss("{ at_40 = \"32 mm2/s\", at_100 = \"5.4483 mm2/s\" }");
    assert!((graded / stated - 1.0).abs() < 1e-3, "{graded} {stated}");
    run("{ grade = 90, viscosity_index = 105 }").refused_json("E209", "ISO VG grade = 90");
    run("{ grade = 32 }").refused_json("E204", "viscosity_index");
    run("\"ISO VG 32\"").refused_json("E204", "viscosity index");
}
