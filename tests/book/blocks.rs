//! Code of the documents: commands parse, case files have keys that exist, JSON and TOML are what they say.

use std::fs;

use asperity::Error;
use asperity::case::gear_train::{self, is_train};
use asperity::case::{self, Source};
use asperity_cli::fuzzing::arguments;
use asperity_tests::markdown::{blocks, pages, root, shell_words};

/// Languages of fenced blocks; transcripts run `sh` and compare `text`, doc tests compile `rust`.
const LANGUAGES: [&str; 10] = [
    "sh",
    "text",
    "toml",
    "json",
    "csv",
    "rust",
    "rust,no_run",
    "python",
    "diff",
    "",
];

/// Whether the command accepts a line of a shell; lines with variables or of other programs are not judged.
fn is_accepted(line: &str) -> bool {
    let words = shell_words(line);
    match words.split_first() {
        Some((program, rest)) if program == "asperity" && !line.contains('$') => {
            arguments(&rest.join("\n"))
        }
        _ => true,
    }
}

/// Errors of a case, or a part of one, except of what it leaves out: tables, and the traces of the reader.
fn wrong(text: &str) -> Vec<String> {
    let source = match Source::new("block.toml", text) {
        Ok(source) => source,
        Err(error) => return vec![error.to_string()],
    };
    let folder = std::path::Path::new("");
    let errors: Vec<Error> = match is_train(&source) {
        true => gear_train::check(source, folder, &[]).errors,
        false => case::check(source, folder, &[]).errors,
    };
    let is_left_out = |error: &&Error| {
        let text = error.to_string();
        ["E103", "E137"].contains(&error.code()) || text.contains("missing key")
    };
    let wrong = errors.iter().filter(|error| !is_left_out(error));
    wrong
        .map(|error| format!("{} {error}", error.code()))
        .collect()
}

/// Whether a TOML block is a case or a part of one.
fn is_case(table: &toml::Table) -> bool {
    const TABLES: [&str; 12] = [
        "gears",
        "material",
        "operation",
        "lubricant",
        "surface",
        "model",
        "map",
        "vehicle",
        "train",
        "planetary",
        "heat",
        "gearbox",
    ];
    let is_own = table
        .keys()
        .all(|key| TABLES.contains(&key.as_str()) || ["title", "mesh"].contains(&key.as_str()));
    is_own && !table.is_empty()
}

#[test]
fn commands_and_data_of_the_documents_are_read_by_the_program() {
    let (mut commands, mut cases) = (0, 0);
    for page in pages() {
        let text = fs::read_to_string(root().join(&page)).unwrap();
        for block in blocks(&text) {
            let language = block.language.split(' ').next().unwrap_or_default();
            assert!(
                LANGUAGES.contains(&language),
                "{page}: a block of {language:?}"
            );
            let body = block.lines.join("\n");
            match language {
                "sh" | "text" => {
                    let lines = block
                        .lines
                        .iter()
                        .filter(|line| line.starts_with("asperity "));
                    for line in lines.filter(|line| !line.ends_with('\\')) {
                        assert!(is_accepted(line), "{page}: {line}");
                        commands += 1;
                    }
                }
                "json" => {
                    let read: Result<serde_json::Value, _> = serde_json::from_str(&body);
                    assert!(read.is_ok(), "{page}: {read:?}\n{body}");
                }
                "toml" => {
                    let read: Result<toml::Table, _> = body.parse();
                    let table = read.unwrap_or_else(|error| panic!("{page}: {error}\n{body}"));
                    if is_case(&table) {
                        assert_eq!(wrong(&body), Vec::<String>::new(), "{page}:\n{body}");
                        cases += 1;
                    }
                }
                _ => {}
            }
        }
    }
    assert!(commands > 60, "{commands} commands");
    assert!(cases > 6, "{cases} cases");
}

#[test]
fn wrong_commands_and_keys_are_found() {
    assert!(is_accepted("asperity run case.toml --notes  # first"));
    assert!(!is_accepted("asperity run case.toml --note-s"));
    assert!(!is_accepted("asperity runn case.toml"));
    assert_eq!(
        wrong("[surface]\nfinish = \"ground\"\n"),
        Vec::<String>::new()
    );
    assert!(wrong("[surface]\nfinnish = \"ground\"\n")[0].starts_with("E203"));
    assert!(wrong("[surface]\ncutoff = \"1 kg\"\n")[0].starts_with("E204"));
    assert!(wrong("[surface\n")[0].contains("E202") || !wrong("[surface\n").is_empty());
}
