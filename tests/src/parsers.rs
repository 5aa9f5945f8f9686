//! Property of every parser, whatever it is given: it returns a value without fault, or refuses with a code.
//!
//! The fuzz targets in `fuzz/` and their deterministic twins in `tests/cli/mutated.rs` call the same functions.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use asperity::case::{self, LoadedCase, Source};
use asperity::result::RunResult;
use asperity_core::quantity::{
    Angle, AngularSpeed, Density, DynamicViscosity, KinematicViscosity, Length, LineLoad,
    PerKelvin, Pressure, PressureViscosity, Quantity, Speed, Temperature, Torque,
};
use asperity_report::{PageTables, StudyResult, html};
use asperity_roughness::generate::Recipe;
use asperity_storage::{check_folder, replace_folder, save};
use asperity_studies::compare::Finish;
use asperity_studies::cycle;
use asperity_studies::map::{self, Axes, MapBand};
use asperity_studies::sweep::{Cases, Study};
use tempfile::TempDir;

/// A trace for every file that a case names.
fn trace() -> Vec<u8> {
    let wave = |i: i32| format!("{:.4}\n", (f64::from(i) * 0.7).sin());
    (0..2500).map(wave).collect::<String>().into_bytes()
}

/// Every quantity reads a text to a finite value that is printed and read again to itself, or refuses it.
///
/// # Panics
/// When it does neither.
pub fn units(text: &str) -> bool {
    fn same<Q: Quantity + std::str::FromStr + std::fmt::Display>(text: &str) -> bool {
        let Ok(read) = text.parse::<Q>() else {
            return false;
        };
        assert!(read.si().is_finite(), "{text:?} is {}", read.si());
        let printed = read.to_string();
        let again = printed.parse::<Q>().ok();
        let off = again.map(|again| (again.si() - read.si()).abs());
        // A degree Celsius is printed from kelvins.
        let rounding = 1e-12 * read.si().abs() + f64::MIN_POSITIVE;
        assert!(
            off.is_some_and(|off| off <= rounding),
            "{text:?} prints as {printed:?}"
        );
        true
    }
    [
        same::<Length>(text),
        same::<Pressure>(text),
        same::<Torque>(text),
        same::<Speed>(text),
        same::<AngularSpeed>(text),
        same::<Angle>(text),
        same::<Temperature>(text),
        same::<LineLoad>(text),
        same::<Density>(text),
        same::<DynamicViscosity>(text),
        same::<KinematicViscosity>(text),
        same::<PressureViscosity>(text),
        same::<PerKelvin>(text),
    ]
    .contains(&true)
}

/// A case text loads, or is refused with a code that is explained.
///
/// # Panics
/// When the code is not.
pub fn case(name: &str, text: &str) -> bool {
    match case::from_text(name, text, &|_| Ok(trace())) {
        Ok(loaded) => {
            assert!(loaded.case.model.positions > 0);
            true
        }
        Err(error) => {
            assert!(!error.to_string().is_empty());
            false
        }
    }
}

/// The text of a planetary case loads, or is refused with codes that are explained, each told once. No file is
/// opened: the flanks are known by their values.
///
/// # Panics
/// When an error has no text.
pub fn planetary_case(text: &str) -> bool {
    let Ok(source) = Source::new("set.toml", text) else {
        return false;
    };
    let names_files = source
        .key_paths()
        .any(|key| key.ends_with("file") || key.ends_with("xu"));
    if names_files {
        return false;
    }
    let found = case::check(source, "".as_ref(), &[]);
    assert_eq!(found.case.is_some(), found.errors.is_empty());
    for error in &found.errors {
        assert!(!error.to_string().is_empty());
    }
    found.case.is_some()
}

/// A result is read and drawn as a page that prints no number that is none, or refused.
///
/// # Panics
/// When the page prints one.
pub fn result(bytes: &[u8]) -> bool {
    let Ok(result) = serde_json::from_slice::<RunResult>(bytes) else {
        return false;
    };
    let tables = PageTables {
        flanks: [None, None],
        load_map: Vec::new(),
        contact: None,
        views: Vec::new(),
        file: None,
    };
    is_drawn(&result, &tables)
}

/// Whether a page is drawn rather than refused.
fn is_drawn(result: &RunResult, tables: &PageTables) -> bool {
    let Ok(page) = html::render(result, tables) else {
        return false;
    };
    let printed = page.split("<script").next().unwrap_or_default();
    for none in [">NaN", "NaN ", ">inf", " inf "] {
        assert!(!printed.contains(none), "the page prints {none:?}");
    }
    true
}

/// A small case without traces.
const SMALL_CASE: &str = r#"
    title = "small case"
    gears = { teeth = [23, 68], module = "1.8 mm", helix = "23.4 deg", face_width = "32 mm" }
    material = { pinion = { elastic_limit = "1500 MPa", flow_pressure = "7 GPa" } }
    operation = { torque = "145 N m", speed = "9000 1/min", bulk_temperature = "90 °C" }
    lubricant = { oil = "m100" }
    surface = { cutoff = "0.25 mm", pinion = { file = "pinion.csv", dx = "0.5 um", z_unit = "um" }, wheel = { file = "wheel.csv", dx = "0.5 um", z_unit = "um" } }
    model = { positions = 3, offsets = 2, depths = 4 }
"#;

fn small_case() -> LoadedCase {
    let height = |i: f64| 0.2 * (0.07 * i).sin() + 0.1 * (0.17 * i).sin();
    let rows = (0..4000).map(|i| format!("{:.5}\n", height(f64::from(i))));
    let trace = rows.collect::<String>().into_bytes();
    case::from_text("case.toml", SMALL_CASE, &|_| Ok(trace.clone())).unwrap()
}

/// The same gears with flanks that are known by their values.
fn small_case_without_traces() -> LoadedCase {
    // Its surrogates take a hundred times as long as a text that is refused.
    static CASE: OnceLock<LoadedCase> = OnceLock::new();
    CASE.get_or_init(read_small_case_without_traces).clone()
}

fn read_small_case_without_traces() -> LoadedCase {
    let flanks = "surface = { pinion = { rq = \"0.3 um\" }, wheel = { rq = \"0.3 um\" } }";
    let lines = SMALL_CASE.lines().map(|line| {
        if line.trim_start().starts_with("surface") {
            flanks
        } else {
            line
        }
    });
    let text = lines.collect::<Vec<_>>().join("\n");
    let missing = |_: &str| Err(std::io::ErrorKind::NotFound.into());
    case::from_text("case.toml", &text, &missing).unwrap()
}

/// A result of the small case, and the bytes of its `page.json`.
fn small_result() -> &'static (RunResult, Vec<u8>) {
    static RESULT: OnceLock<(RunResult, Vec<u8>)> = OnceLock::new();
    RESULT.get_or_init(|| {
        let outcome = asperity::Run::new(&small_case())
            .execute()
            .unwrap()
            .into_only()
            .unwrap();
        let files = asperity_report::texts(&outcome).unwrap();
        let page = files.into_iter().find(|(name, _)| *name == "page.json");
        (outcome.result, page.unwrap().1)
    })
}

/// The text of a `page.json` that is drawn.
pub fn page_seed() -> String {
    String::from_utf8(small_result().1.clone()).unwrap()
}

/// The thinned tables of a page are read and drawn, or refused.
///
/// # Panics
/// When the page prints a number that is none.
pub fn page(bytes: &[u8]) -> bool {
    let Ok(tables) = serde_json::from_slice::<PageTables>(bytes) else {
        return false;
    };
    is_drawn(&small_result().0, &tables)
}

/// The folder of a map of the small case.
fn small_map() -> &'static TempDir {
    static MAP: OnceLock<TempDir> = OnceLock::new();
    MAP.get_or_init(|| {
        let finish = Finish {
            name: "ground".to_owned(),
            case: small_case(),
        };
        let axes = Axes::new(&[-100.0, 145.0], &[9000.0], &[90.0]).unwrap();
        let found = map::map(&[finish], &axes, MapBand::None, &|_, _| ()).unwrap();
        let place = tempfile::tempdir().unwrap();
        found.write(&place.path().join("map")).unwrap();
        place
    })
}

/// The text of a `map.json` that is read.
pub fn map_seed() -> String {
    std::fs::read_to_string(small_map().path().join("map/map.json")).unwrap()
}

/// A `map.json` beside the table of a map is read, drawn, and gives the energy of a cycle, or is refused.
///
/// # Panics
/// When a refusal says nothing.
pub fn map_json(bytes: &[u8]) -> bool {
    let place = tempfile::tempdir().unwrap();
    let table = small_map().path().join("map/map.csv");
    let files = [
        ("map.csv".to_owned(), std::fs::read(table).unwrap()),
        ("map.json".to_owned(), bytes.to_vec()),
    ];
    // With the manifest of these bytes: damage that the sums would reveal reaches the checks behind them.
    asperity_storage::write_among(place.path(), &files).unwrap();
    let found = match map::read(place.path()) {
        Ok(found) => found,
        Err(error) => {
            assert!(!error.to_string().is_empty());
            return false;
        }
    };
    assert!(!found.summary().is_empty());
    let table = "time_s,torque_nm,speed_rpm\n0,100,2000\n1,120,8000\n2,-50,3000\n";
    let cycle = cycle::cycle(table, None).unwrap();
    let _ = cycle::evaluate(&found.clone().into(), 0, &cycle, "cycle", true);
    let _ = found.write(&place.path().join("drawn"));
    true
}

/// The text of a study is read to a list of cases whose places can be named, or is refused.
///
/// # Panics
/// When a refusal says nothing.
pub fn study(text: &str) -> bool {
    let Ok(input) = toml::from_str::<serde_json::Value>(text) else {
        return false;
    };
    let place = tempfile::tempdir().unwrap();
    std::fs::write(
        place.path().join("list.csv"),
        "operation.torque [N m]\n100\n120\n",
    )
    .unwrap();
    let study = Study::of_case(
        small_case_without_traces(),
        &input.to_string(),
        place.path(),
    );
    match study.and_then(Cases::new) {
        Ok(cases) => {
            assert!(cases.count() > 0 && !cases.header().is_empty());
            true
        }
        Err(error) => {
            assert!(!error.to_string().is_empty());
            false
        }
    }
}

/// A recipe of a synthetic profile is read and, where it is small, generated to finite heights, or refused.
///
/// # Panics
/// When a height is not finite, or a refusal says nothing.
pub fn recipe(bytes: &[u8]) -> bool {
    let Ok(recipe) = serde_json::from_slice::<Recipe>(bytes) else {
        return false;
    };
    match recipe.generate() {
        Ok(made) => {
            assert!(
                made.profile
                    .heights()
                    .iter()
                    .all(|height| height.is_finite())
            );
            true
        }
        Err(error) => {
            assert!(!error.to_string().is_empty());
            false
        }
    }
}

/// Every file below `folder` with its content; links are not followed.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        let (path, kind) = (entry.path(), entry.file_type().unwrap());
        match (kind.is_dir(), kind.is_symlink()) {
            (true, _) => found.extend(files(&path)),
            (_, true) => drop(found.insert(path, b"link".to_vec())),
            _ => {
                let bytes = std::fs::read(&path).unwrap();
                found.insert(path, bytes);
            }
        }
    }
    found
}

/// Text of the lock of a draft whose process ended.
const LOCK: &str = "asperity draft of process 1\n";

/// Files around a folder that is written, each `mine`.
const AROUND: [&str; 4] = [
    "victim.txt",
    "box/victim.txt",
    "box/precious/a.txt",
    "box/sub/a.txt",
];

fn around() -> TempDir {
    let place = tempfile::tempdir().unwrap();
    for name in AROUND {
        let file = place.path().join(name);
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(file, "mine").unwrap();
    }
    place
}

/// Checks that nothing around the folder changed.
fn is_untouched(place: &TempDir) {
    for name in AROUND {
        let found = std::fs::read(place.path().join(name)).ok();
        assert_eq!(
            found.as_deref(),
            Some(&b"mine"[..]),
            "{name} is gone or changed"
        );
    }
}

/// Whatever its manifest says, writing a folder anew changes nothing outside of it: with the manifest in the folder
/// itself, in the draft of a dead process and in an older folder that was moved aside.
///
/// # Panics
/// When something else changes.
pub fn manifest(bytes: &[u8]) -> bool {
    let place = around();
    let at = |name: &str| place.path().join("box").join(name);
    for folder in ["result", ".asperity-abc123/new", ".asperity-abc123/old"] {
        std::fs::create_dir_all(at(folder)).unwrap();
        std::fs::write(at(folder).join("a.txt"), "mine").unwrap();
        std::fs::write(at(folder).join("manifest.json"), bytes).unwrap();
        #[cfg(unix)]
        if folder != "result" {
            std::os::unix::fs::symlink(at("precious"), at(folder).join("link")).unwrap();
        }
    }
    std::fs::write(at(".asperity-abc123/lock"), LOCK).unwrap();
    std::fs::write(at(".asperity-abc123/journal"), "sub").unwrap();
    let before = files(&at("result"));
    let written = replace_folder(&at("result"), "result", |made| {
        save(&made.join("b.txt"), b"new")
    });
    is_untouched(&place);
    if written.is_err() {
        assert_eq!(files(&at("result")), before, "a refusal changes nothing");
    }
    written.is_ok()
}

/// Whatever the journal of a dead process says, clearing up after it changes nothing outside of its draft but gives the
/// older folder a name that is free beside it.
///
/// # Panics
/// When something else changes.
pub fn journal(bytes: &[u8]) -> bool {
    let place = around();
    let draft = place.path().join("box/.asperity-abc123");
    std::fs::create_dir_all(draft.join("old")).unwrap();
    std::fs::write(draft.join("old/a.txt"), "mine").unwrap();
    std::fs::write(draft.join("lock"), LOCK).unwrap();
    std::fs::write(draft.join("journal"), bytes).unwrap();
    let before = files(place.path());
    let _ = check_folder(&place.path().join("box/result"), "result");
    is_untouched(&place);
    let after = files(place.path());
    // Its only file is where it was, or in a folder beside the draft.
    let moved: Vec<&PathBuf> = after
        .keys()
        .filter(|path| !before.contains_key(*path))
        .collect();
    match moved.as_slice() {
        [] => false,
        [file] => {
            let folder = file.parent().unwrap();
            assert_eq!(folder.parent(), draft.parent(), "{file:?}");
            assert_eq!(after[*file], b"mine");
            true
        }
        more => panic!("{more:?}"),
    }
}
