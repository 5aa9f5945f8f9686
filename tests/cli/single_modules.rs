//! The commands that evaluate one module alone, and those that tell what the program knows.

use std::f64::consts::PI;
use std::fmt::Write;

use crate::bench::{Bench, Said, root};

/// Reduced modulus of steel on steel [Pa].
const E_STAR: f64 = 115.4e9;

/// A gap file with the heights `h` of x [m], half a micrometre apart, printed to the last digit.
fn gap_file(points: usize, first: f64, spacing: f64, h: impl Fn(f64) -> f64) -> String {
    let mut text = String::from("x_m,h_m\n");
    for i in 0..points {
        let x = first + spacing * i as f64;
        writeln!(text, "{x:e},{:e}", h(x)).unwrap();
    }
    text
}

fn contact(bench: &Bench, load: f64, options: &[&str]) -> Said {
    let load = format!("{load} N/m");
    let mut arguments = vec![
        "contact",
        "--gap",
        "gap.csv",
        "--e-star",
        "115.4 GPa",
        "--load",
        &load,
    ];
    arguments.extend(options);
    bench.run(&arguments).well()
}

fn columns(bench: &Bench, name: &str) -> (String, Vec<Vec<f64>>) {
    let text = std::fs::read_to_string(bench.path(name)).unwrap();
    let (header, table) = text.split_once('\n').unwrap();
    let rows = table
        .lines()
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect());
    (header.to_owned(), rows.collect())
}

#[test]
fn a_cylinder_on_a_gap_file_presses_as_hertz_says() {
    let bench = Bench::new();
    let (load, radius) = (300e3, 10e-3);
    bench.write(
        "gap.csv",
        gap_file(2001, -5e-4, 5e-7, |x| x * x / (2.0 * radius)),
    );
    let result = contact(&bench, load, &["--json", "-o", "points.csv"]).json();
    // Johnson 1985, eqs. 4.43 to 4.45: a = √(4WR/(π E*)), p0 = √(W E*/(π R)).
    let half_width = (4.0 * load * radius / (PI * E_STAR)).sqrt();
    let peak = (load * E_STAR / (PI * radius)).sqrt();
    let p_max = result["p_max_pa"].as_f64().unwrap();
    assert!((p_max / peak - 1.0).abs() < 1e-3, "{p_max} {peak}");
    // The edge falls between two of 2001 points.
    let fraction = result["contact_fraction"].as_f64().unwrap();
    assert!(
        (fraction - 2.0 * half_width / 1e-3).abs() < 2.0 / 2001.0,
        "{fraction}"
    );
    assert_eq!(result["plastic_energy_j_per_m"], 0.0);

    let (header, rows) = columns(&bench, "points.csv");
    assert_eq!(
        header,
        "x_m,h_m,pressure_pa,gap_m,displacement_m,plastic_displacement_m"
    );
    assert_eq!(rows.len(), 2001);
    let carried: f64 = rows.iter().map(|row| row[2] * 5e-7).sum();
    assert!((carried / load - 1.0).abs() < 1e-12, "{carried}");
    // Every number reads back as it was: the file's own x and h, and nothing pressed outside.
    let input = std::fs::read_to_string(bench.path("gap.csv")).unwrap();
    for (line, row) in input.lines().skip(1).zip(&rows) {
        let given: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        assert_eq!(given, row[..2]);
        assert!(row[2] == 0.0 || row[0].abs() < 1.01 * half_width);
    }
}

#[test]
fn a_wavy_gap_presses_as_westergaard_says() {
    let bench = Bench::new();
    let (amplitude, wavelength, load) = (0.1e-6, 100e-6, 1000.0);
    let wave = |x: f64| amplitude * (1.0 - (2.0 * PI * x / wavelength).cos());
    bench.write("gap.csv", gap_file(1600, 0.0, wavelength / 1600.0, wave));
    let result = contact(&bench, load, &["--periodic", "--json"]).json();
    // Johnson 1985, eq. 13.7: p* = π E* Δ/λ, and p_max = 2 √(p̄ p*) for a mean pressure p̄ below p*.
    let full = PI * E_STAR * amplitude / wavelength;
    let mean = load / wavelength;
    let p_max = result["p_max_pa"].as_f64().unwrap();
    assert!(
        (p_max / (2.0 * (mean * full).sqrt()) - 1.0).abs() < 1e-3,
        "{p_max}"
    );
    let fraction = 2.0 / PI * (mean / full).sqrt().asin();
    assert!((result["contact_fraction"].as_f64().unwrap() - fraction).abs() < 2.0 / 1600.0);
}

#[test]
fn a_pressure_limit_caps_the_pressure_and_costs_work() {
    let bench = Bench::new();
    bench.write("gap.csv", gap_file(2001, -5e-4, 5e-7, |x| x * x / 20e-3));
    let limit = ["--pressure-limit", "0.6 GPa", "--json", "-o", "points.csv"];
    let result = contact(&bench, 300e3, &limit).json();
    assert_eq!(result["p_max_pa"], 6e8);
    assert!(result["plastic_energy_j_per_m"].as_f64().unwrap() > 0.0);
    let carried = result["load_n_per_m"].as_f64().unwrap();
    assert!((carried / 300e3 - 1.0).abs() < 1e-12, "{carried}");
    let (_, rows) = columns(&bench, "points.csv");
    assert!(rows.iter().all(|row| row[2] <= 6e8 && row[5] >= 0.0));
}

/// The shipped cases.
fn cases() -> Vec<String> {
    let folder = std::fs::read_dir(root().join("fixtures/cases")).unwrap();
    let mut names: Vec<String> = folder
        .map(|entry| entry.unwrap().path().to_str().unwrap().to_owned())
        .collect();
    names.sort();
    assert!(names.len() >= 4);
    names
}

#[test]
fn film_and_contact_evaluate_every_shipped_case() {
    let bench = Bench::new();
    let few = ["--set", "model.positions=4", "--set", "model.offsets=2"];
    for case in cases() {
        let film = bench
            .run(&["film", &case, "--position", "A", "--json"])
            .well()
            .json();
        assert_eq!(film["path_fraction"], 0.0);
        assert!(film["rows"].as_array().unwrap().len() > 20);
        let pressed = bench
            .run(&["contact", &case, "--position", "B", "--json"])
            .well()
            .json();
        // Roughness raises the peak above Hertz.
        assert!(
            pressed["p_max_pa"].as_f64() > pressed["hertz_p_max_pa"].as_f64(),
            "{case}"
        );
    }
}

#[test]
fn equations_are_listed_and_explained() {
    let bench = Bench::new();
    let all = asperity::equations::all();
    let listed = bench.run(&["equations"]).well().out;
    let tags = listed.lines().filter(|line| !line.starts_with(' '));
    assert_eq!(tags.count(), 1 + all.len());
    // All are printed by the same lines; those with a misprint have one more.
    let tried = all.iter().enumerate();
    for (_, equation) in tried.filter(|(k, one)| k % 8 == 0 || one.misprint.is_some()) {
        let said = bench.run(&["equations", equation.tag]).well().out;
        for part in [
            equation.title,
            equation.formula,
            equation.file,
            equation.test,
        ] {
            assert!(said.contains(part), "{part} is not in {said}");
        }
        if let Some(misprint) = equation.misprint {
            assert!(said.contains(misprint));
        }
    }
    let json = bench.run(&["equations", "--json"]).well().json();
    assert_eq!(json.as_array().unwrap().len(), all.len());
}

/// Every key of a table, with its tables: `gears.module`.
fn keys(table: &toml::Table, path: &str, found: &mut Vec<String>) {
    for (name, value) in table {
        let key = format!("{path}{name}");
        if let toml::Value::Table(inner) = value {
            keys(inner, &format!("{key}."), found);
        }
        found.push(key);
    }
}

/// The tables of the schema that `node` may stand for.
fn tables<'a>(
    schema: &'a serde_json::Value,
    node: &'a serde_json::Value,
) -> Vec<&'a serde_json::Value> {
    if node.get("properties").is_some() {
        return vec![node];
    }
    let named = node["$ref"]
        .as_str()
        .map(|name| &schema["$defs"][name.trim_start_matches("#/$defs/")]);
    let choices = ["anyOf", "oneOf"]
        .iter()
        .filter_map(|kind| node[*kind].as_array())
        .flatten();
    named
        .into_iter()
        .chain(choices)
        .flat_map(|inner| tables(schema, inner))
        .collect()
}

#[test]
fn the_printed_schema_knows_every_key_of_the_shipped_cases() {
    let bench = Bench::new();
    let schema = bench.run(&["schema"]).well().json();
    let mut checked = 0;
    for case in cases() {
        let text = std::fs::read_to_string(&case).unwrap();
        let mut found = Vec::new();
        keys(&text.parse().unwrap(), "", &mut found);
        for key in found {
            let mut nodes = vec![&schema];
            for part in key.split('.') {
                let inner = nodes.iter().flat_map(|node| tables(&schema, node));
                nodes = inner
                    .filter_map(|table| table["properties"].get(part))
                    .collect();
            }
            assert!(!nodes.is_empty(), "{case}: {key} is not in the schema");
            checked += 1;
        }
    }
    assert!(checked > 80, "{checked}");
    let required = schema["required"].as_array().unwrap();
    for table in ["gears", "operation", "lubricant", "surface"] {
        assert!(required.iter().any(|name| name == table), "{required:?}");
    }
}
