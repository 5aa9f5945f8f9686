//! Names and shapes: a constructor is `new`, `from_x` or a noun, a parameter is not a tuple, and few types share a name.

use std::collections::BTreeMap;
use std::fs::read_to_string;
use std::path::Path;

use super::read_only::all_sources;

/// Maximum number of functions named exactly `of`.
const MOST_OF: usize = 40;
/// Maximum number of parameters whose pattern is a tuple.
const MOST_TUPLES: usize = 29;
/// Maximum number of names that several types have.
const MOST_SHARED_NAMES: usize = 75;

/// Source without comments, each replaced by nothing up to the end of its line.
fn without_comments(text: &str) -> String {
    let lines = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default());
    lines.flat_map(|line| [line, "\n"]).collect()
}

/// Names of functions of a source, each with the text of its parameters.
fn signatures(text: &str) -> Vec<(&str, &str)> {
    let mut all = Vec::new();
    for (at, _) in text.match_indices("fn ") {
        let is_word = text[..at].ends_with(|c: char| !c.is_alphanumeric() && c != '_');
        let rest = &text[at + 3..];
        let name_end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
        let (true, Some(name_end)) = (is_word || at == 0, name_end.filter(|end| *end > 0)) else {
            continue;
        };
        let (name, after) = rest.split_at(name_end);
        let generics = if after.starts_with('<') {
            closed(after, 0)
        } else {
            0
        };
        let parameters = &after[generics..];
        if parameters.starts_with('(') {
            all.push((name, &parameters[1..closed(parameters, 0) - 1]));
        }
    }
    all
}

/// Index behind the bracket that closes the one at `start`.
fn closed(text: &str, start: usize) -> usize {
    let bytes = text.as_bytes();
    let mut depth = 0;
    for at in start..bytes.len() {
        match bytes[at] {
            b'(' | b'[' | b'{' | b'<' => depth += 1,
            b'>' if at > 0 && matches!(bytes[at - 1], b'-' | b'=') => {}
            b')' | b']' | b'}' | b'>' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return at + 1;
        }
    }
    bytes.len()
}

/// Number of parameters whose pattern is a tuple.
fn tuples(parameters: &str) -> usize {
    let (mut rest, mut count) = (parameters.trim_start(), 0);
    while !rest.is_empty() {
        if rest.starts_with('(') {
            let after = rest[closed(rest, 0)..].trim_start();
            count += usize::from(after.starts_with(':'));
        }
        let mut at = 0;
        while at < rest.len() && !rest[at..].starts_with(',') {
            let opens = rest[at..].starts_with(['(', '[', '{', '<']);
            let next = if opens { closed(rest, at) } else { at + 1 };
            at = (next..=rest.len())
                .find(|next| rest.is_char_boundary(*next))
                .unwrap();
        }
        rest = rest.get(at + 1..).unwrap_or_default().trim_start();
    }
    count
}

#[test]
fn constructors_are_named_and_parameters_are_not_taken_apart() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (mut seen, mut of, mut apart) = (0, Vec::new(), Vec::new());
    for file in all_sources() {
        let name = file.strip_prefix(&root).unwrap().display().to_string();
        let text = without_comments(&read_to_string(&file).unwrap());
        for (function, parameters) in signatures(&text) {
            seen += 1;
            if function == "of" {
                of.push(name.clone());
            }
            let tuples = tuples(parameters);
            apart.extend(vec![format!("{name}: {function}"); tuples]);
        }
    }
    assert!(seen > 5000, "{seen}");
    println!("{} functions `of`, {} tuples", of.len(), apart.len());
    assert!(of.len() <= MOST_OF, "{}: {of:#?}", of.len());
    assert!(apart.len() <= MOST_TUPLES, "{}: {apart:#?}", apart.len());
}

#[test]
fn a_tuple_in_a_signature_is_seen() {
    let source = "impl A {\n fn b<F: Fn(u8) -> u8>(&self, (c, d): (u8, u8), e: F) {}\n}\nfn of(f: &(u8, u8)) {}";
    let found = signatures(source);
    assert_eq!(found.len(), 2);
    assert_eq!(found[0].0, "b");
    assert_eq!((tuples(found[0].1), tuples(found[1].1)), (1, 0));
    assert_eq!(found[1].0, "of");
    assert_eq!(
        tuples("[a, b]: [u8; 2], (c, (d, e)): (u8, (u8, u8)), g: u8"),
        1
    );
}

/// Names of the types that a source declares outside of functions.
fn types(text: &str) -> Vec<&str> {
    let before_tests = text.split("#[cfg(test)]").next().unwrap_or_default();
    before_tests.lines().filter_map(declared_type).collect()
}

fn declared_type(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("pub").map_or(line, |rest| {
        rest.split_once(") ").map_or(
            rest,
            |(scope, after)| {
                if scope.starts_with('(') { after } else { rest }
            },
        )
    });
    let (kind, rest) = rest.trim_start().split_once(' ')?;
    let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
    let is_type = ["struct", "enum", "trait", "type", "union"].contains(&kind);
    (is_type && !line.starts_with(' ')).then(|| &rest[..end.unwrap_or(rest.len())])
}

/// Classes of the Python module and values of the page have the names of what they pass on, in the same meaning.
#[test]
fn few_types_share_a_name() {
    let mut places = BTreeMap::<String, Vec<String>>::new();
    let of_faces = ["crates/python", "crates/web"].map(|folder| format!("../{folder}/"));
    for file in all_sources() {
        let name = file.display().to_string();
        if of_faces.iter().any(|folder| name.contains(folder)) {
            continue;
        }
        for declared in types(&read_to_string(&file).unwrap()) {
            let of_name = places.entry(declared.to_owned()).or_default();
            of_name.push(name.clone());
        }
    }
    assert!(places.len() > 1000, "{}", places.len());
    places.retain(|_, files| files.len() > 1);
    println!("{} names of several types", places.len());
    let shared = places.len();
    assert!(shared <= MOST_SHARED_NAMES, "{shared}: {places:#?}");
}

#[test]
fn a_declared_type_is_seen() {
    assert_eq!(declared_type("pub(crate) struct Grid<'a> {"), Some("Grid"));
    assert_eq!(declared_type("pub enum Law {"), Some("Law"));
    assert_eq!(declared_type("type Place = [u64; 3];"), Some("Place"));
    assert_eq!(declared_type("    type Error = Error;"), None);
    assert_eq!(declared_type("pub fn of(a: (u8, u8)) {"), None);
}
