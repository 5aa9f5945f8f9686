//! The bulk temperature that the loss keeps up, at the command line.

use crate::bench::{Bench, root};

/// Runs the superfinished e-drive, coarsely, at 20 N m and 500 1/min with a boundary layer that rubs as dry steel.
fn run(bench: &Bench, settings: &[&str]) -> crate::bench::Said {
    let case = root().join("fixtures/cases/e-drive-superfinished.toml");
    let mut arguments = vec![
        "run",
        case.to_str().unwrap(),
        "--no-output",
        "--no-band",
        "--notes",
    ];
    let coarse = [
        "model.positions=4",
        "model.offsets=2",
        "operation.torque=20 N m",
        "operation.speed=500 1/min",
        "model.boundary_friction=2",
    ];
    for setting in coarse.iter().chain(settings) {
        arguments.extend(["--set", setting]);
    }
    bench.run(&arguments)
}

#[test]
fn a_run_says_which_temperature_the_flanks_reach() {
    let jet = "operation.bulk={ law = \"iso\", lubrication = \"jet\" }";
    let said = run(&Bench::new(), &[jet, "operation.oil_temperature=90 °C"]).well();
    let text = said.unwrapped();
    let line = text.lines().find(|line| line.starts_with("bulk"));
    let line = line.unwrap_or_else(|| panic!("{text}"));
    assert!(
        line.contains("°C; oil 90 °C, rise by the loss (iso, unconfirmed, jet)"),
        "{line}"
    );
}

#[test]
fn a_mesh_that_keeps_no_temperature_from_a_hot_start_is_warned_of() {
    let settings = [
        "operation.oil_temperature=0 °C",
        "operation.bulk={ law = \"network\", pinion_to_oil = \"0.25 W/K\", wheel_to_oil = \"0.25 W/K\" }",
    ];
    let said = run(&Bench::new(), &settings).well();
    let text = said.unwrapped();
    let warned = text.lines().find(|line| line.starts_with("W426"));
    let warned = warned.unwrap_or_else(|| panic!("{text}"));
    assert!(
        warned.contains("W426 bulk temperature") && warned.contains("started at 60 °C"),
        "{warned}"
    );
}

#[test]
fn a_mesh_that_heats_itself_on_and_on_is_refused() {
    let settings = [
        "operation.oil_temperature=60 °C",
        "operation.bulk={ law = \"network\", pinion_to_oil = \"0.1 W/K\", wheel_to_oil = \"0.1 W/K\" }",
    ];
    let says = ["the bulk temperature did not settle in", "still moving by"];
    run(&Bench::new(), &settings).refused(3, "E311", &says);
}

#[test]
fn keys_of_the_bulk_temperature_that_do_not_fit_are_refused() {
    for (settings, says) in [
        (
            &["operation.bulk={ law = \"iso\" }"][..],
            "operation.bulk.lubrication: is missing",
        ),
        (
            &["operation.bulk={ law = \"iso\", lubrication = \"dip\", between = \"3 W/K\" }"],
            "takes conductances with law = \"network\" only",
        ),
        (
            &["operation.bulk={ law = \"network\", pinion_to_oil = \"12 W/K\" }"],
            "operation.bulk.wheel_to_oil: is missing",
        ),
        (
            &["operation.bulk={ law = \"network\", lubrication = \"dip\" }"],
            "is used with law = \"iso\" only",
        ),
        (
            &[
                "formulation=paper",
                "operation.bulk={ law = \"iso\", lubrication = \"dip\" }",
            ],
            "belongs to the corrected formulation",
        ),
        (
            &[
                "model.load_share=ehl",
                "operation.bulk={ law = \"iso\", lubrication = \"dip\" }",
            ],
            "load_share = \"solved\"",
        ),
    ] {
        let settings = [settings, &["operation.oil_temperature=90 °C"]].concat();
        run(&Bench::new(), &settings).refused(2, "E205", &[says]);
    }
}
