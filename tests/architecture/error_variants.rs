//! An error has a variant of an enum where a caller branches on it; other errors are constructors of a fault.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::words::sources;

/// Variants of errors that no other file matches. The number may only fall.
const MOST_UNMATCHED: usize = 35;

/// Index behind the bracket that closes the one at `start`; strings and comments are skipped.
fn closed(text: &str, start: usize) -> usize {
    let bytes = text.as_bytes();
    let (mut at, mut depth) = (start, 0);
    while at < bytes.len() {
        match bytes[at] {
            b'"' => {
                at += 1;
                while at < bytes.len() && bytes[at] != b'"' {
                    at += if bytes[at] == b'\\' { 2 } else { 1 };
                }
            }
            b'/' if bytes.get(at + 1) == Some(&b'/') => {
                at += text[at..].find('\n').unwrap_or(0);
            }
            b'{' | b'(' | b'[' => depth += 1,
            b'}' | b')' | b']' => {
                depth -= 1;
                if depth == 0 {
                    return at + 1;
                }
            }
            _ => {}
        }
        at += 1;
    }
    bytes.len()
}

/// Names of the variants in the `body` of an enum.
fn variants(body: &str) -> Vec<String> {
    let mut names = Vec::new();
    let mut at = 0;
    while at < body.len() {
        let rest = &body[at..];
        let Some(first) = rest.chars().next() else {
            break;
        };
        if rest.starts_with("//") {
            at += rest.find('\n').unwrap_or(rest.len());
        } else if first == '#' {
            at = closed(body, at + 1);
        } else if first.is_ascii_uppercase() {
            let end = rest.find(|c: char| !c.is_alphanumeric());
            let end = end.unwrap_or(rest.len());
            names.push(rest[..end].to_owned());
            at += end;
            let fields = body[at..].trim_start();
            if fields.starts_with(['{', '(']) {
                at = closed(body, at + body[at..].len() - fields.len());
            }
        } else {
            at += first.len_utf8();
        }
    }
    names
}

/// Enums of errors in a source, with their variants.
fn error_enums(text: &str) -> Vec<(String, Vec<String>)> {
    let mut found = Vec::new();
    for (at, _) in text.match_indices("thiserror::Error)]") {
        let Some(item) = text[at..].find("pub ").map(|item| at + item) else {
            continue;
        };
        let Some(rest) = text[item..].strip_prefix("pub enum ") else {
            continue;
        };
        let end = rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(0);
        let Some(begin) = text[item..].find('{').map(|begin| item + begin) else {
            continue;
        };
        let body = &text[begin + 1..closed(text, begin) - 1];
        found.push((rest[..end].to_owned(), variants(body)));
    }
    found
}

/// Whether `text` matches `name`, a variant with its enum, in a pattern.
fn is_matched(text: &str, name: &str) -> bool {
    text.match_indices(name).any(|(at, _)| {
        let mut end = at + name.len();
        if text[end..].starts_with(|c: char| c.is_alphanumeric() || c == '_') {
            return false;
        }
        let fields = text[end..].trim_start();
        if fields.starts_with(['{', '(']) {
            end = closed(text, text.len() - fields.len());
        }
        let next = text[end..].trim_start_matches(|c: char| c == ')' || c.is_whitespace());
        let before = text[..at].rsplit(';').next().unwrap_or_default();
        next.starts_with("=>")
            || next.starts_with('|')
            || next.starts_with("if ")
            || next.starts_with("= ")
            || before.ends_with("matches!(")
            || before
                .rsplit('\n')
                .next()
                .is_some_and(|line| line.contains("matches!("))
    })
}

#[test]
fn an_error_that_no_caller_distinguishes_is_a_fault() {
    let sample = "#[derive(Debug, thiserror::Error)]\npub enum E {\n    /// A.\n    #[error(\"{x}, {\")]\n    A { x: f64 },\n    B(F),\n    C,\n}";
    let names = ["A", "B", "C"].map(str::to_owned).to_vec();
    assert_eq!(error_enums(sample), [("E".to_owned(), names)]);
    assert!(is_matched("E::A { .. } => 1", "E::A") && !is_matched("Err(E::A { x })", "E::A"));
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut texts = BTreeMap::new();
    for folder in ["crates", "cli/src", "fixtures/src"] {
        for file in sources(&root.join(folder)) {
            let is_source = file.components().any(|part| part.as_os_str() == "src");
            if is_source && !file.components().any(|part| part.as_os_str() == "target") {
                texts.insert(file.clone(), fs::read_to_string(&file).unwrap());
            }
        }
    }
    let mut unmatched = Vec::new();
    for (file, text) in &texts {
        for (name, variants) in error_enums(text) {
            // A warning is a row of a result and keeps its values.
            if name == "Warning" {
                continue;
            }
            for variant in variants {
                if variant == "Fault" {
                    continue;
                }
                let variant = format!("{name}::{variant}");
                let others = texts.iter().filter(|(other, _)| *other != file);
                if !others
                    .into_iter()
                    .any(|(_, other)| is_matched(other, &variant))
                {
                    unmatched.push(variant);
                }
            }
        }
    }
    assert_eq!(
        unmatched.len(),
        MOST_UNMATCHED,
        "make these constructors of asperity_core::Fault, and lower the number if it fell:\n{}",
        unmatched.join("\n")
    );
}
