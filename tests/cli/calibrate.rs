//! `asperity calibrate` through the command.

use std::fs;
use std::sync::OnceLock;

use crate::bench::Bench;

/// FZG test gears with few windows.
pub const CASE: &str = r#"title = "test gears"

[gears]
teeth = [16, 24]
module = "4.5 mm"
face_width = "14 mm"
profile_shift = [0.182, 0.172]

[operation]
torque = "183.4 N m"
speed = "2166 1/min"
bulk_temperature = "90 °C"

[lubricant]
oil = "m100"

[surface]
cutoff = "0.25 mm"
pinion = { file = "pinion.csv" }
wheel = { file = "wheel.csv", mirrored = true }

[model]
positions = 4
offsets = 1
depths = 0
"#;

const HEAD: &str = "torque_nm,speed_rpm,temperature_c,loss_w,sigma_w,includes\n";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", CASE);
    bench
}

impl Bench {
    /// `calibration.json` of a folder.
    fn calibrated(&self, folder: &str) -> serde_json::Value {
        let text = fs::read_to_string(self.path(folder).join("calibration.json")).unwrap();
        serde_json::from_str(&text).unwrap()
    }
}

/// A design with simulated losses and its calibration, which several tests need: text printed, and files.
struct Rehearsal {
    designed: String,
    calibrated: String,
    files: Vec<(&'static str, String)>,
}

impl Rehearsal {
    fn new() -> Self {
        let bench = bench();
        let design = ["design", "case.toml", "--simulate", "4", "-o", "design"];
        let axes = ["--torque", "60,183.4", "--speed", "25..4400:7:log"];
        let designed = bench.run(&[&design[..], &axes].concat()).well().out;
        let simulated = fs::read_to_string(bench.path("design/simulated.csv")).unwrap();
        let remarked = simulated.lines().map(|line| match line.chars().next() {
            Some('#') => format!("{line}\n"),
            Some('t') => format!("{line},Remark\n"),
            _ => format!("{line},cold\n"),
        });
        bench.write("design/simulated.csv", remarked.collect::<String>());
        let calibrate = [
            "calibrate",
            "design/simulated.csv",
            "case.toml",
            "-o",
            "found",
        ];
        // Measured losses hold what their table says, whatever the case adds to its mesh.
        let seals = "gearbox.seals=[{ shaft = \"pinion\", diameter = \"40 mm\" }]";
        let calibrated = bench
            .run(&[&calibrate[..], &["--set", seals]].concat())
            .well()
            .out;
        let files = [
            "design/design.csv",
            "design/simulated.csv",
            "found/calibration.html",
            "found/calibration.json",
            "found/calibration.toml",
            "found/points.csv",
        ];
        let read = |name| (name, fs::read_to_string(bench.path(name)).unwrap());
        Self {
            designed,
            calibrated,
            files: files.map(read).to_vec(),
        }
    }
}

/// A bench with the files of the rehearsal, which is made once.
fn rehearsed() -> (Bench, &'static Rehearsal) {
    static MADE: OnceLock<Rehearsal> = OnceLock::new();
    let made = MADE.get_or_init(Rehearsal::new);
    let bench = bench();
    for folder in ["design", "found"] {
        fs::create_dir(bench.path(folder)).unwrap();
    }
    for (name, content) in &made.files {
        bench.write(name, content);
    }
    (bench, made)
}

#[test]
fn a_design_is_rehearsed_and_its_calibration_narrows_the_band_of_a_run() {
    let (bench, made) = rehearsed();
    let told = &made.designed;
    assert!(
        told.contains("Measure these 16 points with each of 2 assemblies"),
        "{told}"
    );
    assert!(told.contains("SIMULATED"), "{told}");
    // The table to fill in is refused as it is: nothing was measured.
    let empty = bench.run(&["calibrate", "design/design.csv", "case.toml"]);
    empty.refused(2, "E134", &["design.csv:2: ", "is missing"]);
    let text = &made.calibrated;
    assert!(
        text.contains("W431 the gearbox of the case is ignored"),
        "{text}"
    );
    let unread = "W454 columns of design/simulated.csv that are not read: Remark";
    assert!(text.contains(unread), "{text}");
    let before = text.find("identifiability by").unwrap();
    assert!(before < text.find("  5 to 95 %  ").unwrap(), "{text}");
    assert!(
        text.contains("would help most") == text.contains("Measure next")
            && text.contains("SIMULATED"),
        "{text}"
    );
    assert!(text.contains("W420 2 assemblies"), "{text}");
    let page = fs::read_to_string(bench.path("found/calibration.html")).unwrap();
    for part in [
        "Residuals over speed",
        "Residuals over torque",
        "Residuals over temperature",
        "SIMULATED",
        unread,
    ] {
        assert!(page.contains(part), "{part}");
    }
    let points = fs::read_to_string(bench.path("found/points.csv")).unwrap();
    assert_eq!(points.lines().count(), 33);

    let block = fs::read_to_string(bench.path("found/calibration.toml")).unwrap();
    bench.write("calibrated.toml", format!("{CASE}\n{block}"));
    let width = |case: &str| {
        let said = bench.run(&["run", case, "-o", "out"]).well().out;
        let text = fs::read_to_string(bench.path("out/result.json")).unwrap();
        fs::remove_dir_all(bench.path("out")).unwrap();
        let result: serde_json::Value = serde_json::from_str(&text).unwrap();
        let ends = result["uncertainty"]["loss"]["quantiles_w"]
            .as_array()
            .unwrap()
            .clone();
        let line = said
            .lines()
            .find(|line| line.contains("efficiency (mesh only)"));
        let width = ends[1].as_f64().unwrap() - ends[0].as_f64().unwrap();
        (width, line.unwrap().to_owned())
    };
    let [(plain, of_plain), (calibrated, of_calibrated)] =
        ["case.toml", "calibrated.toml"].map(width);
    assert!(calibrated < 0.92 * plain, "{calibrated} of {plain}");
    // And it is printed.
    assert_ne!(of_plain, of_calibrated);
    let checked = bench.run(&["check", "calibrated.toml"]).well();
    assert!(
        !checked.out.contains("boundary_friction"),
        "{}",
        checked.out
    );
}

#[test]
fn points_that_determine_no_parameter_that_is_left_are_refused() {
    let bench = bench();
    bench.write(
        "rig.csv",
        format!("{HEAD}183.4,1000,90,150,4,mesh\n183.4,2000,90,290,8,mesh\n"),
    );
    let mut given = vec!["calibrate", "rig.csv", "case.toml"];
    for held in ["boundary-friction", "limiting-shear", "eyring-stress"] {
        given.extend(["--hold", held]);
    }
    let said = bench.run(&given);
    let parts = [
        "boundary layer",
        "2 points",
        "temperature: only 90 °C",
        "Lambda* from",
    ];
    said.refused(2, "E310", &parts);
    assert!(said.err.contains("--speed-max"));
    assert!(!bench.path("results").exists());
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

/// The simulated table of the design with changed rows; `change` gets index and cells of a row.
fn rewritten(bench: &Bench, name: &str, change: impl Fn(usize, &mut Vec<String>)) {
    let text = fs::read_to_string(bench.path("design/simulated.csv")).unwrap();
    let rows = text.lines().enumerate().map(|(k, line)| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        if cells.get(3).is_some_and(|cell| cell.parse::<f64>().is_ok()) {
            change(k, &mut cells);
        }
        cells.join(",") + "\n"
    });
    bench.write(name, rows.collect::<String>());
}

/// States the standard deviation of a row relative to its loss.
fn stated(cells: &mut [String], sigma: f64) {
    cells[4] = format!("{:.4}", sigma * cells[3].parse::<f64>().unwrap());
}

#[test]
fn outliers_and_points_that_the_model_does_not_explain_are_named() {
    let (bench, _) = rehearsed();
    rewritten(&bench, "outlier.csv", |k, cells| {
        if k == 7 {
            cells[3] = format!("{:.4}", 2.0 * cells[3].parse::<f64>().unwrap());
        }
    });
    let said = bench.run(&["calibrate", "outlier.csv", "case.toml"]);
    said.refused(2, "E135", &["1 of 32 rows", "outlier.csv:8 by +"]);
    // The errors of the table are 3 %.
    rewritten(&bench, "half.csv", |_, cells| stated(cells, 0.015));
    rewritten(&bench, "quarter.csv", |_, cells| stated(cells, 0.0075));
    let calibrate = |table: &str| bench.run(&["calibrate", table, "case.toml", "-o", "s"]);
    let said = bench.run(&[
        "calibrate",
        "quarter.csv",
        "case.toml",
        "-o",
        "s",
        "--quiet",
    ]);
    let message = "the model does not explain these points within 3 times your errors";
    said.refused(4, "E315", &[message]);
    assert_eq!(
        said.err.matches("quarter.csv:").count(),
        1 + 5,
        "{}",
        said.err
    );
    assert!(!bench.path("s").exists());
    let said = calibrate("half.csv").well();
    let ratio = bench.calibrated("s")["birge_ratio"].as_f64().unwrap();
    assert!((1.5..2.5).contains(&ratio), "{ratio}");
    let words =
        format!("the residuals are {ratio:.2} times the stated errors, and widen the intervals by");
    assert!(said.unwrapped().contains(&words), "{}", said.out);
    assert!(
        said.out
            .contains(&format!("2 assemblies, Birge ratio {ratio:.2}\"\n"))
    );
    // The same residuals with the errors that explain them: narrower bands of the same values.
    let widths = |bench: &Bench, folder: &str| -> Vec<f64> {
        let found = bench.calibrated(folder);
        let parameters = found["parameters"].as_array().unwrap().iter();
        let width = |one: &serde_json::Value| {
            (one["band"][1].as_f64().unwrap() / one["band"][0].as_f64().unwrap()).ln()
        };
        parameters.map(width).collect()
    };
    // Nuisance terms and priors are widened too, so that the bands are not narrower than those of the true errors.
    for (widened, honest) in widths(&bench, "s").iter().zip(widths(&bench, "found")) {
        assert!(*widened > 0.9 * honest, "{widened} {honest}");
    }
}

#[test]
fn too_few_rows_to_confirm_their_errors_are_refused() {
    let (bench, _) = rehearsed();
    let text = fs::read_to_string(bench.path("design/simulated.csv")).unwrap();
    let few: Vec<&str> = text.lines().take(2 + 5).collect();
    bench.write("few.csv", few.join("\n"));
    let hold = |more: &[&str]| {
        let table = [
            "calibrate",
            "few.csv",
            "case.toml",
            "--hold",
            "boundary-layer",
        ];
        bench.run(&[&table, more].concat())
    };
    hold(&[]).refused(2, "E316", &["5 rows for 3 parameters; 6 or more"]);
    hold(&["--hold", "limiting-shear"]).well();
}

#[test]
fn residuals_that_drift_with_the_order_are_reported() {
    let (bench, _) = rehearsed();
    let points = bench.calibrated("found")["points"].clone();
    let residual = |k: usize| points[k]["residual_sigma"].as_f64().unwrap();
    let first = points[0]["line"].as_u64().unwrap() as usize - 1;
    rewritten(&bench, "drift.csv", |k, cells| {
        let own = residual(k - first);
        let smaller = (0..32).filter(|other| residual(*other) < own).count();
        cells[6] = smaller.to_string();
    });
    let said = bench
        .run(&["calibrate", "drift.csv", "case.toml", "-o", "d"])
        .well();
    let drift = "W419 the residuals drift with the order of measurement (correlation +0.9";
    assert!(said.unwrapped().contains(drift), "{}", said.out);
}

/// Largest torque and speed of these points.
fn largest(points: &serde_json::Value) -> [f64; 2] {
    ["torque_nm", "speed_rpm"].map(|key| {
        let all = points.as_array().unwrap().iter();
        all.map(|point| point[key].as_f64().unwrap())
            .fold(0.0, f64::max)
    })
}

#[test]
fn a_design_stays_within_the_rig_and_holds_what_the_rig_cannot_identify() {
    let bench = Bench::new();
    bench.run(&["demo", "rig"]).well();
    let coarse = ["--set", "model.positions=2", "--set", "model.offsets=1"];
    let run = |arguments: &[&str]| bench.run(&[arguments, &coarse].concat());
    let designed = |folder: &str| -> serde_json::Value {
        let text = fs::read_to_string(bench.path(folder).join("design.json")).unwrap();
        serde_json::from_str(&text).unwrap()
    };
    // The case states 145 N m, and 12 000 1/min for its map.
    run(&["design", "rig/case.toml", "-o", "a"]).well();
    assert_eq!(largest(&designed("a")["points"]), [145.0, 12_000.0]);
    let said = run(&[
        "design",
        "rig/case.toml",
        "--torque-max",
        "120",
        "--speed-max",
        "6000",
        "--temperature",
        "60,90",
        "--simulate",
        "1",
        "-o",
        "b",
    ])
    .well();
    let design = designed("b");
    assert_eq!(largest(&design["points"]), [120.0, 6000.0]);
    let text = said.unwrapped();
    for part in [
        "W436 the boundary layer is fixed",
        "Lambda* from",
        "largest torque and speed",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let keys: Vec<&str> = design["parameters"]
        .as_array()
        .unwrap()
        .iter()
        .filter_map(|one| one["key"].as_str())
        .collect();
    assert_eq!(
        keys,
        ["boundary_friction", "limiting_shear", "eyring_stress"]
    );
    // One temperature is designed alike.
    let said = run(&["design", "rig/case.toml", "--temperature", "90", "-o", "c"]).well();
    assert!(
        said.unwrapped().contains("temperature: only 90 °C"),
        "{}",
        said.out
    );

    // Suggestions stay within the table, or within the limits that are stated.
    let table = [
        "calibrate",
        "b/simulated.csv",
        "rig/case.toml",
        "--hold",
        "boundary-layer",
    ];
    let helpful = |more: &[&str], folder: &str| {
        run(&[&table, more, &["-o", folder]].concat()).well();
        bench.calibrated(folder)["identifiability"]["helpful"].clone()
    };
    let [torque, speed] = largest(&helpful(&[], "d"));
    assert!(torque <= 120.0 && speed <= 6000.0, "{torque} {speed}");
    let limits = [
        "--torque-max",
        "90",
        "--speed-max",
        "4000",
        "--temperature",
        "75",
    ];
    let suggested = helpful(&limits, "e");
    let [torque, speed] = largest(&suggested);
    assert!(torque <= 90.0 && speed <= 4000.0, "{torque} {speed}");
    assert_eq!(suggested[0]["temperature_c"], 75.0);
    let said = run(&["design", "rig/case.toml", "--speed-max", "0"]);
    said.refused(2, "E209", &["--speed-max = 0: must be positive"]);
}

#[test]
fn a_design_takes_no_table_and_its_limits_must_leave_points() {
    let bench = bench();
    let said = bench.run(&["design", "rig.csv", "case.toml"]);
    said.refused(2, "E213", &["case.toml"]);
    let said = bench.run(&["design", "case.toml", "--hours", "0.5"]);
    said.refused(2, "E209", &["points of an assembly"]);
    let said = bench.run(&[
        "design",
        "case.toml",
        "--hours",
        "1.25",
        "--assemblies",
        "1",
    ]);
    said.refused(
        2,
        "E209",
        &["points = 5: are too few to confirm the errors"],
    );
    let said = bench.run(&["design", "case.toml", "--speed", "a..b"]);
    said.refused(2, "E209", &["--speed"]);
    fs::create_dir(bench.path("mine")).unwrap();
    bench.write("mine/notes.txt", "kept");
    let said = bench.run(&["design", "case.toml", "-o", "mine"]);
    said.refused(2, "E401", &["mine"]);
}
