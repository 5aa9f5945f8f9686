//! Functions that a reader sees whole.

use std::fs;
use std::path::Path;

use crate::words::sources;

/// Maximum number of lines of a function.
const MOST: usize = 100;

/// Functions of a source longer than `most` lines, with their lengths; tests are left out.
fn longer(source: &str, most: usize) -> Vec<(String, usize)> {
    let before_tests = source.split("#[cfg(test)]").next().unwrap_or_default();
    let lines: Vec<&str> = before_tests.lines().collect();
    let mut found = Vec::new();
    for (k, line) in lines.iter().enumerate() {
        let Some((before, after)) = line.split_once("fn ") else {
            continue;
        };
        let is_function = before.split_whitespace().all(is_qualifier);
        let name = after.split(|c: char| !c.is_alphanumeric() && c != '_');
        let (true, Some(name)) = (is_function, name.into_iter().next()) else {
            continue;
        };
        // rustfmt puts the last brace under the first letter.
        let indent = line.len() - line.trim_start().len();
        let end = format!("{}}}", " ".repeat(indent));
        let length = lines[k..].iter().position(|line| *line == end);
        if let Some(length) = length.filter(|length| length + 1 > most) {
            found.push((name.to_owned(), length + 1));
        }
    }
    found
}

fn is_qualifier(word: &str) -> bool {
    word.starts_with("pub")
        || ["const", "async", "unsafe", "extern", "super)", "crate)"].contains(&word)
}

#[test]
fn no_function_is_longer_than_a_reader_sees_at_once() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folders = fs::read_dir(root.join("crates")).unwrap();
    let folders = folders.map(|entry| entry.unwrap().path().join("src"));
    let mut found = Vec::new();
    for folder in folders
        .chain([root.join("cli/src")])
        .filter(|folder| folder.exists())
    {
        for path in sources(&folder) {
            let name = path.strip_prefix(&root).unwrap().display().to_string();
            let long = longer(&fs::read_to_string(&path).unwrap(), MOST);
            found.extend(
                long.into_iter()
                    .map(|(function, length)| format!("{name}: {function}, {length} lines")),
            );
        }
    }
    assert!(
        found.is_empty(),
        "above {MOST} lines:\n{}",
        found.join("\n")
    );
}

#[test]
fn a_long_function_is_found() {
    let source = "impl A {\n    pub(crate) fn b(\n        &self,\n    ) -> u8 {\n        1\n    }\n}\nfn c() {\n}\n";
    assert_eq!(longer(source, 4), [("b".to_owned(), 5)]);
    assert!(longer(source, 5).is_empty());
}
