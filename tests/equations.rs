//! The table of equations, the tagged formulas in the doc comments and the tests that verify them agree.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use asperity::equations::{all, find, markdown};

const FORMULAS: &str = "crates/asperity/src/equations/formulas.txt";

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Every Rust source of the workspace, by its path from the root.
fn sources() -> BTreeMap<String, String> {
    let mut sources = BTreeMap::new();
    let mut folders: Vec<PathBuf> = ["crates", "cli", "fixtures", "tests"]
        .iter()
        .map(|name| root().join(name))
        .collect();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let name = path.strip_prefix(root()).unwrap().to_string_lossy();
                sources.insert(name.into_owned(), fs::read_to_string(&path).unwrap());
            }
        }
    }
    sources
}

/// Sources of the libraries without their tests.
fn libraries() -> BTreeMap<String, String> {
    // The file that defines the macro shows it on an example.
    let is_library = |name: &str| {
        name.starts_with("crates/")
            && name.contains("/src/")
            && name != "crates/core/src/provenance.rs"
    };
    let code = |text: String| text.split("#[cfg(test)]").next().unwrap().to_owned();
    let libraries = sources().into_iter().filter(|(name, _)| is_library(name));
    libraries.map(|(name, text)| (name, code(text))).collect()
}

/// A doc line that ends in a tag, `[P7]` after two blanks: what precedes the tag, and the tag.
fn tagged(line: &str) -> Option<(&str, &str)> {
    // Rustdoc would take a bare [P7] for a link, so tags outside of code blocks are in backticks.
    let line = line.strip_suffix('`').unwrap_or(line);
    let (before, tag) = line.strip_suffix(']')?.rsplit_once('[')?;
    let before = before.strip_suffix('`').unwrap_or(before);
    let is_tag = !tag.is_empty() && tag.chars().all(|c| c.is_ascii_alphanumeric() || c == '-');
    (before.ends_with("  ") && is_tag).then(|| (before.trim(), tag))
}

/// Tagged formulas of a source: the doc lines from an empty line, a fence or another tag to the tag.
fn formulas(text: &str) -> Vec<(String, String)> {
    let (mut formulas, mut formula, mut in_code) = (Vec::new(), String::new(), false);
    for line in text.lines().map(str::trim) {
        let doc = line.strip_prefix("///").or(line.strip_prefix("//!"));
        let line = doc.unwrap_or_default().trim();
        if line.starts_with("```") {
            in_code = !in_code && line == "```text";
        }
        if line.is_empty() || line.starts_with("```") {
            formula.clear();
            continue;
        }
        let (part, tag) = tagged(line).map_or((line, None), |(part, tag)| (part, Some(tag)));
        let part = part.strip_prefix("- ").unwrap_or(part);
        let is_own_line = in_code
            && !formula.ends_with(',')
            && !part.starts_with("· ")
            && !part.starts_with("in ");
        match (formula.is_empty(), is_own_line) {
            (true, _) => {}
            (false, true) => formula += "; ",
            (false, false) => formula += " ",
        }
        // The page needs no marks of rustdoc: escapes, code, links.
        let plain = [
            ("\\[", "["),
            ("\\]", "]"),
            ("[`", ""),
            ("`]", ""),
            ("`", ""),
        ];
        let plain = plain.iter().fold(part.to_owned(), |part, (mark, text)| {
            part.replace(mark, text)
        });
        formula += &plain;
        if let Some(tag) = tag {
            let words: Vec<&str> = formula.split_whitespace().collect();
            formulas.push((tag.to_owned(), words.join(" ")));
            formula.clear();
        }
    }
    formulas
}

/// `formulas.txt` as the doc comments have it. Of several files with one tag the table keeps its own.
fn formulas_text() -> String {
    let mut places: BTreeMap<String, Vec<(String, String)>> = BTreeMap::new();
    for (name, text) in libraries() {
        for (tag, formula) in formulas(&text) {
            places.entry(tag).or_default().push((name.clone(), formula));
        }
    }
    let mut text = String::from("# Written from the doc comments: tag | file | formula\n");
    for (tag, places) in places {
        let own = find(&tag).map(|row| row.file);
        let (file, _) =
            (places.iter().find(|place| Some(place.0.as_str()) == own)).unwrap_or(&places[0]);
        let parts: Vec<&str> = (places.iter().filter(|place| place.0 == *file))
            .map(|place| place.1.as_str())
            .collect();
        text += &format!("{tag} | {file} | {}\n", parts.join("; "));
    }
    text
}

#[test]
fn the_table_has_the_formulas_of_the_doc_comments() {
    let (file, expected) = (root().join(FORMULAS), formulas_text());
    if std::env::var_os("ASPERITY_WRITE").is_some() {
        fs::write(&file, &expected).unwrap();
    }
    let held = fs::read_to_string(&file).unwrap();
    for (held, expected) in held.lines().zip(expected.lines()) {
        assert_eq!(held, expected, "{FORMULAS} is stale: run `just equations`");
    }
    assert_eq!(held.lines().count(), expected.lines().count());
}

fn lines(file: &str) -> Vec<String> {
    let text = fs::read_to_string(root().join("crates").join(file)).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(str::to_owned).collect()
}

#[test]
fn every_row_has_a_formula_sources_and_a_test() {
    let number = |tag: &str| tag.strip_prefix('P')?.parse::<u32>().ok();
    let rows = lines("core/src/provenance/rows.txt");
    let mut keys = BTreeSet::new();
    let sources = sources();
    for (row, equation) in rows.iter().zip(all()) {
        let fields: Vec<&str> = row.split(" | ").collect();
        assert_eq!(fields[0], equation.tag, "{row}: no formula, or no row");
        assert!(!equation.title.is_empty(), "{row}");
        let named = fields[3].split(", ").filter(|key| *key != "-");
        let known: Vec<&str> = equation.references.iter().map(|r| r.key).collect();
        assert_eq!(named.collect::<Vec<_>>(), known, "{row}: unknown source");
        keys.extend(known);
        let definition = format!("fn {}(", equation.test);
        assert!(
            sources.values().any(|text| text.contains(&definition)),
            "{row}: no such test"
        );
        // An equation of this project's own has no source.
        assert!(
            number(equation.tag).is_none() || !equation.references.is_empty(),
            "{row}"
        );
    }
    assert_eq!(rows.len(), all().len());
    let order = |tag| (number(tag).unwrap_or(u32::MAX), tag);
    assert!(
        all().is_sorted_by(|a, b| order(a.tag) < order(b.tag)),
        "order of rows.txt"
    );
    let listed = lines("asperity/src/equations/sources.txt");
    let texts: BTreeSet<&str> = listed
        .iter()
        .filter_map(|row| Some(row.split_once(" | ")?.1))
        .collect();
    assert_eq!(texts.len(), listed.len(), "a publication has two keys");
    let listed: Vec<&str> = listed
        .iter()
        .map(|row| row.split(" | ").next().unwrap())
        .collect();
    assert_eq!(listed, keys.into_iter().collect::<Vec<_>>(), "sources.txt");
    for number in 1..=37 {
        assert!(find(&format!("P{number}")).is_some(), "P{number}");
    }
}

#[test]
fn every_tag_in_the_sources_has_a_row() {
    for (name, text) in sources() {
        for (tag, _) in formulas(&text) {
            assert!(
                find(&tag).is_some(),
                "{name}: [{tag}] has no row in rows.txt"
            );
        }
    }
}

#[test]
fn the_page_of_equations_has_a_row_for_every_tag_and_all_sources() {
    let page = markdown();
    let count = |start: &str| page.lines().filter(|line| line.starts_with(start)).count();
    for equation in all() {
        let rows = 1 + usize::from(equation.misprint.is_some());
        assert_eq!(count(&format!("| {} |", equation.tag)), rows);
        for reference in &equation.references {
            let source = format!("- `{}` {}", reference.key, reference.text);
            assert_eq!(count(&source), 1, "{source}");
        }
    }
}

/// Tags that a source cites while it runs.
fn cited(code: &str) -> BTreeSet<&str> {
    code.lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .filter_map(|line| line.split_once("cite!(\"")?.1.split_once('"'))
        .map(|(tag, _)| tag)
        .collect()
}

/// Tags that the paper numbers and no function computes: equations that its velocities fulfil, assumptions, and
/// statements that are not used.
const NOT_COMPUTED: [&str; 9] = [
    "P22", "P24", "P25", "P26", "P27", "P28", "P33", "P35", "P37",
];

/// A function around a hot loop of another file may cite the tags of that loop, so a tag that is only cited needs its
/// row and no formula in the same file.
#[test]
fn every_tagged_formula_cites_its_tag_when_it_runs_and_no_other() {
    for (name, code) in libraries() {
        let cited = cited(&code);
        for (tag, _) in formulas(&code) {
            assert!(
                cited.contains(tag.as_str()) || NOT_COMPUTED.contains(&tag.as_str()),
                "{name}: [{tag}] without cite!"
            );
        }
        for tag in cited {
            assert!(
                find(tag).is_some(),
                "{name}: cite!(\"{tag}\") without a row"
            );
        }
    }
}

/// Every number in a text.
fn numbers(text: &str) -> Vec<f64> {
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | 'e' | '-');
    let parts = text.split(|c| !is_part(c));
    parts.filter_map(|part| part.parse().ok()).collect()
}

/// Numbers of a constant in a source or data file, by its name there.
fn constant_in_code(file: &str, name: &str) -> Vec<f64> {
    let text = fs::read_to_string(root().join(file)).unwrap();
    if let Some((family, key)) = name.split_once('.') {
        let data: serde_json::Value = serde_json::from_str(&text).unwrap();
        let families = data["families"].as_array().unwrap();
        let row = families.iter().find(|row| row["name"] == family).unwrap();
        return vec![row[key]["value"].as_f64().unwrap()];
    }
    let definition = if name.starts_with("Self::") {
        format!("{name} => [")
    } else {
        format!("const {name}:")
    };
    let at = text
        .find(&definition)
        .unwrap_or_else(|| panic!("{file} has no {definition}"));
    let (_, value) = text[at..].split_once('=').unwrap();
    numbers(value.split(['\n']).next().unwrap().trim_end_matches(','))
}

#[test]
fn the_constants_of_the_page_are_those_of_the_code() {
    let page = fs::read_to_string(root().join("docs/CONSTANTS.md")).unwrap();
    let rows = page.lines().filter(|line| line.contains("| `crates/"));
    let mut count = 0;
    for row in rows {
        let cells: Vec<String> = (row.replace("\\|", "\u{1}").split('|'))
            .map(|cell| cell.trim().replace('\u{1}', "|"))
            .collect();
        let code: Vec<&str> = cells[3].split('`').collect();
        assert_eq!(
            numbers(&cells[2]),
            constant_in_code(code[1], code[3]),
            "{row}"
        );
        for script in cells[4].split('`').filter(|part| part.ends_with(".py")) {
            assert!(root().join("references").join(script).is_file(), "{script}");
        }
        count += 1;
    }
    assert!(count > 30, "{count}");
}

#[test]
fn no_constant_is_quoted_without_a_source() {
    let mut texts = libraries();
    texts.insert("asperity equations --markdown".to_owned(), markdown());
    for file in ["README.md", "CHANGELOG.md"] {
        texts.insert(
            file.to_owned(),
            fs::read_to_string(root().join(file)).unwrap(),
        );
    }
    for entry in fs::read_dir(root().join("docs")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|ending| ending == "md") {
            texts.insert(
                path.display().to_string(),
                fs::read_to_string(&path).unwrap(),
            );
        }
    }
    for (file, text) in texts {
        let line = text
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ")
            .replace(" //! ", " ");
        for words in [
            "rom memory",
            "ource not reached",
            "ext not reached",
            "tself was not reached",
        ] {
            assert!(!line.contains(words), "{file}: {words}");
        }
    }
}
