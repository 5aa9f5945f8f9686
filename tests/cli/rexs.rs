//! Cases from REXS gearbox files.

use std::fs;

use crate::bench::{Bench, root, trace};

fn bench() -> Bench {
    let bench = Bench::new();
    for name in ["chain.rexs", "planetary.rexs"] {
        let file = root().join("crates/rexs/tests/gearboxes").join(name);
        bench.write(name, fs::read_to_string(file).unwrap());
    }
    bench.write("pinion.csv", trace("x_um,z_um", 6000));
    bench.write("wheel.csv", trace("x_um,z_um", 6000));
    bench
}

const FLANKS: [&str; 4] = ["--pinion", "pinion.csv", "--wheel", "wheel.csv"];

#[test]
fn stages_are_listed() {
    let bench = bench();
    let said = bench.run(&["case", "from-rexs", "chain.rexs"]).well().out;
    assert!(
        said.contains("stage 2: Second stage, 19/47 teeth"),
        "{said}"
    );
    assert!(
        said.contains("load case 2: 60.00000 % of the time"),
        "{said}"
    );
    assert!(
        said.contains("stage 3: Bevel, bevel_stage, not modelled"),
        "{said}"
    );
    let listed = bench.run(&["case", "from-rexs", "planetary.rexs", "--json"]);
    let listed = listed.well().json();
    assert_eq!(listed["stages"][0]["kind"], "planetary");
    assert_eq!(
        listed["stages"][0]["teeth"],
        serde_json::json!([27.0, 24.0, 75.0])
    );
}

#[test]
fn a_stage_runs_at_the_centre_distance_of_its_file() {
    let bench = bench();
    for (stage, distance) in [("1", None), ("2", Some(100.0))] {
        let mut arguments = vec![
            "case",
            "from-rexs",
            "chain.rexs",
            "--stage",
            stage,
            "-o",
            "case.toml",
        ];
        arguments.extend(FLANKS);
        let said = bench.run(&arguments);
        assert_eq!(said.status, 0, "{said:?}");
        assert!(
            said.out.contains("next: asperity check case.toml"),
            "{}",
            said.out
        );
        assert!(
            said.err.contains("the base oil is assumed to be mineral"),
            "{}",
            said.err
        );
        let run = [
            "run",
            "case.toml",
            "--json",
            "--no-output",
            "--set",
            "model.offsets=1",
        ];
        let result = bench.run(&run).well().json();
        let found = result["gears"]["centre_distance"].as_str().unwrap();
        let found: f64 = found.trim_end_matches(" mm").parse().unwrap();
        // The shifts of the first stage give another distance than its file states, which is said.
        let stated = distance.unwrap_or(63.3497);
        assert!((found - stated).abs() < 1e-4, "{found}");
    }
    let mut arguments = vec!["case", "from-rexs", "planetary.rexs", "-o", "set.toml"];
    arguments.extend(FLANKS);
    assert_eq!(bench.run(&arguments).status, 0);
    let written = fs::read_to_string(bench.path("set.toml")).unwrap();
    assert!(
        written.contains("default: the file has no lubricant"),
        "{written}"
    );
    bench.run(&["check", "set.toml"]).well();
}

#[test]
fn without_flanks_the_case_says_what_is_missing() {
    let bench = bench();
    let case = bench
        .run(&["case", "from-rexs", "chain.rexs", "--stage", "2"])
        .out;
    assert!(case.contains("# pinion.file = \"pinion.csv\""), "{case}");
    bench.write("case.toml", &case);
    bench
        .run(&["check", "case.toml"])
        .refused(2, "E204", &["pinion"]);
}

#[test]
fn what_cannot_be_used_is_refused() {
    let bench = bench();
    bench.write("broken.rexs", "<model version=\"1.4\">");
    bench.run(&["case", "from-rexs", "broken.rexs"]).refused(
        2,
        "E132",
        &["broken.rexs", "ends inside"],
    );
    bench
        .run(&["case", "from-rexs", "none.rexs"])
        .refused(2, "E101", &["none.rexs"]);
    for stage in ["3", "4"] {
        let arguments = ["case", "from-rexs", "chain.rexs", "--stage", stage];
        bench.run(&arguments).refused(2, "E133", &["stage"]);
    }
}
