//! `report.html` of both formulations.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use asperity::case::{CaseInput, FlankPlaceInput};
use asperity::result::MeshOutcome;
use asperity_report::Fields;
use serde_json::Value;

use crate::chromium::{self, Look, Opened};
use crate::looks::{assert_sound, first_look};
use crate::pages::{self, e_drive, paper, shipped};

/// Writes the folder of `outcome` with these fields.
fn written(outcome: &MeshOutcome, fields: &Fields) -> (tempfile::TempDir, PathBuf) {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("result");
    asperity_report::write_folder(outcome, &target, fields).unwrap();
    (place, target)
}

/// Writes the folder of the shipped e-drive, which is run once.
fn shipped_e_drive(fields: &Fields) -> (tempfile::TempDir, PathBuf) {
    static OUTCOME: OnceLock<MeshOutcome> = OnceLock::new();
    let outcome = OUTCOME.get_or_init(|| {
        let loaded = asperity::case::load(&shipped("e-drive.toml"), None).unwrap();
        asperity::Run::new(&loaded)
            .execute()
            .unwrap()
            .into_only()
            .unwrap()
    });
    written(outcome, fields)
}

fn result(folder: &Path) -> Value {
    serde_json::from_str(&text(folder, "result.json")).unwrap()
}

fn text(folder: &Path, file: &str) -> String {
    std::fs::read_to_string(folder.join(file)).unwrap()
}

/// The page prints what `result.json` holds, to the digits it prints.
fn assert_same_numbers(opened: &Opened, result: &Value) {
    for (key, factor) in [
        ("efficiency", 100.0),
        ("loss_w", 1.0),
        ("film_w", 1.0),
        ("lubricated_asperity_w", 1.0),
        ("boundary_w", 1.0),
        ("rolling_w", 1.0),
        ("power_in_w", 1e-3),
        ("torque_out_nm", 1.0),
        ("mu_equivalent", 1.0),
        ("loss_factor_ohlendorf", 1.0),
        ("loss_factor_local", 1.0),
        ("mixed_share", 100.0),
    ] {
        let text = opened.shown(&format!("summary.{key}"));
        let number = text.split(' ').next().unwrap();
        let decimals = number.split_once('.').map_or(0, |(_, after)| after.len());
        let exact = factor * result["summary"][key].as_f64().unwrap();
        if key.ends_with("_w") && !["loss_w", "power_in_w"].contains(&key) {
            // Parts add up to their total as printed, which moves one of them by less than its last place.
            let printed: f64 = number.parse().unwrap();
            let step = if number.contains('e') {
                0.05 * exact
            } else {
                0.1_f64.powi(decimals as i32)
            };
            assert!((printed - exact).abs() < step, "{key}: {printed} {exact}");
        } else {
            assert_eq!(number, format!("{exact:.decimals$}"), "{key}");
        }
        // A loss has the digits that its band allows.
        let is_loss = text.contains(" W");
        assert!(
            decimals > 0 || is_loss,
            "{key} is printed with decimals: {text}"
        );
    }
}

/// Bytes of a page.
const LARGEST: usize = 700_000;

#[test]
fn the_report_holds_all_charts_and_the_numbers_of_the_result_and_is_small() {
    let (_keep, folder) = shipped_e_drive(&Fields::Page);
    let page = text(&folder, "report.html");
    // The other pages are of small cases, but for the scans.
    for (name, page) in [("shipped case", &page)]
        .into_iter()
        .chain(pages::all().iter().map(|page| (&*page.name, &page.text)))
    {
        assert!(page.len() < LARGEST, "{name}: {}", page.len());
    }
    let Some(browser) = chromium::find() else {
        return;
    };
    for opened in chromium::open(browser, &[("report", &page)], &Look::at(&[1400, 420])) {
        assert_sound(&opened);
        assert_same_numbers(&opened, &result(&folder));
        let sizes = opened.found["sizes"].as_array().unwrap();
        assert_eq!(sizes.len(), 21, "all charts of a rough contact are there");
        let sliders = opened.found["sliders"].as_array().unwrap();
        assert_eq!(sliders.len(), 1);
        assert_eq!(
            sliders[0]["positions"],
            result(&folder)["path"].as_array().unwrap().len(),
            "the slider has a place for every position"
        );
    }
}

#[test]
fn the_report_of_the_paper_formulation_has_the_numbers_of_its_one_position() {
    let Some(browser) = chromium::find() else {
        return;
    };
    let mut all = pages::all().iter().zip(first_look(browser));
    let paper = all.find(|(page, _)| page.name == "report, paper");
    let (page, [opened, _]) = paper.unwrap();
    assert_same_numbers(opened, &result(&page.folder));
}

#[test]
fn gears_of_all_kinds_are_drawn_with_labels_that_can_be_read_at_any_width() {
    let at = |roll: &str| {
        Some(FlankPlaceInput {
            roll_length: Some(roll.parse().unwrap()),
            ..FlankPlaceInput::default()
        })
    };
    let changes: [&dyn Fn(&mut CaseInput); 4] = [
        &|input| {
            input.gears.teeth = [24, -75];
            input.gears.helix = None;
        },
        &|input| {
            let wheel = input.surface.wheel.as_mut().unwrap();
            (wheel.mirrored, wheel.at) = (None, at("20 mm"));
            input.surface.pinion.at = at("5 mm");
        },
        // Few teeth of a coarse pair, and many fine ones at a steep helix, whose B and D lie beyond the path.
        &|input| {
            input.gears.teeth = [17, 18];
            input.gears.helix = None;
        },
        &|input| {
            input.gears.teeth = [20, 190];
            input.gears.helix = Some("42 deg".parse().unwrap());
            input.gears.module = "1.4 mm".parse().unwrap();
        },
    ];
    let texts =
        changes.map(|change| text(&written(&e_drive(change), &Fields::Page).1, "report.html"));
    for (number, page) in texts.iter().enumerate() {
        let traces = page.matches("class=\"trace").count();
        // Each has its line and its sample in the legend.
        assert_eq!(traces, if number == 1 { 4 } else { 0 }, "page {number}");
    }
    let Some(browser) = chromium::find() else {
        return;
    };
    let pages: Vec<(&str, &str)> = texts.iter().map(|text| ("gears", text.as_str())).collect();
    for opened in chromium::open(browser, &pages, &Look::at(&[1600, 1000, 500, 360])) {
        assert_sound(&opened);
        assert_eq!(
            opened.found["sliders"][0]["positions"], 4,
            "{}",
            opened.name
        );
    }
}

#[test]
fn a_page_without_scripts_shows_the_first_contact_and_no_slider() {
    let report = crate::pages::all()
        .iter()
        .find(|page| page.name == "report, helical")
        .unwrap();
    let figure = report.text.split("id=\"facing\"").nth(1).unwrap();
    let figure = &figure[..figure.find("<script").unwrap()];
    assert!(figure.contains("<label class=\"slider\" hidden"));
    assert!(figure.contains("data-part=\"film\" d=\"M") && figure.contains("Position "));
    let mesh = report.text.split("id=\"mesh\"").nth(1).unwrap();
    let mesh = &mesh[..mesh.find("<script").unwrap()];
    assert!(mesh.contains("<label class=\"slider\" hidden") && mesh.contains("pitch point C"));
}

#[test]
fn every_chart_names_a_table_that_is_there() {
    let (_keep, folder) = shipped_e_drive(&Fields::All);
    let page = std::fs::read_to_string(folder.join("report.html")).unwrap();
    let named: Vec<&str> = page
        .split("data: <a href=\"")
        .skip(1)
        .map(|rest| &rest[..rest.find('"').unwrap()])
        .collect();
    // A table of published laws has a link as well.
    assert_eq!(named.len(), 1 + page.matches("<figure").count());
    for name in named {
        assert!(folder.join(name).is_file(), "{name}");
    }
}

#[test]
fn the_report_loads_nothing_from_anywhere() {
    let (_keep, folder) = shipped_e_drive(&Fields::Page);
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
    let (_keep, folder) = shipped_e_drive(&Fields::Positions(vec![16]));
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
    let mut outcome = paper();
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
        let text = std::fs::read_to_string(&page).unwrap();
        assert_sound(&chromium::open(browser, &[("long trace", &text)], &Look::at(&[1000]))[0]);
    }
}
