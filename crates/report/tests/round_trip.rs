//! A result is equal after it was written and read, whichever case it is of.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use asperity::case::load_with;
use asperity::result::{MeshOutcome, RunResult};
use asperity_core::{Code, Fault};
use asperity_report::tables::{FlankTables, SurfaceRow, TraceRow};
use asperity_report::{Fields, PageTables, read_result, redraw, texts, thin, write_folder};

fn cases() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases");
    let entries = fs::read_dir(folder).unwrap();
    let mut cases: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    cases.sort();
    assert!(cases.len() >= 4);
    cases
}

/// A case with few positions and offsets: what is written has the same fields as that of many.
fn outcome(case: &Path) -> MeshOutcome {
    let loaded = load_with(case, &|input| {
        input.model.positions = Some(4);
        input.model.offsets = Some(2);
        input.model.depths = Some(8);
    });
    asperity::Run::new(&loaded.unwrap())
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
}

/// The first case, run once.
fn smallest() -> MeshOutcome {
    static RUN: OnceLock<MeshOutcome> = OnceLock::new();
    RUN.get_or_init(|| outcome(&cases()[0])).clone()
}

/// Tables of a flank for display, from whole tables.
fn thinned_flank(whole: FlankTables) -> FlankTables {
    const BINS: usize = 350;
    let heights = |row: &TraceRow| {
        let rough = row.roughness_um.unwrap_or(f64::NAN);
        [row.measured_um, row.form_removed_um, rough]
    };
    let (trace, ratios) = (&whole.trace, &whole.material_ratio);
    assert!(trace.len() > 2 * BINS && ratios.len() > 2 * BINS);
    FlankTables {
        trace: thin(trace, BINS, |row| row.x_um, heights),
        material_ratio: thin(
            ratios,
            BINS,
            |row| row.material_ratio_percent,
            |row| [row.height_um],
        ),
        spectrum: whole.spectrum_in_bands(),
    }
}

#[test]
fn every_fixture_case_is_equal_after_a_round_trip_through_json() {
    for case in cases() {
        let result = outcome(&case).result;
        let text = serde_json::to_string_pretty(&result).unwrap();
        let back: RunResult = serde_json::from_str(&text).unwrap();
        assert_eq!(back, result, "{}", case.display());
        assert_eq!(serde_json::to_string_pretty(&back).unwrap(), text);
    }
}

#[test]
fn the_files_in_memory_are_those_of_the_folder() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("result");
    let outcome = smallest();
    write_folder(&outcome, &folder, &Fields::Page).unwrap();
    let held = texts(&outcome).unwrap();
    for (name, text) in &held {
        assert_eq!(&fs::read(folder.join(name)).unwrap(), text, "{name}");
    }
    // Beside them stands the manifest alone.
    assert_eq!(fs::read_dir(&folder).unwrap().count(), held.len() + 1);
}

#[test]
fn a_page_drawn_from_the_folder_is_the_page_drawn_from_the_run() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("result");
    let outcome = smallest();
    write_folder(&outcome, &folder, &Fields::Page).unwrap();
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    let (found, result) = read_result(&folder.join("result.json")).unwrap();
    assert_eq!((found, result), (folder.clone(), outcome.result));
    fs::remove_file(folder.join("report.html")).unwrap();
    let drawn = redraw(&folder, None).unwrap();
    assert_eq!(fs::read_to_string(drawn).unwrap(), page);
}

#[test]
fn a_value_that_is_missing_or_damaged_is_named_with_its_place() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("result");
    write_folder(&smallest(), &folder, &Fields::All).unwrap();
    let file = folder.join("result.json");
    let text = fs::read_to_string(&file).unwrap();
    for (seen, instead, key) in [
        ("\"efficiency\":", "\"efficiencies\":", "summary"),
        (
            "\"loss_w\": ",
            "\"loss_w\": null, \"was\": ",
            "summary.loss_w",
        ),
        (
            "\"s_mm\": ",
            "\"s_mm\": \"near\", \"was\": ",
            "path[0].s_mm",
        ),
        (
            "\"centre_distance\": \"",
            "\"centre_distance\": \"x",
            "centre_distance",
        ),
    ] {
        let damaged = text.replacen(seen, instead, 1);
        assert_ne!(damaged, text, "{seen}");
        fs::write(&file, damaged).unwrap();
        match redraw(&folder, None) {
            Err(error) => {
                let said = error.to_string();
                assert_eq!(error.code(), Code::E402, "{seen}");
                assert!(said.contains(key), "{said} names {key}");
            }
            Ok(_) => panic!("{seen}"),
        }
    }
}

fn is_refused<T>(found: Result<T, Fault>, code: Code, says: &str) {
    let error = found.map(|_| ()).unwrap_err();
    assert_eq!(error.code(), code, "{error}");
    assert!(error.to_string().contains(says), "{error}");
}

/// A position whose contact the page does not show.
fn hidden(folder: &Path) -> String {
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    let shown = |name: &&str| page.contains(&format!("Position {} of 4, at", &name[9..]));
    let names = ["position_1", "position_2", "position_3", "position_4"];
    let hidden = names.iter().find(|name| !shown(name)).unwrap();
    hidden[9..].to_owned()
}

#[test]
fn a_table_that_is_missing_or_damaged_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("result");
    write_folder(&smallest(), &folder, &Fields::All).unwrap();
    let page = fs::read(folder.join("report.html")).unwrap();
    let number: usize = hidden(&folder).parse().unwrap();
    let file = folder.join(format!("position_{number:02}/surface.csv"));
    let text = fs::read_to_string(&file).unwrap();
    let (header, rows) = text.split_once('\n').unwrap();
    let first = rows.lines().next().unwrap();
    let cells = "1,".repeat(10);
    for damaged in [
        format!("{header}\n"),
        text.replacen("gap_um", "gap", 1),
        text.replacen(first, &format!("NaN,{cells}1"), 1),
        text.replacen(first, &format!("inf,{cells}1"), 1),
        text.replacen(first, "1,1", 1),
        text.replacen(first, &format!("one,{cells}1"), 1),
    ] {
        fs::write(&file, &damaged).unwrap();
        let refused = redraw(&folder, Some(number));
        is_refused(refused, Code::E402, "not a table of this result: ");
    }
    fs::remove_file(&file).unwrap();
    let refused = redraw(&folder, Some(number));
    is_refused(refused, Code::E402, " were not stored in ");
    fs::write(folder.join("page.json"), "{}").unwrap();
    let refused = redraw(&folder, None);
    is_refused(refused, Code::E402, "not a result of asperity run: ");
    let kept = fs::read(folder.join("report.html")).unwrap();
    assert_eq!(kept, page, "the old page stays");
}

#[test]
fn a_folder_keeps_the_fields_that_were_asked_for() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("result");
    let outcome = smallest();
    let of = |fields: &Fields| {
        write_folder(&outcome, &folder, fields).unwrap();
        (1..=4)
            .map(|n| folder.join(format!("position_{n:02}")).is_dir())
            .collect::<Vec<_>>()
    };
    assert_eq!(of(&Fields::All), [true; 4]);
    assert_eq!(of(&Fields::Positions(vec![2])), [false, true, false, false]);
    assert_eq!(of(&Fields::Page), [false; 4]);
    let size: u64 = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().metadata().unwrap().len())
        .sum();
    /// Bytes of a folder with every field are about ten times this.
    const MOST: u64 = 2_500_000;
    assert!(size < MOST, "{size} bytes");
    let none = write_folder(&outcome, &folder, &Fields::Positions(vec![9]));
    is_refused(
        none,
        Code::E402,
        "position 9 is not among the 4 of the result",
    );
}

#[test]
fn a_number_that_is_not_finite_is_never_written() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("result");
    for bad in [f64::NAN, f64::INFINITY] {
        let mut outcome = smallest();
        outcome.result.summary.loss_w = bad;
        let refused = write_folder(&outcome, &folder, &Fields::Page);
        is_refused(refused, Code::E501, "not written: summary.loss_w is ");
        assert_eq!(
            fs::read_dir(place.path()).unwrap().count(),
            0,
            "nothing is left"
        );
    }
}

#[test]
fn the_thinned_tables_of_a_contact_keep_the_extremes_of_the_fields() {
    let ends = |values: &mut dyn Iterator<Item = f64>| {
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
            [low.min(v), high.max(v)]
        })
    };
    for case in ["e-drive.toml", "table2.toml"] {
        let place = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases");
        let outcome = outcome(&place.join(case));
        let tables = PageTables::new(&outcome, None).unwrap();
        let whole = tables.contact.as_ref().unwrap();
        let fields = &outcome.fields[whole.position - 1];
        let below = fields.subsurface.as_ref().unwrap();
        // Six digits are kept.
        let near = |[low, high]: [f64; 2], [a, b]: [f64; 2]| {
            (low - a).abs() < 1e-5 * b && (high - b).abs() < 1e-5 * b
        };
        let stresses = ends(&mut whole.subsurface.iter().map(|row| row.von_mises_mpa));
        let exact = ends(&mut below.von_mises.iter().map(|stress| 1e-6 * stress));
        assert!(near(stresses, exact), "{case}: {stresses:?} {exact:?}");
        // The zone that yields is where the von Mises stress exceeds the elastic limit of the softer steel.
        let row = &outcome.result.path[whole.position - 1];
        let yields = whole
            .subsurface
            .iter()
            .filter(|row| row.plastic_stress_mpa > 0.0);
        let limits = yields
            .clone()
            .map(|row| row.von_mises_mpa - row.plastic_stress_mpa);
        let limit = if case == "table2.toml" { 235.0 } else { 1500.0 };
        assert!(limits.clone().all(|of| (of - limit).abs() < 0.02) && limits.count() > 0);
        let elastic = whole
            .subsurface
            .iter()
            .filter(|row| row.plastic_stress_mpa == 0.0);
        assert!(elastic.clone().all(|row| row.von_mises_mpa < limit + 0.02) && elastic.count() > 0);
        let deepest = yields.map(|row| row.depth_um).fold(0.0, f64::max);
        let depth = row.yield_depth_um.unwrap();
        assert!(
            (deepest - depth).abs() < 1e-5 * depth,
            "{case}: {deepest} {depth}"
        );
        let share = row.yield_share.unwrap();
        assert!(share > 0.0 && share < 1.0, "{case}: {share}");
        let page = asperity_report::html::render(&outcome.result, &tables).unwrap();
        let says = format!(
            "down to {depth:.0} µm. It does so in {:.1} % of the section",
            100.0 * share
        );
        assert!(page.contains(&says), "{case}: {says}");
        assert!(
            page.contains(&format!("elastic limit {limit:.0} MPa")),
            "{case}"
        );
        let shown = tables.thinned(&outcome.result, "page.json").unwrap();
        let surface = &shown.contact.unwrap().surface;
        assert!(surface.len() < whole.surface.len());
        let columns: [fn(&SurfaceRow) -> f64; 8] = [
            |row| row.height_pinion_um,
            |row| row.height_pinion_um - row.displacement_pinion_um,
            |row| row.gap_um,
            |row| row.plastic_pinion_um,
            |row| row.plastic_wheel_um,
            |row| row.pressure_solid_mpa,
            |row| row.pressure_fluid_mpa,
            |row| row.pressure_hertz_mpa,
        ];
        for (number, column) in columns.iter().enumerate() {
            let kept = ends(&mut surface.iter().map(column));
            let all = ends(&mut whole.surface.iter().map(column));
            assert_eq!(kept, all, "{case}: column {number}");
        }
        for (record, trace) in outcome.result.flanks.iter().zip(&outcome.traces) {
            for mirrored in [record.mirrored, !record.mirrored] {
                let mut record = record.clone();
                record.mirrored = mirrored;
                let whole = FlankTables::new(&record, trace.as_ref()).unwrap();
                let shown = FlankTables::shown(&record, trace.as_ref()).unwrap();
                assert_eq!(
                    shown,
                    whole.map(thinned_flank),
                    "{case}, mirrored: {mirrored}"
                );
            }
        }
    }
}
