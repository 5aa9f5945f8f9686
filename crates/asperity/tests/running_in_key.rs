//! The key `operation.running_in`: what a case may state, and what running-in follows from it.

#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::path::{Path, PathBuf};

use asperity::case::{CaseInput, LoadedCase, RunningInPlan, Train, load};
use asperity::error::Error;

const KEY: &str = "operation.running_in";
const TORQUE: &str = "operation.running_in.torque";
const ENGAGEMENTS: &str = "operation.running_in.engagements";

fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures")
}

/// The e-drive stage at 145 N m, with keys set one after the other.
fn with(keys: &[(&str, &str)]) -> Result<LoadedCase, Error> {
    let case = load(&fixtures().join("cases/e-drive.toml"), None)?;
    let set = |case: LoadedCase, (key, value): &(&str, &str)| case.with_key(key, value);
    keys.iter().try_fold(case, set)
}

fn plan(keys: &[(&str, &str)]) -> Option<[Option<f64>; 2]> {
    let plan = with(keys).unwrap().case.running_in;
    plan.map(|plan| [Some(plan.torque.si()), plan.engagements])
}

#[test]
fn flanks_run_in_at_the_torque_of_the_operation_or_at_their_own() {
    let table = r#"{ torque = "302 N m", engagements = 1e3 }"#;
    let both = Some([Some(302.0), Some(1e3)]);
    for (keys, expected) in [
        (&[][..], None),
        (&[(KEY, "false")], None),
        (&[(KEY, "true")], Some([Some(145.0), None])),
        (&[(KEY, "{}")], Some([Some(145.0), None])),
        (&[(KEY, table)], both),
        (&[(TORQUE, "302 N m"), (ENGAGEMENTS, "1000")], both),
        (
            &[(KEY, "true"), (TORQUE, "302 N m"), (ENGAGEMENTS, "1e3")],
            both,
        ),
        (&[(KEY, table), (KEY, "false")], None),
        (
            &[(ENGAGEMENTS, "20"), ("operation.torque", "90 N m")],
            Some([Some(90.0), Some(20.0)]),
        ),
        // The flanks that the operation loads run in.
        (
            &[(TORQUE, "302 N m"), ("operation.torque", "-90 N m")],
            Some([Some(-302.0), None]),
        ),
        (&[(TORQUE, "-302 N m")], Some([Some(302.0), None])),
    ] {
        assert_eq!(plan(keys), expected, "{keys:?}");
    }
}

#[test]
fn a_case_with_running_in_is_the_same_as_text_and_as_json() {
    for value in [
        "true",
        "false",
        r#"{ torque = "302 N m" }"#,
        "{ engagements = 10.0 }",
    ] {
        let input = with(&[(KEY, value)]).unwrap().case.input.clone();
        assert!(input.operation.running_in.is_some());
        let text: CaseInput = input.to_toml().unwrap().parse().unwrap();
        assert_eq!(text, input, "{value}");
        let json = serde_json::to_value(&input).unwrap();
        assert_eq!(
            serde_json::from_value::<CaseInput>(json).unwrap(),
            input,
            "{value}"
        );
    }
    let stated = with(&[(KEY, "true")]).unwrap();
    let mut listed = stated.case.defaults.iter();
    assert!(!listed.any(|default| default.key.contains("running_in")));
}

#[test]
fn impossible_running_in_is_refused_at_its_key() {
    for (key, value, code, at, says) in [
        (
            TORQUE,
            "0 N m",
            "E209",
            TORQUE,
            "must be finite and not zero",
        ),
        (
            TORQUE,
            "inf N m",
            "E204",
            TORQUE,
            "must start with a number",
        ),
        (TORQUE, "302", "E204", TORQUE, "has no unit"),
        (TORQUE, "3e9 N m", "E212", TORQUE, "usual is 0.01 to"),
        (ENGAGEMENTS, "0.5", "E212", ENGAGEMENTS, "usual is 1 to"),
        (ENGAGEMENTS, "2e10", "E212", ENGAGEMENTS, "usual is 1 to"),
        (ENGAGEMENTS, "0", "E209", ENGAGEMENTS, "must be 1 to 1e10"),
        (ENGAGEMENTS, "-5", "E209", ENGAGEMENTS, "must be 1 to 1e10"),
        (ENGAGEMENTS, "inf", "E209", ENGAGEMENTS, "must be 1 to 1e10"),
        (ENGAGEMENTS, "nan", "E209", ENGAGEMENTS, "must be 1 to 1e10"),
        (KEY, "yes", "E204", KEY, "true, false, or a table"),
        (KEY, "{ load = 3 }", "E204", KEY, "unknown field"),
        (
            "operation.running_in.load",
            "3",
            "E203",
            "operation.running_in.load",
            "unknown key",
        ),
        (
            "model.run_in",
            "true",
            "E203",
            "model.run_in",
            "unknown key",
        ),
        (
            "model.include_running_in",
            "true",
            "E203",
            "model.include_running_in",
            "unknown key",
        ),
    ] {
        let error = with(&[(key, value)]).unwrap_err();
        let said = error.to_string();
        assert_eq!(error.code(), code, "{key} = {value}: {said}");
        assert_eq!(error.place().unwrap().key.as_deref(), Some(at), "{said}");
        assert!(said.contains(says), "{key} = {value}: {said}");
    }
}

#[test]
fn flanks_that_would_flow_as_a_whole_are_refused_with_a_torque_that_they_bear() {
    // The case at a torque, and the part of it that the message names.
    let refused = |keys: &[(&str, &str)], at: &str| {
        let error = with(keys).unwrap_err();
        let said = error.to_string();
        assert_eq!(error.code(), "E212", "{said}");
        assert_eq!(error.place().unwrap().key.as_deref(), Some(at), "{said}");
        let (_, part) = said.split_once(", up to ").unwrap();
        let (part, _) = part.split_once(" of this torque").unwrap();
        part.parse::<f64>().unwrap()
    };
    let part = refused(&[(TORQUE, "40 kN m")], TORQUE);
    let torque = |part: f64| format!("{} N m", 40e3 * part);
    let bearable = with(&[(TORQUE, &torque(part))]).unwrap();
    assert!(bearable.warnings.iter().all(|of| !of.text.contains(TORQUE)));
    let more = with(&[(TORQUE, &torque(1.2 * part))]).unwrap();
    assert!(
        more.warnings
            .iter()
            .any(|of| of.code == "W201" && of.text.contains(TORQUE))
    );
    // A soft wheel flows at the torque of the operation, which is no load of running-in then.
    let soft = ("material.wheel.flow_pressure", "0.5 GPa");
    let part = refused(&[soft, (KEY, "true")], KEY);
    with(&[soft]).unwrap();
    with(&[soft, (TORQUE, &format!("{} N m", 145.0 * part))]).unwrap();
}

#[test]
fn the_meshes_of_a_train_run_in_at_their_parts_of_the_torque_of_the_input_shaft() {
    let flank = fixtures().join("profiles/ground_pinion.csv");
    let text = format!(
        r#"
        train = {{ input = "in" }}
        mesh.one = {{ shafts = ["in", "mid"], gears = {{ teeth = [23, 46], module = "2 mm", face_width = "32 mm" }} }}
        mesh.two = {{ shafts = ["mid", "out"], gears = {{ teeth = [23, 68], module = "3 mm", face_width = "50 mm" }} }}
        lubricant.oil = "m100"
        surface.pinion.file = '{}'
        [operation]
        torque = "100 N m"
        speed = "3000 1/min"
        bulk_temperature = "90 °C"
        running_in = {{ torque = "150 N m", engagements = 1e3 }}
        "#,
        flank.display()
    );
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("train.toml");
    let train = |text: &str| {
        std::fs::write(&file, text).unwrap();
        Train::load(&file)
    };
    let plans = |train: Train| -> Vec<RunningInPlan> {
        let meshes = train.meshes();
        meshes
            .map(|mesh| mesh.case.case.running_in.unwrap())
            .collect()
    };
    let stated = plans(train(&text).unwrap());
    let expected = [150.0, 300.0];
    for (plan, torque) in stated.iter().zip(expected) {
        assert!(
            (plan.torque.si().abs() / torque - 1.0).abs() < 1e-12,
            "{plan:?}"
        );
        assert_eq!(plan.engagements, Some(1e3));
    }
    let of_operation = text.replace("torque = \"150 N m\", ", "");
    for (plan, torque) in plans(train(&of_operation).unwrap())
        .iter()
        .zip([100.0, 200.0])
    {
        assert!(
            (plan.torque.si().abs() / torque - 1.0).abs() < 1e-12,
            "{plan:?}"
        );
    }
    let error = train(&text.replace("150 N m", "60 kN m")).unwrap_err();
    assert_eq!(error.code(), "E212", "{error}");
}
