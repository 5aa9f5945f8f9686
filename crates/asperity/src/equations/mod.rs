//! The equations of the model: tag, formula, file, test, sources and misprints of the 2022 paper.
//!
//! Formula and file of an equation come from the doc comment that ends in its tag; `formulas.txt` is written from the
//! doc comments of the workspace. The rows of `asperity-core`, which has the tags, have the title, the test, the keys of the
//! sources and the misprint, and `sources.txt` the bibliography.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use asperity_core::provenance::ROWS;
use serde::Serialize;

/// A publication.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
pub struct Reference {
    /// Short key, `author_year`.
    pub key: &'static str,
    /// Authors, title, place, year, as a bibliography prints it (with its DOI if it has one).
    pub text: &'static str,
}

/// One equation of the model: its tag in the sources, its formula and its test.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Equation {
    /// Tag at the end of the doc comment, between brackets: `P7`, `Hertz-1`.
    pub tag: &'static str,
    /// Computed quantity, in a few words.
    pub title: &'static str,
    /// The formula in Unicode text, as used.
    pub formula: &'static str,
    /// Source file, from the root of the workspace.
    pub file: &'static str,
    /// Name of a test function that verifies the equation.
    pub test: &'static str,
    /// Publications; empty for a definition of this project.
    pub references: Vec<Reference>,
    /// Misprint of the 2022 paper, and the form used instead.
    pub misprint: Option<&'static str>,
}

/// Rows of a text file: fields between ` | `, comments after `#`.
fn rows(text: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    let is_row = |line: &&str| !line.is_empty() && !line.starts_with('#');
    let fields = |line: &'static str| line.split(" | ").map(str::trim).collect();
    text.lines().filter(is_row).map(fields)
}

static SOURCES: LazyLock<Vec<Reference>> = LazyLock::new(|| {
    let reference = |row: Vec<&'static str>| match row[..] {
        [key, text] => Some(Reference { key, text }),
        _ => None,
    };
    rows(include_str!("sources.txt"))
        .filter_map(reference)
        .collect()
});

static EQUATIONS: LazyLock<Vec<Equation>> = LazyLock::new(|| {
    let formulas = rows(include_str!("formulas.txt")).filter_map(|row| match row[..] {
        [tag, file, formula] => Some((tag, [file, formula])),
        _ => None,
    });
    let formulas: BTreeMap<_, _> = formulas.collect();
    let equation = |row: Vec<&'static str>| {
        let [tag, title, test, keys, ref misprint @ ..] = row[..] else {
            return None;
        };
        let [file, formula] = *formulas.get(tag)?;
        let references = keys
            .split(", ")
            .filter_map(|key| SOURCES.iter().find(|source| source.key == key));
        Some(Equation {
            tag,
            title,
            formula,
            file,
            test,
            references: references.copied().collect(),
            misprint: misprint.first().copied(),
        })
    };
    rows(ROWS).filter_map(equation).collect()
});

/// Every equation of the model: those of the 2022 paper by number, then the others by tag.
pub fn all() -> &'static [Equation] {
    &EQUATIONS
}

/// The equation of the model with this tag, in upper or lower case.
///
/// ```
/// assert_eq!(asperity::equations::find("p7").map(|e| e.tag), Some("P7"));
/// ```
pub fn find(tag: &str) -> Option<&'static Equation> {
    let tag = tag.trim();
    all().iter().find(|row| row.tag.eq_ignore_ascii_case(tag))
}

/// The equations with these tags, in the order of [`all`].
pub(crate) fn of_tags(tags: &BTreeSet<&'static str>) -> Vec<&'static Equation> {
    all().iter().filter(|row| tags.contains(row.tag)).collect()
}

/// The distinct sources of `equations`, by key.
pub(crate) fn bibliography<'a>(
    equations: impl IntoIterator<Item = &'a Equation>,
) -> Vec<Reference> {
    let mut references: Vec<Reference> = equations
        .into_iter()
        .flat_map(|equation| equation.references.iter().copied())
        .collect();
    references.sort_by_key(|reference| reference.key);
    references.dedup();
    references
}

/// The equations as a page of Markdown, as `asperity equations --markdown` prints it.
pub fn markdown() -> String {
    let mut page = String::from(
        "# Equations\n\n\
        The file of each equation, its formula as used, and the test that verifies it. Tags `P1` to `P37` are the\n\
        numbers in the 2022 paper; the others come from the sources named. Formula and file are read from the doc\n\
        comments. `asperity equations --markdown` prints this page, `asperity equations P7` one row.\n\n\
        | tag | gives | formula as used | file | test | sources |\n|---|---|---|---|---|---|\n",
    );
    for equation in all() {
        let keys: Vec<_> = equation.references.iter().map(|r| r.key).collect();
        page.push_str(&format!(
            "| {} | {} | {} | `{}` | `{}` | {} |\n",
            equation.tag,
            cell(equation.title),
            cell(equation.formula),
            equation.file,
            equation.test,
            if keys.is_empty() {
                "own definition".to_owned()
            } else {
                keys.join(", ")
            },
        ));
    }
    page.push_str("\n## Misprints of the paper\n\n| equation | printed, and what is used instead |\n|---|---|\n");
    for equation in all() {
        if let Some(misprint) = equation.misprint {
            page.push_str(&format!("| {} | {} |\n", equation.tag, cell(misprint)));
        }
    }
    page.push_str("\n## Sources\n\n");
    for reference in bibliography(all()) {
        page.push_str(&format!("- `{}` {}\n", reference.key, reference.text));
    }
    page
}

/// Text as a cell of a Markdown table.
fn cell(text: &str) -> String {
    text.split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
        .replace('|', "\\|")
}
