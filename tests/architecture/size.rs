//! No crate outgrows the others.

use std::fs;
use std::path::Path;

use crate::ALLOWED;
use crate::words::sources;

#[test]
fn no_crate_is_more_than_a_fifth_of_the_lines() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let lines = |folder: &str| -> usize {
        let count = |path: &std::path::PathBuf| fs::read_to_string(path).unwrap().lines().count();
        sources(&root.join(folder)).iter().map(count).sum()
    };
    let sizes: Vec<(&str, usize)> = ALLOWED
        .iter()
        .map(|(folder, _)| (*folder, lines(folder)))
        .collect();
    let whole: usize = sizes.iter().map(|(_, lines)| lines).sum();
    for (folder, lines) in &sizes {
        let share = 100.0 * *lines as f64 / whole as f64;
        println!("{folder:<24} {lines:>6} lines {share:>5.1} %");
    }
    for (folder, lines) in sizes {
        assert!(
            5 * lines <= whole,
            "{folder} has {lines} of {whole} lines of Rust"
        );
    }
}
