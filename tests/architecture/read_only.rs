//! A case does not change after it was made, and nothing reads what a version that nobody had wrote.

use std::fs::read_to_string;
use std::path::{Path, PathBuf};

use super::words::sources;

/// Types of a case, each made once and read only.
const READ_ONLY: [&str; 3] = ["Case", "LoadedCase", "OperatingCase"];

pub fn all_sources() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folders = std::fs::read_dir(root.join("crates")).unwrap();
    let folders = folders.map(|entry| entry.unwrap().path().join("src"));
    let folders = folders.chain([root.join("cli/src")]);
    folders.flat_map(|folder| sources(&folder)).collect()
}

/// Whether a line assigns to a value of a resolved case: `case.case.model.offsets = 4`, `loaded.surfaces = other`.
fn assigns(line: &str) -> bool {
    let Some((left, _)) = line.split_once("= ") else {
        return false;
    };
    let left = left
        .trim()
        .trim_end_matches(['+', '-', '*', '/'])
        .trim_end();
    let is_place = left
        .chars()
        .all(|c| c.is_alphanumeric() || c == '_' || c == '.');
    let parts: Vec<&str> = left.split('.').collect();
    let is_of_case = parts.iter().skip(1).any(|part| *part == "case") && parts.len() > 2;
    is_place && (is_of_case || parts.get(1) == Some(&"surfaces"))
}

#[test]
fn no_source_assigns_to_a_resolved_case() {
    let mut found = Vec::new();
    // The meshes of a train that is being read have keys in their field `case`.
    let is_of_keys = |file: &PathBuf| file.ends_with("crates/case/src/train/train_parts.rs");
    for file in all_sources().into_iter().filter(|file| !is_of_keys(file)) {
        let text = read_to_string(&file).unwrap();
        let lines = text.lines().filter(|line| assigns(line));
        found.extend(lines.map(|line| format!("{}: {}", file.display(), line.trim())));
    }
    assert!(found.is_empty(), "{found:#?}");
    for line in [
        "case.case.model.offsets = 4;",
        "few.case.input.model.offsets = Some(4);",
        "loaded.surfaces = other;",
        "half.case.model.boundary_friction *= 0.5;",
    ] {
        assert!(assigns(line), "{line}");
    }
    assert!(!assigns("let offsets = case.case.model.offsets;"));
}

/// What a caller cannot do without `DerefMut` or a public field no scan of lines has to find.
#[test]
fn the_types_of_a_case_have_no_public_field_and_are_not_borrowed_mutably() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/case/src");
    let text: String = sources(&root)
        .iter()
        .map(|file| read_to_string(file).unwrap())
        .collect();
    assert!(!text.contains("DerefMut"));
    for name in READ_ONLY {
        let at = text.find(&format!("pub struct {name}")).unwrap();
        let body = &text[at..at + text[at..].find("}\n").unwrap()];
        let body = body.split(";\n").next().unwrap();
        assert!(!body[10..].contains("pub "), "{body}");
    }
}

/// Words of what an earlier version wrote or called otherwise; before the first release there is none.
const OF_VERSIONS: [&str; 8] = [
    "former name",
    "former version",
    "earlier version",
    "earlier name",
    "older version",
    "older map",
    "older results",
    "in older ",
];

#[test]
fn no_source_speaks_of_versions_that_nobody_had() {
    let mut found = Vec::new();
    let mut versions = 0;
    for file in all_sources() {
        let text = read_to_string(&file).unwrap();
        versions += text.matches("const SCHEMA_VERSION").count();
        let lines = text.lines();
        let of_versions = lines.filter(|line| OF_VERSIONS.iter().any(|words| line.contains(words)));
        found.extend(of_versions.map(|line| format!("{}: {}", file.display(), line.trim())));
    }
    assert!(found.is_empty(), "{found:#?}");
    assert_eq!((versions, asperity::result::SCHEMA_VERSION), (1, 1));
}
