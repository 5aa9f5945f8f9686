//! Arrows between the crates point down only.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// What each crate may use of the workspace. The physics crates stand apart from each other.
const ALLOWED: &[(&str, &[&str])] = &[
    ("crates/core", &[]),
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
        "cli",
        &[
            "asperity",
            "asperity-core",
            "asperity-contact",
            "asperity-ns-film",
            "asperity-roughness",
            "asperity-fixtures",
        ],
    ),
    ("fixtures", &["asperity-core", "asperity-roughness"]),
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
            for name in used.keys().filter(|name| name.starts_with("asperity")) {
                assert!(
                    may_use.contains(&name.as_str()),
                    "{folder} must not use {name} ({section})"
                );
            }
        }
    }
}
