//! Arrows between the crates point down only, and the files of a crate import each other without circles.

mod embedded;
mod error_variants;
mod file_imports;
mod hosted;
mod key_names;
mod long_functions;
mod message_numbers;
mod one_way_to_run;
mod read_only;
mod shapes;
mod tables_once;
mod walk;
mod words;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Crates of the workspace that each crate may use. The physics crates stand apart from each other.
const ALLOWED: &[(&str, &[&str])] = &[
    ("crates/fourier", &[]),
    ("crates/core", &["asperity-fourier"]),
    ("crates/oil", &["asperity-core"]),
    ("crates/storage", &["asperity-core"]),
    ("crates/table", &["asperity-core", "asperity-storage"]),
    ("crates/rexs", &["asperity-core"]),
    ("crates/profile-io", &["asperity-core", "asperity-storage"]),
    ("crates/roughness", &["asperity-core"]),
    ("crates/gear", &["asperity-core"]),
    ("crates/contact", &["asperity-core"]),
    (
        "crates/ehl",
        &["asperity-core", "asperity-oil", "asperity-contact"],
    ),
    ("crates/ehl-regime", &["asperity-core", "asperity-oil"]),
    ("crates/tribo-friction", &["asperity-core", "asperity-oil"]),
    ("crates/ns-film", &["asperity-core"]),
    ("crates/efficiency", &["asperity-core"]),
    (
        "crates/mixed-film",
        &[
            "asperity-core",
            "asperity-contact",
            "asperity-ehl-regime",
            "asperity-oil",
            "asperity-roughness",
            "asperity-tribo-friction",
        ],
    ),
    (
        "crates/flanks",
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
            "asperity-mixed-film",
            "asperity-efficiency",
            "asperity-oil",
        ],
    ),
    (
        "crates/case",
        &[
            "asperity-flanks",
            "asperity-core",
            "asperity-oil",
            "asperity-profile-io",
            "asperity-roughness",
            "asperity-gear",
            "asperity-contact",
            "asperity-ehl",
            "asperity-ehl-regime",
            "asperity-tribo-friction",
            "asperity-ns-film",
            "asperity-mixed-film",
            "asperity-efficiency",
            "asperity-table",
            "asperity-storage",
        ],
    ),
    (
        "crates/uncertainty",
        &[
            "asperity-core",
            "asperity-oil",
            "asperity-ehl-regime",
            "asperity-tribo-friction",
            "asperity-mixed-film",
            "asperity-case",
        ],
    ),
    (
        "crates/asperity",
        &[
            "asperity-core",
            "asperity-oil",
            "asperity-profile-io",
            "asperity-roughness",
            "asperity-gear",
            "asperity-contact",
            "asperity-ehl",
            "asperity-ehl-regime",
            "asperity-tribo-friction",
            "asperity-ns-film",
            "asperity-mixed-film",
            "asperity-efficiency",
            "asperity-storage",
            "asperity-case",
            "asperity-uncertainty",
        ],
    ),
    (
        "crates/report",
        &[
            "asperity-table",
            "asperity-storage",
            "asperity",
            "asperity-core",
            "asperity-roughness",
        ],
    ),
    (
        "crates/studies",
        &[
            "asperity-table",
            "asperity-storage",
            "asperity-report",
            "asperity",
            "asperity-core",
            "asperity-roughness",
        ],
    ),
    (
        "crates/paper-2022",
        &[
            "asperity-storage",
            "asperity-report",
            "asperity",
            "asperity-core",
            "asperity-roughness",
            "asperity-gear",
            "asperity-contact",
            "asperity-ehl-regime",
            "asperity-ns-film",
            "asperity-tribo-friction",
            "asperity-efficiency",
        ],
    ),
    (
        "crates/calibration",
        &[
            "asperity-table",
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
            "asperity-paper-2022",
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

/// The Python module, outside of the workspace: it passes on the results of the libraries, and runs the command.
const OF_THE_MODULE: &[&str] = &[
    "asperity",
    "asperity-calibration",
    "asperity-cli",
    "asperity-fixtures",
    "asperity-paper-2022",
    "asperity-report",
    "asperity-rexs",
    "asperity-storage",
    "asperity-studies",
];

/// The page, outside of the workspace: the same job as that of the command, in a browser.
const OF_THE_PAGE: &[&str] = &[
    "asperity",
    "asperity-calibration",
    "asperity-paper-2022",
    "asperity-report",
    "asperity-rexs",
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

/// Crates of the workspace that a crate reaches by what it and its tests depend on.
fn reached_by(package: &str) -> BTreeSet<String> {
    let folders = ALLOWED.iter().map(|(folder, _)| *folder);
    let manifests: BTreeMap<String, toml::Table> = folders
        .map(manifest)
        .map(|one| (one["package"]["name"].as_str().unwrap().to_owned(), one))
        .collect();
    let (mut found, mut open) = (BTreeSet::new(), vec![package.to_owned()]);
    while let Some(name) = open.pop() {
        for section in ["dependencies", "dev-dependencies", "build-dependencies"] {
            let used = manifests[&name]
                .get(section)
                .and_then(toml::Value::as_table);
            let used = used.into_iter().flat_map(|used| used.keys());
            let ours = used.filter(|used| manifests.contains_key(*used));
            open.extend(ours.filter(|used| found.insert((*used).clone())).cloned());
        }
    }
    found
}

/// Compiled and tested, each of these crates has nothing of the 2022 paper's formulation: the programs register it.
#[test]
fn only_programs_reach_the_formulation_of_the_paper() {
    const PAPER: &str = "asperity-paper-2022";
    let programs = ["cli", "crates/paper-2022"];
    let mut without = 0;
    for (folder, _) in ALLOWED {
        let package = manifest(folder)["package"]["name"]
            .as_str()
            .unwrap()
            .to_owned();
        let reached = reached_by(&package);
        if programs.contains(folder) {
            assert!(reached.contains("asperity"), "{folder}");
            continue;
        }
        without += 1;
        assert!(!reached.contains(PAPER), "{folder} reaches {PAPER}");
    }
    assert_eq!(without, ALLOWED.len() - programs.len());
    assert!(reached_by("asperity-cli").contains(PAPER));
    // What the library reaches is found by way of others.
    assert!(reached_by("asperity-studies").contains("asperity-fourier"));
}

/// Whether the crate in `folder` uses these of ours, stands outside of the workspace and has its version.
fn stands_outside(folder: &str, on: &[&str]) -> toml::Table {
    let outside = manifest(folder);
    let used = outside["dependencies"].as_table().unwrap().keys();
    let ours: Vec<&str> = used
        .map(String::as_str)
        .filter(|name| name.starts_with("asperity"))
        .collect();
    assert_eq!(ours, on, "{folder}");
    let workspace = &manifest(".")["workspace"];
    let excluded = workspace["exclude"].as_array().unwrap();
    assert!(excluded.iter().any(|each| each.as_str() == Some(folder)));
    let version = &workspace["package"]["version"];
    assert_eq!(&outside["package"]["version"], version, "{folder}");
    outside
}

#[test]
fn the_python_module_stands_on_the_libraries_and_outside_of_the_workspace() {
    let module = stands_outside("crates/python", OF_THE_MODULE);
    // A wheel is linked as the programs of a release are, and made small by its levels of optimisation.
    let profiles = &manifest(".")["profile"];
    for key in ["lto", "codegen-units", "strip"] {
        let stated = profiles["dist"].get(key);
        let stated = stated.unwrap_or_else(|| &profiles["release"][key]);
        assert_eq!(&module["profile"]["release"][key], stated, "{key}");
    }
}

#[test]
fn the_benches_are_built_as_the_program() {
    let benches = manifest("benches");
    let mut release = manifest(".")["profile"]["release"].clone();
    let lock = Path::new(env!("CARGO_MANIFEST_DIR")).join("../benches/Cargo.lock");
    let lock = std::fs::read_to_string(lock).unwrap();
    let levels = release["package"].as_table_mut().unwrap();
    levels.retain(|name, _| lock.contains(&format!("name = \"{name}\"\n")));
    assert_eq!(benches["profile"]["release"], release);
}

#[test]
fn the_page_stands_on_the_libraries_and_outside_of_the_workspace() {
    stands_outside("crates/web", OF_THE_PAGE);
    let versions = |folder: &str| -> BTreeMap<String, BTreeSet<String>> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("..")
            .join(folder);
        let lock = std::fs::read_to_string(path.join("Cargo.lock")).unwrap();
        let lock: toml::Table = lock.parse().unwrap();
        let mut found = BTreeMap::<_, BTreeSet<_>>::new();
        for package in lock["package"].as_array().unwrap() {
            let text = |key: &str| package[key].as_str().unwrap().to_owned();
            found
                .entry(text("name"))
                .or_default()
                .insert(text("version"));
        }
        found
    };
    // The numbers of both come from the same code.
    let (of_page, of_command) = (versions("crates/web"), versions("."));
    for name in ["realfft", "rustfft", "libm", "rayon", "toml", "serde_json"] {
        assert_eq!(of_page[name], of_command[name], "{name}");
    }
    let page = manifest("crates/web");
    let build = manifest("crates/web/build");
    assert_eq!(
        page["dependencies"]["wasm-bindgen"],
        build["dependencies"]["wasm-bindgen-cli-support"]
    );
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

/// Largest number of layers of the modules at the top of crates in which a case becomes a result.
const LAYERS: &[(&str, usize)] = &[
    ("crates/flanks", 8),
    ("crates/case", 9),
    ("crates/asperity", 15),
];

#[test]
fn the_modules_of_a_crate_are_layers() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for (folder, most) in LAYERS {
        let layers = file_imports::layers(&root.join(folder).join("src"));
        let count = layers.longest.len();
        println!(
            "{folder}: {count} layers, {} upward imports",
            layers.upward.len()
        );
        assert!(layers.upward.is_empty(), "{folder}: {:?}", layers.upward);
        assert!(count <= *most, "{folder}: {}", layers.longest.join(" -> "));
    }
}

#[test]
fn a_library_without_a_program_of_its_tests_has_none_in_its_sources() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut without = 0;
    for (folder, _) in ALLOWED {
        let manifest = manifest(folder);
        let library = manifest.get("lib").and_then(|library| library.get("test"));
        if library.and_then(toml::Value::as_bool) != Some(false) {
            continue;
        }
        without += 1;
        for path in words::sources(&root.join(folder).join("src")) {
            let text = std::fs::read_to_string(&path).unwrap();
            assert!(
                !text.contains("#[cfg(test)]"),
                "{} never runs",
                path.display()
            );
        }
    }
    assert!(without > 4, "{without}");
}

#[test]
fn every_crate_has_a_readme_and_an_example() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for (folder, _) in ALLOWED {
        if !folder.starts_with("crates/") {
            continue;
        }
        let folder = root.join(folder);
        let readme = std::fs::read_to_string(folder.join("README.md")).unwrap();
        assert!(
            !readme.contains("](..") && !readme.contains("](examples"),
            "{}: a registry has no other files of the repository",
            folder.display()
        );
        // The front page of the documentation has an example, its own or that of the README, of the crate or of the command.
        let front = std::fs::read_to_string(folder.join("src/lib.rs")).unwrap();
        let is_page = |line: &&str| line.starts_with("//!") || line.starts_with("#![doc");
        let page: Vec<&str> = front.lines().filter(is_page).collect();
        let has_readme = page.iter().any(|line| line.contains("../README.md"));
        assert!(
            page.contains(&"//! ```") || has_readme && readme.contains("```"),
            "{}: no example on the front page",
            folder.display()
        );
        let examples = std::fs::read_dir(folder.join("examples"));
        assert!(
            examples.is_ok_and(|mut files| files.next().is_some()),
            "{} has no example",
            folder.display()
        );
    }
}

#[test]
fn every_package_has_the_files_of_its_licences() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let outside = ["crates/python", "crates/web"];
    let folders = ALLOWED.iter().map(|(folder, _)| *folder).chain(outside);
    for folder in folders.filter(|folder| *folder != "tests") {
        for name in ["LICENSE-MIT", "LICENSE-APACHE"] {
            let text = std::fs::read(root.join(name)).unwrap();
            let own = std::fs::read(root.join(folder).join(name));
            assert!(own.is_ok_and(|own| own == text), "{folder}/{name}");
        }
    }
}

#[test]
fn the_dense_reference_solver_is_behind_a_feature() {
    {
        let folder = "crates/ehl";
        let package = manifest(folder);
        let faer = package["dependencies"]["faer"].as_table().unwrap();
        assert_eq!(faer["optional"].as_bool(), Some(true), "{folder}");
        let features = package["features"].as_table().unwrap();
        let of_oracle = features["oracle"].as_array().unwrap();
        let is_faer = |name: &toml::Value| name.as_str() == Some("dep:faer");
        assert!(of_oracle.iter().any(is_faer), "{folder}");
        let default = features.get("default").and_then(toml::Value::as_array);
        assert!(default.is_none_or(Vec::is_empty), "{folder}");
        let for_tests = package["dev-dependencies"].as_table().unwrap();
        assert!(!for_tests.contains_key("asperity-ehl"), "{folder}");
    }
}

/// Every crate says who uses it and what it does not know; the crates that it names use it.
#[test]
fn a_crate_names_its_callers_and_what_it_does_not_know() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let package = |folder: &str| {
        manifest(folder)["package"]["name"]
            .as_str()
            .unwrap()
            .to_owned()
    };
    for (folder, _) in ALLOWED
        .iter()
        .filter(|(folder, _)| folder.starts_with("crates/"))
    {
        let pages = ["src/lib.rs", "README.md"].map(|page| root.join(folder).join(page));
        let texts = pages.map(|page| std::fs::read_to_string(page).unwrap_or_default());
        let mut lines = texts.iter().flat_map(|text| text.lines());
        let said = lines.find_map(|line| {
            let (callers, rest) = line.split_once("It is used by ")?.1.split_once(". ")?;
            rest.contains("It does not know ").then_some(callers)
        });
        let said = said.unwrap_or_else(|| panic!("{folder}: who uses it, what does it not know?"));
        let name = package(folder);
        for caller in said.split('`').skip(1).step_by(2) {
            let of = match caller {
                "cli" => caller.to_owned(),
                _ => format!("crates/{caller}"),
            };
            let uses = manifest(&of)["dependencies"]
                .as_table()
                .unwrap()
                .contains_key(&name);
            let passed_on = folder == &"crates/flanks" && caller == "asperity";
            assert!(uses || passed_on, "{of} does not use {name}");
        }
    }
}
