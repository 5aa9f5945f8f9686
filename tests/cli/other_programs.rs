//! Files and tables of other programs: read, or refused with what then works, which is tried here.

use crate::bench::{Bench, E_DRIVE, trace, with_line};

pub(crate) const VEHICLE: &str = "vehicle={ mass = \"1500 kg\", wheel_radius = \"300 mm\", ratio = 10.0, drag_area = \"0.6 m2\", rolling_resistance = 0.01 }";

/// A bench with a small map of the drive.
pub(crate) fn with_map() -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    let case = with_line("positions", "positions = 4\nload_share = \"lambda-star\"");
    bench.write("case.toml", case);
    let axes = [
        "--torque=-200,-20,20,200",
        "--speed=500,12000",
        "--band",
        "none",
    ];
    bench
        .run(
            &[
                &["map", "case.toml", "-o", "m", "-q", "--export", "vecto"][..],
                &axes,
            ]
            .concat(),
        )
        .well();
    bench
}

#[test]
fn a_file_that_is_no_table_says_how_to_export_one() {
    let bench = with_map();
    bench.write("sheet.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1".as_slice());
    bench.write("data.h5", b"\x89HDF\r\n\x1a\n\0\0".as_slice());
    let said = bench.run(&["cycle", "m", "sheet.xls", "--no-output"]);
    said.refused(2, "E117", &["sheet.xls: not a valid Excel workbook"]);
    bench.write("data.mat", b"MATLAB 5.0 MAT-file\0\0\0\x01IM".as_slice());
    for (file, advice) in [
        ("data.h5", "Export the table as CSV, or as text with tabs."),
        (
            "data.mat",
            "write the columns with their names as CSV, in MATLAB with writetable",
        ),
    ] {
        let said = bench.run(&["cycle", "m", file, "--no-output"]);
        said.refused(2, "E108", &[file, "is not a table as text"]);
        assert!(
            said.err.to_lowercase().contains(&advice.to_lowercase()),
            "{}",
            said.err
        );
        bench
            .run(&["calibrate", file, "case.toml"])
            .refused(2, "E108", &[file]);
        bench
            .run(&["oil", "fit", "--oil", "m100", file])
            .refused(2, "E108", &[file]);
        let added = [
            "map",
            "case.toml",
            "-o",
            "n",
            "--export",
            "csv",
            "--add-loss",
            file,
        ];
        bench.run(&added).refused(2, "E108", &[file]);
    }
}

#[test]
fn a_cycle_without_names_takes_those_of_the_command_line() {
    let bench = with_map();
    let cycle = |file: &str, more: &[&str]| {
        let all = [
            "cycle",
            "m",
            file,
            "--no-output",
            "--set",
            VEHICLE,
            "--json",
        ];
        bench.run(&[&all[..], more].concat())
    };
    bench.write("own.csv", "time_s,speed_km_h\n0,0\n1,3.6\n2,7.2\n3,3.6\n");
    let lost = |said: crate::bench::Said| {
        said.well().json()["finishes"][0]["lost_wh"]
            .as_f64()
            .unwrap()
    };
    let own = lost(cycle("own.csv", &[]));
    bench.write("bare.txt", "0 7 0\n1 7 1\n2 7 2\n3 7 1\n");
    let said = bench.run(&["cycle", "m", "bare.txt", "--no-output"]);
    said.refused(2, "E101", &["no line of names above the first row 0, 7, 0"]);
    assert!(
        said.err.contains("--columns time_s,-,speed_km_h"),
        "{}",
        said.err
    );
    let named = lost(cycle("bare.txt", &["--columns", "time_s,-,speed_m_s"]));
    assert!((named - own).abs() < 1e-12);
    // UTF-16 with tabs and decimal commas, as spreadsheets save it; a column that is not read.
    let text = "Zeit [s]\tGeschwindigkeit [km/h]\tBemerkung\r\n0\t0\tlos\r\n1\t3,6\t\r\n2\t7,2\t\r\n3\t3,6\t\r\n";
    let mut bytes = vec![0xff, 0xfe];
    bytes.extend(text.encode_utf16().flat_map(u16::to_le_bytes));
    bench.write("wide.txt", bytes);
    let said = cycle("wide.txt", &[]).well();
    let text = said.json()["warnings"].to_string();
    assert!(
        text.contains("W454") && text.contains("Bemerkung"),
        "{text}"
    );
    let said = bench
        .run(&["cycle", "m", "wide.txt", "--no-output", "--set", VEHICLE])
        .well();
    let named = "W454 columns of the cycle that are not read: Bemerkung";
    assert!(
        (said.out.clone() + &said.err).contains(named),
        "{}",
        said.out
    );
    assert!((lost(cycle("wide.txt", &[])) - own).abs() < 1e-12);
    // A fault of all rows.
    let rows: String = (0..12).map(|k| format!("{k},1 km/h\n")).collect();
    bench.write("units.csv", format!("time_s,speed_km_h\n{rows}"));
    cycle("units.csv", &[]).refused_json(
        "E101",
        "12 lines look like this: line 2 \"0 1 km/h\", line 3 \"1 1 km/h\"",
    );
}

#[test]
fn a_loss_map_of_vecto_is_an_added_loss() {
    let bench = with_map();
    let maps = std::fs::read_dir(bench.path("m/export")).unwrap();
    let vtlm = maps
        .map(|file| file.unwrap().path())
        .find(|file| {
            file.extension()
                .is_some_and(|extension| extension == "vtlm")
        })
        .unwrap();
    let vtlm = vtlm.display().to_string();
    let axes = [
        "--torque=20,200",
        "--speed=500,12000",
        "--band",
        "none",
        "--export",
        "csv",
    ];
    let map = |folder: &str, file: &str| {
        let all = ["map", "case.toml", "-o", folder, "-q", "--add-loss", file];
        bench.run(&[&all[..], &axes].concat())
    };
    map("n", &vtlm).well();
    // The rows of a speed have torques of their own; the last column is empty.
    bench.write(
        "axle.vtlm",
        "Input Speed [rpm],Input Torque [Nm],Torque Loss [Nm],Eff [-]\n0,-50000,1500\n0,-200,6\n0,50000,1500\n\
         12000,-50000,1500\n12000,-1253,37.5\n12000,0,37.5\n12000,50000,1500\n",
    );
    map("o", "axle.vtlm").well();
    bench.write(
        "hole.vtlm",
        "Input Speed [rpm],Input Torque [Nm],Torque Loss [Nm]\n0,0,1\n0,100,2\n12000,-100,2\n12000,0,1\n12000,100,2\n",
    );
    map("p", "hole.vtlm").refused(
        2,
        "E101",
        &["hole.vtlm: no row at -100 N m, 0 1/min", "add it"],
    );
}

#[test]
fn columns_of_losses_and_cycles_that_are_not_read_are_named_where_they_are_used() {
    let bench = with_map();
    let losses = "speed_rpm,loss_torque_nm,Remark\n0,0.1,a\n12000,0.3,b\n";
    bench.write("losses.csv", losses);
    bench.write(
        "trip.csv",
        "time_s,torque_nm,speed_rpm,gear\n0,50,1000,1\n1,60,2000,2\n",
    );
    let unread = [
        "W454 columns of losses.csv that are not read: Remark",
        "W454 columns of the cycle that are not read: gear",
    ];
    // A pair of gears and a train with a table of losses: check and run, each once.
    bench.run(&["demo", "--gears", "vw-id3"]).well();
    bench.write("vw-id3/losses.csv", losses);
    for (case, stated) in [
        ("case.toml", "gearbox.loss_table=losses.csv"),
        (
            "vw-id3/case.toml",
            "gearbox.tables=[{ file = \"losses.csv\", shaft = \"input\" }]",
        ),
    ] {
        let set = [
            "--set",
            stated,
            "--set",
            "model.positions=4",
            "--set",
            "model.offsets=2",
        ];
        let check = bench.run(&[&["check", case][..], &set].concat()).well();
        let named = check.unwrapped().matches(unread[0]).count();
        assert_eq!(named, 1, "{}", check.out);
        let run = ["run", case, "--no-output", "--no-band", "--json"];
        let run = bench.run(&[&run[..], &set].concat()).well().json();
        assert_eq!(
            run["warnings"].to_string().matches("W454").count(),
            1,
            "{run:#}"
        );
    }
    // Tables beside a map.
    let map = [
        "map",
        "case.toml",
        "-o",
        "n",
        "--torque=20,200",
        "--speed=500,12000",
        "--band",
        "none",
        "--export",
        "csv",
        "--add-loss",
        "losses.csv",
        "--cycle",
        "trip.csv",
    ];
    let out = bench.run(&map).well().unwrapped();
    let page = std::fs::read_to_string(bench.path("n/map.html")).unwrap();
    let json = std::fs::read_to_string(bench.path("n/map.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(
        json["table_warnings"].as_array().unwrap().len(),
        2,
        "{json:#}"
    );
    for text in unread {
        assert!(out.contains(text) && page.contains(text), "{text}: {out}");
    }
    // A column of a list of cases is a key.
    bench.write("list.csv", "operation.torque [N m],Remark\n100,1\n");
    bench.write(
        "study.toml",
        "case = \"case.toml\"\n[sample]\nmethod = \"list\"\nfile = \"list.csv\"\n",
    );
    let sweep = bench.run(&["sweep", "run", "study.toml"]);
    sweep.refused(2, "E203", &["Remark"]);
}

#[test]
fn the_mean_of_an_isotropic_surface_is_refused_for_its_rows() {
    let bench = Bench::new();
    bench.write_flanks();
    // Points x, y, z: ridges across all rows, or rows that are moved against each other.
    let surface = |moved: usize| {
        let z = |i: usize| 0.4 * (0.05 * i as f64).sin() + 0.2 * (0.31 * i as f64).cos();
        let point = |k: usize| {
            let (i, row) = (k % 6000, k / 6000);
            format!("{};{};{:.5}\n", 0.5 * i as f64, 2 * row, z(i + moved * row))
        };
        "x [um];y [um];z [um]\n".to_owned() + &(0..8 * 6000).map(point).collect::<String>()
    };
    bench.write("ridges.csv", surface(0));
    bench.write("isotropic.csv", surface(37));
    let check = |line: &str| {
        bench.write(
            "case.toml",
            with_line("pinion =", &format!("pinion = {{ {line} }}")),
        );
        bench.run(&["check", "case.toml"])
    };
    check("file = \"ridges.csv\", line = \"mean\"").well();
    let said = check("file = \"isotropic.csv\", line = \"mean\"");
    said.refused(
        2,
        "E141",
        &[
            "isotropic.csv: the mean of the surface has Rq ",
            "Write rows = 8 in surface.pinion instead of line",
        ],
    );
    check("file = \"isotropic.csv\", rows = 8").well();
}

#[test]
fn a_trace_over_the_edge_of_the_flank_names_the_range_before_it() {
    let bench = Bench::new();
    let z = |i: usize| {
        let rough = 0.3 * (0.05 * i as f64).sin();
        match i {
            0..7000 => rough,
            7000..7020 => rough - 3.0 * (i - 6999) as f64,
            _ => -60.0,
        }
    };
    let rows: String = (0..8000)
        .map(|i| format!("{};{:.5}\n", 0.5 * i as f64, z(i)))
        .collect();
    bench.write("edge.csv", format!("x [um];z [um]\n{rows}"));
    bench.write_flanks();
    bench.write(
        "case.toml",
        with_line("pinion =", "pinion = { file = \"edge.csv\" }"),
    );
    let said = bench.run(&["check", "case.toml"]);
    said.refused(
        2,
        "E131",
        &["edge.csv", "all steep steps are at the end of the trace"],
    );
    let words = &said.err;
    let range = words
        .split("range = \"")
        .nth(1)
        .and_then(|rest| rest.split('"').next());
    let range = range.unwrap_or_else(|| panic!("{words}"));
    assert_eq!(range, "0.00 mm .. 3.45 mm");
    let line = format!("pinion = {{ file = \"edge.csv\", range = \"{range}\" }}");
    bench.write("case.toml", with_line("pinion =", &line));
    bench.run(&["check", "case.toml"]).well();
}

#[test]
fn the_warning_of_the_first_screen_has_two_lines_and_its_explanation_the_rest() {
    let bench = Bench::new();
    bench.write_flanks();
    let long = trace("x_um,z_um", 16_000);
    bench.write("long.csv", long);
    let case = with_line(
        "wheel =",
        "wheel = { file = \"long.csv\", mirrored = true }",
    );
    bench.write("case.toml", case);
    let few = [
        "--set",
        "model.positions=4",
        "--set",
        "model.offsets=2",
        "--no-output",
    ];
    let screen = |more: &[&str]| {
        let all = [&["run", "case.toml"][..], &few, more].concat();
        let said = bench.run(&all).well();
        said.out + &said.err
    };
    let first = screen(&[]);
    let begin = first.find("W448").unwrap_or_else(|| panic!("{first}"));
    let text = first[begin..].split(" notes: --notes").next().unwrap();
    // The last line counts the notes.
    assert!(text.lines().count() <= 3, "{text}");
    assert!(!text.contains("windows are taken from it"), "{text}");
    assert!(
        screen(&["--notes"]).contains("keep the trace if it was"),
        "the notes have it all"
    );
    assert!(
        bench
            .run(&["explain", "W448"])
            .well()
            .out
            .contains("measured along the tooth")
    );
}

#[test]
fn an_oil_temperature_without_a_law_shows_the_line_that_is_missing() {
    let bench = Bench::new();
    bench.write_flanks();
    let case = E_DRIVE.replace("bulk_temperature", "oil_temperature");
    bench.write("case.toml", case.as_str());
    let said = bench.run(&["check", "case.toml"]);
    said.refused(2, "E205", &["operation.oil_temperature"]);
    let words = &said.err;
    let line = words
        .split("the line ")
        .nth(1)
        .and_then(|rest| rest.split(" under").next());
    let line = line.unwrap_or_else(|| panic!("{words}"));
    bench.write(
        "case.toml",
        case.replace("[operation]\n", &format!("[operation]\n{line}\n")),
    );
    bench.run(&["check", "case.toml"]).well();
}

#[test]
fn trains_and_a_planetary_set_of_the_library_are_worked() {
    let bench = Bench::new();
    for (name, shafts, meshes) in [
        ("vw-id3", 3, ["stage1", "stage2"]),
        ("FVA-industrial", 3, ["stage1", "stage2"]),
        ("fva-planetary", 3, ["sun and planet", "planet and ring"]),
    ] {
        bench.run(&["demo", "--gears", name]).well();
        let case = format!("{name}/case.toml");
        let few = ["--set", "model.positions=4", "--set", "model.offsets=2"];
        let run = ["run", &case, "--no-output", "--no-band", "--json"];
        let json = bench.run(&[&run[..], &few].concat()).well().json();
        let names: Vec<&str> = json["meshes"]
            .as_array()
            .unwrap_or_else(|| panic!("{json:#}"))
            .iter()
            .map(|mesh| mesh["mesh"].as_str().unwrap())
            .collect();
        assert_eq!(names, meshes, "{name}");
        assert_eq!(json["shafts"].as_array().unwrap().len(), shafts, "{name}");
        let text = std::fs::read_to_string(bench.path(&case)).unwrap();
        assert!(
            text.contains("SYNTHETIC") && text.contains("ASSUMED"),
            "{text}"
        );
        // Each number of the gears has its certainty and source.
        for line in text
            .lines()
            .filter(|line| line.starts_with("teeth") || line.starts_with("module"))
        {
            assert!(line.contains("  # "), "{line}");
        }
    }
    bench.run(&["demo", "--gears", "vw-id4"]).refused(
        2,
        "E220",
        &["vw-id4", "Did you mean \"vw-id3\"?", "fva-planetary"],
    );
    let listed = bench.run(&["list", "gears"]).well().unwrapped();
    assert!(
        listed.contains("vw-id3, tesla-model3, sew, fva-industrial"),
        "{listed}"
    );
}
