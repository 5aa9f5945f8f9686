//! `report.html` of both formulations.

use std::path::Path;

use asperity::band::run_with_band;
use asperity::case::{CaseInput, FlankPlaceInput, Formulation, load_with};
use asperity::kept_fields::KeptFields;
use asperity::result::Outcome;
use asperity_report::Fields;
use serde_json::Value;

use crate::chromium::{self, Opened};

/// A page may take this long from its start to the end of its self-test, which zooms every chart
/// several times; opening alone is a small part of it.
const PATIENCE_MS: f64 = 5000.0;

/// Runs a shipped case and writes its folder.
fn folder(case: &str, formulation: Option<Formulation>) -> (tempfile::TempDir, std::path::PathBuf) {
    let loaded = asperity::case::load(&shipped(case), formulation).unwrap();
    written(&asperity::run(&loaded, &|_, _| {}).unwrap())
}

fn shipped(case: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../fixtures/cases")
        .join(case)
}

fn written(outcome: &Outcome) -> (tempfile::TempDir, std::path::PathBuf) {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("result");
    asperity_report::write_folder(outcome, &target, &Fields::All).unwrap();
    (place, target)
}

/// A small e-drive, changed.
fn changed(change: &dyn Fn(&mut CaseInput)) -> (tempfile::TempDir, std::path::PathBuf) {
    let small = |input: &mut CaseInput| {
        (input.model.positions, input.model.offsets) = (Some(6), Some(2));
        change(input);
    };
    let loaded = load_with(&shipped("e-drive.toml"), &small).unwrap();
    written(&run_with_band(&loaded, &KeptFields::Highest, &|_, _| {}).unwrap())
}

fn result(folder: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(folder.join("result.json")).unwrap()).unwrap()
}

pub fn assert_sound(opened: &Opened) {
    assert!(opened.console.is_empty(), "{:?}", opened.console);
    let found = opened.selftest();
    assert_eq!(found["faults"], serde_json::json!([]));
    assert_eq!(
        found["resources"],
        serde_json::json!([]),
        "the page fetches nothing"
    );
    assert!(
        found["milliseconds"].as_f64().unwrap() < PATIENCE_MS,
        "{}",
        found["milliseconds"]
    );
    assert_eq!(
        found["labels"],
        serde_json::json!([]),
        "no label is covered or cut"
    );
    for slider in found["sliders"].as_array().unwrap() {
        assert_eq!(slider["different"], slider["positions"], "{slider}");
        assert_eq!(
            (&slider["broken"], &slider["restored"]),
            (&false.into(), &true.into()),
            "{slider}"
        );
        assert!(slider["width"].as_f64().unwrap() > 150.0, "{slider}");
    }
    for figure in found["drawn"].as_array().unwrap() {
        assert!(figure["size"].as_f64().unwrap() > 5.0, "{figure} has drawn");
        assert!(
            figure["width"].as_f64().unwrap() > 200.0,
            "{figure} has room"
        );
    }
    for chart in found["zoom"].as_array().unwrap() {
        for what in ["readOff", "dragged", "restored", "keyed", "whole"] {
            assert_eq!(chart[what], true, "{what} of {chart}");
        }
    }
}

/// The page prints what `result.json` holds, to the digits it prints.
fn assert_same_numbers(opened: &Opened, result: &Value) {
    for (key, factor) in [
        ("efficiency", 100.0),
        ("loss_w", 1.0),
        ("sliding_w", 1.0),
        ("rolling_w", 1.0),
        ("power_in_w", 1e-3),
        ("torque_out_nm", 1.0),
        ("mu_equivalent", 1.0),
        ("loss_factor", 1.0),
        ("loss_factor_local", 1.0),
        ("mixed_share", 100.0),
    ] {
        let text = opened.shown(&format!("summary.{key}"));
        let number = text.split(' ').next().unwrap();
        let decimals = number.split_once('.').map_or(0, |(_, after)| after.len());
        let exact = factor * result["summary"][key].as_f64().unwrap();
        assert_eq!(number, format!("{exact:.decimals$}"), "{key}");
        assert!(decimals > 0, "{key} is printed with decimals: {text}");
    }
}

#[test]
fn every_chart_of_the_report_draws_and_zooms_and_nothing_is_fetched() {
    let Some(browser) = chromium::find() else {
        return;
    };
    let (_keep, folder) = folder("e-drive.toml", None);
    for width in [1400, 420] {
        let opened = chromium::open(browser, &folder.join("report.html"), width);
        assert_sound(&opened);
        assert_same_numbers(&opened, &result(&folder));
        let found = opened.selftest();
        assert_eq!(
            found["drawn"].as_array().unwrap().len(),
            29,
            "all charts of a rough contact are there"
        );
        let sliders = found["sliders"].as_array().unwrap();
        assert_eq!(sliders.len(), 1);
        assert_eq!(
            sliders[0]["positions"],
            result(&folder)["path"].as_array().unwrap().len(),
            "the slider has a place for every position"
        );
    }
}

#[test]
fn the_report_of_the_paper_formulation_draws_with_its_one_position() {
    let Some(browser) = chromium::find() else {
        return;
    };
    let (_keep, folder) = folder("table2.toml", Some(Formulation::Paper));
    let opened = chromium::open(browser, &folder.join("report.html"), 1000);
    assert_sound(&opened);
    assert_same_numbers(&opened, &result(&folder));
}

#[test]
fn gears_of_all_kinds_are_drawn_with_labels_that_can_be_read_at_any_width() {
    let Some(browser) = chromium::find() else {
        return;
    };
    let at = |roll: &str| {
        Some(FlankPlaceInput {
            roll_length: Some(roll.parse().unwrap()),
            ..FlankPlaceInput::default()
        })
    };
    let pages = [
        changed(&|input| {
            input.gears.teeth = [24, -75];
            input.gears.helix = None;
        }),
        changed(&|input| {
            let wheel = input.surface.wheel.as_mut().unwrap();
            (wheel.mirrored, wheel.at) = (None, at("20 mm"));
            input.surface.pinion.at = at("5 mm");
        }),
        // Few teeth of a coarse pair, and many fine ones at a steep helix, whose B and D lie beyond the path.
        changed(&|input| {
            input.gears.teeth = [17, 18];
            input.gears.helix = None;
        }),
        changed(&|input| {
            input.gears.teeth = [20, 190];
            input.gears.helix = Some("42 deg".parse().unwrap());
            input.gears.module = "1.4 mm".parse().unwrap();
        }),
    ];
    for (number, (_keep, folder)) in pages.iter().enumerate() {
        for width in [1600, 1000, 500, 360] {
            let opened = chromium::open(browser, &folder.join("report.html"), width);
            assert_sound(&opened);
            let found = opened.selftest();
            assert_eq!(found["sliders"][0]["positions"], 6, "page {number}");
            let traces = opened.document.matches("class=\"trace").count();
            // Each has its line and its sample in the legend.
            assert_eq!(traces, if number == 1 { 4 } else { 0 }, "page {number}");
        }
    }
}

#[test]
fn a_page_without_scripts_shows_the_first_contact_and_no_slider() {
    let (_keep, folder) = changed(&|_| {});
    let page = std::fs::read_to_string(folder.join("report.html")).unwrap();
    let figure = page.split("id=\"facing\"").nth(1).unwrap();
    let figure = &figure[..figure.find("<script").unwrap()];
    assert!(figure.contains("<label class=\"slider\" hidden"));
    assert!(figure.contains("data-part=\"film\" d=\"M") && figure.contains("Position "));
    /// Bytes of a page with a few positions.
    const LARGEST: usize = 1_000_000;
    assert!(page.len() < LARGEST, "{}", page.len());
}

#[test]
fn a_broken_chart_would_be_noticed() {
    let Some(browser) = chromium::find() else {
        return;
    };
    let (_keep, folder) = folder("table2.toml", Some(Formulation::Paper));
    let page = folder.join("report.html");
    let text = std::fs::read_to_string(&page).unwrap();
    let broken = text.replacen("\"series\":[{", "\"series\":[null,{", 1);
    assert_ne!(text, broken);
    std::fs::write(&page, broken).unwrap();
    let opened = chromium::open(browser, &page, 1000);
    assert!(!opened.console.is_empty() || opened.selftest()["faults"] != serde_json::json!([]));
}

#[test]
fn every_chart_names_a_table_that_is_there() {
    let (_keep, folder) = folder("e-drive.toml", None);
    let page = std::fs::read_to_string(folder.join("report.html")).unwrap();
    let named: Vec<&str> = page
        .split("data: <code>")
        .skip(1)
        .map(|rest| &rest[..rest.find('<').unwrap()])
        .collect();
    assert_eq!(named.len(), page.matches("<figure").count());
    for name in named {
        assert!(folder.join(name).is_file(), "{name}");
    }
}

#[test]
fn the_report_loads_nothing_from_anywhere() {
    let (_keep, folder) = folder("e-drive.toml", None);
    let page = std::fs::read_to_string(folder.join("report.html")).unwrap();
    for loader in [
        "src=",
        "@import",
        "url(http",
        "<link",
        "fetch(",
        "XMLHttpRequest",
        "<img",
        "<iframe",
    ] {
        assert!(!page.contains(loader), "{loader}");
    }
    assert!(page.contains("default-src 'none'"));
}

#[test]
fn a_report_is_drawn_anew_from_its_folder_with_another_position() {
    let (_keep, folder) = folder("e-drive.toml", None);
    let page = folder.join("report.html");
    let first = std::fs::read_to_string(&page).unwrap();
    asperity_report::redraw(&folder.join("result.json"), None).unwrap();
    assert_eq!(std::fs::read_to_string(&page).unwrap(), first);
    asperity_report::redraw(&folder, Some(16)).unwrap();
    assert!(
        std::fs::read_to_string(&page)
            .unwrap()
            .contains("Position 16 of 16")
    );
    assert!(asperity_report::redraw(&folder, Some(17)).is_err());
}

#[test]
fn a_trace_of_a_hundred_thousand_points_makes_a_page_that_still_opens_quickly() {
    // Tables are thinned for display: a long trace must not make a page of its size.
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases/table2.toml");
    let loaded = asperity::case::load(&path, Some(Formulation::Paper)).unwrap();
    let mut outcome = asperity::run(&loaded, &|_, _| {}).unwrap();
    let heights = (0..100_000).map(|i| 1e-7 * (f64::from(i) * 0.37).sin());
    let spacing = "0.5 um".parse().unwrap();
    let long = asperity_core::Profile::new(spacing, heights.collect()).unwrap();
    outcome.traces[0] = Some(long);
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("result");
    asperity_report::write_folder(&outcome, &target, &Fields::Page).unwrap();
    let page = target.join("report.html");
    /// Bytes of the page, whatever the length of the trace.
    const LARGEST: u64 = 1_000_000;
    assert!(std::fs::metadata(&page).unwrap().len() < LARGEST);
    if let Some(browser) = chromium::find() {
        assert_sound(&chromium::open(browser, &page, 1000));
    }
}
