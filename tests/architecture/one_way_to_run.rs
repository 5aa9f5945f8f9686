//! One way to run a case, and one way to a thread.

use std::fs::read_to_string;
use std::path::Path;

use super::read_only::all_sources;

/// What a run of a case returns.
const RUNS: [&str; 5] = ["Outcome", "MeshOutcome", "TrainLosses", "Losses", "MeshRun"];

/// The public functions of a source that return a run: the type that they belong to, their names, and whether they take a value.
fn runs_of(text: &str) -> Vec<(String, String)> {
    let mut of = String::new();
    let mut found = Vec::new();
    let lines: Vec<&str> = text.lines().collect();
    for (k, line) in lines.iter().enumerate() {
        if let Some(header) = line.strip_prefix("impl") {
            let name = header.rsplit(" for ").next().unwrap();
            let name = name.trim_start_matches(|c: char| c != ' ').trim_start();
            let end = name
                .find(|c: char| !c.is_alphanumeric())
                .unwrap_or(name.len());
            of = name[..end].to_owned();
        } else if *line == "}" {
            of.clear();
        }
        let Some(name) = line.trim_start().strip_prefix("pub fn ") else {
            continue;
        };
        let signature: Vec<&str> = (lines[k..].iter())
            .map(|line| line.trim())
            .take_while(|line| !line.is_empty())
            .scan(false, |ended, line| {
                let goes_on = !*ended;
                *ended = line.ends_with('{') || line.ends_with(';');
                goes_on.then_some(line)
            })
            .collect();
        let signature = signature.join(" ");
        let Some((_, returned)) = signature.rsplit_once(" -> ") else {
            continue;
        };
        let mut words = returned.split(|c: char| !c.is_alphanumeric());
        if words.any(|word| RUNS.contains(&word)) {
            let end = name.find(['(', '<']).unwrap();
            found.push((of.clone(), name[..end].to_owned()));
        }
    }
    found
}

#[test]
fn a_case_runs_by_one_builder() {
    let mut found = Vec::new();
    for file in all_sources() {
        let text = read_to_string(&file).unwrap();
        // Values of a run that was made are no entry.
        let of_runs = runs_of(&text).into_iter();
        found.extend(of_runs.filter(|(of, _)| !RUNS.contains(&of.as_str())));
    }
    let names: Vec<(&str, &str)> = (found.iter())
        .map(|(of, name)| (of.as_str(), name.as_str()))
        .collect();
    assert_eq!(names, [("Run", "execute"), ("Run", "losses")]);
    let other = "pub fn run(\n    case: &Case,\n) -> Result<Outcome, Error> {\n}\n";
    assert_eq!(runs_of(other).len(), 1);
}

#[test]
fn only_a_task_has_thread_locals_that_carry_results_or_control() {
    /// Memory that a thread keeps for speed alone, and what a page and Python tell the thread of their work.
    const SCRATCH: [&str; 5] = [
        "crates/contact/src/solver/mod.rs",
        "crates/ehl-regime/src/attenuation.rs",
        "crates/mixed-film/src/rough_contact.rs",
        "crates/python/src/work.rs",
        "crates/web/src/bindings.rs",
    ];
    let mut found = Vec::new();
    for file in all_sources() {
        let text = read_to_string(&file).unwrap();
        let Some((_, block)) = text.split_once("thread_local! {") else {
            continue;
        };
        let name = file.to_string_lossy().replace("/tests/../", "/");
        if !SCRATCH.iter().any(|known| name.ends_with(known)) {
            let block = block.split("\n}").next().unwrap();
            found.push((name, block.matches("static ").count()));
        }
    }
    let [(file, statics)] = &found[..] else {
        panic!("{found:?}");
    };
    assert!(file.ends_with("crates/core/src/task.rs"), "{file}");
    assert_eq!(*statics, 2);
}

/// Crates that compute have no other way to a thread than `asperity_core::task`: they do not depend on rayon.
#[test]
fn crates_that_compute_reach_threads_by_a_task_alone() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = Vec::new();
    for entry in std::fs::read_dir(root.join("crates")).unwrap() {
        let manifest = entry.unwrap().path().join("Cargo.toml");
        let text = read_to_string(&manifest).unwrap();
        let table: toml::Table = text.parse().unwrap();
        if table["dependencies"].get("rayon").is_some() {
            found.push(table["package"]["name"].as_str().unwrap().to_owned());
        }
    }
    found.sort();
    // Python makes pools of its own.
    assert_eq!(found, ["asperity-core", "asperity-python"]);
}
