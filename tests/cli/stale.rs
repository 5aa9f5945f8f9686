//! Studies, maps and records after a file that they read has changed.

use std::collections::BTreeSet;
use std::fs;

use asperity::case::FILE_KEYS;
use asperity_studies::sweep::{Shard, Study, SweepError, run};

use crate::bench::{Bench, E_DRIVE, OIL_FILE, root};

/// A study of the case as it is, and with `choice` in addition.
fn bench(choice: &str) -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.shorten_flanks();
    let losses = "\n[gearbox]\nloss_table = \"losses.csv\"\n";
    let case = E_DRIVE.replace("[model]", "[model]\nload_share = \"lambda-star\"");
    bench.write("case.toml", format!("{case}{losses}"));
    bench.write("losses.csv", table(0.3));
    bench.write(
        "study.toml",
        format!(
            "case = \"case.toml\"\ncolumns = [\"loss_w\", \"gearbox_loss_w\"]\n\
             [[axis]]\nname = \"what\"\nchoice.as_is = {{}}\nchoice.with = {{ {choice} }}\n"
        ),
    );
    bench
}

fn table(loss: f64) -> String {
    format!("speed_rpm,loss_torque_nm\n0,0.1\n20000,{loss}\n")
}

/// 1.25 mm of a flank, which are read sooner.
fn trace(name: &str) -> String {
    let text = fs::read_to_string(root().join(format!("fixtures/profiles/{name}.csv"))).unwrap();
    let rows: Vec<&str> = text.lines().take(1 + 2500).collect();
    rows.join("\n")
}

/// The trace without its heights above 1 um.
fn worn(trace: &str) -> String {
    let lower = |row: &str| match row.split_once(',') {
        Some((x, z)) => match z.parse::<f64>() {
            Ok(z) => format!("{x},{}", z.min(1.0)),
            Err(_) => row.to_owned(),
        },
        None => row.to_owned(),
    };
    trace.lines().map(lower).collect::<Vec<_>>().join("\n")
}

fn coefficients(b1: f64) -> String {
    format!(
        r#"{{ "source": "own tests", "oil": "pao", "coefficients": {{ "b1": {b1}, "b2": 1.0, "b3": 1.0,
            "b4": -0.35, "b5": 2.8, "b6": -0.1, "b7": 0.75, "b8": -0.39, "b9": 0.62 }} }}"#
    )
}

fn oil_file(stress: &str) -> String {
    OIL_FILE.replace("value = \"4.8 MPa\"", &format!("value = \"{stress} MPa\""))
}

/// A pair of traces before and after a test.
const PAIR: &str = "like = [\"pinion.csv\"], after = [\"own\"]";

/// What makes a case read `own` by `key`.
fn choice(key: &str) -> String {
    let wheel = "wheel = { file = \"wheel.csv\", mirrored = true }";
    let coast = |flanks: &str| {
        format!("\"operation.torque\" = \"-145 N m\", \"surface.coast\" = {{ {flanks} }}")
    };
    match key {
        "surface.pinion.file"
        | "surface.wheel.file"
        | "gearbox.loss_table"
        | "lubricant.oil_file" => {
            format!("\"{key}\" = \"own\"")
        }
        "model.film_friction.xu" => "\"model.film_friction\" = { xu = \"own\" }".to_owned(),
        "surface.pinion.traces" => "\"surface.pinion\" = { traces = [\"own\"] }".to_owned(),
        "surface.wheel.traces" => {
            "\"surface.wheel\" = { traces = \"ow*\", mirrored = true }".to_owned()
        }
        "surface.coast.pinion.file" => coast(&format!("pinion = {{ file = \"own\" }}, {wheel}")),
        "surface.coast.wheel.file" => {
            coast("pinion = { file = \"pinion.csv\" }, wheel = { file = \"own\" }")
        }
        "surface.coast.pinion.traces" => {
            coast(&format!("pinion = {{ traces = [\"own\"] }}, {wheel}"))
        }
        "surface.coast.wheel.traces" => {
            coast("pinion = { file = \"pinion.csv\" }, wheel = { traces = [{ file = \"own\" }] }")
        }
        "surface.pinion.like" => "\"surface.pinion\" = { like = [\"own\"] }".to_owned(),
        "surface.wheel.like" => "\"surface.wheel\" = { like = \"ow*\" }".to_owned(),
        "surface.coast.pinion.like" => coast(&format!("pinion = {{ like = [\"own\"] }}, {wheel}")),
        "surface.coast.wheel.like" => {
            coast("pinion = { file = \"pinion.csv\" }, wheel = { like = [{ file = \"own\" }] }")
        }
        "surface.pinion.after" => format!("\"surface.pinion\" = {{ {PAIR} }}"),
        "surface.wheel.after" => format!("\"surface.wheel\" = {{ {PAIR} }}"),
        "surface.coast.pinion.after" => coast(&format!("pinion = {{ {PAIR} }}, {wheel}")),
        "surface.coast.wheel.after" => coast(&format!(
            "pinion = {{ file = \"pinion.csv\" }}, wheel = {{ {PAIR} }}"
        )),
        key => panic!("{key}: a key that names files needs an entry here and in `contents`"),
    }
}

/// A content of `own` and another one, for a key.
fn contents(key: &str) -> [String; 2] {
    match key {
        "gearbox.loss_table" => [table(0.4), table(0.9)],
        "lubricant.oil_file" => [oil_file("4.8"), oil_file("5.0")],
        key if key.ends_with("after") => {
            let before = trace("ground_pinion");
            [before.clone(), worn(&before)]
        }
        "model.film_friction.xu" => [coefficients(-8.9), coefficients(-8.0)],
        _ => [trace("ground_pinion"), trace("ground_fine_pinion")],
    }
}

/// The merged table after a run that finds the parts of earlier ones in `parts`.
fn merged(bench: &Bench, parts: &str) -> String {
    let folder = ["study.toml", "--parts", parts, "--quiet"];
    bench.run(&[&["sweep", "run"][..], &folder].concat()).well();
    let merge = [&["sweep", "merge"][..], &folder, &["-o", "out"]].concat();
    bench.run(&merge).well();
    let table = fs::read_to_string(bench.path("out/sweep.csv")).unwrap();
    // Every case has a result.
    assert!(
        table.lines().skip(1).all(|row| row.ends_with(',')),
        "{table}"
    );
    table
}

#[test]
fn a_study_run_again_equals_a_clean_one_whichever_file_changed() {
    for key in FILE_KEYS {
        let bench = bench(&choice(key));
        let [before, after] = contents(key);
        bench.write("own", before);
        let first = merged(&bench, "parts");
        bench.write("own", after);
        let again = merged(&bench, "parts");
        assert_eq!(again, merged(&bench, "clean"), "{key}");
        assert_ne!(again, first, "{key}");
    }
}

#[test]
fn a_new_file_of_a_pattern_is_a_change_of_the_study() {
    let bench = bench("\"surface.pinion\" = { traces = \"own*\" }");
    bench.write("own1", trace("ground_pinion"));
    let first = merged(&bench, "parts");
    bench.write("own2", trace("ground_fine_pinion"));
    let again = merged(&bench, "parts");
    assert_eq!(again, merged(&bench, "clean"));
    assert_ne!(again, first);
}

#[test]
fn shards_of_two_inputs_are_not_put_together() {
    let bench = bench("\"surface.pinion.file\" = \"own\"");
    let shard = |shard: &str| {
        bench
            .run(&["sweep", "run", "study.toml", "--shard", shard])
            .well();
    };
    bench.write("own", trace("ground_pinion"));
    shard("1/2");
    bench.write("own", trace("ground_fine_pinion"));
    shard("2/2");
    let merge = ["sweep", "merge", "study.toml", "-o", "out"];
    bench
        .run(&merge)
        .refused(3, "E309", &["1 of 2 cases", "other inputs", "parts"]);
    // A part that was put among the others is refused by the inputs that it states.
    let folders = fs::read_dir(bench.path("parts")).unwrap();
    let folders: Vec<_> = folders.map(|entry| entry.unwrap().path()).collect();
    assert_eq!(folders.len(), 2);
    for (from, to) in [(0, 1), (1, 0)] {
        for part in fs::read_dir(&folders[from]).unwrap() {
            let part = part.unwrap();
            let copy = folders[to].join(part.file_name());
            if !copy.exists() {
                fs::copy(part.path(), copy).unwrap();
            }
        }
    }
    bench
        .run(&merge)
        .refused(2, "E402", &["was computed from inputs", "part-"]);
}

#[test]
fn a_damaged_part_is_refused_and_run_again_once_it_is_removed() {
    let bench = bench("\"gearbox.loss_table\" = \"own\"");
    bench.write("own", table(0.4));
    let whole = merged(&bench, "parts");
    let folder = fs::read_dir(bench.path("parts")).unwrap().next().unwrap();
    let part = fs::read_dir(folder.unwrap().path())
        .unwrap()
        .next()
        .unwrap();
    let part = part.unwrap().path();
    let text = fs::read_to_string(&part).unwrap();
    let number = text.lines().last().unwrap().split(',').nth(3).unwrap();
    let damages = [
        text.replacen(number, "nan", 1),
        text.replacen(number, &number[..number.len() - 1], 1),
        text.replacen(",with,", ",0.5,", 1),
        text[..text.len() - 3].to_owned(),
        text.lines().skip(3).collect::<Vec<_>>().join("\n"),
    ];
    for damaged in damages {
        assert_ne!(damaged, text);
        fs::write(&part, damaged).unwrap();
        for verb in ["merge", "run"] {
            bench
                .run(&["sweep", verb, "study.toml"])
                .refused(2, "E402", &["part-"]);
        }
    }
    fs::remove_file(&part).unwrap();
    assert_eq!(merged(&bench, "parts"), whole);
}

#[test]
fn a_file_that_changes_while_the_study_runs_stops_it() {
    let bench = bench("\"surface.pinion.file\" = \"own\"");
    bench.write("own", trace("ground_pinion"));
    let study = Study::load(&bench.path("study.toml")).unwrap();
    bench.write("own", trace("ground_fine_pinion"));
    let shard = Shard { number: 1, of: 1 };
    let error = run(&study, shard, &bench.path("parts"), &|_| {}).unwrap_err();
    assert!(
        matches!(&error, SweepError::Changed { file } if file.ends_with("own")),
        "{error}"
    );
}

/// Every field of the keys of a case that holds a path is the end of a key in the list that studies go by.
#[test]
fn no_key_that_names_a_file_is_missing_in_the_list() {
    let folders = ["crates/case/src/input", "crates/oil/src"];
    let entries = folders.map(|folder| fs::read_dir(root().join(folder)).unwrap());
    let mut fields = BTreeSet::new();
    let paths = entries
        .into_iter()
        .flatten()
        .map(|entry| entry.unwrap().path());
    for file in paths.filter(|path| path.is_file()) {
        let text = fs::read_to_string(file).unwrap();
        let tables = ["JsonSchema", "choices! {", "table! {"];
        if !tables.iter().any(|table| text.contains(table)) {
            continue;
        }
        let paths = text.lines().filter(|line| line.contains("PathBuf"));
        let named = paths.filter_map(|line| match line.trim().strip_suffix("(PathBuf),") {
            Some(law) => Some(law.to_lowercase()),
            None => {
                let (name, _) = line.trim().split_once(": ")?;
                Some(name.trim_start_matches("pub ").to_owned())
            }
        });
        fields.extend(named);
    }
    let ends = FILE_KEYS.iter().filter_map(|key| key.rsplit('.').next());
    // Lists of traces are files and patterns of them.
    let listed: BTreeSet<String> = ends
        .filter(|end| !["traces", "like", "after"].contains(end))
        .map(str::to_owned)
        .collect();
    assert_eq!(fields, listed);
}

#[test]
fn a_map_states_another_fingerprint_once_a_file_changed() {
    let coast = format!("{E_DRIVE}\n[surface.coast]\npinion = {{ file = \"own\" }}\n");
    let case = coast.replace("[model]", "[model]\nload_share = \"lambda-star\"");
    let case = format!("{case}\n[gearbox]\nloss_table = \"losses.csv\"\n");
    let bench = Bench::new();
    bench.write_flanks();
    bench.shorten_flanks();
    bench.write("case.toml", case);
    bench.write("losses.csv", table(0.3));
    bench.write("own", trace("ground_pinion"));
    let fingerprint = || {
        let axes = ["--torque=-100,100", "--speed=9000", "--temperature=90"];
        let map = [
            &["map", "case.toml", "-o", "m", "--band", "none"][..],
            &axes,
        ]
        .concat();
        bench.run(&map).well();
        let text = fs::read_to_string(bench.path("m/map.json")).unwrap();
        let json: serde_json::Value = serde_json::from_str(&text).unwrap();
        json["finishes"][0]["fingerprint"]
            .as_str()
            .unwrap()
            .to_owned()
    };
    let first = fingerprint();
    assert_eq!(fingerprint(), first);
    bench.write("own", trace("ground_fine_pinion"));
    let second = fingerprint();
    bench.write("losses.csv", table(0.4));
    let third = fingerprint();
    bench.write("pinion.csv", trace("ground_fine_pinion"));
    let all = BTreeSet::from([first, second, third, fingerprint()]);
    assert_eq!(all.len(), 4);
}
