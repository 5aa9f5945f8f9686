//! One file of each kind that a review of the readers found refused or misread, made here, with the value known by
//! construction. The kinds that are tested elsewhere:
//!
//! | case | test |
//! |---|---|
//! | c13, tips of shifted pairs | `gear::tips_of_the_addendum_alone_are_noted_with_what_their_alteration_is_worth` |
//! | c20, direction of grooves | `the_direction_of_a_wave_is_exact_at_any_angle_spacing_and_length` of `asperity-roughness` |
//! | four planets of 102 teeth | `ranges::planets_that_cannot_be_assembled_are_named_by_check_and_by_a_run` |
//! | names that are formulas | `storage::no_name_of_a_train_or_a_sweep_is_a_formula_in_a_table` |
//! | thousands of unknown keys | `case_commands::check_of_thousands_of_wrong_keys_needs_little_memory` |
//! | absurd numbers | `ranges::a_mistaken_number_is_named_by_its_key_on_the_first_screen` |

use std::fs;

use crate::bench::{Bench, heights, root, rows};
use crate::other_programs::{VEHICLE, with_map};

/// The parameters of a profile by `profile info`, from `file` with `options`.
fn info(bench: &Bench, file: &str, options: &[&str]) -> serde_json::Value {
    let all = [&["profile", "info", file, "--json"], options].concat();
    bench.run(&all).well().json()
}

/// Heights \[um\] as a column, for comparison with a row of a surface.
fn column(bench: &Bench, name: &str, heights: &[f64]) {
    let lines: Vec<String> = heights.iter().map(|z| format!("{z:.6}")).collect();
    bench.write(name, lines.join("\n") + "\n");
}

/// Checks that two profiles have the same parameters, up to the rounding of their units.
fn same(one: &serde_json::Value, other: &serde_json::Value) {
    assert_eq!(one["n"], other["n"]);
    for pointer in ["/dx_um", "/iso4287/ra_um", "/iso4287/rq_um", "/iso4287/rsk"] {
        let number = |info: &serde_json::Value| info.pointer(pointer).unwrap().as_f64().unwrap();
        let (one, other) = (number(one), number(other));
        assert!(
            (one - other).abs() < 1e-9 * other.abs(),
            "{pointer}: {one} {other}"
        );
    }
}

/// A surface of rows that are moved against each other; its heights are those of [`heights`] with six decimals.
fn surface(points: usize, row: usize) -> Vec<f64> {
    let moved = heights(points + 210);
    moved[7 * row..]
        .iter()
        .take(points)
        .map(|z| (z * 1e6).round() / 1e6)
        .collect()
}

#[test]
fn c01_a_column_of_depths_has_the_parameters_of_its_heights() {
    let bench = Bench::new();
    let file = |name: &str, sign: f64| {
        let groove = |i: usize| if i % 400 < 12 { -2.0 } else { 0.0 };
        let row =
            |i: usize, z: f64| format!("{:.1},{:.5}", 0.5 * i as f64, sign * (0.1 * z + groove(i)));
        format!("Position (um),{name} (um)\n{}", rows(8000, row))
    };
    bench.write("height.csv", file("Height", 1.0));
    bench.write("depth.csv", file("Depth", -1.0));
    let [height, depth] = ["height.csv", "depth.csv"].map(|name| info(&bench, name, &[]));
    same(&height, &depth);
    // Grooves in a flat flank.
    assert!(depth["iso4287"]["rsk"].as_f64().unwrap() < -3.0);
}

#[test]
fn c02_and_c12_cycles_backwards_in_metres_a_second_and_of_vecto_have_the_energy_of_one() {
    let bench = with_map();
    let energy = |name: &str, text: &str| {
        bench.write(name, text);
        let all = [
            "cycle",
            "m",
            name,
            "--no-output",
            "--set",
            VEHICLE,
            "--json",
        ];
        let json = bench.run(&all).well().json();
        let number = |value: &serde_json::Value| value.as_f64().unwrap();
        let finish = &json["finishes"][0];
        [&json["drive_wh"], &json["coast_wh"], &finish["lost_wh"]].map(number)
    };
    let flat = |speed: f64| format!("time_s,speed_km_h\n0,0\n10,{speed}\n20,{speed}\n30,0\n");
    let forwards = energy("c02_forward.csv", &flat(10.8));
    assert!(forwards.iter().all(|energy| *energy > 0.0), "{forwards:?}");
    assert_eq!(energy("c02_reverse.csv", &flat(-10.8)), forwards);
    let hill = "time_s,speed_km_h,grade_percent\n0,0,0\n10,10.8,1\n20,10.8,1\n30,0,0\n";
    let hill = energy("hill.csv", hill);
    let mps = "time_seconds,speed_meters_per_second,grade,road_type\n0,0,0,0\n10,3,0.01,0\n20,3,0.01,0\n30,0,0,0\n";
    let vecto = "<t>,<v>,<grad>\n0,0,0\n10,10.8,1\n20,10.8,1\n30,0,0\n";
    for (name, text) in [("c12_mps.csv", mps), ("c12_vdri.vdri", vecto)] {
        for (found, expected) in energy(name, text).iter().zip(hill) {
            assert!(
                (found - expected).abs() < 1e-9 * expected.max(1.0),
                "{name}: {found} {expected}"
            );
        }
    }
}

#[test]
fn c04_a_phase_map_of_zygo_has_its_spacing_units_and_missing_points() {
    let bench = Bench::new();
    let file = |hole: &dyn Fn(usize, usize) -> bool| {
        let head = "Zygo XYZ Data File - Format 1\n0 0 0 0 \"Mon Nov 02 10:00:00 2026\"\n0 0 300 20 1 255\n12 8 300 20\n\"\"\n\"\"\n\"\"\n\
            0 0.5 6.328e-07 0 1 0 2.5e-06 1793000000\n1 0 0 0 0 0 \"\"\n#\n";
        let points = (0..20).flat_map(|y| {
            let row = surface(300, y).into_iter().enumerate();
            row.map(move |(x, z)| (x, y, z))
        });
        let point = |(x, y, z): (usize, usize, f64)| {
            if hole(x, y) {
                format!("{} {} No Data\n", x + 12, y + 8)
            } else {
                format!("{} {} {z:.6}\n", x + 12, y + 8)
            }
        };
        head.to_owned() + &points.map(point).collect::<String>() + "#\n"
    };
    bench.write("full.xyz", file(&|_, _| false));
    bench.write("nodata.xyz", file(&|x, y| y == 2 && (40..43).contains(&x)));
    column(&bench, "row3.txt", &surface(300, 2));
    let row3 = info(&bench, "row3.txt", &["--dx", "2.5um", "--z-unit", "um"]);
    let full = info(&bench, "full.xyz", &["--row", "3"]);
    same(&full, &row3);
    assert_eq!(
        (full["n"].as_u64(), full["dx_um"].as_f64()),
        (Some(300), Some(2.5))
    );
    let refused = bench.run(&["profile", "info", "nodata.xyz", "--row", "3"]);
    refused.refused(
        2,
        "E107",
        &["nodata.xyz: 3 of 300 points have no height, the first is column 41 of row 3"],
    );
    let filled = info(
        &bench,
        "nodata.xyz",
        &["--row", "3", "--gaps", "interpolate"],
    );
    assert_eq!(filled["n"], full["n"]);
}

#[test]
fn c05_points_that_are_left_out_are_missing_on_their_grid() {
    let bench = Bench::new();
    let mut text = "x (um)\ty (um)\tz (um)\n".to_owned();
    for y in 0..30 {
        for (x, z) in surface(420, y).iter().enumerate() {
            // 125 points, five of them in row 7.
            let is_out = match y {
                6 => (10..15).contains(&x),
                0..6 => x % 20 == 7 && y % 2 == 0,
                _ => (y, x % 140) == (9, 3) || y == 20 && x < 54,
            };
            if !is_out {
                text += &format!(
                    "{:.3}\t{:.3}\t{z:.6}\n",
                    1.5 * x as f64,
                    3.0 * f64::from(y as u32)
                );
            }
        }
    }
    assert_eq!(text.lines().count(), 1 + 30 * 420 - 125);
    bench.write("holes.xyz", text);
    let refused = bench.run(&["profile", "info", "holes.xyz", "--row", "7"]);
    refused.refused(
        2,
        "E107",
        &["holes.xyz: 5 of 420 points have no height, the first is column 11 of row 7"],
    );
    column(&bench, "row10.txt", &surface(420, 10));
    let alone = info(&bench, "row10.txt", &["--dx", "1.5um", "--z-unit", "um"]);
    same(&info(&bench, "holes.xyz", &["--row", "11"]), &alone);
    let filled = info(
        &bench,
        "holes.xyz",
        &["--row", "7", "--gaps", "interpolate"],
    );
    assert_eq!(filled["n"], 420);
}

#[test]
fn c06_the_sums_over_a_load_spectrum_are_no_components() {
    let bench = Bench::new();
    let plain = fs::read_to_string(root().join("crates/rexs/tests/gearboxes/chain.rexs")).unwrap();
    let sums = r#"<accumulation><component id="1" type="gear_unit"><attribute id="operating_time" unit="h">5000</attribute></component></accumulation>"#;
    bench.write("plain.rexs", &plain);
    bench.write(
        "accumulation.rexs",
        plain.replace("</load_spectrum>", &format!("{sums}</load_spectrum>")),
    );
    let stages = |name: &str| {
        let json = bench
            .run(&["case", "from-rexs", name, "--json"])
            .well()
            .json();
        json["stages"].clone()
    };
    assert_eq!(stages("accumulation.rexs"), stages("plain.rexs"));
    assert_eq!(
        stages("plain.rexs")[0]["teeth"],
        serde_json::json!([20, 41])
    );
}

#[test]
fn c08_a_first_number_that_counts_the_heights_is_none_of_them() {
    let bench = Bench::new();
    let two = |z: f64| format!("{z:.2}\n");
    let heights: String = heights(2000).into_iter().map(|z| two(3.0 * z)).collect();
    let conditions = "\" TEST \"\nDATE2026/11/02,TIME 10:12:00\nJIS1994\nprofile=R\nRa 0.32 um\n";
    bench.write("alone.csv", &heights);
    bench.write("count.csv", format!("2000\n{heights}"));
    bench.write("conditions.csv", format!("{conditions}2000\n{heights}"));
    let stated = ["--dx", "0.5um", "--z-unit", "um"];
    let alone = info(&bench, "alone.csv", &stated);
    assert_eq!(alone["n"], 2000);
    for name in ["count.csv", "conditions.csv"] {
        same(&info(&bench, name, &stated), &alone);
        // What is asked for is what was lacking.
        let asked = bench.run(&["profile", "info", name, "--z-unit", "um"]);
        asked.refused(2, "E110", &["--dx"]);
    }
}

#[test]
fn c10_a_matrix_has_the_unit_and_the_spacing_of_its_head() {
    let bench = Bench::new();
    for (unit, factor) in [("um", 1.0), ("nm", 1e3)] {
        let head = format!(
            "\"Measured date\",\"2026/11/02 10:00:00\"\n\"Model\",\"laser microscope\"\n\"XY Calibration\",\"1.25\",\"um\"\n\
             \"Output image data\",\"Height\"\n\"Horizontal\",\"500\"\n\"Vertical\",\"12\"\n\"Unit\",\"{unit}\"\n\n\"Height\"\n"
        );
        let row = |row: usize| {
            let cells = surface(500, row)
                .into_iter()
                .map(|z| format!("\"{:.3}\"", factor * (100.0 + z)));
            cells.collect::<Vec<_>>().join(",") + "\n"
        };
        let rows: String = (0..12).map(row).collect();
        bench.write(&format!("{unit}.csv"), head + &rows);
    }
    column(&bench, "row1.txt", &surface(500, 0));
    let alone = info(&bench, "row1.txt", &["--dx", "1.25um", "--z-unit", "um"]);
    for name in ["um.csv", "nm.csv"] {
        let found = info(&bench, name, &["--row", "1"]);
        assert_eq!(
            (&found["n"], &found["dx_um"]),
            (&alone["n"], &alone["dx_um"])
        );
        let [found, expected] = [&found, &alone].map(|info| info["iso4287"]["rq_um"].as_f64());
        let [found, expected] =
            [found, expected].map(|rq| rq.unwrap_or_else(|| panic!("{alone:#}")));
        assert!(
            (found / expected - 1.0).abs() < 1e-3,
            "{name}: {found} {expected}"
        );
    }
}

#[test]
fn c15_no_data_is_a_missing_point_like_its_other_names() {
    let bench = Bench::new();
    let file = |mark: &str| {
        let row = |i: usize, z: f64| match i {
            250..258 => format!("{i}.0,{mark}"),
            _ => format!("{i}.0,{z:.4}"),
        };
        format!("x (um),z (um)\n{}", rows(4000, row))
    };
    bench.write("nodata.csv", file("No Data"));
    let refused = bench.run(&["profile", "info", "nodata.csv"]);
    refused.refused(2, "E107", &["8 of 4000 points have no height"]);
    let filled = |name: &str| info(&bench, name, &["--gaps", "interpolate"]);
    let expected = filled("nodata.csv");
    for mark in ["Bad", "---", "null"] {
        bench.write("other.csv", file(mark));
        same(&filled("other.csv"), &expected);
    }
}

#[test]
fn c17_and_c18_exports_without_title_and_of_slow_steps_are_read() {
    let bench = Bench::new();
    let head = "Step type\tTRACTION\tStep description\tcurve\n\
        SRR (%)\tTraction Coeff (-)\t\tPot RTD Temp (degC)\tLube RTD Temp (degC)\tBall Load (N)\tRolling Speed (mm/s)\tSliding Speed (mm/s)\tSRR (%)\tTraction Force (N)\tTraction Coeff (-)\n";
    // Readings of an oil that this program describes, printed as the machine prints them.
    bench
        .run(&["oil", "traction", "m100", "-o", "curves"])
        .well();
    let table = fs::read_to_string(bench.path("curves/traction_over_slide_to_roll.csv")).unwrap();
    let mut text = String::new();
    let mut last = String::new();
    let mut count = 0;
    for line in table.lines().skip(1).step_by(3) {
        let cells: Vec<f64> = line
            .split(',')
            .take(5)
            .map(|cell| cell.parse().unwrap())
            .collect();
        let [load, speed, slide, celsius, traction] = cells[..] else {
            panic!("{line}")
        };
        let step = format!("{load} {speed} {celsius}");
        if step != last {
            text += &format!("\nStep 1 started at 02/11/2026 10:01\n{head}");
            last = step;
        }
        count += 1;
        let traction = format!("{traction:.6}");
        let force = traction.parse::<f64>().unwrap() * load;
        text += &format!(
            "{slide:.3}\t{traction}\t\t{celsius:.1}\t{celsius:.1}\t{load:.3}\t{:.2}\t{:.2}\t{slide:.3}\t{force:.6}\t{traction}\n",
            1e3 * speed,
            10.0 * speed * slide
        );
    }
    let title = "MTM311 Test Data File\nLubricant name:\n";
    // A sliding speed of -.005 mm/s prints as -.01 or .00.
    let slow = |printed: &str| {
        let row = format!(
            "-0.020\t-0.000200\t\t40.0\t40.0\t30.000\t25.00\t{printed}\t-0.020\t-0.006000\t-0.000200\n"
        );
        format!("{title}{text}\nStep 9 started at 02/11/2026 10:01\n{head}{row}")
    };
    let fit = |name: &str, text: &str| {
        bench.write(name, text);
        let all = [
            "oil", "fit", name, "--oil", "m100", "-o", "fitted", "--json",
        ];
        let json = bench.run(&all).well().json();
        json["points"]
            .as_array()
            .map_or_else(|| panic!("{json:#}"), Vec::len)
    };
    let with_title = fit("with_title.txt", &format!("{title}{text}"));
    assert!(
        with_title > 20 && with_title <= count,
        "{with_title} of {count}"
    );
    assert_eq!(fit("without_title.txt", text.trim_start()), with_title);
    for printed in ["-0.01", "0.00"] {
        // The slow reading has no film to fit; it contradicts nothing.
        assert!(fit("slow.txt", &slow(printed)) >= with_title);
    }
}
