//! Computed tables that no document shows, as CSV files in `tests/golden/evidence`.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Whether tests write their tables instead of comparing them.
pub fn is_writing() -> bool {
    std::env::var_os("ASPERITY_WRITE").is_some()
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("golden/evidence")
}

fn file(name: &str) -> PathBuf {
    folder().join(name).with_extension("csv")
}

fn stored(name: &str) -> String {
    std::fs::read_to_string(file(name))
        .unwrap_or_else(|_| panic!("{name}: no document and no file of tests/golden/evidence"))
}

/// A cell without the marks of Markdown.
fn plain(cell: &str) -> String {
    let cell = cell.trim().replace("**", "").replace('`', "");
    cell.replace("\\*", "*")
}

/// The rows of a Markdown table as CSV, the header first. Text next to the table is left out.
fn as_csv(table: &str) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let is_row = |line: &&str| line.starts_with('|') && !line.starts_with("|---");
    for line in table.lines().filter(is_row) {
        let cells = line
            .strip_prefix('|')
            .and_then(|line| line.strip_suffix('|'));
        writer
            .write_record(cells.unwrap().split('|').map(plain))
            .unwrap();
    }
    String::from_utf8(writer.into_inner().unwrap()).unwrap()
}

/// Compares or writes the file of a table.
pub fn hold(name: &str, table: &str) {
    let made = as_csv(table);
    if is_writing() {
        std::fs::write(file(name), &made).unwrap();
        return;
    }
    let stored = stored(name);
    for (stored, made) in stored.lines().zip(made.lines()) {
        assert_eq!(stored, made, "{name}: not up to date; see document.rs");
    }
    assert_eq!(stored.len(), made.len(), "{name} is stale");
}

/// Panics if the file of a table lacks a row.
pub fn hold_row(name: &str, row: &str) {
    let row = as_csv(row);
    assert!(stored(name).contains(&row), "{name}.csv lacks {row}");
}

/// Tables of the refused gap law `power`, as commit 1078c1ac made them.
pub const OF_REFUSED_LAW: [&str; 3] = ["gap-laws", "ehl-laws-power", "load-share-reference"];

/// Panics unless the folder has a file of each name, and no other.
pub fn hold_names(names: impl Iterator<Item = &'static str>) {
    let expected: BTreeSet<String> = names.map(|name| format!("{name}.csv")).collect();
    let entries = std::fs::read_dir(folder()).unwrap();
    let found = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let found: BTreeSet<String> = found.filter(|name| name.ends_with(".csv")).collect();
    assert_eq!(found, expected, "files of tests/golden/evidence");
}

#[test]
fn tables_become_csv_without_the_marks_of_markdown() {
    let table = "| `a` | Λ\\*, b |\n|---|---|\n| **no** | -0.1, 2 |\n\nTest: `name`.\n";
    assert_eq!(as_csv(table), "a,\"Λ*, b\"\nno,\"-0.1, 2\"\n");
}
