//! The table of equations, the tags in the sources and the tests that prove them agree.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Every Rust source of the workspace with its path from the root.
fn sources() -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut folders: Vec<PathBuf> = ["crates", "cli", "fixtures", "tests"]
        .iter()
        .map(|name| root().join(name))
        .collect();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let name = path
                    .strip_prefix(root())
                    .unwrap()
                    .to_string_lossy()
                    .into_owned();
                found.push((name, fs::read_to_string(&path).unwrap()));
            }
        }
    }
    found
}

/// Tags of a source: `[P7]` at the end of a doc line, parted from the formula by two blanks.
fn tags(text: &str) -> BTreeSet<String> {
    text.lines()
        .map(str::trim)
        .filter(|line| line.starts_with("///") || line.starts_with("//!"))
        .filter_map(|line| {
            // Rustdoc would take a bare [P7] for a link, so most tags stand in backticks.
            let line = line.strip_suffix('`').unwrap_or(line);
            let (before, tag) = line.strip_suffix(']')?.rsplit_once('[')?;
            let before = before.strip_suffix('`').unwrap_or(before);
            let is_tag =
                !tag.is_empty() && tag.chars().all(|c| c.is_ascii_alphanumeric() || c == '-');
            (before.ends_with("  ") && is_tag).then(|| tag.to_owned())
        })
        .collect()
}

#[test]
fn every_row_points_at_a_tagged_formula_and_a_test_that_exist() {
    let sources = sources();
    for equation in asperity_calibration::equations::all() {
        let (_, text) = sources
            .iter()
            .find(|(name, _)| name == equation.file)
            .unwrap_or_else(|| panic!("{}: no file {}", equation.tag, equation.file));
        assert!(
            tags(text).contains(equation.tag),
            "{}: no doc line ending in [{}] in {}",
            equation.tag,
            equation.tag,
            equation.file
        );
        let definition = format!("fn {}(", equation.test);
        assert!(
            sources.iter().any(|(_, text)| text.contains(&definition)),
            "{}: no test {}",
            equation.tag,
            equation.test
        );
        // An equation of this project's own has no source.
        let of_the_paper = equation.tag.trim_start_matches('P').parse::<u32>().is_ok();
        assert!(
            !of_the_paper || !equation.references.is_empty(),
            "{}: no source",
            equation.tag
        );
    }
}

#[test]
fn every_tag_in_the_sources_has_a_row_and_no_row_is_double() {
    let rows: Vec<&str> = asperity_calibration::equations::all()
        .iter()
        .map(|e| e.tag)
        .collect();
    let unique: BTreeSet<&str> = rows.iter().copied().collect();
    assert_eq!(rows.len(), unique.len(), "a tag has two rows");
    for (name, text) in sources() {
        for tag in tags(&text) {
            assert!(unique.contains(tag.as_str()), "{name}: [{tag}] has no row");
        }
    }
}

#[test]
fn the_page_of_equations_is_what_the_program_prints() {
    let page = fs::read_to_string(root().join("docs/EQUATIONS.md")).unwrap();
    assert!(
        page == asperity::equations::markdown(&asperity_calibration::equations::all()),
        "docs/EQUATIONS.md is stale: run `asperity equations --markdown > docs/EQUATIONS.md`"
    );
}

/// Tags that a source notes while it runs, its tests left out.
fn cited(text: &str) -> BTreeSet<String> {
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    code.lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .filter_map(|line| line.split_once("cite!(\"")?.1.split_once('"'))
        .map(|(tag, _)| tag.to_owned())
        .collect()
}

/// Tags that the paper numbers and no function computes: equations that its velocities fulfil, assumptions, and
/// statements that are not used.
const NOT_COMPUTED: &[&str] = &[
    "P22", "P24", "P25", "P26", "P27", "P28", "P33", "P35", "P37",
];

#[test]
fn every_number_of_the_paper_has_a_row() {
    let rows: BTreeSet<&str> = asperity_calibration::equations::all()
        .iter()
        .map(|e| e.tag)
        .collect();
    for number in 1..=37 {
        assert!(rows.contains(format!("P{number}").as_str()), "P{number}");
    }
}

/// A function around a hot loop of another file may note the tags of that loop, so that only their rows
/// are asked of it.
#[test]
fn every_tagged_formula_notes_its_tag_when_it_runs_and_no_other() {
    let rows: BTreeSet<&str> = asperity_calibration::equations::all()
        .iter()
        .map(|e| e.tag)
        .collect();
    let mut missing = Vec::new();
    for (name, text) in sources() {
        let is_library = name.starts_with("crates/") && name.contains("/src/");
        // The file that defines the macro shows it on an example.
        if !is_library || name == "crates/core/src/provenance.rs" {
            continue;
        }
        let code = text.split("#[cfg(test)]").next().unwrap_or_default();
        let (tagged, cited) = (tags(code), cited(&text));
        for tag in tagged.difference(&cited) {
            if NOT_COMPUTED.contains(&tag.as_str()) {
                continue;
            }
            missing.push(format!("{name}: [{tag}] without cite!"));
        }
        for tag in cited.iter().filter(|tag| !rows.contains(tag.as_str())) {
            missing.push(format!("{name}: cite!(\"{tag}\") without a row"));
        }
    }
    missing.sort();
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}
