//! `asperity calibrate` through the command.

use std::fs;

use crate::bench::Bench;

/// FZG test gears with few windows.
const CASE: &str = r#"title = "test gears"

[gears]
teeth = [16, 24]
module = "4.5 mm"
face_width = "14 mm"
profile_shift = [0.182, 0.172]

[operation]
torque = "183.4 N m"
speed = "2166 1/min"
temperature = "90 °C"

[lubricant]
oil = "m100"

[surface]
cutoff = "0.25 mm"
pinion = { file = "pinion.csv" }
wheel = { file = "wheel.csv", mirrored = true }

[model]
positions = 4
offsets = 2
depths = 0
"#;

const HEAD: &str = "torque_nm,speed_rpm,temperature_c,loss_w,sigma_w,includes\n";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", CASE);
    bench
}

/// A design with simulated losses in the folder `design`.
fn designed(bench: &Bench) -> String {
    let axes = ["--torque", "60,183.4", "--speed", "25..4400:7:log"];
    let mut arguments = vec![
        "calibrate",
        "--design",
        "case.toml",
        "--simulate",
        "4",
        "-o",
        "design",
    ];
    arguments.extend(axes);
    bench.run(&arguments).well().out
}

#[test]
fn a_design_is_rehearsed_and_its_calibration_narrows_the_band_of_a_run() {
    let bench = bench();
    let told = designed(&bench);
    assert!(
        told.contains("16 points for each of 2 assemblies"),
        "{told}"
    );
    assert!(told.contains("SIMULATED"), "{told}");
    // The table to fill in is refused as it is: nothing was measured.
    let empty = bench.run(&["calibrate", "design/design.csv", "case.toml"]);
    empty.refused(2, "E134", &["design.csv:2: ", "is missing"]);
    let said = bench.run(&[
        "calibrate",
        "design/simulated.csv",
        "case.toml",
        "-o",
        "found",
        // Measured losses hold what their table says, whatever the case adds to its mesh.
        "--set",
        "gearbox.seals=[{ shaft = \"pinion\", diameter = \"40 mm\" }]",
    ]);
    let text = said.well().out;
    assert!(
        text.contains("W431 the gearbox of the case is ignored"),
        "{text}"
    );
    let before = text.find("identifiability by").unwrap();
    assert!(before < text.find("95 % band").unwrap(), "{text}");
    assert!(
        text.contains("would help most") && text.contains("SIMULATED"),
        "{text}"
    );
    assert!(text.contains("W420 2 assemblies"), "{text}");
    let page = fs::read_to_string(bench.path("found/calibration.html")).unwrap();
    for part in [
        "Residuals over speed",
        "Residuals over torque",
        "Residuals over temperature",
        "SIMULATED",
    ] {
        assert!(page.contains(part), "{part}");
    }
    let points = fs::read_to_string(bench.path("found/points.csv")).unwrap();
    assert_eq!(points.lines().count(), 33);

    let block = fs::read_to_string(bench.path("found/calibration.toml")).unwrap();
    bench.write("calibrated.toml", format!("{CASE}\n{block}"));
    let width = |case: &str| {
        let result = bench
            .run(&["run", case, "--no-output", "--json"])
            .well()
            .json();
        let ends = result["band"]["quantiles_w"].as_array().unwrap().clone();
        ends[1].as_f64().unwrap() - ends[0].as_f64().unwrap()
    };
    let (plain, calibrated) = (width("case.toml"), width("calibrated.toml"));
    assert!(calibrated < 0.8 * plain, "{calibrated} of {plain}");
    // And it is printed.
    let line = |case: &str| {
        let text = bench.run(&["run", case, "--no-output"]).well().out;
        text.lines()
            .find(|line| line.contains("efficiency (mesh only)"))
            .unwrap()
            .to_owned()
    };
    assert_ne!(line("case.toml"), line("calibrated.toml"));
    let checked = bench.run(&["check", "calibrated.toml"]).well();
    assert!(
        !checked.out.contains("boundary_friction"),
        "{}",
        checked.out
    );
}

#[test]
fn one_temperature_or_two_points_are_refused_for_the_share() {
    let bench = bench();
    bench.write(
        "rig.csv",
        format!("{HEAD}183.4,1000,90,150,4,mesh\n183.4,2000,90,290,8,mesh\n"),
    );
    let said = bench.run(&["calibrate", "rig.csv", "case.toml"]);
    let parts = [
        "boundary layer",
        "2 points",
        "temperature: only 90 °C",
        "Lambda* from",
    ];
    said.refused(2, "E310", &parts);
    assert!(!bench.path("results").exists());
    // A design is refused alike.
    let said = bench.run(&["calibrate", "--design", "case.toml", "--temperature", "90"]);
    said.refused(2, "E310", &["temperature: only 90 °C"]);
}

#[test]
fn rows_that_cannot_be_used_are_named_with_their_lines() {
    let bench = bench();
    bench.write(
        "rig.csv",
        format!("{HEAD}183.4,1000,90,150,,mesh\n183.4,2000,363,290,8,mesh\n183.4,2000,90,290,8,\n"),
    );
    let said = bench.run(&["calibrate", "rig.csv", "case.toml"]);
    said.refused(
        2,
        "E134",
        &[
            "rig.csv:2: sigma_w",
            "rig.csv:3: temperature_c",
            "rig.csv:4: includes",
        ],
    );
    bench.write("none.csv", format!("{HEAD}183.4,1000,90,150,4,mesh\n"));
    let said = bench.run(&["calibrate", "none.csv"]);
    said.refused(2, "E134", &["names no case"]);
    let said = bench.run(&["calibrate", "missing.csv", "case.toml"]);
    said.refused(2, "E103", &["missing.csv"]);
}

#[test]
fn an_outlier_is_named_and_scatter_beyond_sigma_is_told() {
    let bench = bench();
    designed(&bench);
    let text = fs::read_to_string(bench.path("design/simulated.csv")).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let changed = |change: &dyn Fn(usize, f64) -> [f64; 2]| -> String {
        let rows = lines.iter().enumerate().map(|(k, line)| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            if let Some(loss) = cells.get(3).and_then(|cell| cell.parse::<f64>().ok()) {
                let [loss, sigma] = change(k, loss);
                (cells[3], cells[4]) = (format!("{loss:.4}"), format!("{sigma:.4}"));
            }
            cells.join(",") + "\n"
        });
        rows.collect()
    };
    let outlier = changed(&|k, loss| [if k == 7 { 2.0 * loss } else { loss }, 0.03 * loss]);
    bench.write("outlier.csv", outlier);
    let said = bench.run(&["calibrate", "outlier.csv", "case.toml"]);
    said.refused(2, "E135", &["1 of 32 rows", "outlier.csv:8 by +"]);
    // A standard deviation of a third of the truth.
    bench.write("scatter.csv", changed(&|_, loss| [loss, 0.01 * loss]));
    let said = bench
        .run(&["calibrate", "scatter.csv", "case.toml", "-o", "s"])
        .well();
    assert!(
        said.unwrapped().contains("W419 the residuals are"),
        "{}",
        said.out
    );
}

#[test]
fn a_design_takes_no_table_and_its_limits_must_leave_points() {
    let bench = bench();
    let said = bench.run(&["calibrate", "--design", "rig.csv", "case.toml"]);
    said.refused(2, "E205", &["--design"]);
    let said = bench.run(&["calibrate", "--design", "case.toml", "--hours", "0.5"]);
    said.refused(2, "E209", &["points of an assembly"]);
    let said = bench.run(&["calibrate", "--design", "case.toml", "--speed", "a..b"]);
    said.refused(2, "E209", &["--speed"]);
    fs::create_dir(bench.path("mine")).unwrap();
    bench.write("mine/notes.txt", "kept");
    let said = bench.run(&["calibrate", "--design", "case.toml", "-o", "mine"]);
    said.refused(2, "E401", &["mine"]);
}
