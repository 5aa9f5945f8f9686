//! Number of crates that a program builds which embeds the crate `asperity`.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

/// Maximum number of crates without default features.
const MOST: usize = 65;

fn crates(features: &[&str]) -> usize {
    let tree = Command::new(env!("CARGO"))
        .args(["tree", "-p", "asperity", "-e", "normal", "--prefix", "none"])
        .args(["--locked", "--offline"])
        .args(features)
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
        .output()
        .unwrap();
    let text = String::from_utf8(tree.stdout).unwrap();
    assert!(tree.status.success(), "{features:?}");
    let package = |line: &str| line.split(' ').take(2).collect::<Vec<_>>().join(" ");
    text.lines().map(package).collect::<BTreeSet<_>>().len()
}

/// The tree is that of the system, and the page states the one of Linux.
#[cfg(target_os = "linux")]
#[test]
fn the_crates_of_an_embedding_program_are_as_many_as_its_page_states() {
    let [all, least] = [crates(&[]), crates(&["--no-default-features"])];
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/howto/embed.md");
    let page = std::fs::read_to_string(page).unwrap();
    let stated = format!("{least} crates instead of {all}");
    assert!(page.contains(&stated), "docs/howto/embed.md: {stated}");
    assert!(least <= MOST, "{least} crates, more than {MOST}");
}
