//! The contact alone: what its options do, what it reads, and what it warns of and refuses.

use std::f64::consts::PI;
use std::fmt::Write;

use serde_json::Value;

use crate::bench::{Bench, Said};

/// Reduced modulus [Pa], and radius [m].
const E_STAR: f64 = 115.4e9;
const RADIUS: f64 = 10e-3;

/// Text with the columns x and another at points `spacing` apart about zero [m], all digits printed.
fn columns(header: &str, points: usize, spacing: f64, value: impl Fn(f64) -> f64) -> String {
    let mut text = format!("{header}\n");
    for i in 0..points {
        let x = (i as f64 - 0.5 * (points - 1) as f64) * spacing;
        writeln!(text, "{x:e},{:e}", value(x)).unwrap();
    }
    text
}

fn cylinder(x: f64) -> f64 {
    x * x / (2.0 * RADIUS)
}

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("gap.csv", columns("x_m,h_m", 2001, 5e-7, cylinder));
    bench
}

fn gap(bench: &Bench, options: &[&str]) -> Said {
    let mut arguments = vec!["contact", "--gap", "gap.csv", "--e-star", "115.4 GPa"];
    arguments.extend(options);
    bench.run(&arguments)
}

fn result(bench: &Bench, options: &[&str]) -> Value {
    let mut options = options.to_vec();
    options.push("--json");
    gap(bench, &options).well().json()
}

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"))
}

fn codes(result: &Value) -> Vec<String> {
    let warnings = result["warnings"].as_array().unwrap();
    let code = |warning: &Value| warning["code"].as_str().unwrap().to_owned();
    warnings.iter().map(code).collect()
}

#[test]
fn a_controlled_approach_gives_back_the_load_that_made_it() {
    let bench = bench();
    let loaded = result(&bench, &["--load", "300 N/mm"]);
    let approach = format!("{} m", number(&loaded["approach_m"]));
    let datum = format!("{} m", number(&loaded["approach_datum_m"]));
    for options in [
        vec!["--approach", &approach],
        vec!["--approach", &approach, "--datum", &datum],
    ] {
        let lowered = result(&bench, &options);
        let load = number(&lowered["load_n_per_m"]);
        assert!((load / 300e3 - 1.0).abs() < 1e-6, "{load}");
        assert_eq!(lowered["approach_m"], loaded["approach_m"]);
    }
    gap(&bench, &["--approach", "1 um", "--datum", "1 um"]).refused(
        2,
        "E209",
        &["datum", "farther"],
    );
}

#[test]
fn every_kernel_has_its_own_contact_of_a_wave() {
    let bench = Bench::new();
    let (amplitude, length, points) = (1e-6, 1e-3, 1024);
    bench.write(
        "gap.csv",
        columns("x_m,h_m", points, length / points as f64, |x| {
            amplitude * (1.0 - (2.0 * PI * x / length).cos())
        }),
    );
    // Westergaard: at a quarter of the closing pressure a third of the wave touches, at 4 times the mean.
    let closing = PI * E_STAR * amplitude / length;
    let load = format!("{} N/m", 0.25 * closing * length);
    let with = |kernel: &[&str]| {
        let mut options = vec!["--load", &load];
        options.extend(kernel);
        result(&bench, &options)
    };
    let [strip, short, spectral, free] = [
        &["--kernel", "periodised"][..],
        &["--periodic"],
        &["--kernel", "spectral"],
        &["--kernel", "strip"],
    ]
    .map(with);
    assert_eq!(strip, short);
    for periodic in [&strip, &spectral] {
        let largest = number(&periodic["p_max_pa"]);
        assert!(
            (largest / closing - 1.0).abs() < 1e-4,
            "{largest} {closing}"
        );
        assert!((number(&periodic["contact_fraction"]) - 1.0 / 3.0).abs() < 3e-3);
    }
    assert_ne!(strip["p_max_pa"], spectral["p_max_pa"]);
    // Alone, the crest has no neighbours to push it down.
    assert!(
        number(&free["p_max_pa"]) < 0.99 * closing || number(&free["p_max_pa"]) > 1.01 * closing
    );
}

#[test]
fn a_prescribed_pressure_deforms_and_carries_nothing() {
    let bench = bench();
    bench.write("p.csv", columns("x_m,p_MPa", 2001, 5e-7, |_| 0.0));
    let plain = result(&bench, &["--load", "300 N/mm"]);
    let none = result(&bench, &["--load", "300 N/mm", "--prescribed", "p.csv"]);
    assert_eq!(plain["p_max_pa"], none["p_max_pa"]);
    // 1 GPa over the middle fifth dents it, so that less is left for the middle.
    let middle = |x: f64| if x.abs() < 100e-6 { 1000.0 } else { 0.0 };
    bench.write("p.csv", columns("x_m,p_MPa", 2001, 5e-7, middle));
    let dented = result(&bench, &["--load", "300 N/mm", "--prescribed", "p.csv"]);
    assert_eq!(number(&dented["load_n_per_m"]).round(), 300e3);
    assert!(number(&dented["p_max_pa"]) != number(&plain["p_max_pa"]));
    assert!(number(&dented["contact_fraction"]) > 1.05 * number(&plain["contact_fraction"]));
    for (text, code, says) in [
        (
            columns("x_m,p_MPa", 2001, 6e-7, middle),
            "E209",
            "at the points of the gap",
        ),
        (
            columns("x_m,p_MPa", 1001, 5e-7, middle),
            "E209",
            "prescribed pressure has 1001 values",
        ),
        (
            columns("x_m,p", 2001, 5e-7, middle),
            "E104",
            "does not name a pressure unit",
        ),
        (
            columns("x_m,q_MPa", 2001, 5e-7, middle),
            "E102",
            "no column p",
        ),
    ] {
        bench.write("p.csv", text);
        gap(&bench, &["--load", "3 N/m", "--prescribed", "p.csv"]).refused(2, code, &[says]);
    }
}

#[test]
fn the_stress_below_a_cylinder_is_that_of_hertz() {
    let bench = bench();
    let options = [
        "--load",
        "300 N/mm",
        "--stress",
        "stress.csv",
        "--elastic-limit",
        "500 MPa",
    ];
    let found = result(&bench, &options);
    let p0 = (300e3 * E_STAR / (PI * RADIUS)).sqrt();
    let b = (4.0 * 300e3 * RADIUS / (PI * E_STAR)).sqrt();
    let stress = &found["stress"];
    let (shear, mises) = (&stress["shear_max"], &stress["von_mises_max"]);
    // Johnson 1985: 0.30028 p0 at 0.786 b; von Mises 0.5575 p0. The depths are 5 % apart.
    assert!((number(&shear["value_pa"]) / (0.30028 * p0) - 1.0).abs() < 2e-3);
    assert!((number(&shear["z_m"]) / (0.786 * b) - 1.0).abs() < 0.1);
    assert!((number(&mises["value_pa"]) / (0.5575 * p0) - 1.0).abs() < 2e-3);
    assert!(number(&shear["x_m"]).abs() < 1e-6);
    let zone = &stress["yield_zone"];
    assert!(number(&zone["shallowest_m"]) < 0.786 * b && number(&zone["deepest_m"]) > 0.786 * b);
    let file = std::fs::read_to_string(bench.path("stress.csv")).unwrap();
    let lines: Vec<&str> = file.lines().collect();
    assert_eq!(
        lines[0],
        "x_m,z_m,sigma_xx_pa,sigma_zz_pa,tau_xz_pa,von_mises_pa"
    );
    assert_eq!((lines.len() - 1) % 2001, 0);
    assert!(lines[1].starts_with("-5e-4,"), "{}", lines[1]);
    // Sliding brings the largest shear nearer to the surface, and makes it larger.
    let mut sliding = options.to_vec();
    sliding.extend(["--friction", "0.3"]);
    let sliding = &result(&bench, &sliding)["stress"]["shear_max"];
    assert!(number(&sliding["value_pa"]) > 1.05 * number(&shear["value_pa"]));
    assert!(number(&sliding["z_m"]) < number(&shear["z_m"]));
    let said = gap(&bench, &options).well().out;
    assert!(
        said.contains("Largest von Mises stress") && said.contains("Elastic limit exceeded from")
    );
    let mut bad = options.to_vec();
    bad.extend(["--poisson", "0.7"]);
    gap(&bench, &bad).refused(2, "E209", &["Poisson"]);
}

#[test]
fn two_profiles_run_in_until_they_stay_elastic() {
    let bench = Bench::new();
    let wavy = |x: f64| 3e-7 * (x / 4e-6).sin() + 1e-7 * (x / 1.7e-6).cos();
    bench.write("one.csv", columns("x_m,z_m", 600, 1e-6, wavy));
    let fine = |x: f64| 5e-8 * (x / 2.9e-6).sin();
    bench.write("other.csv", columns("x_m,z_m", 600, 1e-6, fine));
    let flanks = [
        "contact",
        "--flanks",
        "one.csv",
        "other.csv",
        "--radius",
        "3 mm",
        "--e-star",
        "115.4 GPa",
        "--load",
        "100 N/mm",
    ];
    let run = |options: &[&str]| bench.run(&[&flanks[..], options].concat());
    let solved = |options: &[&str]| run(&[options, &["--json"]].concat()).well().json();
    let limit = ["--pressure-limit", "2 GPa"];
    let once = solved(&limit);
    assert!(number(&once["plastic_energy_j_per_m"]) > 0.0);
    assert_eq!(once["running_in"], serde_json::json!([]));
    let ran_in = solved(&[&limit[..], &["--running-in", "4", "--first-share", "1"]].concat());
    let cycles = ran_in["running_in"].as_array().unwrap();
    let work = |cycle: &Value| number(&cycle["plastic_energy_j_per_m"]);
    let (first, last) = (&cycles[0], &cycles[cycles.len() - 1]);
    assert!(work(first) > work(&once) && work(last) <= 1e-6 * work(first));
    // The first profile took all of the flow: the other is as it was.
    assert_eq!(last["rq_m"][1], first["rq_m"][1]);
    let heights: Vec<f64> = (0..600)
        .map(|i| wavy((f64::from(i) - 299.5) * 1e-6))
        .collect();
    let mean = heights.iter().sum::<f64>() / 600.0;
    let power = heights.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / 600.0;
    assert!(number(&last["rq_m"][0]) < 0.9999 * power.sqrt());
    assert!(work(&ran_in) <= 1e-5 * work(first));
    assert!(number(&ran_in["contact_fraction"]) > number(&once["contact_fraction"]));
    run(&[&limit[..], &["--running-in", "4", "--first-share", "2"]].concat()).refused(
        2,
        "E209",
        &["share"],
    );
    let said = run(&["--running-in", "4"]);
    assert!(
        said.status == 2 && said.err.contains("--pressure-limit"),
        "{}",
        said.err
    );
    bench.write("other.csv", columns("x_m,z_m", 500, 1e-6, |_| 0.0));
    run(&[]).refused(2, "E209", &["second flank has 500 values"]);
}

#[test]
fn a_gap_in_any_usual_encoding_is_read_and_what_is_no_text_is_refused() {
    let bench = bench();
    let text = columns("x (µm),h (µm)", 201, 2.0, |x| x * x / 20e3);
    let mut found = vec![];
    let latin: Vec<u8> = text.chars().map(|c| c as u8).collect();
    let wide: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    for bytes in [
        text.as_bytes().to_vec(),
        latin,
        [&b"\xff\xfe"[..], &wide].concat(),
        wide,
    ] {
        bench.write("gap.csv", bytes);
        found.push(result(&bench, &["--load", "30 N/mm"]));
    }
    assert!(found.windows(2).all(|pair| pair[0] == pair[1]));
    bench.write("gap.csv", b"PK\x03\x04\0\0\0\0x,h");
    gap(&bench, &["--load", "30 N/mm"]).refused(
        2,
        "E108",
        &["gap.csv: ", "is not a table as text"],
    );
    bench.write("gap.csv", "x_um,h_um\n0,1\n5,1\n6,1\n");
    let said = gap(&bench, &["--load", "30 N/mm"]);
    said.refused(2, "E109", &["off the even grid"]);
    for option in ["--dx", "--columns", "--z-unit", "--decimal", "--lambda-c"] {
        assert!(!said.err.contains(option), "{}", said.err);
    }
}

#[test]
fn the_advice_names_options_that_the_command_has() {
    let bench = Bench::new();
    let help = bench.run(&["contact", "--help"]).well().out;
    let far = "x_um,h_um\n0,1\n1,1\n5,1\n";
    for text in [
        "x_um,h_um\n0,1\n1,a\n",
        "",
        "x,h\n0,1\n",
        "x_um,h_um\n5,1\n1,1\n",
        "x_um,h_um\n5,1\n",
        far,
    ] {
        bench.write("gap.csv", text);
        let said = gap(&bench, &["--load", "3 N/m"]);
        assert_eq!(said.status, 2);
        for word in said
            .err
            .split_whitespace()
            .filter(|word| word.starts_with("--"))
        {
            let option = word.trim_end_matches(|c: char| !c.is_alphanumeric());
            assert!(help.contains(option), "{option}: {}", said.err);
        }
        assert!(
            !said.err.contains("Say ") && !said.err.contains("case"),
            "{}",
            said.err
        );
    }
}

#[test]
fn a_loose_tolerance_ends_with_its_own_code() {
    let bench = bench();
    for tolerance in ["1e-2", "1.1e-4", "inf"] {
        let options = ["--load", "300 N/mm", "--tolerance", tolerance];
        gap(&bench, &options).refused(2, "E211", &["at most 1e-4"]);
    }
    result(&bench, &["--load", "300 N/mm", "--tolerance", "1e-4"]);
    gap(&bench, &[]).refused(2, "E205", &["--load or --approach"]);
}

#[test]
fn doubts_about_a_contact_are_told_with_their_code() {
    let bench = bench();
    let plain = result(&bench, &["--load", "300 N/mm"]);
    assert_eq!(
        (codes(&plain), number(&plain["p_end_pa"])),
        (Vec::<String>::new(), 0.0)
    );
    // Hertz's half width is 0.58 mm, that of the window 0.5 mm.
    let wide = result(&bench, &["--load", "3000 N/mm"]);
    assert_eq!(codes(&wide), ["W413"]);
    assert!(number(&wide["p_end_pa"]) > 0.0);
    let said = gap(&bench, &["--load", "3000 N/mm"]).well().out;
    assert!(
        said.contains("\nW413 the contact runs into the end of the window"),
        "{said}"
    );
    let outlier = |x: f64| cylinder(x) + if x > 499.9e-6 { 1.0 } else { 0.0 };
    bench.write("gap.csv", columns("x_m,h_m", 2001, 5e-7, outlier));
    let deep = result(&bench, &["--load", "300 N/mm"]);
    assert_eq!(codes(&deep), ["W414"]);
    let apart = number(&deep["p_max_pa"]) / number(&plain["p_max_pa"]) - 1.0;
    assert!(apart.abs() < 1e-5, "{apart:e}");
}

#[test]
fn columns_that_a_contact_does_not_read_are_named() {
    let bench = bench();
    let plain = result(&bench, &["--load", "300 N/mm", "-o", "points.csv"]);
    std::fs::rename(bench.path("points.csv"), bench.path("gap.csv")).unwrap();
    // The program's own points have the gap that they were computed from.
    let again = result(&bench, &["--load", "300 N/mm"]);
    assert_eq!((&again, codes(&again)), (&plain, vec![]));
    bench.write("gap.csv", columns("x_m,h_m", 2001, 5e-7, cylinder));
    let pressed = |x: f64| if x.abs() < 100e-6 { 1000.0 } else { 0.0 };
    let text = columns("x_m,p_MPa,remark", 2001, 5e-7, pressed);
    let rows = text.lines().enumerate();
    let row = |(at, row): (usize, &str)| format!("{row}{}\n", if at > 0 { ",a" } else { "" });
    bench.write("p.csv", rows.map(row).collect::<String>());
    let options = ["--load", "300 N/mm", "--prescribed", "p.csv"];
    let warnings = result(&bench, &options)["warnings"].clone();
    let text = "columns of p.csv that are not read: remark";
    assert_eq!(
        warnings,
        serde_json::json!([{ "code": "W454", "text": text }])
    );
    let said = gap(&bench, &options).well().out;
    assert!(said.contains(&format!("\nW454 {text}\n")), "{said}");
}
