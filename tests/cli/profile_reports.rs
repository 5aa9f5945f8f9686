//! Arguments of `asperity profile`: the views of a profile and its preparation.

use asperity_roughness::involute::{Involute, heights as involute};
use serde_json::Value;

use crate::bench::{Bench, heights, rows, trace};

const OF_THE_ISSUE: [(&str, &[&str]); 4] = [
    (
        "iso4287",
        &[
            "ra_um", "rq_um", "rz_um", "rp_um", "rv_um", "rt_um", "rsk", "rku", "rsm_um", "rc_um",
            "rdq",
        ],
    ),
    (
        "iso21920",
        &[
            "ra_um", "rq_um", "rz_um", "rp_um", "rv_um", "rt_um", "rsk", "rku", "rsm_um", "rc_um",
            "rdq",
        ],
    ),
    (
        "material_ratio",
        &["rk_um", "rpk_um", "rvk_um", "mr1_percent", "mr2_percent"],
    ),
    ("spectral", &["m0_um2", "m2", "m4_per_um2", "bandwidth"]),
];

/// A bench with a flank of 6000 points, and what `info --json` says of it with `options`.
fn info(options: &[&str]) -> Value {
    let bench = Bench::new();
    bench.write("flank.csv", trace("x_um,z_um", 6000));
    json(&bench, options)
}

fn json(bench: &Bench, options: &[&str]) -> Value {
    let arguments = [&["profile", "info", "flank.csv", "--json"], options].concat();
    bench.run(&arguments).well().json()
}

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn the_report_has_every_key_that_scripts_rely_on() {
    let found = info(&["--lambda-c", "0.25mm"]);
    for key in ["n", "dx_um", "length_um"] {
        number(&found[key]);
    }
    assert_eq!(found["format"], "delimited-text");
    assert_eq!(found["filter_state"], "unknown");
    assert!(found["warnings"].is_array());
    for (table, keys) in OF_THE_ISSUE {
        for key in keys {
            number(&found[table][key]);
        }
    }
}

#[test]
fn the_details_of_a_profile_stand_in_the_report() {
    let found = info(&["--lambda-c", "0.25mm"]);
    assert!(number(&found["material_ratio_secant"]["rk_um"]) > 0.0);
    assert!(number(&found["summits"]["density_per_mm"]) > 0.0);
    assert!(number(&found["autocorrelation"]["to_one_fifth_um"]) > 0.0);
    assert!(
        found["psd"]["convention"]
            .as_str()
            .unwrap()
            .contains("Hann")
    );
    // λc/3 to 5 λs.
    assert!((number(&found["hurst"]["longest_um"]) - 250.0 / 3.0).abs() < 1e-9);
    assert!((number(&found["hurst"]["shortest_um"]) - 12.5).abs() < 1e-9);
    assert!(number(&found["hurst"]["standard_error"]) > 0.0);
    let named = info(&["--lambda-c", "0.25mm", "--hurst", "60um:20um"]);
    assert!((number(&named["hurst"]["shortest_um"]) - 20.0).abs() < 1e-9);
    let few = info(&["--lambda-c", "0.25mm", "--hurst", "12um:10um"]);
    assert!(few["hurst"]["hurst"].is_null());
    assert!(few["hurst"]["reason"].as_str().unwrap().contains("too few"));
}

#[test]
fn a_range_holds_the_values_that_other_choices_give() {
    let cutoff = ["--lambda-c", "0.25mm"];
    let found = info(&cutoff);
    let range = |name: &str| {
        let ranges = found["ambiguity"].as_array().unwrap().iter();
        let range = ranges.clone().find(|range| range["parameter"] == name);
        let range = range.unwrap_or_else(|| panic!("no range of {name}"));
        (number(&range["low"]), number(&range["high"]))
    };
    for others in [
        ["--ends", "reg1"],
        ["--ends", "reflect"],
        ["--lambda-s", "none"],
    ] {
        let other = info(&[&cutoff[..], &others[..]].concat());
        for (name, key) in [
            ("Ra", "ra_um"),
            ("Rz", "rz_um"),
            ("Rku", "rku"),
            ("RSm", "rsm_um"),
        ] {
            let (low, high) = range(name);
            let value = number(&other["iso4287"][key]);
            let rounding = 1e-9 * value.abs();
            assert!(
                (low - rounding..=high + rounding).contains(&value),
                "{name} {value} with {others:?} is outside {low} .. {high}"
            );
        }
    }
    let (low, high) = range("Rk");
    let secant = number(&found["material_ratio_secant"]["rk_um"]);
    assert!((low..=high).contains(&secant));
}

#[test]
fn curves_are_printed_on_request_and_agree_with_the_parameters() {
    let found = info(&["--lambda-c", "0.25mm", "--curves"]);
    let list =
        |value: &Value| -> Vec<f64> { value.as_array().unwrap().iter().map(number).collect() };
    let psd = &found["curves"]["psd"];
    let (f, wavelength, density) = (
        list(&psd["frequency_per_um"]),
        list(&psd["wavelength_um"]),
        list(&psd["density_um3"]),
    );
    assert!((f[7] * wavelength[7] - 1.0).abs() < 1e-12);
    let power: f64 = density.iter().sum::<f64>() * f[0];
    // Three waves of even height: the window weighs them alike but for what it cuts at the ends.
    assert!((power / number(&found["spectral"]["m0_um2"]) - 1.0).abs() < 0.05);
    let curve = list(&found["curves"]["material_ratio"]["height_um"]);
    assert!(curve.is_sorted_by(|a, b| a >= b));
    assert!((curve[0] - curve[curve.len() - 1] - number(&found["iso4287"]["rt_um"])).abs() < 1e-12);
    let rho = list(&found["curves"]["autocorrelation"]["rho"]);
    // One, but for the rounding of a transform.
    assert!((rho[0] - 1.0).abs() < 1e-12);
    assert!(info(&[])["curves"].is_null());
    let bench = Bench::new();
    bench.write("flank.csv", trace("x_um,z_um", 6000));
    let said = bench.run(&["profile", "info", "flank.csv", "--curves"]);
    said.refused(2, "E205", &["--curves", "--json"]);
}

#[test]
fn the_text_fits_on_a_screen_of_eighty_columns() {
    let bench = Bench::new();
    bench.write("flank.csv", trace("x,z", 6000));
    let said = bench.run(&["profile", "info", "flank.csv"]).well().out;
    for line in said.lines() {
        assert!(line.chars().count() <= 80, "{line:?}");
        assert_eq!(line, line.trim_end());
    }
    // With the four lines of a case, and one between the tables.
    assert!(said.lines().count() <= 47, "{said}");
    for part in [
        "open = range over permitted choices: ends",
        "Hurst exponent",
        "summits",
        "half of m0",
        "autocorrelation to 0.2",
    ] {
        assert!(said.contains(part), "{part:?} is not in {said}");
    }
    assert!(
        said.contains("W111 no unit found for the x values"),
        "{said}"
    );
}

#[test]
fn a_filter_asked_for_is_applied_whatever_the_preset() {
    let level = info(&["--level"]);
    assert!(level["waviness"].is_null());
    let filtered = info(&["--level", "--lambda-c", "0.25mm"]);
    let same = info(&["--lambda-c", "0.25mm", "--lambda-s", "none"]);
    assert_eq!(filtered["iso4287"], same["iso4287"]);
    assert_ne!(filtered["iso4287"], level["iso4287"]);
    let bench = Bench::new();
    bench.write("flank.csv", trace("x_um,z_um", 6000));
    let said = bench.run(&["profile", "info", "flank.csv", "--level", "--robust"]);
    said.refused(2, "E205", &["--robust", "pass --lambda-c"]);
    let said = bench.run(&["profile", "info", "flank.csv", "--lambda-c", "-1mm"]);
    said.informed("E120", &["flank.csv: cut-off", "must be"]);
}

/// A rough trace on an involute, run from root to tip.
fn flank(bench: &Bench, flank: &Involute) {
    let points = 6001;
    let along: Vec<f64> = (0..points).map(|i| 0.5e-6 * (i as f64 - 3000.0)).collect();
    let form = involute(flank, &along).unwrap();
    let rough = heights(points);
    let sum = |i: usize| 1e6 * form[i] + rough[i];
    bench.write(
        "flank.csv",
        format!(
            "x_um,z_um\n{}",
            rows(points, |i, _| format!(
                "{:.1},{:.7}",
                0.5 * i as f64,
                sum(i)
            ))
        ),
    );
    bench.write(
        "rough.csv",
        format!(
            "x_um,z_um\n{}",
            rows(points, |i, z| format!("{:.1},{z:.7}", 0.5 * i as f64))
        ),
    );
}

#[test]
fn an_involute_comes_off_and_the_roughness_stays() {
    let bench = Bench::new();
    let on = Involute {
        base_radius: "30 mm".parse().unwrap(),
        roll_length: "15 mm".parse().unwrap(),
        towards_root: false,
    };
    flank(&bench, &on);
    let asked = [
        "--form",
        "involute",
        "--base-radius",
        "30mm",
        "--roll-length",
        "15mm",
    ];
    let unfiltered = ["--lambda-c", "none", "--lambda-s", "none"];
    let found = json(&bench, &[&asked[..], &unfiltered].concat());
    let arguments = [&["profile", "info", "rough.csv", "--json"], &unfiltered[..]].concat();
    let plain = bench.run(&arguments).well().json();
    for key in ["ra_um", "rq_um", "rt_um"] {
        let (a, b) = (
            number(&found["iso4287"][key]),
            number(&plain["iso4287"][key]),
        );
        // Heights are written to 1e-7 um.
        assert!((a - b).abs() < 2e-7, "{key}: {a} {b}");
    }
    assert_eq!(found["preparation"]["recipe"]["form"], "involute");
    assert_eq!(
        number(&found["preparation"]["involute"]["roll_length_mm"]),
        15.0
    );
    assert!(found["warnings"].as_array().unwrap().is_empty());
    let codes = |found: &Value| found["warnings"][0]["code"].clone();
    assert_eq!(codes(&json(&bench, &unfiltered)), "W112");
    // The wrong way round the curvature runs the other way along the flank.
    let turned = json(
        &bench,
        &[&asked[..], &unfiltered, &["--towards-root"]].concat(),
    );
    assert!(number(&turned["iso4287"]["rt_um"]) > 2.0 * number(&found["iso4287"]["rt_um"]));
    let text = bench
        .run(&[&["profile", "info", "flank.csv"], &asked[..]].concat())
        .unwrapped();
    let form =
        "form involute (base radius 30 mm, roll length 15 mm at the middle, towards the tip)";
    assert!(text.contains(form), "{text}");
    bench
        .run(&[&["profile", "filter", "flank.csv", "r.csv"], &asked[..]].concat())
        .well();
}

#[test]
fn an_involute_without_its_place_is_refused() {
    let bench = Bench::new();
    bench.write("flank.csv", trace("x_um,z_um", 6000));
    let refused = |options: &[&str], code: &str, says: &[&str]| {
        let arguments = [&["profile", "info", "flank.csv"], options].concat();
        let said = bench.run(&arguments);
        match code {
            "E120" => said.informed(code, says),
            _ => said.refused(2, code, says),
        }
    };
    let form = ["--form", "involute"];
    let radius = ["--base-radius", "30mm"];
    refused(&form, "E205", &["needs --base-radius"]);
    refused(
        &[form, radius].concat(),
        "E205",
        &["needs --roll-length", "√(r² − r_b²)"],
    );
    refused(&radius, "E205", &["go with --form involute only"]);
    refused(
        &["--towards-root"],
        "E205",
        &["go with --form involute only"],
    );
    let low = ["--roll-length", "0.1mm"];
    refused(
        &[form, radius, low].concat(),
        "E120",
        &["flank.csv: roll length", "below the base circle"],
    );
    let backwards = ["--base-radius", "-30mm", "--roll-length", "15mm"];
    refused(
        &[&form[..], &backwards].concat(),
        "E120",
        &["flank.csv: base radius"],
    );
}

#[test]
fn a_trace_too_short_is_told_what_it_is_long_enough_for() {
    let bench = Bench::new();
    let refused = |name: &str, says: &[&str]| {
        let said = bench.run(&["profile", "info", name]);
        said.informed("E120", says);
    };
    bench.write("1mm.csv", trace("x_um,z_um", 2000));
    bench.write("third.csv", trace("x_um,z_um", 700));
    refused(
        "third.csv",
        &[
            "read as delimited text, 700 points",
            "Pass --lambda-c 0.08mm, or --level",
        ],
    );
    let said = bench.run(&["profile", "info", "third.csv", "--lambda-c", "0.08mm"]);
    said.well();
    bench.write("short.csv", trace("x_um,z_um", 120));
    refused("short.csv", &["120 points. Pass --level for no filter"]);
    let heights = rows(400, |_, z| format!("{z:.4}"));
    bench.write("r.tx2", format!("0.20000\n400\n{heights}"));
    let conditions = "Evaluation length\t0.2mm\nCutoff value\t0.25mm\n";
    bench.write("r.tx3", conditions);
    refused("r.tx2", &["It was filtered before: pass --as-is"]);
    let many = ["profile", "info", "1mm.csv", "--as-is", "--sections", "900"];
    bench
        .run(&many)
        .informed("E120", &["Pass fewer --sections"]);
}

#[test]
fn a_roughness_profile_taken_as_it_is_is_not_warned_of() {
    let bench = Bench::new();
    bench.write("r.csv", trace("roughness profile\nx_um,z_um", 6000));
    let codes = |options: &[&str]| {
        let arguments = [&["profile", "info", "r.csv", "--json"], options].concat();
        bench.run(&arguments).well().json()["warnings"].to_string()
    };
    assert!(codes(&["--lambda-c", "0.25mm"]).contains("W118"));
    assert!(!codes(&["--as-is"]).contains("W118"));
    let said = bench.run(&["profile", "info", "r.csv", "--lambda-c", "0.25mm"]);
    let hint = "to use the filtering of the instrument, pass --as-is";
    assert!(said.well().unwrapped().contains(hint));
}

#[test]
fn of_many_files_the_good_ones_are_shown_and_the_others_named() {
    let bench = Bench::new();
    bench.write("good.csv", trace("x_um,z_um", 6000));
    bench.write("few.csv", trace("x_um,z_um", 5));
    let files = ["profile", "info", "good.csv", "few.csv", "nosuch.csv"];
    let said = bench.run(&files);
    assert_eq!(said.status, 2);
    assert!(
        said.out.contains("good.csv") && !said.out.contains("few.csv"),
        "{said:?}"
    );
    assert!(said.err.contains("E106 few.csv: 5 points"), "{said:?}");
    assert!(said.err.contains("E103 nosuch.csv"), "{said:?}");
    let said = bench.run(&[&files[..], &["--json"]].concat());
    assert_eq!(said.status, 2);
    let entries = said.json();
    assert!(number(&entries[0]["iso4287"]["ra_um"]) > 0.0);
    assert_eq!(entries[1]["error"]["code"], "E106");
    assert_eq!(entries[2]["file"], "nosuch.csv");
}

#[test]
fn what_cannot_be_written_or_resampled_is_refused() {
    let bench = Bench::new();
    bench.write("flank.csv", trace("x_um,z_um", 1000));
    let refused = |options: &[&str], code: &str, says: &[&str]| {
        let arguments = [&["profile", "convert", "flank.csv"], options].concat();
        bench.run(&arguments).refused(2, code, says);
    };
    refused(
        &["no/out.csv"],
        "E401",
        &["no/out.csv", "there is no folder no"],
    );
    refused(
        &["o.csv", "--resample", "0um"],
        "E209",
        &["--resample", "greater than zero"],
    );
    refused(
        &["o.csv", "--resample", "-1um"],
        "E209",
        &["--resample -1 um"],
    );
    refused(&["o.csv", "--resample", "1e-9um"], "E209", &["is too fine"]);
    refused(&["o.csv", "--outliers", "-2"], "E209", &["--outliers -2"]);
    refused(
        &["o.csv", "--row", "2"],
        "E119",
        &["flank.csv: the file holds a single profile"],
    );
    assert_eq!(bench.listing(), ["flank.csv"]);
}

#[test]
fn what_cannot_be_generated_is_refused_with_the_range() {
    let bench = Bench::new();
    for rq in ["1e300 m", "0 um", "2 mm", "1e-14 m"] {
        bench
            .run(&["profile", "generate", "-o", "a.csv", "--rq", rq])
            .refused(2, "E209", &["rq", "must lie from 1e-12 to 1e-3 m"]);
    }
}

/// A trace like measured ones has their parameters but other heights.
#[test]
fn a_trace_is_generated_like_measured_ones() {
    let bench = Bench::new();
    for seed in ["1", "2"] {
        let file = format!("flank{seed}.csv");
        let arguments = [
            "profile", "generate", "--points", "8001", "--seed", seed, "-o", &file,
        ];
        bench.run(&arguments).well();
    }
    let like = |seed: &str, output: &str| {
        bench
            .run(&[
                "profile",
                "generate",
                "--like",
                "flank1.csv",
                "--like",
                "flank2.csv",
                "--seed",
                seed,
                "--json",
                "-o",
                output,
            ])
            .well()
            .json()
    };
    let (third, fourth) = (like("3", "three.csv"), like("4", "four.csv"));
    let rq = |made: &serde_json::Value| made["achieved"]["rq"].as_str().unwrap().to_owned();
    assert_ne!(rq(&third), rq(&fourth));
    let info = |file: &str| {
        let report = bench
            .run(&["profile", "info", "--json", file])
            .well()
            .json();
        ["ra_um", "rz_um", "rdq"].map(|key| report["iso4287"][key].as_f64().unwrap())
    };
    for (made, measured) in info("three.csv").into_iter().zip(info("flank1.csv")) {
        assert!((made / measured - 1.0).abs() < 0.2, "{made} {measured}");
    }
    let pieces =
        "profile generate --like flank1.csv --like flank2.csv --method pieces --json -o pieces.csv";
    let pieces: Vec<&str> = pieces.split(' ').collect();
    let made = bench.run(&pieces).well().json();
    let first = &made["pieces"][0];
    assert!((150.0..=300.0).contains(&first["length_um"].as_f64().unwrap()));
    assert!(first["file"].as_str().unwrap().starts_with("flank"));
    let text = std::fs::read_to_string(bench.path("pieces.csv")).unwrap();
    assert!(text.contains("pieces of 2 traces"), "{text:.200}");
    let rough = "profile generate --points 8001 --rq 1um -o rough.csv";
    bench.run(&rough.split(' ').collect::<Vec<_>>()).well();
    for (more, code) in [("--method pieces", "W461"), ("--like rough.csv", "W462")] {
        let one = format!("profile generate --like flank1.csv {more} --json -o other.csv");
        let made = bench.run(&one.split(' ').collect::<Vec<_>>()).well().json();
        assert_eq!(made["warnings"][0]["code"], code);
    }
    bench
        .run(&[
            "profile",
            "generate",
            "--points",
            "2000",
            "--spacing",
            "0.7 um",
            "-o",
            "other.csv",
        ])
        .well();
    bench
        .run(&[
            "profile",
            "generate",
            "--like",
            "flank1.csv",
            "--like",
            "other.csv",
            "-o",
            "no.csv",
        ])
        .refused(2, "E120", &["spaced"]);
}

#[test]
fn heights_of_a_fine_trace_are_printed_with_digits() {
    let bench = Bench::new();
    let fine = rows(6000, |i, z| {
        format!("{:.1},{:.9}", 0.5 * i as f64, 1e-4 * z)
    });
    bench.write("fine.csv", format!("x_um,z_um\n{fine}"));
    let said = bench.run(&["profile", "info", "fine.csv"]).well();
    assert!(
        !said.out.contains("0.0000 ") && !said.out.contains("0.00000,"),
        "{}",
        said.out
    );
    let heights = said
        .out
        .lines()
        .find(|line| line.starts_with("Ra "))
        .unwrap();
    let ra: f64 = heights.split_whitespace().nth(1).unwrap().parse().unwrap();
    assert!((1.5e-5..3e-5).contains(&ra), "{heights}");
}
