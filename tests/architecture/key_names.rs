//! The list of keys for the names in equations has keys of the case file only.

use std::path::Path;

use asperity::CaseInput;

const LIST: &str = "../crates/case/src/text/key_names.rs";

#[test]
fn every_key_of_a_row_is_a_key_of_the_case_file() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join(LIST);
    let text = std::fs::read_to_string(source).unwrap();
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
