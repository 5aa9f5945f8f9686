//! The job of the page without a browser: the same files as the command's, and what it refuses.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fs;
use std::path::PathBuf;

use asperity::Run;
use asperity::case::{self, Train};
use asperity::pipeline::Kept;
use asperity_calibration::evidence::standard_plan;
use asperity_report::{COLUMNS, Results, texts};
use asperity_web::{Files, gearbox_stage, keys, library, register, run, versus};

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
        .pictures(Kept::Highest)
        .interval(true)
        .evidence(&standard_plan)
        .progress(&told())
        .execute()
        .unwrap()
        .into_only()
        .unwrap();
    assert_eq!(found.files, texts(&outcome).unwrap());
    let only = found.outcome.only().unwrap();
    assert_eq!(only.result, outcome.result);
    assert!(
        found
            .summary()
            .starts_with("e-drive first stage, ground flanks")
    );
}

#[test]
fn a_case_of_the_page_can_choose_the_formulation_of_the_paper() {
    register();
    let (text, files) = small();
    let text = format!("formulation = \"paper\"\n{text}");
    let found = run("e-drive.toml", &text, &files, &told()).unwrap();
    let on_disk = case::load_with(&fixtures().join("cases/e-drive.toml"), &|input| {
        input.formulation = Some(asperity_paper_2022::register());
        (input.model.positions, input.model.offsets) = (Some(3), Some(2));
    });
    let outcome = Run::new(&on_disk.unwrap())
        .execute()
        .unwrap()
        .into_only()
        .unwrap();
    let only = found.outcome.only().unwrap();
    assert_eq!(only.result.formulation.name(), "paper");
    assert_eq!(only.result.summary, outcome.result.summary);
}

#[test]
fn what_cannot_be_run_is_refused_with_code_place_and_help() {
    let (text, files) = small();
    let refused = |text: &str, files: &Files| run("case.toml", text, files, &told()).unwrap_err();
    let unit = refused(&text.replace("145 N m", "145 furlongs"), &files);
    let place = unit.place.unwrap();
    assert_eq!((unit.code.as_str(), place.line), ("E204", Some(20)));
    assert_eq!(place.key.as_deref(), Some("operation.torque"));
    assert!(!unit.help.is_empty());
    let missing = refused(&text, &Files::default());
    assert_eq!(missing.code, "E103");
    assert!(
        missing.message.contains("no file has been chosen"),
        "{}",
        missing.message
    );
    let set = refused("[planetary]\nteeth = [27, 24, -75]\n", &files);
    assert_eq!(set.code, "E204", "{}", set.message);
    let huge = text.replace("offsets = 2", "offsets = 2\ndepths = 4000000");
    let huge = refused(&huge, &files);
    assert!(
        ["E209", "E212"].contains(&huge.code.as_str()),
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
    // Gears by name have the keys of the form.
    let library: serde_json::Value = serde_json::from_str(&library().unwrap()).unwrap();
    for kind in ["oils", "steels", "gears"] {
        let all = library[kind].as_array().unwrap();
        assert!(all.len() >= 3);
        let is_noted = |one: &serde_json::Value| one["name"].is_string() && one["note"].is_string();
        assert!(all.iter().all(is_noted), "{kind}");
    }
    let fzg = &library["gears"][0]["keys"];
    assert_eq!(fzg["gears"]["teeth"], serde_json::json!([16, 24]));
    assert_eq!(fzg["operation"]["torque"], "183.4 N m");
}

#[test]
fn the_headline_adds_up_and_two_results_differ_by_the_torque_that_was_changed() {
    let (text, files) = small();
    let a = run("e-drive.toml", &text, &files, &told()).unwrap();
    let b = run(
        "e-drive.toml",
        &text.replace("145 N m", "50 N m"),
        &files,
        &told(),
    )
    .unwrap();
    let tiles = serde_json::to_value(a.tiles()).unwrap();
    let watts = |text: &serde_json::Value| -> f64 {
        let text = text.as_str().unwrap().trim_start_matches("< ");
        text.split(' ').next().unwrap().parse().unwrap()
    };
    let parts = tiles.as_array().unwrap().iter();
    let mut parts = parts.filter(|tile| tile["name"] == "parts of the loss");
    let parts = parts.next().unwrap()["rows"].as_array().unwrap().clone();
    let shown = parts
        .iter()
        .filter(|row| !row[1].as_str().unwrap().starts_with('<'));
    let sum: f64 = shown.map(|row| watts(&row[1])).sum();
    assert_eq!(sum, watts(&tiles[0]["value"]));

    let both = versus(&a, &b).unwrap();
    assert!(
        both.verdict.starts_with("With B the loss is ")
            && both.verdict.contains("lower than with A"),
        "{}",
        both.verdict
    );
    assert!(both.rows[0][3].starts_with('-'), "{:?}", both.rows[0]);
    let torque = ["operation.torque", "145 N m", "50 N m"].map(str::to_owned);
    assert_eq!(both.inputs, [torque]);
    // Against itself nothing differs.
    let same = versus(&a, &a).unwrap();
    assert_eq!(same.verdict, "With B the loss is exactly as with A");
    assert!(same.inputs.is_empty());
}

#[test]
fn a_stage_of_a_gearbox_file_becomes_a_case_with_the_chosen_flanks() {
    let folder = fixtures().join("../crates/rexs/tests/gearboxes");
    let bytes = fs::read(folder.join("chain.rexs")).unwrap();
    let made = gearbox_stage("chain.rexs", &bytes, 0, ["p.csv", ""]).unwrap();
    assert_eq!(made.stage, 1);
    let text = keys("chain.toml", &made.case).unwrap();
    let case: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(case["surface"]["pinion"]["file"], "p.csv");
    assert!(case["gears"]["module"].is_string());
    let refused = |bytes: &[u8], stage| {
        let made = gearbox_stage("chain.rexs", bytes, stage, ["", ""]);
        made.unwrap_err().code
    };
    // A bevel stage cannot be a mesh of a train.
    assert!(
        made.notes.iter().any(|note| note.contains("bevel")),
        "{:?}",
        made.notes
    );
    let second = gearbox_stage("chain.rexs", &bytes, 2, ["", ""]).unwrap();
    assert_eq!((second.stage, second.stages.len()), (2, 3));
    assert_eq!(refused(&bytes, 99), "E133");
    assert_eq!(refused(b"heights\n", 0), "E132");
}

/// Two stages on the profiles of the e-drive, a clutch by its table, and a seal.
const TRAIN: &str = r#"
title = "two stages"
train.input = "motor"
mesh.first = { shafts = ["motor", "counter"], gears = { teeth = [23, 68], module = "1.8 mm", face_width = "32 mm" } }
mesh.second = { shafts = ["counter", "output"], gears = { teeth = [25, 61], module = "2.5 mm", face_width = "40 mm" } }
operation = { torque = "60 N m", speed = "4000 1/min", bulk_temperature = "90 °C" }
lubricant.oil = "m100"
surface = { pinion.file = "ground_pinion.csv", wheel = { file = "ground_wheel.csv", mirrored = true }, cutoff = "0.25 mm" }
gearbox.seals = [{ shaft = "output", diameter = "50 mm" }]
gearbox.tables = [{ shaft = "output", file = "idle.csv" }]
model = { positions = 4, offsets = 2 }
"#;
const IDLE: &[u8] = b"speed_rpm,loss_torque_nm\n0,0.1\n5000,0.2\n";

#[test]
fn a_gear_train_runs_on_files_in_memory_as_on_disk() {
    let (_, mut files) = small();
    files.hold("idle.csv", IDLE.to_vec());
    let found = run("train.toml", TRAIN, &files, &told()).unwrap();
    assert!(found.outcome.only().is_none());
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("train");
    fs::create_dir_all(&folder).unwrap();
    for name in ["ground_pinion.csv", "ground_wheel.csv"] {
        fs::copy(fixtures().join("profiles").join(name), folder.join(name)).unwrap();
    }
    fs::write(folder.join("idle.csv"), IDLE).unwrap();
    fs::write(folder.join("train.toml"), TRAIN).unwrap();
    let train = Train::load(&folder.join("train.toml")).unwrap();
    let outcome = Run::new(&train)
        .pictures(Kept::Highest)
        .interval(true)
        .evidence(&standard_plan)
        .execute()
        .unwrap();
    assert_eq!(found.outcome.whole, outcome.whole);
    assert_eq!(found.summary(), Results::from(&outcome).summary(COLUMNS));
    // Each mesh names its case by the place of the file.
    let names = |files: &[(String, Vec<u8>)]| {
        files
            .iter()
            .map(|(name, _)| name.clone())
            .collect::<Vec<_>>()
    };
    let of_disk = texts(&outcome).unwrap();
    assert_eq!(names(&found.files), names(&of_disk));
    assert_eq!(found.files[..4], of_disk[..4]);
    for name in [
        "train.json",
        "report.html",
        "first/report.html",
        "second/result.json",
    ] {
        assert!(found.files.iter().any(|(known, _)| known == name), "{name}");
    }
    let tiles = found.tiles();
    assert_eq!(tiles[1].name, "loss of all meshes");
    let parts = tiles
        .iter()
        .find(|tile| tile.name == "meshes and parts")
        .unwrap();
    assert_eq!(parts.rows.len(), 4, "{parts:?}");
    // Side by side with the same train at another torque, and with a pair of gears.
    let other = run(
        "train.toml",
        &TRAIN.replace("60 N m", "30 N m"),
        &files,
        &told(),
    )
    .unwrap();
    let both = versus(&found, &other).unwrap();
    assert!(
        both.verdict.starts_with("With B the loss is "),
        "{}",
        both.verdict
    );
    let loss = both
        .rows
        .iter()
        .find(|row| row[0] == "loss of all meshes")
        .unwrap();
    assert!(loss[3].starts_with('-'), "{loss:?}");
    assert!(
        both.inputs.iter().any(|row| row[0] == "operation.torque"),
        "{:?}",
        both.inputs
    );
    let (text, files) = small();
    let pair = run("e-drive.toml", &text, &files, &told()).unwrap();
    assert!(!versus(&found, &pair).unwrap().verdict.is_empty());
    // A file that is not chosen is named with its key.
    let missing = run("train.toml", TRAIN, &files, &told()).unwrap_err();
    assert_eq!(missing.code, "E103");
    assert!(missing.message.contains("idle.csv"), "{}", missing.message);
}

#[test]
fn a_gearbox_of_several_stages_becomes_one_case() {
    let bytes = fs::read(fixtures().join("../crates/rexs/tests/gearboxes/planetary.rexs")).unwrap();
    let made = gearbox_stage("planetary.rexs", &bytes, 0, ["", ""]).unwrap();
    let text = keys("planetary.toml", &made.case).unwrap();
    let case: serde_json::Value = serde_json::from_str(&text).unwrap();
    let has_train = case.get("mesh").is_some() || case.get("planetary").is_some();
    assert!(has_train, "{}", made.case);
}
