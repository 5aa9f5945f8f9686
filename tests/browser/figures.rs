//! The paper's figures: all are made, small, with their tables, and the documents show them as they are made now.

use std::path::Path;

use asperity_tests::picture::difference;

#[test]
fn every_figure_has_its_table_and_a_place_in_the_docs() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut all = crate::pages::all().iter();
    let page = all.find(|page| page.name == "figures").unwrap();
    let entries = std::fs::read_dir(&page.folder).unwrap();
    let files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    // The names that are checked before the computation are those that it writes.
    let mut names: Vec<_> = files
        .iter()
        .map(|file| file.file_name().unwrap().to_string_lossy().into_owned())
        .filter(|name| name.starts_with("fig"))
        .collect();
    names.sort();
    assert_eq!(names, asperity_paper_2022::figures::FILES);
    let docs = std::fs::read_to_string(root.join("docs/PAPER.md")).unwrap();
    for number in ["06", "07", "08", "09", "10", "11", "12", "13"] {
        let of = |ending: &str| {
            files.iter().any(|file| {
                let name = file.file_name().unwrap().to_string_lossy();
                name.contains(&format!("fig{number}")) && name.ends_with(ending)
            })
        };
        assert!(of(".svg") && of(".csv"), "figure {number}");
    }
    /// Limit of what a code host shows without complaint.
    const LARGEST: u64 = 200_000;
    for file in files
        .iter()
        .filter(|file| file.extension().is_some_and(|e| e == "svg"))
    {
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        assert!(std::fs::metadata(file).unwrap().len() < LARGEST, "{name}");
        assert!(
            docs.contains(&format!("figures/{name}")),
            "{name} is shown in docs/PAPER.md"
        );
        let text = std::fs::read_to_string(file).unwrap();
        let committed = std::fs::read_to_string(root.join("docs/figures").join(&name)).unwrap();
        // `just pictures` makes them anew, with their tables.
        assert_eq!(difference(&committed, &text), None, "{name}");
        assert!(!text.contains("NaN") && !text.contains("inf"), "{name}");
    }
}
