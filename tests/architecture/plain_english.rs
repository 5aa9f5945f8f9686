//! Doc comments in plain technical English: the share of blocks with a phrase of [`PHRASES`].

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::words::sources;

/// Highest share of the doc-comment blocks with one of the phrases. Lower it when comments are corrected; 0.02 is the goal.
const HIGHEST_SHARE: f64 = 0.0125;

/// Environment variable that prints all places also when the share is below its bound.
const PRINT: &str = "ASPERITY_PRINT_WORDS";

/// Phrases that a native author would not write, each with what to write instead. `^` marks the begin of a block.
const PHRASES: &[(&str, &str)] = &[
    ("that of", "repeat the noun, or use the possessive"),
    ("those of", "repeat the noun, or use the possessive"),
    ("; none where", "`None` if ..."),
    ("; none of", "`None` if ..."),
    ("; none when", "`None` if ..."),
    ("; none for", "`None` if ..."),
    ("^the same,", "name the thing"),
    ("^the same with", "name the thing"),
    ("beside", "besides, in addition to, next to, compared with"),
    ("is no", "is not a ..."),
    ("are no", "are not ..."),
    ("alone", "only"),
    ("asked for", "requested"),
    ("asks for", "requires"),
    ("stands in", "is in"),
    ("stand in", "are in"),
    ("stands for", "represents"),
    ("stand for", "represent"),
    ("found.", "the noun: solution, contact, root"),
    ("^takes", "a noun phrase, or Subtracts, Moves ..."),
    ("^gives", "Returns"),
    ("^tells", "Reports"),
    ("^says", "Reports"),
    ("told", "reported, specified"),
    ("tells", "reports, specifies"),
    ("tell", "report, specify"),
    ("meets", "is in contact, pairs"),
    ("meet", "are in contact, pair"),
    ("met", "in contact, paired"),
    ("hangs on", "depends on"),
    ("hang on", "depend on"),
    ("looks at", "uses"),
    ("look at", "use"),
    ("looked at", "used"),
    ("but for", "except"),
    ("has it", "according to ..."),
    ("have it", "according to ..."),
    ("user's own", "user-defined"),
    ("each once", "distinct"),
    ("in vain", "ignored"),
    ("keeps up", "equilibrium"),
    ("keep up", "equilibrium"),
    ("so many", "number of ..."),
    ("kept", "stored, cached"),
    ("^what", "a noun phrase"),
    ("^where", "a noun phrase"),
    ("^how", "a noun phrase"),
    ("^why", "a noun phrase"),
    ("referee", "reference solution"),
    ("reading of the model", "formulation"),
];

/// Plain English that contains one of the phrases.
const ACCEPTED: &[&str] = &[
    "there is no",
    "there are no",
    "is no longer",
    "are no longer",
];

/// A run of `///` or `//!` lines: its first line, counted from 1, and its prose in lower case without code.
struct Block {
    line: usize,
    prose: String,
}

/// Kind and text of a doc-comment line.
fn doc_line(line: &str) -> Option<(&str, &str)> {
    let line = line.trim();
    if line.starts_with("////") {
        return None;
    }
    let kind = line.get(..3).filter(|kind| ["///", "//!"].contains(kind))?;
    Some((kind, line[3..].trim()))
}

/// Doc-comment blocks of a source.
fn blocks(source: &str) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut last_kind = None;
    let mut in_code = false;
    for (index, line) in source.lines().enumerate() {
        let doc = doc_line(line);
        let kind = doc.map(|(kind, _)| kind);
        if kind != last_kind {
            last_kind = kind;
            in_code = false;
            if kind.is_some() {
                let (line, prose) = (index + 1, String::new());
                blocks.push(Block { line, prose });
            }
        }
        let (Some((_, text)), Some(block)) = (doc, blocks.last_mut()) else {
            continue;
        };
        if text.starts_with("```") {
            in_code = !in_code;
        } else if !in_code {
            // A gap of two spaces where a paragraph ends: no phrase goes over it.
            block.prose.push_str(text);
            block
                .prose
                .push_str(if text.is_empty() { "  " } else { " " });
        }
    }
    for block in &mut blocks {
        block.prose = without_code(&block.prose).to_lowercase();
    }
    blocks
}

/// The text with each span between backticks replaced by an empty one.
fn without_code(text: &str) -> String {
    let prose: Vec<&str> = text.split('`').step_by(2).collect();
    prose.join("``")
}

/// Phrases of the table in a block.
fn phrases(prose: &str) -> Vec<&'static (&'static str, &'static str)> {
    let mut prose = prose.to_owned();
    for accepted in ACCEPTED {
        prose = prose.replace(accepted, "");
    }
    let contains = |(phrase, _): &&(&str, &str)| {
        let begin = phrase.strip_prefix('^');
        let phrase = begin.unwrap_or(phrase);
        let is_letter = |c: char| c.is_alphanumeric();
        prose.match_indices(phrase).any(|(at, _)| {
            let (before, after) = (&prose[..at], &prose[at + phrase.len()..]);
            let placed = match begin {
                Some(_) => before.is_empty(),
                None => !before.ends_with(is_letter),
            };
            placed && !after.starts_with(is_letter)
        })
    };
    PHRASES.iter().filter(contains).collect()
}

#[test]
fn doc_comments_are_in_plain_english() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let crates = fs::read_dir(root.join("crates")).unwrap();
    let mut folders: Vec<_> = crates
        .map(|entry| entry.unwrap().path().join("src"))
        .filter(|folder| folder.exists())
        .collect();
    folders.push(root.join("cli/src"));
    folders.sort();
    let (mut all, mut marked, mut places) = (0_u32, 0_u32, Vec::new());
    for path in folders.iter().flat_map(|folder| sources(folder)) {
        let name = path.strip_prefix(&root).unwrap().display();
        for block in blocks(&fs::read_to_string(&path).unwrap()) {
            let phrases = phrases(&block.prose);
            all += 1;
            marked += u32::from(!phrases.is_empty());
            places.extend(phrases.iter().map(|(phrase, better)| {
                format!("{name}:{}: \"{phrase}\": write {better}", block.line)
            }));
        }
    }
    assert!(all > 5000, "only {all} doc comments were read");
    let share = f64::from(marked) / f64::from(all);
    let counted = format!("{marked} of {all} doc comments, a share of {share:.4}");
    if std::env::var_os(PRINT).is_some() {
        println!("{}\n{counted}", places.join("\n"));
    }
    assert!(
        share <= HIGHEST_SHARE,
        "{}\n{counted}, above {HIGHEST_SHARE}",
        places.join("\n")
    );
}

#[test]
fn every_name_of_the_glossary_is_in_the_sources() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let glossary = fs::read_to_string(root.join("docs/GLOSSARY.md")).unwrap();
    let sources: String = sources(&root.join("crates"))
        .iter()
        .map(|path| fs::read_to_string(path).unwrap())
        .collect();
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let words: BTreeSet<&str> = sources.split(|c| !is_name(c)).collect();
    let names: Vec<&str> = glossary.split('`').skip(1).step_by(2).collect();
    assert!(names.len() > 40, "only {} names were read", names.len());
    let unknown: Vec<_> = names.iter().filter(|name| !words.contains(*name)).collect();
    assert!(
        unknown.is_empty(),
        "docs/GLOSSARY.md names what no source has: {unknown:?}"
    );
}

#[test]
fn the_terms_of_pages_have_the_meanings_of_the_glossary() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let glossary = fs::read_to_string(root.join("docs/GLOSSARY.md")).unwrap();
    let glossary = glossary.replace('\\', "");
    for term in asperity_report::TERMS {
        let row = format!("| {} | {}", term.name, term.meaning);
        assert!(glossary.contains(&row), "no row begins with {row}");
    }
}

#[test]
fn a_phrase_is_found_in_prose_and_not_in_code() {
    let seen = |source: &str| -> Vec<Vec<&str>> {
        let blocks = blocks(source);
        let phrases = blocks.iter().map(|block| phrases(&block.prose));
        phrases
            .map(|phrases| phrases.iter().map(|(phrase, _)| *phrase).collect())
            .collect()
    };
    assert_eq!(
        seen("/// What is\n/// kept.\nfn f() {}\n//! The load that\n//! of gears."),
        [vec!["kept", "^what"], vec!["that of"]]
    );
    assert_eq!(
        seen(
            "/// The metal. See what there is no\n/// `kept` of.\n/// ```\n/// kept\n/// ```\n// kept"
        ),
        [Vec::<&str>::new()]
    );
}
