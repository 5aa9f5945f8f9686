//! Code of the documents: commands parse, case files have keys that exist, JSON and TOML are what they say.

use asperity::Error;
use asperity::case::{self, Source};
use asperity_cli::fuzzing::arguments;
use asperity_tests::markdown::{blocks, prose, shell_words, without_code};

use crate::generated::documents;

/// Languages of fenced blocks; transcripts run `sh` and compare `text`, doc tests compile `rust`, and `bash` is not run.
const LANGUAGES: [&str; 11] = [
    "sh",
    "bash",
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

/// Whether the command accepts a line of a shell, up to a remark after three blanks; lines with variables or of other
/// programs are not judged.
fn is_accepted(line: &str) -> bool {
    let words = shell_words(line.split("   ").next().unwrap_or_default());
    match words.split_first() {
        Some((program, rest)) if program == "asperity" && !line.contains('$') => {
            arguments(&rest.join("\n"))
        }
        _ => true,
    }
}

/// Errors of a case or a gear train, or a part of one, except of what it leaves out: tables, and the traces of the reader.
fn wrong(text: &str) -> Vec<String> {
    let source = match Source::new("block.toml", text) {
        Ok(source) => source,
        Err(error) => return vec![error.to_string()],
    };
    let folder = std::path::Path::new("");
    let is_left_out = |error: &&Error| {
        let text = error.to_string();
        ["E103", "E137"].contains(&error.code().as_str()) || text.contains("missing key")
    };
    let faults = |errors: &[Error]| -> Vec<String> {
        let wrong = errors.iter().filter(|error| !is_left_out(error));
        wrong
            .map(|error| format!("{} {error}", error.code()))
            .collect()
    };
    // [heat] does not show that it belongs to a train.
    let source = if text.starts_with("[heat]") {
        Source::new("block.toml", &format!("{text}\n[mesh.part]\n")).unwrap_or(source)
    } else {
        source
    };
    faults(&case::check(source, folder, &[]).errors)
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

/// What the program cannot read of a block, and how many commands and cases it read.
fn judged(language: &str, lines: &[&str]) -> (Vec<String>, [usize; 2]) {
    let body = lines.join("\n");
    match language {
        "sh" | "bash" | "text" => {
            let is_whole =
                |line: &&&str| line.starts_with("asperity ") && !line.ends_with(['\\', '.']);
            let commands: Vec<_> = lines.iter().filter(is_whole).collect();
            let refused = commands.iter().filter(|line| !is_accepted(line));
            let faults = refused.map(|line| format!("not a command: {line}"));
            (faults.collect(), [commands.len(), 0])
        }
        "json" => {
            let read: Result<serde_json::Value, _> = serde_json::from_str(&body);
            let fault = read.err().map(|error| format!("{error}:\n{body}"));
            (fault.into_iter().collect(), [0, 0])
        }
        "toml" => match body.parse::<toml::Table>() {
            Err(error) => (vec![format!("{error}:\n{body}")], [0, 0]),
            Ok(table) if is_case(&table) => (wrong(&body), [0, 1]),
            Ok(_) => (Vec::new(), [0, 0]),
        },
        known if LANGUAGES.contains(&known) => (Vec::new(), [0, 0]),
        other => (vec![format!("a block of {other:?}")], [0, 0]),
    }
}

#[test]
fn commands_and_data_of_the_documents_are_read_by_the_program() {
    let (mut faults, mut commands, mut cases) = (Vec::new(), 0, 0);
    for (page, text) in documents() {
        for block in blocks(&text) {
            let language = block.language.split(' ').next().unwrap_or_default();
            let (wrong, read) = judged(language, &block.lines);
            faults.extend(wrong.iter().map(|fault| format!("{page}: {fault}")));
            (commands, cases) = (commands + read[0], cases + read[1]);
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
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
    for (language, lines) in [
        ("toml", ["[surface"]),
        ("json", ["{,}"]),
        ("text", ["asperity runn case.toml"]),
        ("fortran", [""]),
    ] {
        assert_eq!(judged(language, &lines).0.len(), 1, "{language}");
    }
}

/// Numbers with the unit W in prose; tables are written by tests, and code is not said.
fn watts(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for line in prose(text).iter().filter(|line| !line.starts_with('|')) {
        let line = without_code(line);
        let words: Vec<&str> = line
            .split(|c: char| c == ' ' || "(),;:".contains(c))
            .collect();
        let is_number = |word: &&str| word.starts_with(|c: char| c.is_ascii_digit());
        let pairs = words
            .windows(2)
            .filter(|pair| pair[1].trim_end_matches('.') == "W");
        found.extend(
            pairs
                .map(|pair| pair[0])
                .filter(is_number)
                .map(str::to_owned),
        );
    }
    found
}

#[test]
fn losses_in_the_prose_of_a_page_are_in_its_transcripts() {
    let mut count = 0;
    for (page, text) in documents() {
        let shown: Vec<&str> = blocks(&text)
            .iter()
            .filter(|block| block.language == "text")
            .flat_map(|block| block.lines.clone())
            .flat_map(|line| line.split(|c: char| c != '.' && !c.is_ascii_digit()))
            .collect();
        if shown.is_empty() {
            continue;
        }
        for number in watts(&text) {
            count += 1;
            assert!(
                shown.contains(&&*number),
                "{page}: {number} W is in no transcript of this page"
            );
        }
    }
    assert!(count > 1, "{count} losses");
    assert_eq!(
        watts("It loses 690 W (530 to 920 W).\n```text\n5 W\n```\n"),
        ["690", "920"]
    );
}
