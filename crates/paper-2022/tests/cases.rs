//! Shipped cases in the paper's formulation.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity::case::{LoadedCase, load};
use asperity::core::Checked;
use asperity::ehl_regime::{FilmConditions, FilmThickness, FilmThicknessLaw, RegimeError};
use asperity::quantity::Length;
use asperity::result::RunResult;
use asperity_paper_2022::{figures, film, register};

fn cases() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases");
    let entries = std::fs::read_dir(folder).unwrap();
    let mut cases: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    cases.sort();
    assert!(cases.len() >= 4);
    cases
}

fn shipped(case: &Path) -> LoadedCase {
    load(case, Some(register())).unwrap()
}

#[test]
fn every_fixture_case_is_equal_after_a_round_trip_through_json() {
    for case in cases() {
        let run = asperity::Run::new(&shipped(&case))
            .execute()
            .unwrap()
            .into_only()
            .unwrap();
        let text = serde_json::to_string_pretty(&run.result).unwrap();
        let back: RunResult = serde_json::from_str(&text).unwrap();
        assert_eq!(back, run.result, "{}", case.display());
        assert_eq!(serde_json::to_string_pretty(&back).unwrap(), text);
        assert_eq!(back.formulation, register());
        assert_eq!(back.path.len(), 1);
        // The solids of the march carry the load that its fluid leaves.
        let steps = &run.fields[0].history;
        assert!(steps.is_empty() || steps.last().unwrap().load_error < 0.01);
    }
}

#[test]
fn a_gradient_over_the_heights_is_refused() {
    let error = asperity::pipeline::check_heights(&shipped(&cases()[0])).unwrap_err();
    assert!(
        error.to_string().contains("formulation = \"paper\""),
        "{error}"
    );
}

#[test]
fn a_flank_without_a_trace_is_refused() {
    let case = shipped(&cases()[0]).with(|input| {
        input.surface.wheel = Some(asperity::case::FlankInput {
            rq: "0.3 um".parse().ok(),
            ..Default::default()
        });
    });
    let error = asperity::Run::new(&case.unwrap()).losses().err().unwrap();
    assert_eq!(error.code(), "E303", "{error}");
}

#[test]
fn each_figure_has_its_drawing_and_its_table() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().join("figures");
    let table_2 = cases()
        .into_iter()
        .find(|case| case.ends_with("table2.toml"))
        .unwrap();
    let written = figures::write(&shipped(&table_2), &folder).unwrap();
    let names: Vec<&str> = written
        .iter()
        .map(|file| file.file_name().unwrap().to_str().unwrap())
        .collect();
    assert_eq!(names, figures::FILES);
}

/// A film without thickness.
#[derive(Debug)]
struct NoFilm;

impl FilmThicknessLaw for NoFilm {
    fn name(&self) -> &str {
        "no film"
    }

    fn film(&self, _: &FilmConditions) -> Result<Checked<FilmThickness>, RegimeError> {
        let [central, minimum] = [1e-7, 0.0].map(Length::from_si);
        Ok(Checked::inside(FilmThickness { central, minimum }))
    }

    fn speed_exponent(&self) -> f64 {
        0.7
    }
}

#[test]
fn pressure_across_a_film_that_cannot_be_is_refused() {
    let case = load(&cases()[0], None).unwrap();
    assert_eq!(film(&case, None).unwrap().rows.len(), 25);
    let case = case.with_laws(|laws| laws.film = Some(Arc::new(NoFilm)));
    assert_eq!(film(&case, None).unwrap_err().code(), "E308");
}
