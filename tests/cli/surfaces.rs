//! Surfaces of instruments in the command and in cases.

use asperity::core::quantity::Length;

use crate::bench::{Bench, heights, rows, trace, with_line};

/// A Digital Surf file of `count` rows of `points` points, 0.5 um apart, of this kind of content.
pub fn sur(points: usize, count: usize, kind: i16, replica: i16) -> Vec<u8> {
    let all = heights(points + 500 * count);
    let rows: Vec<&[f64]> = (0..count)
        .map(|row| &all[500 * row..500 * row + points])
        .collect();
    let mut bytes = digital_surf(&rows, 0.5);
    bytes[18..20].copy_from_slice(&kind.to_le_bytes());
    bytes[288..290].copy_from_slice(&replica.to_le_bytes());
    bytes
}

/// A Digital Surf file of a surface with these rows of heights \[um\], `dy` um apart, and points 0.5 um apart.
pub fn digital_surf<R: AsRef<[f64]>>(rows: &[R], dy: f32) -> Vec<u8> {
    let (points, count) = (rows[0].as_ref().len(), rows.len());
    let mut bytes = vec![0; 512];
    let mut set = |at: usize, part: &[u8]| bytes[at..at + part.len()].copy_from_slice(part);
    set(0, b"DIGITAL SURF");
    set(14, &1_i16.to_le_bytes());
    set(18, &2_i16.to_le_bytes());
    set(98, &32_i16.to_le_bytes());
    set(108, &(points as i32).to_le_bytes());
    set(112, &(count as i32).to_le_bytes());
    set(120, &0.5_f32.to_le_bytes());
    set(124, &dy.to_le_bytes());
    set(128, &0.1_f32.to_le_bytes());
    for unit in [180, 196] {
        set(unit, b"um");
    }
    set(212, b"nm");
    for z in rows.iter().flat_map(|row| row.as_ref()) {
        bytes.extend(((z * 1e4).round() as i32).to_le_bytes());
    }
    bytes
}

/// A MAT-file of level 5 with two vectors that are not named z.
fn two_arrays() -> Vec<u8> {
    let element = |kind: u32, data: &[u8]| {
        let mut bytes = [kind, data.len() as u32].map(u32::to_le_bytes).concat();
        bytes.extend(data);
        bytes.resize(bytes.len().next_multiple_of(8), 0);
        bytes
    };
    let mut bytes = vec![0; 128];
    bytes[..19].copy_from_slice(b"MATLAB 5.0 MAT-file");
    bytes[124..].copy_from_slice(b"\x00\x01IM");
    for name in ["left", "right"] {
        let flags = [6_u32, 0].map(u32::to_le_bytes).concat();
        let sizes = [3_i32, 1].map(i32::to_le_bytes).concat();
        let numbers = [1.0_f64, 2.0, 3.0].map(f64::to_le_bytes).concat();
        let parts = [
            element(6, &flags),
            element(5, &sizes),
            element(1, name.as_bytes()),
            element(9, &numbers),
        ];
        bytes.extend(element(14, &parts.concat()));
    }
    bytes
}

#[test]
fn a_surface_gives_a_row_or_its_mean() {
    let bench = Bench::new();
    bench.write("flank.sur", sur(6000, 3, 2, 0));
    let info = |more: &[&str]| {
        let all = ["profile", "info", "flank.sur", "--lambda-c", "0.25 mm"];
        bench.run(&[&all, more].concat())
    };
    // The lines for a case take rows of the surface, and the form that was removed.
    let none = info(&["--form", "poly2"]);
    for line in ["{ file = \"flank.sur\", rows = 3 }", "form = \"poly2\""] {
        assert!(none.out.contains(line), "{}", none.out);
    }
    none.surveyed(&[
        "flank.sur: the file holds 3 profiles",
        "--row",
        "set surface.pinion.rows 3",
    ]);
    assert!(
        none.out.contains("Sq ") && none.out.contains("lay of traces along the rows"),
        "{}",
        none.out
    );
    let json = info(&["--json"]).json();
    assert_eq!(json["rows"], 3);
    assert!(json["areal"]["sdr"].as_f64().unwrap() > 0.0, "{json:#}");
    assert_eq!(json["error"]["code"], "E119");
    // A trace without parameters is one document too.
    bench.write("short.csv", trace("x_um,z_um", 150));
    let short = bench.run(&["profile", "info", "short.csv", "--json"]);
    assert_eq!(short.json()["error"]["code"], "E120");
    assert!(short.err.starts_with("E120 "), "{}", short.err);
    let ra = |more: &[&str]| {
        let found = info(&[more, &["--json"]].concat()).well().json();
        (
            found["iso4287"]["ra_um"].as_f64().unwrap(),
            found["warnings"].to_string(),
        )
    };
    let (row, _) = ra(&["--row", "2"]);
    let (mean, notes) = ra(&["--line", "mean"]);
    assert!(mean < row && notes.contains("W320"), "{mean} {row} {notes}");
    let short = info(&["--line", "column", "--row", "1"]);
    short.refused(2, "E106", &["flank.sur: 3 points"]);
}

#[test]
fn a_scan_is_proposed_whole() {
    let bench = Bench::new();
    // Isotropic, crossed and ridged scans: the lay that the case measures decides what is done with the rows.
    for kept in [0.8, 0.3, 0.999] {
        bench.write("scan.sur", digital_surf(&changing(3000, 30, kept), 2.0));
        let said = bench.run(&["profile", "info", "scan.sur"]);
        let line = "pinion = { file = \"scan.sur\" }";
        assert!(said.out.contains(line), "{kept}: {}", said.out);
    }
}

#[test]
fn a_case_takes_lines_of_a_surface() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("flank.sur", sur(6000, 3, 2, 0));
    let run = |line: &str| {
        bench.write("case.toml", with_line("pinion", line));
        bench.run(&["run", "case.toml", "--no-output", "--no-band", "--json"])
    };
    let of = |line: &str| {
        run(line).well().json()["summary"]["loss_w"]
            .as_f64()
            .unwrap()
    };
    let row = of("pinion = { file = \"flank.sur\", row = 2 }");
    let mean = run("pinion = { file = \"flank.sur\", line = \"mean\" }");
    mean.refused_json("E141", "flank.sur: the mean of the surface has Rq ");
    // Rows 1 and 3 of three, each a tooth of its own.
    let rows = of("pinion = { file = \"flank.sur\", rows = 2 }");
    let warned = |line: &str| run(line).well().json()["warnings"].to_string();
    let said = warned("pinion = { file = \"flank.sur\", rows = 2 }");
    let says = "surface.pinion: 2 lines of flank.sur count as teeth of their own";
    assert!(said.contains("W447") && said.contains(says), "{said}");
    assert!(!warned("pinion = { file = \"flank.sur\", row = 2 }").contains("W447"));
    let listed = of(
        "pinion = { traces = [{ file = \"flank.sur\", row = 1 }, { file = \"flank.sur\", row = 3 }] }",
    );
    assert_eq!(rows, listed);
    assert_ne!(rows, row);
    let said = run("pinion = { file = \"flank.sur\", rows = 4 }");
    said.refused_json("E209", "surface.pinion.rows = 4");
    let said = run("pinion = { file = \"flank.sur\", rows = 2, row = 1 }");
    said.refused_json("E205", "leave row and line out");
    let said = run("pinion = { file = \"pinion.csv\", line = \"mean\" }");
    let says = "surface.pinion.file: this file holds a single profile; leave line out";
    assert!(said.err.contains(says), "{}", said.err);
    let said = bench.run(&["profile", "info", "pinion.csv", "--line", "mean"]);
    said.refused(2, "E119", &["pinion.csv: the file holds a single profile"]);
}

/// Rows that change into each other: each holds the share `kept` of the one before.
fn changing(points: usize, count: usize, kept: f64) -> Vec<Vec<f64>> {
    const SHIFTS: usize = 5000;
    let all = heights(points + SHIFTS);
    let mut rows = vec![all[..points].to_vec()];
    for k in 1..count {
        let shift = 97 * k * k % SHIFTS;
        let fresh = &all[shift..shift + points];
        let added = (1.0 - kept * kept).sqrt();
        let pairs = rows[k - 1].iter().zip(fresh);
        rows.push(pairs.map(|(z, new)| kept * z + added * new).collect());
    }
    rows
}

/// The lay of a case is that of the surface its traces come from, with its interval, unless the case states one.
#[test]
fn the_lay_of_a_surface_replaces_the_assumed_one() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("flank.sur", digital_surf(&changing(3000, 80, 0.9), 4.0));
    let case = with_line("pinion", "pinion = { file = \"flank.sur\", rows = 2 }");
    bench.write("case.toml", &case);
    let lay = |arguments: &[&str]| {
        let checked = bench.run(&[&["check", "case.toml", "--json"], arguments].concat());
        let checked = checked.well().json();
        let mut defaults = checked["defaults"].as_array().unwrap().iter();
        let lay = defaults.find(|default| default["key"] == "model.lay");
        lay.cloned()
    };
    let found = lay(&[]).unwrap();
    let source = found["source"].as_str().unwrap();
    assert!(
        source.starts_with("pinion 0.") && source.contains("measured on flank.sur"),
        "{source}"
    );
    assert!(source.ends_with("wheel assumed, 0 to 1/6"), "{source}");
    let gammas: Vec<f64> = serde_json::from_str(found["value"].as_str().unwrap()).unwrap();
    assert_eq!(gammas[1], 1.0 / 12.0);
    assert!(
        gammas[0] > 0.0 && gammas[0] < 1.0 && gammas[0] != gammas[1],
        "{gammas:?}"
    );
    assert_eq!(lay(&["--set", "model.lay=0.1"]), None);

    // The run at the medians is that of a case that states these medians, and only its interval differs.
    let run = |arguments: &[&str]| {
        let run = bench.run(&[&["run", "case.toml", "--no-output", "--json"], arguments].concat());
        run.well().json()
    };
    let (measured, stated) = (run(&[]), run(&["--set", &format!("model.lay={gammas:?}")]));
    let loss =
        |result: &serde_json::Value| result["summary"]["loss_at_medians_w"].as_f64().unwrap();
    assert_eq!(loss(&measured), loss(&stated));
    let drawn = |result: &serde_json::Value| {
        let constants = result["uncertainty"]["constants"]
            .as_array()
            .unwrap()
            .clone();
        constants
            .into_iter()
            .find(|constant| constant["name"] == "lay")
    };
    assert_eq!(drawn(&stated), None);
    let (drawn, mean) = (drawn(&measured).unwrap(), 0.5 * (gammas[0] + gammas[1]));
    assert_eq!(drawn["value"], mean);
    assert!(drawn["low"].as_f64().unwrap() < mean && mean < drawn["high"].as_f64().unwrap());
    let said = bench
        .run(&["run", "case.toml", "--no-output", "--no-band", "--notes"])
        .well();
    assert!(said.out.contains("lay  pinion 0."), "{}", said.out);
    assert!(!said.out.contains("W444"), "{}", said.out);
}

#[test]
fn rows_of_too_many_pairs_are_fewer_and_still_spread_evenly() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("flank.sur", digital_surf(&changing(3000, 40, 0.9), 4.0));
    let pinion = "pinion = { file = \"flank.sur\", rows = 20 }";
    bench.write("case.toml", with_line("pinion", pinion));
    let wheel = "surface.wheel={ file = \"flank.sur\", rows = 32 }";
    let formula = ["--set", "model.load_share=lambda-star"];
    let check = ["check", "case.toml", "--set", wheel, "--json"];
    let checked = bench.run(&[&check[..], &formula].concat());
    let checked = checked.well().json();
    assert_eq!(checked["traced"][0]["teeth"], serde_json::json!([8, 8]));
    let mut warnings = checked["warnings"].as_array().unwrap().iter();
    let left_out = warnings.find(|warning| warning["code"] == "W427").unwrap();
    let says = "8 rows spread evenly of the pinion and 8 rows spread evenly of the wheel";
    assert!(left_out["text"].to_string().contains(says), "{left_out}");
}

/// Another surface of the kind of a measured one has its roughness, and is read by a case.
#[test]
fn a_surface_is_generated_like_a_measured_one() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("flank.sur", digital_surf(&changing(3000, 30, 0.8), 2.0));
    let like = |seed: &str, output: &str| {
        let run = [
            "profile",
            "generate",
            "--like",
            "flank.sur",
            "--seed",
            seed,
            "-o",
            output,
            "--json",
        ];
        bench.run(&run).well().json()
    };
    let made = like("3", "three.x3p");
    // Pieces or spectrum as its rows are, or as asked.
    let spectrum = "profile generate --like flank.sur --method spectrum --json -o spectrum.x3p";
    let spectrum = bench.run(&spectrum.split(' ').collect::<Vec<_>>()).well();
    assert_eq!(spectrum.json()["pieces"], serde_json::json!([]));
    let pieces = "profile generate --like flank.sur --method pieces --json -o pieces.x3p";
    let pieces = bench
        .run(&pieces.split(' ').collect::<Vec<_>>())
        .well()
        .json();
    assert_eq!(pieces["pieces"][0]["file"], "flank.sur");
    assert_eq!(pieces["warnings"][0]["code"], "W461");
    assert_eq!(pieces["pieces"][0]["size_um"][1], 60.0, "{pieces}");
    like("4", "four.x3p");
    like("3", "again.x3p");
    let bytes = |name: &str| std::fs::read(bench.path(name)).unwrap();
    assert_eq!(bytes("three.x3p"), bytes("again.x3p"));
    assert_ne!(bytes("three.x3p"), bytes("four.x3p"));
    let shown = |name: &str| {
        let said = bench.run(&["profile", "info", name, "--json"]);
        serde_json::from_str::<serde_json::Value>(&said.out).unwrap()
    };
    let (measured, made_again) = (shown("flank.sur"), shown("three.x3p"));
    for key in ["columns", "rows", "dx_um", "dy_um"] {
        assert_eq!(measured[key], made_again[key], "{key}");
    }
    let sq = |value: &serde_json::Value| {
        let sq: Length = serde_json::from_value(value["areal"]["sq"].clone()).unwrap();
        sq.si()
    };
    assert!((sq(&made_again) / sq(&measured) - 1.0).abs() < 0.15);
    assert_eq!(made["achieved"]["sq"], made_again["areal"]["sq"]);
    let case = with_line("pinion", "pinion = { file = \"three.x3p\", rows = 2 }");
    bench.write("case.toml", case);
    bench.run(&["check", "case.toml"]).well();
    let said = bench.run(&[
        "profile",
        "generate",
        "--like",
        "flank.sur",
        "-o",
        "other.csv",
    ]);
    said.refused(2, "E401", &["name it .x3p"]);
    bench.write("short.sur", digital_surf(&changing(2000, 30, 0.8), 2.0));
    let both = [
        "profile",
        "generate",
        "--like",
        "flank.sur",
        "--like",
        "short.sur",
        "-o",
        "o.x3p",
    ];
    bench.run(&both).refused(
        2,
        "E120",
        &["short.sur: its rows, points or their distances differ"],
    );
}

#[test]
fn a_lay_that_a_surface_does_not_show_stays_assumed_and_is_named() {
    let bench = Bench::new();
    bench.write_flanks();
    for (count, dy, kept, says) in [
        (3, 0.5, 0.9, "3 rows with heights are too few"),
        (80, 40.0, 0.1, "the rows are 40 um apart"),
        (
            6,
            0.5,
            0.99,
            "the ridges are longer than half of the surface",
        ),
    ] {
        bench.write("flank.sur", digital_surf(&changing(3000, count, kept), dy));
        bench.write(
            "case.toml",
            with_line("pinion", "pinion = { file = \"flank.sur\", rows = 2 }"),
        );
        let said = bench
            .run(&["run", "case.toml", "--no-output", "--no-band", "--json"])
            .well()
            .json();
        let mut warnings = said["warnings"].as_array().unwrap().iter();
        let warning = warnings.find(|warning| warning["code"] == "W444");
        let text = warning.unwrap_or_else(|| panic!("{count} rows: no W444"))["text"].to_string();
        assert!(
            text.contains(says) && text.contains("assumed to be 0 to 1/6"),
            "{text}"
        );
        let mut defaults = said["defaults"].as_array().unwrap().iter();
        let lay = defaults
            .find(|default| default["key"] == "model.lay")
            .unwrap();
        let value: Vec<f64> = serde_json::from_str(lay["value"].as_str().unwrap()).unwrap();
        assert_eq!(value, [1.0 / 12.0; 2]);
    }
}

#[test]
fn files_without_heights_and_replicas_are_told() {
    let bench = Bench::new();
    bench.write("colours.sur", sur(200, 3, 12, 0));
    let said = bench.run(&["profile", "info", "colours.sur"]);
    said.refused(
        2,
        "E320",
        &["colours.sur: the file (Digital Surf (sur, pro)) holds a colour image"],
    );
    bench.write("two.mat", two_arrays());
    let said = bench.run(&["profile", "info", "two.mat"]);
    said.refused(
        2,
        "E321",
        &["two.mat: the file holds several arrays", "left, right"],
    );
    bench.write("cast.sur", sur(6000, 1, 2, 1));
    let said = bench.run(&[
        "profile",
        "info",
        "cast.sur",
        "--lambda-c",
        "0.25 mm",
        "--json",
    ]);
    assert!(said.well().json()["warnings"].to_string().contains("W321"));
}

#[test]
fn a_stated_unit_never_shrinks_a_surface_that_has_its_own() {
    let bench = Bench::new();
    bench.write("flank.sur", sur(6000, 1, 2, 0));
    bench.write_flanks();
    let ra = |file: &str, unit: &[&str]| {
        let info = ["profile", "info", file, "--lambda-c", "0.25 mm", "--json"];
        let found = bench.run(&[&info, unit].concat()).well().json();
        let ra = found["iso4287"]["ra_um"].as_f64().unwrap();
        (ra, found["warnings"].to_string())
    };
    let (plain, _) = ra("flank.sur", &[]);
    let (stated, notes) = ra("flank.sur", &["--z-unit", "um"]);
    assert!(
        stated == plain && notes.contains("W323"),
        "{stated} {notes}"
    );
    let (_, notes) = ra("pinion.csv", &["--z-unit", "nm"]);
    assert!(notes.contains("W322"), "{notes}");
}

#[test]
fn a_unit_that_is_stated_again_for_a_scan_as_text_changes_no_loss() {
    let bench = Bench::new();
    bench.write_flanks();
    let all = heights(7500);
    let row = |y: usize| {
        let point = move |(x, z): (usize, &f64)| {
            format!(
                "{:.4},{:.2},{:.9}\n",
                5e-4 * x as f64,
                0.5 * y as f64,
                1e-3 * z
            )
        };
        let heights = all[500 * y..500 * y + 6000].iter().enumerate();
        heights.map(point).collect::<String>()
    };
    let points: String = (0..3).map(row).collect();
    bench.write("points.csv", format!("x [mm],y [mm],z [mm]\n{points}"));
    let matrix = |y: usize| {
        let heights = all[500 * y..500 * y + 6000].iter();
        let heights: Vec<String> = heights.map(|z| format!("{:.9}", 1e-3 * z)).collect();
        heights.join("\t") + "\n"
    };
    let rows: String = (0..3).map(matrix).collect();
    let head = "# Width: 3 mm\n# Height: 1.5 mm\n# Value units: mm\n";
    bench.write("matrix.txt", format!("{head}{rows}"));
    let loss = |file: &str, units: &str| {
        let line = format!("pinion = {{ file = \"{file}\", rows = 2{units} }}");
        bench.write("case.toml", with_line("pinion", &line));
        let run = bench.run(&["run", "case.toml", "--no-output", "--no-band", "--json"]);
        run.well().json()["summary"]["loss_w"].as_f64().unwrap()
    };
    for file in ["points.csv", "matrix.txt"] {
        let plain = loss(file, "");
        assert_eq!(
            loss(file, ", x_unit = \"mm\", z_unit = \"mm\""),
            plain,
            "{file}"
        );
        let info = [
            "profile", "info", file, "--dx", "0.5um", "--dy", "500um", "--z-unit", "mm", "--json",
        ];
        let said = bench.run(&info).json();
        assert_eq!(
            (&said["dx_um"], &said["dy_um"]),
            (&0.5.into(), &500.0.into()),
            "{said}"
        );
    }
    let said = bench.run(&["profile", "info", "pinion.csv", "--dy", "2um"]);
    said.refused(
        2,
        "E119",
        &["pinion.csv: the file holds a single profile; --dy has no rows"],
    );
}

#[test]
fn heights_too_small_for_a_flank_are_refused_by_a_case() {
    let bench = Bench::new();
    bench.write_flanks();
    let small = rows(6000, |i, z| format!("{};{:.9}", 0.5 * i as f64, 1e-6 * z));
    bench.write("small.csv", format!("x [um];z [um]\n{small}"));
    bench.write(
        "case.toml",
        with_line("pinion", "pinion = { file = \"small.csv\" }"),
    );
    let said = bench.run(&["run", "case.toml", "--no-output"]);
    said.refused(2, "E131", &["small.csv", "no flank is as smooth as"]);
}

#[test]
fn material_ratios_and_heights_are_told_where_asked_for() {
    let bench = Bench::new();
    // Straight flanks from -1 um to 1 um: the material ratio falls evenly.
    let zigzag = |i: usize| 2.0 * ((i % 200) as f64 / 100.0 - 1.0).abs() - 1.0;
    let rows: String = (0..4000)
        .map(|i| format!("{:.1};{:.4}\n", 0.5 * i as f64, zigzag(i)))
        .collect();
    bench.write("zigzag.csv", format!("x [um];z [um]\n{rows}"));
    let asked = [
        "profile",
        "info",
        "zigzag.csv",
        "--as-is",
        "--rmr",
        "0.5um",
        "--rdc",
        "5:75",
    ];
    let said = bench.run(&asked).well();
    assert!(
        said.out.contains("Rmr(0.5 um) 25.") && said.out.contains("Rdc(5 %, 75 %) 1.4"),
        "{}",
        said.out
    );
    let found = bench.run(&[&asked[..], &["--json"]].concat()).well().json();
    let levels = &found["material_levels"];
    let percent = levels["rmr"][0]["percent"].as_f64().unwrap();
    let height = levels["rdc"][0]["um"].as_f64().unwrap();
    assert!(
        (percent - 25.0).abs() < 0.5 && (height - 1.4).abs() < 0.01,
        "{levels}"
    );
    let wrong = bench.run(&["profile", "info", "zigzag.csv", "--rdc", "75:5"]);
    assert!(
        wrong.status != 0 && wrong.err.contains("the smaller first"),
        "{}",
        wrong.err
    );
}
