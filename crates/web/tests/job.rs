//! The job of the page without a browser: the same files as the command's, and what it refuses.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fs;
use std::path::PathBuf;

use asperity::Run;
use asperity::case;
use asperity::pipeline::KeptFields;
use asperity_report::texts;
use asperity_web::{Files, keys, oils, run};

fn fixtures() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../fixtures")
}

/// The e-drive with few positions, and the profiles that it names.
fn small() -> (String, Files) {
    let text = fs::read_to_string(fixtures().join("cases/e-drive.toml")).unwrap();
    let mut files = Files::default();
    for name in ["ground_pinion.csv", "ground_wheel.csv"] {
        files.hold(
            name,
            fs::read(fixtures().join("profiles").join(name)).unwrap(),
        );
    }
    (
        format!("{text}\n[model]\npositions = 3\noffsets = 2\n"),
        files,
    )
}

fn told() -> impl Fn(usize, usize) + Sync {
    |_, _| {}
}

#[test]
fn the_files_of_a_run_are_those_of_the_library_on_the_files_on_disk() {
    let (text, files) = small();
    let found = run("e-drive.toml", &text, &files, &told()).unwrap();
    let on_disk = case::load_with(&fixtures().join("cases/e-drive.toml"), &|input| {
        (input.model.positions, input.model.offsets) = (Some(3), Some(2));
    });
    let outcome = Run::new(&on_disk.unwrap())
        .fields(&KeptFields::Highest)
        .band(true)
        .progress(&told())
        .execute()
        .unwrap();
    assert_eq!(found.files, texts(&outcome).unwrap());
    assert_eq!(found.title, outcome.result.title);
    assert!(
        found
            .summary
            .starts_with("e-drive first stage, ground flanks")
    );
}

#[test]
fn what_cannot_be_run_is_refused_with_code_place_and_help() {
    let (text, files) = small();
    let refused = |text: &str, files: &Files| run("case.toml", text, files, &told()).unwrap_err();
    let unit = refused(&text.replace("145 N m", "145 furlongs"), &files);
    let place = unit.place.unwrap();
    assert_eq!((unit.code, place.line), ("E204", Some(17)));
    assert_eq!(place.key.as_deref(), Some("operation.torque"));
    assert!(unit.help.is_some());
    let missing = refused(&text, &Files::default());
    assert_eq!(missing.code, "E103");
    assert!(
        missing.message.contains("no file has been chosen"),
        "{}",
        missing.message
    );
    let set = refused("[planetary]\nteeth = [27, 24, -75]\n", &files);
    assert_eq!(set.code, "E205");
    let huge = text.replace("offsets = 2", "offsets = 2\ndepths = 4000000");
    let huge = refused(&huge, &files);
    assert!(
        ["E209", "E212"].contains(&huge.code),
        "{} {}",
        huge.code,
        huge.message
    );
}

#[test]
fn a_form_can_be_filled_from_the_text_of_a_case() {
    let (text, _) = small();
    let found: serde_json::Value =
        serde_json::from_str(&keys("case.toml", &text).unwrap()).unwrap();
    assert_eq!(found["gears"]["module"], "1.8 mm");
    assert_eq!(found["surface"]["wheel"]["mirrored"], true);
    assert_eq!(keys("case.toml", "gears = 3").unwrap_err().code, "E204");
    let oils: serde_json::Value = serde_json::from_str(&oils().unwrap()).unwrap();
    let has_source = |oil: &serde_json::Value| oil["name"].is_string() && oil["source"].is_string();
    assert!(oils.as_array().unwrap().iter().all(has_source));
    assert!(oils.as_array().unwrap().len() >= 3);
}
