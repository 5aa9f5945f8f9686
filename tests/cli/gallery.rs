//! README, gallery, tutorial and other pages of the demo run in one folder, as they share commands: they print what they show, and
//! the pictures are figures of the pages that they write.

use std::fs;

use asperity_tests::picture::{Figure, animated, hold_picture};

use crate::bench::root;
use crate::transcripts::{bench, holds};

/// Pictures in `docs/gallery`, with the page and its figure.
const PICTURES: [(&str, &str, &str); 11] = [
    ("finishes", "demo-case-compare/compare.html", "local-losses"),
    (
        "wrong_oil",
        "wrong_oil-sweep/sweep.html",
        "loss_w-over-base-oil",
    ),
    (
        "hot_day",
        "hot_day-sweep/sweep.html",
        "loss_w-over-operation-bulk_temperature",
    ),
    ("ridges", "demo-case-ridges/ridges.html", "watts-pinion"),
    ("running_in", "running-in/running_in.html", "loss"),
    ("relief", "relief/report.html", "load"),
    ("planetary", "planetary/sun_planet/report.html", "mesh"),
    ("own_law", "own-law/report.html", "friction"),
    ("rig", "rig/calibration.html", "measured"),
    ("traction", "m100-traction/traction.html", "over-slide"),
    ("cycle", "demo-case-map-urban/cycle.html", "loss-0-0"),
];

#[test]
#[ignore = "slow: just test-all"]
fn slow_pages_of_the_demo_print_what_they_show_and_their_pictures_are_drawn() {
    let bench = bench();
    holds("README.md", &bench, 10);
    let read = |page: &str| fs::read_to_string(bench.path("results").join(page)).unwrap();
    let report = read("e-drive/report.html");
    hold_picture("figures/mesh.svg", &animated(&report));
    for (name, figure) in [("band", "band"), ("local_loss", "local-loss")] {
        let file = format!("figures/{name}.svg");
        hold_picture(&file, &Figure::new(&report, figure).alone());
    }

    let files = fs::read_dir(root().join("docs/gallery")).unwrap();
    for file in files.map(|entry| entry.unwrap().path()) {
        if file.extension().is_some_and(|ending| ending == "toml") {
            let name = file.file_name().unwrap().to_str().unwrap();
            fs::create_dir_all(bench.path("docs/gallery")).unwrap();
            fs::copy(&file, bench.path("docs/gallery").join(name)).unwrap();
        }
    }
    holds("docs/GALLERY.md", &bench, 20);
    let document = fs::read_to_string(root().join("docs/GALLERY.md")).unwrap();
    for (name, page, figure) in PICTURES {
        let page = read(page);
        let file = format!("gallery/{name}.svg");
        hold_picture(&file, &Figure::new(&page, figure).alone());
        assert!(document.contains(&format!("]({file})")), "{file}");
    }
    // The sweep has the loss of the run for the oil of the case.
    let loss = |file: &str, row: &str| {
        let text = read(file);
        let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let header = lines.next().unwrap();
        let column = header.iter().position(|name| *name == "loss_w");
        let row = lines.find(|cells| cells.contains(&row)).unwrap();
        row[column.unwrap()].parse::<f64>().unwrap()
    };
    let swept = loss("wrong_oil-sweep/sweep.csv", "polyalphaolefin");
    let compared = loss("demo-case-compare/compare.csv", "ground");
    assert!((swept / compared - 1.0).abs() < 1e-12, "{swept} {compared}");
    let hot = read("hot_day-sweep/sweep.html");
    assert!(hot.contains("All cases have model.offsets = 4 and model.positions = 6."));
    holds("docs/TUTORIAL.md", &bench, 40);
    holds("docs/howto/rig.md", &bench, 30);
    holds("docs/howto/vehicle.md", &bench, 12);
    holds("docs/howto/what-matters.md", &bench, 15);
}
