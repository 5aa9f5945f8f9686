//! Messages about solutions and results: errors that end a run, warnings that go with a result.

use crate::bench::{Bench, E_DRIVE, NO_RELIEF, root, rows, with_line};

/// A bench with the small case, its flanks, and a change to one line.
fn bench_with(key: &str, line: &str) -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", with_line(key, line));
    bench
}

#[track_caller]
fn run_is_refused(bench: &Bench, options: &[&str], status: i32, code: &str, says: &[&str]) {
    let before = bench.listing();
    let mut arguments = vec!["run", "case.toml", "-o", "out"];
    arguments.extend(options);
    bench.run(&arguments).refused(status, code, says);
    assert_eq!(bench.listing(), before, "nothing is left behind");
}

#[test]
fn points_too_far_apart_for_the_contact_are_refused() {
    let bench = bench_with("cutoff", "cutoff = \"0 mm\"\nnoise_cutoff = \"0 um\"");
    for name in ["pinion.csv", "wheel.csv"] {
        bench.write(
            name,
            format!(
                "x_um,z_um\n{}",
                rows(500, |i, z| format!("{},{z:.4}", 20 * i))
            ),
        );
    }
    let says = [
        "position 1 of 2",
        "dx 20.000 um gives ",
        "points per Hertz half-width (at least 20 needed)",
    ];
    run_is_refused(&bench, &[], 2, "E121", &says);
}

#[test]
fn a_trace_shorter_than_the_contact_is_refused() {
    let bench = bench_with("offsets", "window = 99");
    let says = [
        "position ",
        "2750 um is shorter than the",
        "set model.window = 11.06 half-widths",
    ];
    run_is_refused(&bench, &[], 2, "E122", &says);
}

#[test]
fn traces_whose_windows_cannot_differ_are_refused() {
    // Filtered, the traces of 2.75 mm hold one window of 11.3 half-widths to either side and less than 1.6 half-widths more.
    let bench = bench_with("offsets", "window = 11.3\noffsets = 2");
    let says = [
        "position ",
        "is shorter than the",
        "that the windows of the contact need",
    ];
    run_is_refused(&bench, &[], 2, "E122", &says);
    let one = [
        "run",
        "case.toml",
        "--no-output",
        "--no-band",
        "--set",
        "model.offsets=1",
    ];
    bench.run(&one).well();
}

#[test]
fn a_finish_without_a_recipe_is_refused() {
    let bench = bench_with("pinion", "pinion = { ra = \"0.3 um\", finish = \"honed\" }");
    let says = ["surface.pinion.finish = \"honed\""];
    run_is_refused(&bench, &[], 2, "E223", &says);
}

#[test]
fn tip_relief_that_nobody_states_is_said_first_with_what_it_changes() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE.replace(NO_RELIEF, ""));
    let run = ["run", "case.toml", "--no-output", "--json"];
    let result = bench.run(&run).well().json();
    let first = &result["warnings"][0];
    assert_eq!(first["code"], "W439");
    let text = first["text"].as_str().unwrap();
    assert!(
        text.starts_with("tip relief of both gears not stated, taken from 0 to 10 um. The loss"),
        "{text}"
    );
}

#[test]
fn traces_are_said_to_narrow_the_interval_only_where_they_do() {
    let bench = Bench::new();
    let trust = |finish: &str| {
        let case = format!(
            r#"
            gears = {{ teeth = [24, 61], module = "4 mm", helix = "15 deg", face_width = "40 mm" }}
            operation = {{ torque = "300 N m", speed = "3000 1/min", bulk_temperature = "80 °C" }}
            lubricant = {{ oil = "m100" }}
            surface = {{ noise_cutoff = "2.5 um", pinion = {{ {finish} }}, wheel = {{ {finish} }} }}
            model = {{ positions = 4, offsets = 4 }}
            "#
        );
        bench.write("case.toml", case);
        let said = bench.run(&["run", "case.toml", "--notes"]);
        assert_eq!(said.status, 0, "{}", said.err);
        said.out.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let ground = trust(r#"finish = "ground", ra = "0.3 um""#);
    let polished = trust(r#"finish = "superfinished", ra = "0.1 um""#);
    assert!(
        ground.contains("; traces would narrow the interval to "),
        "{ground}"
    );
    assert!(
        polished.contains("; traces would hardly narrow the interval"),
        "{polished}"
    );
    // Nor are traces named as what narrows the largest parts.
    let advice = |said: &str| {
        let (_, after) = said.split_once("to narrow it ").unwrap_or_default();
        after.split(" trust ").next().unwrap_or_default().to_owned()
    };
    assert!(advice(&ground).contains("traces of the flanks"), "{ground}");
    assert!(!advice(&polished).contains("traces"), "{polished}");
}

#[test]
fn a_contact_that_does_not_converge_reports_no_pressure() {
    let bench = bench_with("title", "title = \"x\"");
    // 1e-17 is below the round-off of a double: no iteration can get there.
    let said = bench.run(&[
        "contact",
        "case.toml",
        "--tolerance",
        "1e-17",
        "-o",
        "points.csv",
    ]);
    said.refused(
        3,
        "E301",
        &[
            "case.toml: not converged to 1e-17 after",
            "duality gap",
            "load error",
        ],
    );
    assert!(!bench.path("points.csv").exists());
}

#[test]
fn a_run_that_does_not_converge_says_where_saves_the_gap_and_reports_no_efficiency() {
    // 1e-16 is below the round-off of a sum over the window.
    let bench = bench_with("offsets", "tolerance = 1e-16");
    let said = bench.run(&["run", "case.toml"]);
    said.refused(
        3,
        "E301",
        &[
            "case.toml: position ",
            " of ",
            "not converged to 1e-16 after",
            "load error",
            "Its gap is saved in results/failed/case.csv",
        ],
    );
    assert!(!bench.path("results/case").exists());
    let gap = std::fs::read_to_string(bench.path("results/failed/case.csv")).unwrap();
    let heights = gap.strip_prefix("x_m,h_m\n").unwrap().lines();
    assert!(heights.count() > 100);
}

#[test]
fn a_surface_too_soft_for_the_load_is_outside_the_model() {
    let bench = bench_with("flow_pressure", "flow_pressure = \"100 MPa\"");
    let says = [
        "position 1 of 2",
        "flow pressure 100 MPa is below",
        "one and a half times the Hertz pressure",
    ];
    run_is_refused(&bench, &[], 4, "E306", &says);
}

#[test]
fn the_paper_and_the_contact_alone_need_a_trace() {
    let bench = bench_with("pinion", "pinion = { rq = \"0.3 um\" }");
    let says = ["two measured profiles", "Give surface.pinion.file"];
    run_is_refused(&bench, &["--formulation", "paper"], 4, "E303", &says);
    bench
        .run(&[
            "contact",
            "case.toml",
            "--set",
            "model.load_share=lambda-star",
        ])
        .refused(4, "E303", &says);
    // Where the contact is solved, the surrogates of the first pair are pressed.
    bench.run(&["contact", "case.toml"]).well();
}

#[test]
fn marching_that_misses_the_load_is_not_converged() {
    // 1e-13 % is below round-off: halving the step cannot get there.
    let bench = bench_with("depths", "[paper]\nnumerical_error = \"1e-13 %\"");
    let says = [
        "position 1 of 1",
        "left a load error of",
        "(allowed 1.0e-13 %). No efficiency is reported",
    ];
    run_is_refused(&bench, &["--formulation", "paper"], 3, "E304", &says);
}

#[test]
fn a_load_that_is_reached_roughly_is_named_on_the_first_screen() {
    let bench = bench_with("depths", "[paper]\nnumerical_error = \"20 %\"");
    let run = ["run", "case.toml", "--formulation", "paper", "--no-output"];
    let said = bench.run(&run).well();
    let says = "W451 the contacts carry their load with an error of up to ";
    assert!(said.out.contains(says), "{}", said.out);
}

#[test]
fn an_oil_thinner_than_a_law_takes_is_outside_the_model() {
    let bench = bench_with("bulk_temperature", "bulk_temperature = \"240 °C\"");
    let says = [
        "position 1 of 2",
        "viscosity = 0.",
        "above 1 mPa s for Xu's law",
    ];
    let xu = ["--set", "model.film_friction=xu"];
    run_is_refused(&bench, &xu, 4, "E305", &says);
}

#[test]
fn a_pressure_beyond_sense_on_the_path_ends_without_an_efficiency() {
    // At the pitch point the pressure is below the limit; edge contact exceeds it.
    let bench = bench_with("torque", "torque = \"40 kN m\"");
    let says = [
        "position 1 of",
        "is beyond physical sense (at most 2e10 Pa). No efficiency is reported",
    ];
    run_is_refused(&bench, &[], 4, "E308", &says);
}

#[test]
fn a_folder_that_is_no_result_is_refused_and_untouched() {
    let bench = bench_with("title", "title = \"x\"");
    std::fs::create_dir(bench.path("notes")).unwrap();
    bench.write("notes/diary.txt", "12 March: wear");
    // Many programs write a result.json; only ours may be replaced.
    std::fs::create_dir(bench.path("other")).unwrap();
    bench.write("other/result.json", "{ \"program\": \"another\" }");
    bench
        .run(&["run", "case.toml", "--no-band", "-o", "mixed"])
        .well();
    bench.write("mixed/notes.txt", "keep me");
    for (folder, says) in [
        ("notes", "(diary.txt is not part of a result)"),
        ("other", "exists and is not a result folder"),
        ("mixed", "(notes.txt is not part of a result)"),
        ("case.toml", "case.toml: exists and is not a result folder"),
        ("case.toml/out", "case.toml: cannot be written"),
    ] {
        let before = bench.listing();
        let said = bench.run(&["run", "case.toml", "--no-band", "-o", folder]);
        said.refused(2, "E401", &[says]);
        assert_eq!(bench.listing(), before);
    }
    let read = |name: &str| std::fs::read_to_string(bench.path(name)).unwrap();
    assert_eq!(read("notes/diary.txt"), "12 March: wear");
    assert_eq!(read("other/result.json"), "{ \"program\": \"another\" }");
    assert_eq!(read("mixed/notes.txt"), "keep me");
    bench
        .run(&["demo", "notes"])
        .refused(2, "E401", &["notes: exists already", "name another"]);
    let gap = ["contact", "case.toml", "-o", "notes"];
    bench
        .run(&gap)
        .refused(2, "E401", &["notes: cannot be written"]);
}

#[test]
fn the_page_of_what_is_no_result_is_refused() {
    let bench = bench_with("title", "title = \"x\"");
    bench
        .run(&["run", "case.toml", "--no-band", "-o", "out", "--quiet"])
        .well();
    std::fs::create_dir(bench.path("set")).unwrap();
    bench.write("set/train.json", "{}");
    for (arguments, says) in [
        (
            &["report", "set"][..],
            "set: the result of a gear train; name the folder of one of its meshes",
        ),
        (
            &["report", "nosuch"],
            "nosuch: not a result of asperity run: there is no such file",
        ),
        (
            &["report", "case.toml"],
            "case.toml: not a result of asperity run: it is not JSON",
        ),
        (
            &["report", "out", "--position", "99"],
            "position 99 is not among the 2",
        ),
    ] {
        bench.run(arguments).refused(2, "E402", &[says]);
    }
}

/// Runs the small case with a changed line; the warning with `code` must say all of `says`.
#[track_caller]
fn warns(bench: &Bench, options: &[&str], code: &str, says: &[&str]) {
    let run = ["run", "case.toml", "--no-output", "--no-band", "--json"];
    let result = bench.run(&[&run, options].concat()).well().json();
    let warnings = &result["warnings"];
    let holds = |entry: &serde_json::Value| {
        let text = entry["text"].as_str().unwrap();
        entry["code"] == code && says.iter().all(|part| text.contains(part))
    };
    assert!(
        warnings.as_array().unwrap().iter().any(holds),
        "{says:?} is not in {warnings:#}"
    );
}

#[test]
fn what_calls_for_attention_in_a_result_is_said_with_it() {
    let plain = bench_with("title", "title = \"x\"");
    warns(
        &plain,
        &[],
        "W401",
        &["kinematic viscosity 7.2", "outside 15 to 350 mm2/s"],
    );
    warns(
        &plain,
        &[],
        "W409",
        &["asperities yield at", "of 2 positions"],
    );
    warns(
        &plain,
        &["--formulation", "paper"],
        "W402",
        &["mu_eq 0.001 is outside 0.01-0.12 for lubricated steel"],
    );
    let says = [
        "is the pitch point, where there is no sliding",
        "Set paper.position",
    ];
    warns(&plain, &["--formulation", "paper"], "W412", &says);
    let wide = bench_with("offsets", "offsets = 16\nwindow = 10.8");
    warns(
        &wide,
        &[],
        "W407",
        &[
            "independent windows of the contact",
            "experience with like flanks",
        ],
    );
    let deep = bench_with("depths", "depths = 12");
    warns(
        &deep,
        &[],
        "W410",
        &["von Mises stress", "the elastic limit 1500 MPa"],
    );
    // W405 and W409 state the zone that yields, where the stress is computed.
    let zone = "The von Mises stress exceeds the elastic limit down to ";
    warns(
        &deep,
        &[],
        "W409",
        &[zone, " % of the section below a contact"],
    );
    let softer = ["--set", "material.pinion.elastic_limit=235 MPa"];
    warns(
        &deep,
        &softer,
        "W405",
        &[zone, " % of the section below a contact"],
    );
    let soft = bench_with("elastic_limit", "elastic_limit = \"235 MPa\"");
    warns(
        &soft,
        &[],
        "W405",
        &["exceeds 1.79 x the elastic limit 235 MPa"],
    );
    let values = bench_with("pinion", "pinion = { rq = \"0.3 um\" }");
    warns(
        &values,
        &["--set", "model.load_share=zhu-hu"],
        "W408",
        &["roughness values", "without rpk and asperity_radius"],
    );
    warns(
        &values,
        &[],
        "W438",
        &[
            "pinion: no trace was measured",
            "12 surrogates (ground) have the stated Rq",
            "state surface.noise_cutoff",
        ],
    );
    let open = bench_with("pinion", "pinion = { ra = \"0.1 um\" }");
    warns(
        &open,
        &[],
        "W437",
        &["may be ground or superfinished", "State surface.finish"],
    );
}

#[test]
fn what_calls_for_attention_in_the_flanks_is_said_with_the_result() {
    let same = bench_with("wheel", "");
    warns(&same, &[], "W404", &["both flanks use the same trace"]);
    let rough = bench_with("title", "title = \"x\"");
    let table = rows(6000, |i, z| format!("{:.1},{:.4}", 0.5 * i as f64, 4.0 * z));
    rough.write("pinion.csv", format!("x_um,z_um\n{table}"));
    warns(
        &rough,
        &["--set", "model.film_friction=xu"],
        "W403",
        &["Xu (S is held at 0.6 um)", "outside 0 to 0.6 um"],
    );
    let two = bench_with("title", "title = \"x\"");
    let table = rows(3000, |i, z| format!("{i},{z:.4}"));
    two.write("pinion.csv", format!("x_um,z_um\n{table}"));
    warns(
        &two,
        &[],
        "W119",
        &[
            "the flanks are spaced 1 um and 500 nm",
            "resampled to 500 nm",
        ],
    );
    // The unit that the case states against the file is what the first screen says.
    let in_nm = bench_with(
        "pinion",
        "pinion = { file = \"pinion.csv\", z_unit = \"nm\" }",
    );
    let said = in_nm.run(&["run", "case.toml", "--no-output"]).well();
    assert!(
        said.out.contains("\nW322 pinion.csv: nm was stated"),
        "{}",
        said.out
    );
    let by_lambda_star = ["--set", "model.load_share=lambda-star"];
    let long_waves = bench_with("cutoff", "noise_cutoff = \"120 um\"");
    warns(
        &long_waves,
        &by_lambda_star,
        "W406",
        &["fewer than 5 asperities reach into the peak zone"],
    );
    // Grooves of a square wave on a smooth flank: all core, no peaks.
    let as_is = "cutoff = \"0 mm\"\nnoise_cutoff = \"0 um\"\nform = \"none\"";
    let grooves = bench_with("cutoff", as_is);
    let table = |height: fn(usize) -> f64| {
        let rows = rows(6000, |i, _| format!("{:.1},{}", 0.5 * i as f64, height(i)));
        format!("x_um,z_um\n{rows}")
    };
    grooves.write("pinion.csv", table(|i| if i % 40 < 20 { 0.5 } else { 0.0 }));
    grooves.write("wheel.csv", table(|_| 0.0));
    let says = ["no peaks above the core in 4 of 4 mixed contacts"];
    warns(&grooves, &by_lambda_star, "W411", &says);
    let options = ["run", "case.toml", "-o", "out", "--no-band"];
    let solved = grooves.run(&options).well();
    let text = std::fs::read_to_string(grooves.path("out/result.json")).unwrap();
    assert!(!text.contains("W411"), "{}", solved.out);
    // A flank that leans so far that the contact is at the end of its window.
    let leaning = bench_with("cutoff", as_is);
    let table = rows(6000, |i, z| {
        let x = 0.5 * i as f64;
        format!("{x:.1},{:.5}", z + 0.05 * x)
    });
    leaning.write("pinion.csv", format!("x_um,z_um\n{table}"));
    let dry = ["--set", "model.load_share=lambda-star"];
    let says = ["the rough contact runs into the end of its window at"];
    warns(&leaning, &dry, "W413", &says);
    let raw = bench_with("cutoff", "cutoff = \"0.25 mm\"\nform = \"none\"");
    let arc = |i: usize| 38.0 * (i as f64 / 3000.0 - 1.0).powi(2);
    let table = rows(6001, |i, z| {
        format!("{:.1},{:.4}", 0.5 * i as f64, z + arc(i))
    });
    raw.write("pinion.csv", format!("x_um,z_um\n{table}"));
    warns(
        &raw,
        &[],
        "W112",
        &["pinion.csv: form not removed (parabola of 38"],
    );
}

#[test]
fn the_shipped_case_of_the_paper_warns_as_its_documents_say() {
    let bench = Bench::new();
    let case = root().join("fixtures/cases/table2.toml");
    let arguments = [
        "run",
        case.to_str().unwrap(),
        "--no-output",
        "--formulation",
        "paper",
        "--notes",
    ];
    let said = bench.run(&arguments).well().out;
    for says in ["W402 mu_eq 0.32", "W404 ", "W405 p0 621 MPa"] {
        assert!(said.contains(says), "{said}");
    }
}

/// A bench whose flanks lie at these roll lengths [mm].
fn placed(pinion: &str, wheel: &str) -> Bench {
    let bench = bench_with(
        "pinion",
        &format!("pinion = {{ file = \"pinion.csv\", at = {{ roll_length = \"{pinion} mm\" }} }}"),
    );
    let text = std::fs::read_to_string(bench.path("case.toml")).unwrap();
    let placed =
        format!("wheel = {{ file = \"wheel.csv\", at = {{ roll_length = \"{wheel} mm\" }} }}");
    bench.write(
        "case.toml",
        text.replace("wheel = { file = \"wheel.csv\", mirrored = true }", &placed),
    );
    bench
}

#[test]
fn what_is_doubtful_about_the_places_of_traces_is_said() {
    // Arcs 0.5 to 3.5 mm and 3.6 to 6.6 mm of 0.34 to 3.66 mm and 3.39 to 6.84 mm in contact.
    let most = placed("4.579", "21.126");
    let says = [
        "the traces cover",
        "% of the loss along the path of contact",
    ];
    warns(&most, &["--set", "model.positions=16"], "W417", &says);
    let one = bench_with(
        "pinion",
        "pinion = { file = \"pinion.csv\", at = { diameter = \"43 mm\" } }",
    );
    let says = [
        "not known of the trace of the wheel",
        "any place of their flanks",
    ];
    warns(&one, &[], "W418", &says);
    let beside = placed("12", "21.126");
    run_is_refused(
        &beside,
        &[],
        2,
        "E123",
        &["the traces cover", "at least 30 % are needed"],
    );
    let both = ["--set", "surface.pinion.mirrored=true"];
    run_is_refused(
        &most,
        &both,
        2,
        "E205",
        &["surface.pinion.at: states how the trace lies"],
    );
    let coast = [
        "--set",
        "operation.torque=-145 N m",
        "--set",
        "surface.coast={ pinion = { file = \"pinion.csv\" }, wheel = { file = \"wheel.csv\", mirrored = true, from = \"tip\" } }",
    ];
    run_is_refused(
        &most,
        &coast,
        2,
        "E205",
        &["surface.coast.wheel.at: states how the trace lies"],
    );
    let two = ["--set", "surface.pinion.at.radius=22 mm"];
    run_is_refused(
        &most,
        &two,
        2,
        "E205",
        &["needs exactly one of position, roll_length"],
    );
    let below = placed("4.579", "21.126");
    let low = ["--set", "surface.pinion.at={ radius = \"20 mm\" }"];
    run_is_refused(
        &below,
        &low,
        2,
        "E209",
        &["must not be below the base radius"],
    );
}
