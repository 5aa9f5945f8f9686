//! The commands that evaluate one module alone, and those that tell what the program knows.

use crate::bench::{Bench, root};

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
