//! The chapters of the book: the list is complete, no page is too long, formulas and tags of the model hold.

use std::fs;

use asperity::equations::find;
use asperity_tests::markdown::{links, pages, prose, root};

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
/// Most words of a page that is read and not searched.
const MOST_WORDS: usize = 2500;

fn words(text: &str) -> usize {
    let has_letters = |word: &&str| word.contains(char::is_alphanumeric);
    text.split_whitespace().filter(has_letters).count()
}

#[test]
fn no_page_is_too_long() {
    for page in pages() {
        let is_read =
            page.starts_with("docs/") || ["README.md", "CONTRIBUTING.md"].contains(&page.as_str());
        if is_read && page != GENERATED {
            let words = words(&fs::read_to_string(root().join(&page)).unwrap());
            assert!(words <= MOST_WORDS, "{page} has {words} words");
        }
    }
    assert_eq!(words("one | two-three |\n|---|---|"), 2);
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
        let spans: Vec<&str> = match is_display {
            true => vec![line],
            false => {
                let outside = asperity_tests::markdown::without_code(line);
                if outside.matches('$').count() % 2 == 1 {
                    faults.push(format!("a single $: {line}"));
                }
                line.split('$').skip(1).step_by(2).collect()
            }
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
