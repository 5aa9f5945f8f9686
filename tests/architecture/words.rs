//! Words of the command stay in the command.

use std::fs;
use std::path::{Path, PathBuf};

/// Rust sources below `folder`.
pub fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// Contents of the strings of a source, its comments and tests left out.
fn strings(text: &str) -> Vec<String> {
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    let is_code = |line: &&str| !line.trim_start().starts_with("//");
    let code: String = code
        .lines()
        .filter(is_code)
        .flat_map(|line| [line, "\n"])
        .collect();
    // An escaped quotation mark or one as a character does not end a string.
    let code = code.replace("\\\"", "'").replace("'\"'", "' '");
    code.split('"')
        .skip(1)
        .step_by(2)
        .map(str::to_owned)
        .collect()
}

/// Options of a command line: `--` and a letter at the begin of a word.
fn options(text: &str) -> impl Iterator<Item = &str> {
    let bare = |word: &&str| {
        let name = word.trim_start_matches(|c: char| !c.is_ascii_alphanumeric() && c != '-');
        name.strip_prefix("--")
            .is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_lowercase()))
    };
    text.split_whitespace().filter(bare)
}

/// Texts that are of the command although a library writes them.
const OF_THE_COMMAND: [&str; 4] = [
    // A page of the documents, which tells how the command takes a case.
    "crates/case/src/load/page.rs",
    // The heading of the page of equations.
    "crates/asperity/src/equations/mod.rs",
    // The first screen of the command `run`.
    "crates/report/src/summary.rs",
    // The program that builds the page, which runs cargo.
    "crates/web/build/src/main.rs",
];

#[test]
fn no_message_of_a_library_names_an_option_of_the_command() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut named = Vec::new();
    let mut strings_seen = 0;
    for path in sources(&root.join("crates")) {
        let name = path.strip_prefix(&root).unwrap().display().to_string();
        let in_library = name.contains("/src/");
        if !in_library || OF_THE_COMMAND.contains(&name.as_str()) {
            continue;
        }
        let strings = strings(&fs::read_to_string(&path).unwrap());
        strings_seen += strings.len();
        for text in &strings {
            named.extend(options(text).map(|option| format!("{name}: {option}")));
        }
    }
    assert!(strings_seen > 1000, "only {strings_seen} strings were read");
    assert!(named.is_empty(), "{}", named.join("\n"));
}

#[test]
fn an_option_is_found_in_a_string_and_not_in_a_comment() {
    let seen = |text: &str| -> Vec<String> {
        let strings = strings(text);
        let options = strings.iter().flat_map(|text| options(text));
        options.map(str::to_owned).collect()
    };
    assert_eq!(seen("f(\"say \\\"x\\\" with\n (--dx).\")"), ["(--dx)."]);
    assert!(seen("// \"--dx\"\nf('\"', \"a -- b, 3--4\")").is_empty());
}

/// Distributions of a loss are skewed: an interval has two ends, and half of it is named as such.
#[test]
fn no_interval_is_printed_as_a_value_with_a_symmetric_deviation() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (mut seen, mut printed) = (0, Vec::new());
    for path in ["crates", "cli/src"]
        .map(|folder| root.join(folder))
        .iter()
        .flat_map(|at| sources(at))
    {
        let name = path.strip_prefix(&root).unwrap().display().to_string();
        if !name.contains("/src/") {
            continue;
        }
        let strings = strings(&fs::read_to_string(&path).unwrap());
        seen += strings.len();
        printed.extend(
            strings
                .into_iter()
                .filter(|text| text.contains('±'))
                .map(|text| format!("{name}: {text}")),
        );
    }
    assert!(seen > 2000, "only {seen} strings were read");
    assert!(printed.is_empty(), "{}", printed.join("\n"));
}
