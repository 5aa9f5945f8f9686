//! Every link, anchor and picture of the documents leads somewhere.

use std::fs;
use std::path::{Component, Path, PathBuf};

use asperity_tests::markdown::{anchors, links, pages, root};

use crate::chapters::chapters;
use crate::generated::{documents, generated};

/// A path without `.` and `..`.
pub fn normal(path: &Path) -> PathBuf {
    let mut parts = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => {
                parts.pop();
            }
            Component::CurDir => {}
            part => parts.push(part),
        }
    }
    parts
}

/// Why a link of `page` leads nowhere; `None` if it does not.
fn fault(page: &str, link: &str, text: &str, chapters: &[String]) -> Option<String> {
    if ["https://", "http://", "mailto:"]
        .iter()
        .any(|start| link.starts_with(start))
    {
        return None;
    }
    let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
    let packages = ["crates/", "cli/", "fixtures/"];
    if !file.is_empty()
        && page.ends_with("README.md")
        && packages.iter().any(|start| page.starts_with(start))
    {
        return Some(format!(
            "{page}: {link}: a registry shows this page alone; write the path as code"
        ));
    }
    let folder = Path::new(page).parent().unwrap_or(Path::new(""));
    let target = match file {
        "" => PathBuf::from(page),
        _ => normal(&folder.join(file)),
    };
    let name = target.to_string_lossy().replace('\\', "/");
    if !file.is_empty() && !root().join(&target).exists() {
        return Some(format!("{page}: {link}: no such file"));
    }
    // mdBook makes a page of each chapter and copies other files of its folder; anything else is not in the book.
    let is_chapter = |name: &str| chapters.iter().any(|chapter| chapter == name);
    let is_in_book = is_chapter(&name) || (name.starts_with("docs/") && !name.ends_with(".md"));
    if is_chapter(page) && !is_in_book {
        return Some(format!(
            "{page}: {link}: not part of the book; write the path as code"
        ));
    }
    if anchor.is_empty() {
        return None;
    }
    let known = match file {
        "" => anchors(text),
        _ => anchors(&fs::read_to_string(root().join(&target)).unwrap_or_default()),
    };
    (!known.iter().any(|known| known == anchor)).then(|| format!("{page}: {link}: no such heading"))
}

#[test]
fn every_link_leads_to_a_file_and_a_heading() {
    let mut chapters = chapters();
    chapters.extend(generated().iter().map(|(page, _)| page.clone()));
    let mut faults = Vec::new();
    let mut count = 0;
    for (page, text) in documents() {
        for link in links(&text) {
            count += 1;
            faults.extend(fault(&page, &link, &text, &chapters));
        }
    }
    assert!(count > 200, "{count} links");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn links_that_lead_nowhere_are_found() {
    let text = "# One\n\n[a](#one) [b](#two) [c](none.md) [d](../Cargo.toml) [e](UNITS.md#quantities-and-units)";
    let chapters = ["docs/UNITS.md".to_owned(), "docs/X.md".to_owned()];
    let found = |page| -> Vec<String> {
        let found = links(text).into_iter();
        found
            .filter_map(|link| fault(page, &link, text, &chapters))
            .collect()
    };
    let faults = found("docs/X.md");
    assert_eq!(faults.len(), 3, "{faults:?}");
    assert!(faults[0].contains("#two: no such heading"));
    assert!(faults[1].contains("none.md: no such file"));
    assert!(faults[2].contains("../Cargo.toml: not part of the book"));
    assert_eq!(found("docs/OTHER.md").len(), 2);
    let of_package = found("crates/x/README.md");
    assert!(of_package[1].contains("none.md: a registry shows this page alone"));
}

#[test]
fn every_picture_is_a_drawing() {
    for page in pages() {
        let text = fs::read_to_string(root().join(&page)).unwrap();
        let folder = root().join(&page).parent().unwrap().to_owned();
        for link in links(&text).iter().filter(|link| link.ends_with(".svg")) {
            let drawing = fs::read_to_string(folder.join(link)).unwrap();
            // An animation repeats infinitely.
            let drawing = drawing.replace("infinite", "");
            assert!(drawing.contains("<svg"), "{page}: {link}");
            assert!(
                !drawing.contains("NaN") && !drawing.contains("inf"),
                "{page}: {link}"
            );
        }
    }
}
