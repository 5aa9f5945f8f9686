//! Pages that the program prints for the book; they are not in the tree.

use std::collections::BTreeSet;
use std::fs;
use std::process::Command;
use std::sync::LazyLock;

use asperity_tests::markdown::{pages, prose, root};

/// Pages by their places in the book, and the commands that print them.
const PRINTED: [(&str, &str); 3] = [
    ("docs/COMMANDS.md", "completions markdown"),
    ("docs/MESSAGES.md", "explain --markdown"),
    ("docs/EQUATIONS.md", "equations --markdown"),
];

static GENERATED: LazyLock<Vec<(String, String)>> = LazyLock::new(|| {
    let printed = |(page, command): (&str, &str)| {
        let mut program = Command::new(env!("CARGO_BIN_EXE_asperity-tested"));
        let output = program.args(command.split(' ')).output().unwrap();
        assert!(output.status.success(), "asperity {command}");
        (page.to_owned(), String::from_utf8(output.stdout).unwrap())
    };
    PRINTED.map(printed).to_vec()
});

/// The pages that the program prints, by their places in the book, with their texts.
pub fn generated() -> &'static [(String, String)] {
    &GENERATED
}

/// All pages, those of the tree and those that the program prints, with their texts.
pub fn documents() -> Vec<(String, String)> {
    let read = |page: String| {
        let text = fs::read_to_string(root().join(&page)).unwrap();
        (page, text)
    };
    let committed = pages().into_iter().map(read);
    committed.chain(generated().iter().cloned()).collect()
}

#[test]
fn the_book_gets_the_pages_that_are_checked_here() {
    let script = fs::read_to_string(root().join(".ci/book")).unwrap();
    for (page, command) in PRINTED {
        let name = page.trim_start_matches("docs/");
        let writes = format!("asperity {command} >\"$source/{name}\"");
        assert!(script.contains(&writes), ".ci/book lacks {writes}");
        assert!(
            script.contains(&format!("]({name})")),
            "{name} is no chapter"
        );
        assert!(!root().join(page).exists(), "{page} is not of the tree");
    }
}

#[test]
fn headings_of_the_printed_pages_are_unique() {
    for (page, text) in generated() {
        let lines = prose(text).into_iter();
        let headings: Vec<&str> = lines.filter(|line| line.starts_with('#')).collect();
        let different: BTreeSet<&str> = headings.iter().copied().collect();
        assert_eq!(different.len(), headings.len(), "{page}");
        assert!(headings.len() > 2, "{page}: {headings:?}");
        assert!(text.starts_with("# "), "{page} has no title");
    }
}
