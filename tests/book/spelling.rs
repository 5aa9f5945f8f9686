//! Spelling, by the vocabulary of the project: a rare word that is a usual misprint of a frequent one is refused.
//!
//! The vocabulary is that of the documents and the doc comments, so every term of the field that is in use is known, and
//! a new word is questioned only where it resembles a frequent one.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use asperity_tests::markdown::{prose, root, without_code};

use crate::generated::documents;

/// Words that resemble a frequent one and are right.
const RIGHT: &[&str] = &[
    "comptes", "create", "phrases", "radical", "simple", "slides", "solides", "solvers", "styles",
    "though", "weighs",
];

/// Letters of the shortest word that is judged.
const SHORTEST: usize = 6;
/// Most occurrences of a rare word, and fewest of a frequent one.
const RARE: usize = 2;
const FREQUENT: usize = 12;

/// The lower-case words of a line of prose; names and abbreviations are left out.
fn words(line: &str) -> Vec<String> {
    let line = without_code(line);
    let mut words = Vec::new();
    for part in line.split(|c: char| c.is_whitespace() || "[]|,;".contains(c)) {
        let is_path = part.contains("](") || part.contains('/') || part.contains('$');
        for word in part.split(|c: char| !c.is_ascii_alphabetic()) {
            let is_word =
                word.len() >= SHORTEST && word.bytes().skip(1).all(|b| b.is_ascii_lowercase());
            if is_word && !is_path {
                words.push(word.to_ascii_lowercase());
            }
        }
    }
    words
}

/// Adds the words of all Rust doc comments below a folder.
fn count_comments(folder: &Path, counts: &mut BTreeMap<String, usize>) {
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap()) {
        let path = entry.path();
        if path.is_dir() {
            if path.file_name().is_some_and(|name| name != "target") {
                count_comments(&path, counts);
            }
        } else if path.extension().is_some_and(|e| e == "rs") {
            let text = fs::read_to_string(&path).unwrap();
            for line in text.lines().map(str::trim_start) {
                let comment = line.strip_prefix("///").or(line.strip_prefix("//!"));
                for word in comment.map(words).unwrap_or_default() {
                    *counts.entry(word).or_default() += 1;
                }
            }
        }
    }
}

/// All words that `word` is a usual misprint of: a letter left out or added, a vowel for another, two letters exchanged. The
/// first letter is seldom wrong.
fn neighbours(word: &str) -> BTreeSet<String> {
    const VOWELS: [char; 5] = ['a', 'e', 'i', 'o', 'u'];
    let mut found = BTreeSet::new();
    for at in 1..=word.len() {
        let (head, tail) = word.split_at(at);
        found.extend(('a'..='z').map(|c| format!("{head}{c}{tail}")));
        let Some(rest) = tail.get(1..) else { continue };
        found.insert(format!("{head}{rest}"));
        if tail.starts_with(VOWELS) {
            found.extend(VOWELS.map(|c| format!("{head}{c}{rest}")));
        }
        if let Some(rest) = tail.get(2..) {
            found.insert(format!("{head}{}{}{rest}", &tail[1..2], &tail[..1]));
        }
    }
    found.remove(word);
    found
}

/// The frequent word that `word` is probably meant to be. Endings do not count: they are inflections.
fn meant(word: &str, counts: &BTreeMap<String, usize>) -> Option<String> {
    if counts.get(word).is_some_and(|count| *count > RARE) {
        return None;
    }
    let stem = |word: &str| word[..word.len() - 1].to_owned();
    let mut near = neighbours(word).into_iter();
    near.find(|other| {
        let is_inflected = stem(other) == word || stem(word) == *other || stem(word) == stem(other);
        !is_inflected && counts.get(other).is_some_and(|count| *count >= FREQUENT)
    })
}

/// The words of the documents with their places, and how often each is in documents and doc comments.
fn vocabulary() -> (Vec<(String, String)>, BTreeMap<String, usize>) {
    let mut counts = BTreeMap::new();
    for folder in ["crates", "cli"] {
        count_comments(&root().join(folder), &mut counts);
    }
    let mut places = Vec::new();
    for (page, text) in documents() {
        for word in prose(&text).into_iter().flat_map(words) {
            *counts.entry(word.clone()).or_default() += 1;
            places.push((word, page.clone()));
        }
    }
    (places, counts)
}

#[test]
fn the_documents_are_spelled_as_the_vocabulary() {
    let (places, counts) = vocabulary();
    assert!(counts.len() > 2500, "{} words", counts.len());
    let doubtful: BTreeSet<String> = places
        .iter()
        .filter(|(word, _)| !RIGHT.contains(&word.as_str()))
        .filter_map(|(word, page)| {
            let other = meant(word, &counts)?;
            Some(format!("{page}: {word} (for {other}?)"))
        })
        .collect();
    let lines: Vec<String> = doubtful.into_iter().collect();
    assert!(
        lines.is_empty(),
        "correct these words, or add them to RIGHT:\n{}",
        lines.join("\n")
    );
    // Misprints of words that the field uses.
    for (misprint, word) in [
        ("lubricaton", "lubrication"),
        ("pressrue", "pressure"),
        ("contcat", "contact"),
        ("temparature", "temperature"),
        ("asperitties", "asperities"),
    ] {
        assert_eq!(
            meant(misprint, &counts).as_deref(),
            Some(word),
            "{misprint}"
        );
    }
}
