//! Arrows between the crates point down only, and the files of a crate import each other without circles.

mod file_imports;
mod size;
mod words;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Crates of the workspace that each crate may use. The physics crates stand apart from each other.
const ALLOWED: &[(&str, &[&str])] = &[
    ("crates/core", &[]),
    ("crates/storage", &[]),
    ("crates/rexs", &[]),
    ("crates/profile-io", &["asperity-core"]),
    ("crates/roughness", &["asperity-core"]),
    ("crates/gear", &["asperity-core"]),
    ("crates/contact", &["asperity-core"]),
    ("crates/ehl", &["asperity-core", "asperity-contact"]),
    ("crates/ehl-regime", &["asperity-core"]),
    ("crates/tribo-friction", &["asperity-core"]),
    ("crates/ns-film", &["asperity-core"]),
    ("crates/efficiency", &["asperity-core"]),
    (
        "crates/asperity",
        &[
            "asperity-core",
            "asperity-profile-io",
            "asperity-roughness",
            "asperity-gear",
            "asperity-contact",
            "asperity-ehl",
            "asperity-ehl-regime",
            "asperity-tribo-friction",
            "asperity-ns-film",
            "asperity-efficiency",
        ],
    ),
    (
        "crates/report",
        &[
            "asperity-storage",
            "asperity",
            "asperity-core",
            "asperity-roughness",
        ],
    ),
    (
        "crates/studies",
        &[
            "asperity-storage",
            "asperity-report",
            "asperity",
            "asperity-core",
            "asperity-roughness",
            "asperity-contact",
            "asperity-ns-film",
        ],
    ),
    (
        "crates/calibration",
        &[
            "asperity-storage",
            "asperity-report",
            "asperity",
            "asperity-core",
        ],
    ),
    (
        "cli",
        &[
            "asperity-calibration",
            "asperity-storage",
            "asperity-rexs",
            "asperity-studies",
            "asperity-report",
            "asperity",
            "asperity-core",
            "asperity-contact",
            "asperity-ns-film",
            "asperity-profile-io",
            "asperity-roughness",
            "asperity-fixtures",
        ],
    ),
    ("fixtures", &["asperity-core", "asperity-roughness"]),
];

/// The Python module, outside of the workspace: it passes on what the libraries compute.
const OF_THE_MODULE: &[&str] = &[
    "asperity",
    "asperity-report",
    "asperity-storage",
    "asperity-studies",
];

fn manifest(folder: &str) -> toml::Table {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let text = std::fs::read_to_string(root.join(folder).join("Cargo.toml")).unwrap();
    text.parse().unwrap()
}

#[test]
fn every_member_is_in_the_table_of_allowed_arrows() {
    let members: BTreeSet<String> = manifest(".")["workspace"]["members"]
        .as_array()
        .unwrap()
        .iter()
        .map(|member| member.as_str().unwrap().to_owned())
        .filter(|member| member != "tests")
        .collect();
    let listed: BTreeSet<String> = ALLOWED
        .iter()
        .map(|(folder, _)| (*folder).to_owned())
        .collect();
    assert_eq!(members, listed);
}

#[test]
fn no_crate_uses_one_above_or_beside_it() {
    let allowed: BTreeMap<_, _> = ALLOWED.iter().copied().collect();
    for (folder, may_use) in allowed {
        let manifest = manifest(folder);
        for section in ["dependencies", "dev-dependencies", "build-dependencies"] {
            let Some(used) = manifest.get(section).and_then(toml::Value::as_table) else {
                continue;
            };
            // Tests of a crate may turn on features of its own.
            let own = manifest["package"]["name"].as_str();
            let others = used.keys().filter(|name| Some(name.as_str()) != own);
            for name in others.filter(|name| name.starts_with("asperity")) {
                assert!(
                    may_use.contains(&name.as_str()),
                    "{folder} must not use {name} ({section})"
                );
            }
        }
    }
}

#[test]
fn the_python_module_stands_on_the_libraries_and_outside_of_the_workspace() {
    let module = manifest("crates/python");
    let used = module["dependencies"].as_table().unwrap().keys();
    let ours: Vec<&str> = used
        .map(String::as_str)
        .filter(|name| name.starts_with("asperity"))
        .collect();
    assert_eq!(ours, OF_THE_MODULE);
    let excluded = &manifest(".")["workspace"]["exclude"];
    let excluded = excluded.as_array().unwrap();
    assert!(
        excluded
            .iter()
            .any(|folder| folder.as_str() == Some("crates/python"))
    );
    // Both are built with the same versions of what they use, and as releases alike.
    assert_eq!(
        module["profile"]["release"],
        manifest(".")["profile"]["release"]
    );
    let version = &manifest(".")["workspace"]["package"]["version"];
    assert_eq!(&module["package"]["version"], version);
}

#[test]
fn the_files_of_a_crate_import_each_other_without_circles() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let circles: Vec<String> = ALLOWED
        .iter()
        .flat_map(|(folder, _)| {
            let sources = root.join(folder).join("src");
            let circles = file_imports::circles(&sources);
            circles
                .into_iter()
                .map(move |files| format!("{folder}: {}", files.join(", ")))
        })
        .collect();
    assert!(
        circles.is_empty(),
        "files that import each other in a circle:\n{}",
        circles.join("\n")
    );
}

#[test]
fn every_crate_has_a_readme_and_an_example() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for (folder, _) in ALLOWED {
        if !folder.starts_with("crates/") {
            continue;
        }
        let folder = root.join(folder);
        assert!(folder.join("README.md").exists(), "{}", folder.display());
        let examples = std::fs::read_dir(folder.join("examples"));
        assert!(
            examples.is_ok_and(|mut files| files.next().is_some()),
            "{} has no example",
            folder.display()
        );
    }
}

#[test]
fn the_dense_reference_solver_is_behind_a_feature() {
    let contact = manifest("crates/contact");
    let faer = contact["dependencies"]["faer"].as_table().unwrap();
    assert_eq!(faer["optional"].as_bool(), Some(true));
    let features = contact["features"].as_table().unwrap();
    let of_oracle = features["oracle"].as_array().unwrap();
    assert!(
        of_oracle
            .iter()
            .any(|name| name.as_str() == Some("dep:faer"))
    );
    let default = features.get("default").and_then(toml::Value::as_array);
    assert!(default.is_none_or(Vec::is_empty));
}
