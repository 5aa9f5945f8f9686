//! Hosted checks and the hosted page: what they use cannot be exchanged by others, and no fuzz target is forgotten.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use asperity_report::html::{policy, source};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

#[test]
fn every_action_is_pinned_by_its_commit() {
    let workflows = std::fs::read_dir(root().join(".github/workflows")).unwrap();
    let mut uses = 0;
    for file in workflows.map(|entry| entry.unwrap().path()) {
        let text = std::fs::read_to_string(&file).unwrap();
        for line in text.lines().filter_map(|line| line.split_once("uses: ")) {
            let (_, commit) = line.1.split_once('@').unwrap();
            let (commit, version) = commit.split_once(" # ").unwrap_or((commit, ""));
            let is_commit =
                commit.len() == 40 && commit.bytes().all(|byte| byte.is_ascii_hexdigit());
            assert!(
                is_commit && !version.is_empty(),
                "{}: {}",
                file.display(),
                line.1
            );
            uses += 1;
        }
    }
    assert!(uses > 20);
}

#[test]
fn the_ordinary_tests_check_arithmetic_and_the_nightly_ones_the_dense_solver() {
    let read = |name: &str| std::fs::read_to_string(root().join(name)).unwrap();
    let manifest: toml::Table = read("Cargo.toml").parse().unwrap();
    let dev = &manifest["profile"]["dev"];
    for key in ["overflow-checks", "debug-assertions"] {
        let is_on =
            |profile: &toml::Value| profile.get(key).is_none_or(|on| on.as_bool() == Some(true));
        let packages = dev["package"].as_table().unwrap();
        let ours = packages
            .iter()
            .filter(|(name, _)| name.starts_with("asperity"));
        assert!(is_on(dev), "{key}");
        assert!(ours.into_iter().all(|(_, package)| is_on(package)), "{key}");
    }
    let recipe =
        "\ntest-all:\n    cargo test --workspace --locked --features asperity-ehl/oracle\n";
    assert!(read("justfile").contains(recipe));
    let job = read(".github/workflows/nightly.yml");
    assert!(job.contains("run: just test-all\n") && !job.contains("CARGO_PROFILE"));
}

#[test]
fn every_fuzz_target_runs_every_night() {
    let job = std::fs::read_to_string(root().join(".github/workflows/nightly.yml")).unwrap();
    for folder in ["fuzz", "crates/profile-io/fuzz"] {
        let manifest = std::fs::read_to_string(root().join(folder).join("Cargo.toml")).unwrap();
        let manifest: toml::Table = manifest.parse().unwrap();
        let targets: BTreeSet<&str> = manifest["bin"]
            .as_array()
            .unwrap()
            .iter()
            .map(|bin| bin["name"].as_str().unwrap())
            .collect();
        let listed = |target: &&str| match folder {
            "fuzz" => job.contains(&format!("\n          - {target}\n")),
            _ => job.contains(&format!(
                "\n          - {{ folder: {folder}, target: {target} }}\n"
            )),
        };
        let missing: Vec<_> = targets.iter().filter(|target| !listed(target)).collect();
        assert!(missing.is_empty(), "{folder}: {missing:?}");
        let files = std::fs::read_dir(root().join(folder).join("fuzz_targets")).unwrap();
        let files = files.map(|entry| entry.unwrap().path());
        for file in files.filter(|file| file.file_stem() != Some("common".as_ref())) {
            let name = file.file_stem().unwrap().to_str().unwrap();
            assert!(targets.contains(name), "{folder}: {name} is no target");
        }
    }
}

#[test]
fn the_browser_page_runs_its_own_scripts_and_those_of_a_report() {
    let page = std::fs::read_to_string(root().join("crates/web/page/index.html")).unwrap();
    let inline = page.split("<script>").nth(1).unwrap();
    let inline = source(inline.split("</script>").next().unwrap());
    let report = policy();
    let of = |name: &str| {
        let directive = report.split("; ").find_map(|part| part.strip_prefix(name));
        directive.unwrap().trim().to_owned()
    };
    let scripts = format!(
        "script-src 'self' 'wasm-unsafe-eval' {inline} {};",
        of("script-src")
    );
    let styles = format!("style-src 'self' {};", of("style-src"));
    for directive in [scripts, styles] {
        assert!(page.contains(&directive), "index.html needs {directive}");
    }
}

/// The text after `before` to the end of the quoted value, in a file.
fn quoted_after(file: &str, before: &str) -> String {
    let text = std::fs::read_to_string(root().join(file)).unwrap();
    let (_, rest) = text
        .split_once(before)
        .unwrap_or_else(|| panic!("{file}: no {before}"));
    let end = rest.find(['"', '\n']).unwrap();
    rest[..end].to_owned()
}

#[test]
fn every_recipe_has_the_version_of_the_program() {
    let version = env!("CARGO_PKG_VERSION");
    for (file, before) in [
        ("crates/python/Cargo.toml", "\nversion = \""),
        ("crates/web/Cargo.toml", "\nversion = \""),
        ("CITATION.cff", "\nversion: "),
        ("packaging/conda/recipe.yaml", "\n  version: \""),
        ("packaging/homebrew/asperity.rb", "\n  version \""),
    ] {
        assert_eq!(quoted_after(file, before), version, "{file}");
    }
}

#[test]
fn the_address_of_the_repository_is_one_wherever_it_stands() {
    let stated = |file: &str| {
        let text = std::fs::read_to_string(root().join(file)).unwrap();
        let line = text.lines().find(|line| line.starts_with("repository = "));
        line.map(|line| line.split('"').nth(1).unwrap().to_owned())
    };
    let address = stated("Cargo.toml");
    assert_eq!(stated("crates/python/Cargo.toml"), address);
    // Until there is an address the recipes leave a place for the owner.
    let address = address.unwrap_or_else(|| "https://github.com/OWNER/asperity".to_owned());
    for file in [
        "packaging/conda/recipe.yaml",
        "packaging/homebrew/asperity.rb",
    ] {
        let text = std::fs::read_to_string(root().join(file)).unwrap();
        let found: Vec<&str> = text
            .match_indices("https://github.com/")
            .map(|(at, _)| &text[at..])
            .collect();
        assert!(
            !found.is_empty() && found.iter().all(|rest| rest.starts_with(&address)),
            "{file}"
        );
    }
}

#[test]
fn every_archive_that_a_recipe_takes_is_one_of_a_release() {
    let formula = std::fs::read_to_string(root().join("packaging/homebrew/asperity.rb")).unwrap();
    let workflow = std::fs::read_to_string(root().join(".github/workflows/release.yml")).unwrap();
    let archives = formula
        .lines()
        .filter_map(|line| line.split_once("/asperity-"));
    let targets: Vec<&str> = archives
        .filter_map(|(_, rest)| rest.split_once(".tar.gz").map(|(target, _)| target))
        .collect();
    assert_eq!(targets.len(), 4);
    for target in targets {
        assert!(workflow.contains(&format!("target: {target}")), "{target}");
    }
}
