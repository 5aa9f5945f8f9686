//! Files that the program reads back are as it wrote them, to the last digit.

use std::fs;
use std::path::PathBuf;

use crate::bench::{Bench, E_DRIVE};

/// The text with another last digit.
fn with_another_digit(text: &str) -> String {
    let at = text.rfind(|c: char| c.is_ascii_digit()).unwrap();
    let other = if &text[at..=at] == "7" { "8" } else { "7" };
    format!("{}{other}{}", &text[..at], &text[at + 1..])
}

const STUDY: &str = r#"case = "case.toml"
columns = ["loss_w"]
[[axis]]
name = "torque"
choice.as_is = {}
choice.low = { "operation.torque" = "60 N m" }
"#;

/// The only file in the only folder in `folder`.
fn only_file(mut folder: PathBuf) -> PathBuf {
    while folder.is_dir() {
        folder = fs::read_dir(folder)
            .unwrap()
            .next()
            .unwrap()
            .unwrap()
            .path();
    }
    folder
}

#[test]
fn a_table_of_our_own_of_which_a_digit_was_changed_is_refused() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE.replace("depths = 0", "depths = 4"));
    bench.write("study.toml", STUDY);
    let rows = "time_s,torque_nm,speed_rpm\n0,40,500\n1,40,500\n";
    bench.write("few.csv", rows);
    let map = ["map", "case.toml", "-o", "m", "-q", "--band", "none"];
    let axes = ["--torque=-100,100", "--speed=500,9000"];
    bench.run(&[&map[..], &axes].concat()).well();
    let run = ["run", "case.toml", "-o", "r", "-q", "--no-band"];
    bench.run(&[&run[..], &["--fields", "all"]].concat()).well();
    bench
        .run(&["sweep", "run", "study.toml", "-q", "--parts", "parts"])
        .well();
    let part = only_file(bench.path("parts"));
    // The page has the tables of one position; those of the other are read.
    let page = fs::read_to_string(bench.path("r/page.json")).unwrap();
    let page: serde_json::Value = serde_json::from_str(&page).unwrap();
    let shown = page["contact"]["position"].as_u64().unwrap();
    let other = (3 - shown).to_string();
    let cycle = ["cycle", "m", "few.csv", "--no-output"];
    let report = ["report", "r", "--position", &other];
    let merge = [
        "sweep",
        "merge",
        "study.toml",
        "-q",
        "--parts",
        "parts",
        "-o",
        "s",
    ];
    let again = ["sweep", "run", "study.toml", "-q", "--parts", "parts"];
    let files = [
        (bench.path("m/map.csv"), &cycle[..]),
        (bench.path("m/map.json"), &cycle),
        (bench.path("r/result.json"), &report),
        (bench.path("r/page.json"), &report),
        (
            bench.path(&format!("r/position_0{other}/surface.csv")),
            &report,
        ),
        (
            bench.path(&format!("r/position_0{other}/subsurface.csv")),
            &report,
        ),
        (bench.path("r/convergence.csv"), &report),
        (part.clone(), &again),
        (part, &merge),
    ];
    for (file, command) in files {
        bench.run(command).well();
        let whole = fs::read_to_string(&file).unwrap();
        fs::write(&file, with_another_digit(&whole)).unwrap();
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        bench.run(command).refused(2, "E402", &[&name]);
        fs::write(&file, whole).unwrap();
        bench.run(command).well();
    }
}
