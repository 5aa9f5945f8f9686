//! Keys of the case file: those of the names in equations exist, and those of the model stay few.

use std::collections::BTreeSet;
use std::path::Path;

use asperity::CaseInput;

const LIST: &str = "../crates/case/src/text/key_names.rs";
/// Maximum number of keys of the table `model`.
const MOST_OF_MODEL: usize = 28;
/// Film thicknesses in the state of a mesh position: the smooth gap, and its mass flow.
const FILMS: [&str; 2] = ["gap", "mass_flow"];

fn source(name: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap()
}

/// What a comparison refuted is evidence, and no option.
#[test]
fn the_model_has_few_keys() {
    let page = source("../docs/CASE_FILE.md");
    let rows = page.lines().filter_map(|row| row.strip_prefix("| `model."));
    let keys: BTreeSet<&str> = rows
        .filter_map(|row| row.split(['.', '`']).next())
        .collect();
    assert!(
        keys.contains("load_share") && keys.len() <= MOST_OF_MODEL,
        "{keys:?}"
    );
}

#[test]
fn a_position_has_two_film_thicknesses() {
    let text = source("../crates/mixed-film/src/position_film.rs");
    let (_, fields) = text.split_once("pub struct PositionFilm<'a> {").unwrap();
    let (fields, _) = fields.split_once("\n}").unwrap();
    let films = fields
        .lines()
        .filter_map(|line| line.trim().strip_suffix(": Length,"));
    assert_eq!(films.collect::<Vec<_>>(), FILMS);
}

#[test]
fn every_key_of_a_row_is_a_key_of_the_case_file() {
    let text = source(LIST);
    let (_, rows) = text.split_once("const NAMES: &[Name] = &[\n").unwrap();
    let (rows, _) = rows.split_once("];").unwrap();
    let mut seen = 0;
    for row in rows.lines() {
        // ("gears", "helix angle", "gears.helix"),
        let words: Vec<&str> = row.split('"').skip(1).step_by(2).collect();
        let [_, _, key] = words[..] else {
            panic!("{row}")
        };
        let removed = CaseInput::default().unset(key);
        let is_unknown = removed.is_err_and(|error| error.code() == "E203");
        assert!(!is_unknown, "{row}");
        seen += 1;
    }
    assert!(seen >= 20, "only {seen} rows were read");
}
