//! The page of a comparison, and what it compares.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use asperity::case::{CaseInput, FlankInput, load_with};
use asperity_report::StudyResult;
use asperity_studies::compare::{Comparison, Finish, compare};

fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures")
}

fn finish(name: &str, files: [&str; 2]) -> Finish {
    let flank = |file: &str, mirrored| FlankInput {
        file: Some(
            fixtures()
                .canonicalize()
                .unwrap()
                .join("profiles")
                .join(file),
        ),
        mirrored: Some(mirrored),
        ..FlankInput::default()
    };
    let change = |input: &mut CaseInput| {
        input.surface.pinion = flank(files[0], false);
        input.surface.wheel = Some(flank(files[1], true));
        input.model.offsets = Some(12);
        input.model.positions = Some(4);
    };
    let case = load_with(&fixtures().join("cases/e-drive.toml"), &change).unwrap();
    Finish {
        name: name.to_owned(),
        case,
    }
}

fn ground_and_superfinished() -> &'static Comparison {
    static FOUND: OnceLock<Comparison> = OnceLock::new();
    FOUND.get_or_init(|| {
        let finishes = [
            finish("ground", ["ground_pinion.csv", "ground_wheel.csv"]),
            finish(
                "superfinished",
                ["superfinished.csv", "superfinished_wheel.csv"],
            ),
            finish("ground again", ["ground_pinion.csv", "ground_wheel.csv"]),
        ];
        compare(&finishes, &|_, _| {}).unwrap()
    })
}

#[test]
fn a_finish_does_not_differ_from_itself_and_superfinishing_pays() {
    let found = ground_and_superfinished();
    let of = |index: usize| found.finishes[index].difference.clone().unwrap();
    let same = of(2);
    assert_eq!((same.at_medians_w, same.watts.ends()), (0.0, [0.0; 2]));
    assert!(of(1).watts.high < 0.0, "{:?}", of(1));
    assert!(found.finishes[0].difference.is_none());
    // Far smoother flanks lose far less: the closest parameters order the windows as the losses do.
    let size = |index: usize| found.correlations[index].with_loss.abs();
    assert!(
        found.correlations[0].with_loss > 0.5,
        "{:?}",
        found.correlations
    );
    assert!((1..found.correlations.len()).all(|index| size(index) <= size(index - 1)));
}

#[test]
fn the_tables_that_the_page_of_a_comparison_names_are_there() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("compared");
    let found = ground_and_superfinished();
    found.write(&folder).unwrap();
    // An older comparison is replaced as a whole.
    found.write(&folder).unwrap();
    let page = std::fs::read_to_string(folder.join("compare.html")).unwrap();
    for rest in page.split("data: <code>").skip(1) {
        assert!(folder.join(&rest[..rest.find('<').unwrap()]).is_file());
    }
}
