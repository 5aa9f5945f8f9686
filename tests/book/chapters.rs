//! The chapters of the book: the list is complete, no page is too long, formulas and tags of the model hold.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use asperity::equations::find;
use asperity_tests::markdown::{links, pages, prose, root};

use crate::links::normal;

/// The chapters in `docs/SUMMARY.md`, relative to the root of the project.
pub fn chapters() -> Vec<String> {
    let summary = fs::read_to_string(root().join("docs/SUMMARY.md")).unwrap();
    let names = links(&summary).into_iter();
    names.map(|name| format!("docs/{name}")).collect()
}

/// The list of chapters, the only page in `docs` that is not a chapter.
const LIST: &str = "docs/SUMMARY.md";

#[test]
fn every_page_of_the_docs_is_a_chapter() {
    let chapters = chapters();
    for page in pages() {
        let is_chapter = chapters.contains(&page);
        let belongs = page.starts_with("docs/") && page != LIST;
        assert_eq!(is_chapter, belongs, "{page} and docs/SUMMARY.md");
    }
    for chapter in &chapters {
        assert!(root().join(chapter).is_file(), "{chapter}");
    }
}

/// The page that the program writes into the tree.
const GENERATED: &str = "docs/CASE_FILE.md";
/// Pages at the root that are read with the book.
const AT_ROOT: [&str; 3] = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"];
/// Most words of a page, of the two that may be longer, and of all.
const MOST_WORDS: usize = 1300;
const LONG: [&str; 2] = ["docs/ARCHITECTURE.md", "docs/files/profiles.md"];
const MOST_WORDS_OF_LONG: usize = 1500;
const MOST_WORDS_OF_ALL: usize = 40_000;
/// Most links from README to a page.
const MOST_LINKS: usize = 2;
/// Pages that give dates.
const DATED: [&str; 2] = ["docs/PERFORMANCE.md", "docs/decisions/"];

/// Pages that are written by hand, with their texts.
fn written() -> Vec<(String, String)> {
    let mut written = pages();
    let at_root = |page: &String| AT_ROOT.contains(&page.as_str());
    written.retain(|page| (page.starts_with("docs/") || at_root(page)) && page != GENERATED);
    let read = |page: String| {
        let text = fs::read_to_string(root().join(&page)).unwrap();
        (page, text)
    };
    written.into_iter().map(read).collect()
}

fn words(text: &str) -> usize {
    let has_letters = |word: &&str| word.contains(char::is_alphanumeric);
    text.split_whitespace().filter(has_letters).count()
}

#[test]
fn neither_a_page_nor_the_book_is_too_long() {
    let mut sum = 0;
    for (page, text) in written() {
        let words = words(&text);
        let most = if LONG.contains(&page.as_str()) {
            MOST_WORDS_OF_LONG
        } else {
            MOST_WORDS
        };
        assert!(words <= most, "{page} has {words} words");
        sum += words;
    }
    assert!(sum <= MOST_WORDS_OF_ALL, "the book has {sum} words");
    assert_eq!(words("one | two-three |\n|---|---|"), 2);
}

#[test]
fn no_page_is_far_from_the_first() {
    let texts = written();
    let mut reached = BTreeSet::from(["README.md".to_owned()]);
    for _ in 0..MOST_LINKS {
        let from = reached.clone();
        for (page, text) in texts.iter().filter(|(page, _)| from.contains(page)) {
            let folder = Path::new(page).parent().unwrap();
            reached.extend(links(text).iter().map(|link| {
                let file = link.split('#').next().unwrap_or_default();
                normal(&folder.join(file)).to_string_lossy().into_owned()
            }));
        }
    }
    let far = texts
        .iter()
        .filter(|(page, _)| page != LIST && !reached.contains(page));
    let far: Vec<&str> = far.map(|(page, _)| page.as_str()).collect();
    assert!(
        far.is_empty(),
        "more than {MOST_LINKS} links from README: {far:?}"
    );
}

/// Dates and commits in a text.
fn dates(text: &str) -> Vec<&str> {
    const MONTHS: [&str; 12] = [
        "January",
        "February",
        "March",
        "April",
        "May",
        "June",
        "July",
        "August",
        "September",
        "October",
        "November",
        "December",
    ];
    let is_digit = |c: char| c.is_ascii_digit();
    let is_date = |word: &&str| {
        let parts: Vec<&str> = word.split('-').collect();
        let numbers = |parts: &[&str]| {
            parts
                .iter()
                .all(|part| !part.is_empty() && part.chars().all(is_digit))
        };
        parts.len() == 3 && parts[0].len() == 4 && numbers(&parts)
    };
    let is_commit = |word: &&str| {
        let is_hex = word.bytes().all(|b| matches!(b, b'0'..=b'9' | b'a'..=b'f'));
        word.len() == 8 && is_hex && word.contains(is_digit) && !word.chars().all(is_digit)
    };
    let words: Vec<&str> = text
        .split(|c: char| !(c.is_alphanumeric() || c == '-'))
        .filter(|word| !word.is_empty())
        .collect();
    let months = words.windows(2).filter_map(|pair| {
        let is_number = |word: &str| word.starts_with(is_digit);
        let [first, second] = [pair[0], pair[1]];
        let is_month = MONTHS.contains(&first) && is_number(second)
            || MONTHS.contains(&second) && is_number(first);
        is_month.then_some(first)
    });
    let others = words
        .iter()
        .copied()
        .filter(|word| is_date(word) || is_commit(word));
    months.chain(others).collect()
}

#[test]
fn only_measured_times_and_decisions_are_dated() {
    for (page, text) in written() {
        let may = DATED.iter().any(|begin| page.starts_with(begin));
        let found = dates(&text);
        assert!(may || found.is_empty(), "{page}: {found:?}");
    }
    assert_eq!(
        dates("on 28 November and 2026-11-29 by `4b8e8d5a` in May"),
        ["28", "2026-11-29", "4b8e8d5a"]
    );
}

/// Code spans that have the form of a tag: letters, digits and hyphens, with a capital first.
fn tags(text: &str) -> Vec<&str> {
    let is_tag = |span: &&str| {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '-';
        span.starts_with(|c: char| c.is_ascii_uppercase()) && span.chars().all(is_part)
    };
    let spans = prose(text)
        .into_iter()
        .flat_map(|line| line.split('`').skip(1).step_by(2));
    spans.filter(is_tag).collect()
}

/// What keeps a formula from being set by mdBook or a code host.
fn faults_of_formulas(text: &str) -> Vec<String> {
    let mut faults = Vec::new();
    let mut is_display = false;
    for line in prose(text) {
        if line.trim() == "$$" {
            is_display = !is_display;
            continue;
        }
        let spans: Vec<&str> = if is_display {
            vec![line]
        } else {
            let outside = asperity_tests::markdown::without_code(line);
            if outside.matches('$').count() % 2 == 1 {
                faults.push(format!("a single $: {line}"));
            }
            line.split('$').skip(1).step_by(2).collect()
        };
        for span in spans {
            // Markdown takes a backslash before punctuation as its own.
            let mut pairs = span.chars().zip(span.chars().skip(1));
            if pairs.any(|(first, second)| first == '\\' && second.is_ascii_punctuation()) {
                faults.push(format!("a backslash before punctuation: {span}"));
            }
            let depth = span.matches('{').count().cmp(&span.matches('}').count());
            if depth.is_ne() || span.matches("\\left").count() != span.matches("\\right").count() {
                faults.push(format!("unbalanced: {span}"));
            }
        }
    }
    if is_display {
        faults.push("a display formula is not closed".to_owned());
    }
    faults
}

#[test]
fn chapters_of_the_model_name_equations_that_exist() {
    let mut chapters = chapters();
    chapters.retain(|chapter| chapter.starts_with("docs/model/"));
    assert!(chapters.len() >= 8, "{chapters:?}");
    for chapter in chapters {
        let text = fs::read_to_string(root().join(&chapter)).unwrap();
        let named = tags(&text);
        assert!(named.len() >= 5, "{chapter} names {named:?}");
        for tag in named {
            assert!(
                find(tag).is_some(),
                "{chapter}: no equation has the tag {tag}"
            );
        }
        assert!(
            links(&text).iter().any(|link| link.ends_with(".svg")),
            "{chapter} has no picture"
        );
        assert_eq!(faults_of_formulas(&text), Vec::<String>::new(), "{chapter}");
    }
}

#[test]
fn tags_and_faults_of_formulas_are_found() {
    assert_eq!(
        tags("by `Hertz-1`, not `model.lay` nor `--json`\n```\n`P7`\n```"),
        ["Hertz-1"]
    );
    assert_eq!(
        faults_of_formulas("$a_H$ and `$b`\n\n$$\n\\frac{a}{b}\n$$").len(),
        0
    );
    for text in [
        "5 $ each",
        "$a\\,b$",
        "$\\frac{a}{b$",
        "$$\na",
        "$\\left( a )$",
    ] {
        assert_eq!(faults_of_formulas(text).len(), 1, "{text}");
    }
}
