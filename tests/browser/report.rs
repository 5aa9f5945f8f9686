//! `report.html` of both formulations.

use std::path::Path;

use asperity::case::Formulation;
use asperity_report::Fields;
use serde_json::Value;

use crate::chromium::{self, Opened};

/// A page may take this long from its start to the end of its self-test, which zooms every chart
/// several times; opening alone is a small part of it.
const PATIENCE_MS: f64 = 5000.0;

/// Runs a shipped case and writes its folder.
fn folder(case: &str, formulation: Option<Formulation>) -> (tempfile::TempDir, std::path::PathBuf) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../fixtures/cases")
        .join(case);
    let loaded = asperity::case::load(&path, formulation).unwrap();
    let outcome = asperity::run(&loaded, &|_, _| {}).unwrap();
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("result");
    asperity_report::write_folder(&outcome, &target, &Fields::All).unwrap();
    (place, target)
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
