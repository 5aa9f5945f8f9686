//! The sources of a result as BibTeX.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use asperity::result::RunResult;

/// One entry per source cited by the equations of `results`, with their tags as note.
pub fn bibtex<'a>(results: impl Iterator<Item = &'a RunResult>) -> String {
    let mut sources: BTreeMap<&str, (&str, Vec<&str>)> = BTreeMap::new();
    for result in results {
        for source in &result.references {
            let equations = result.equations.iter();
            let own = equations.filter(|equation| equation.references.contains(&source.key));
            let (_, tags) = sources
                .entry(&source.key)
                .or_insert((&source.text, Vec::new()));
            for tag in own.map(|equation| &*equation.tag) {
                if !tags.contains(&tag) {
                    tags.push(tag);
                }
            }
        }
    }
    let mut text = String::new();
    for (key, (source, tags)) in sources {
        let (authors, title) = parts(source);
        // Writing into a string cannot fail.
        let _ = writeln!(text, "@misc{{{key},");
        if !authors.is_empty() {
            let authors = escaped(&authors.join(" and "));
            let _ = writeln!(text, "  author = {{{authors}}},");
        }
        let _ = writeln!(text, "  title = {{{}}},", escaped(title));
        if let Some(year) = year(key) {
            let _ = writeln!(text, "  year = {{{year}}},");
        }
        if let Some(doi) = doi(source) {
            let _ = writeln!(text, "  doi = {{{doi}}},");
        }
        let _ = writeln!(
            text,
            "  note = {{{}}}\n}}",
            escaped(&format!("equations {}", tags.join(", ")))
        );
    }
    text
}

/// Splits a reference into the authors, each "A. B. Name", and the rest.
fn parts(text: &str) -> (Vec<&str>, &str) {
    let mut authors = Vec::new();
    let mut rest = text;
    while let Some((first, after)) = rest.split_once(", ") {
        let mut letters = first.chars();
        let has_initial =
            letters.next().is_some_and(char::is_uppercase) && letters.next() == Some('.');
        if !has_initial {
            break;
        }
        authors.push(first);
        rest = after;
    }
    (authors, rest)
}

/// The year at the end of a key, `hertz_1881`.
fn year(key: &str) -> Option<&str> {
    let year = key.rsplit('_').next()?;
    (year.len() == 4 && year.bytes().all(|byte| byte.is_ascii_digit())).then_some(year)
}

fn doi(text: &str) -> Option<&str> {
    let (_, rest) = text
        .split_once("doi:")
        .or_else(|| text.split_once("doi "))?;
    let end = rest.find([' ', ',', ';']).unwrap_or(rest.len());
    Some(rest[..end].trim_end_matches('.'))
}

fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        if matches!(letter, '&' | '%' | '$' | '#' | '_' | '{' | '}') {
            escaped.push('\\');
        }
        escaped.push(letter);
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn authors_year_and_doi_are_told_apart() {
        let text = "I. A. Polonsky, L. M. Keer, A numerical method, Wear 231 (1999) 206-219, doi:10.1016/S0043-1648(99)00113-1";
        let (authors, title) = parts(text);
        assert_eq!(authors, ["I. A. Polonsky", "L. M. Keer"]);
        assert!(title.starts_with("A numerical method"));
        assert_eq!(doi(text), Some("10.1016/S0043-1648(99)00113-1"));
        assert_eq!(year("polonsky_1999"), Some("1999"));
        assert_eq!(year("iso_14179"), None);
        assert_eq!(escaped("50 % & more_"), "50 \\% \\& more\\_");
    }
}
