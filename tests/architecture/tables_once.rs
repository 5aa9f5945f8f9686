//! Tables are described by `columns!`: one renderer writes heads of tables on pages, one aligns columns in the terminal. Intervals
//! are written by `Digits`.

use std::fs::read_to_string;
use std::path::Path;

use super::words::sources;

/// Head of a table on a page, as the one renderer writes it.
const HEAD: &str = "thead {";

/// Whether a line pads a value to a width, as an aligned row of a table does.
fn pads(line: &str) -> bool {
    let mut rest = line;
    while let Some(at) = rest.find('{') {
        rest = &rest[at + 1..];
        let Some(end) = rest.find(['{', '}', '"']) else {
            break;
        };
        let Some((_, form)) = rest[..end].split_once(':') else {
            continue;
        };
        let form = form.trim_start_matches(['<', '>', '^']);
        let width = form.split('.').next().unwrap_or_default();
        let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let is_number = width.starts_with(|c| ('1'..='9').contains(&c))
            && width.bytes().all(|c| c.is_ascii_digit());
        let is_named = width
            .strip_suffix('$')
            .is_some_and(|name| !name.is_empty() && name.chars().all(is_name));
        if rest.as_bytes()[end] == b'}' && (is_number || is_named) {
            return true;
        }
    }
    false
}

#[test]
fn tables_of_pages_and_of_the_terminal_are_described_once() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folders = std::fs::read_dir(root.join("crates")).unwrap();
    let folders = folders.map(|entry| entry.unwrap().path().join("src"));
    let (mut heads, mut padded, mut intervals) = (Vec::new(), Vec::new(), Vec::new());
    for folder in folders.chain([root.join("cli/src")]) {
        for file in sources(&folder) {
            let text = read_to_string(&file).unwrap();
            for (number, line) in text.lines().enumerate() {
                let line = line.trim_start();
                let place = format!("{}:{}: {line}", file.display(), number + 1);
                if line.contains(HEAD) {
                    heads.push(place);
                } else if !line.starts_with("//") && line.contains("}..{") {
                    intervals.push(place);
                } else if !line.starts_with("//") && pads(line) {
                    padded.push(place);
                }
            }
        }
    }
    assert_eq!(heads.len(), 1, "{heads:#?}");
    // `Digits` of the losses: an interval, and one with signs.
    let is_of_digits = |place: &String| place.contains("loss_band.rs");
    assert!(
        intervals.len() <= 2 && intervals.iter().all(is_of_digits),
        "{intervals:#?}"
    );
    // The bar of the progress, and the list of the commands.
    assert!(padded.len() <= 2, "{padded:#?}");
}

#[test]
fn a_padded_value_is_seen() {
    for line in [
        "{:>9.1} W",
        "{name:<11} loss",
        "{:24}",
        "{:width$}",
        "x {:^3} {:.2}",
    ] {
        assert!(pads(line), "{line}");
    }
    for line in [
        "{:.1}",
        "{value:.digits$}",
        "{:+.3}",
        "{name}",
        "{:?} 12",
        "{month:02}",
        "{value:.1e}",
        "a { b: 3 }",
    ] {
        assert!(!pads(line), "{line}");
    }
}
