//! Pressure across the film of Table 2, the paper's Fig. 8.

use std::fmt::Write;

use asperity_paper_2022::{FilmSurvey, film};
use asperity_tests::table_2;

use crate::comparison::{Comparison, Table, digits};

fn survey(place: Option<f64>) -> FilmSurvey {
    film(&table_2().load(), place).unwrap()
}

/// The row next to a thickness \[m\].
fn at(survey: &FilmSurvey, thickness: f64) -> &asperity_paper_2022::FilmRow {
    survey
        .rows
        .iter()
        .find(|row| (row.thickness_m / thickness - 1.0).abs() < 1e-9)
        .unwrap()
}

/// Difference across 100 nm by the paper's equation \[Pa\], and that across 1 µm over the Hertz pressure.
pub fn across_thin_films() -> (f64, f64) {
    let survey = survey(None);
    (at(&survey, 1e-7).paper_pa, at(&survey, 1e-6).ratio_to_hertz)
}

pub fn at_the_pitch_point() -> Table {
    // Closed forms against closed forms in double precision; the paper's loses digits where its
    // terms cancel.
    const DIGITS: f64 = 1e-9;
    let survey = survey(None);
    let (thin, thick) = (at(&survey, 1e-7), at(&survey, 1e-3));
    let row = |quantity: &str, expected, actual| {
        Comparison::new(quantity, "Pa", expected, actual, DIGITS)
    };
    Table {
        name: "film-values",
        test: "the_pressure_across_the_film_is_that_computed_elsewhere",
        rows: vec![
            row(
                "100 nm, reynolds-cross",
                0.059_674_199_448_826_8,
                thin.reynolds_cross_pa,
            ),
            row("100 nm, paper", 0.059_674_113_946_688_14, thin.paper_pa),
            row("1 mm, paper", 588.351_677_938_071_9, thick.paper_pa),
        ],
    }
}

#[test]
fn the_pressure_across_the_film_is_that_computed_elsewhere() {
    at_the_pitch_point().hold();
}

pub fn over_thickness() -> String {
    let mut text = String::from(
        "| film | reynolds-cross Pa | paper Pa | larger of both over p₀ |\n|---|---|---|---|\n",
    );
    let survey = survey(None);
    for (name, thickness) in [
        ("1 nm", 1e-9),
        ("10 nm", 1e-8),
        ("100 nm", 1e-7),
        ("1 µm", 1e-6),
        ("10 µm", 1e-5),
        ("100 µm", 1e-4),
        ("1 mm", 1e-3),
    ] {
        let row = at(&survey, thickness);
        let _ = writeln!(
            text,
            "| {name} | {} | {} | {:.2e} |",
            digits(row.reynolds_cross_pa),
            digits(row.paper_pa),
            row.ratio_to_hertz
        );
    }
    text.push_str("\nTests: `across_thin_films_the_pressure_hardly_varies`, `across_thick_films_it_grows_with_thickness_over_radius`.\n");
    text
}

#[test]
fn across_thin_films_the_pressure_hardly_varies() {
    let survey = survey(None);
    for row in &survey.rows {
        if row.thickness_m < 1.01e-7 {
            assert!(
                row.reynolds_cross_pa.abs() <= 1.0 && row.paper_pa.abs() <= 1.0,
                "{row:?}"
            );
        }
        if row.thickness_m < 1.01e-6 {
            assert!(row.ratio_to_hertz < 1e-3, "{row:?}");
        }
    }
    // The smallest and the largest thickness of the figure.
    assert!(survey.rows[0].thickness_m < 1.01e-9);
    assert!(survey.rows.last().unwrap().thickness_m > 0.99e-3);
}

#[test]
fn across_thick_films_it_grows_with_thickness_over_radius() {
    // Rolling walls at u: ρ u² ln(1 + h/r₂), which is h/r₂ up to the next term of the logarithm.
    let case = table_2().load().at_stated().unwrap();
    let pitch = case
        .gears
        .kinematics(case.gears.path().c, case.speed)
        .unwrap();
    let scale = case.oil().density.si() * pitch.entrainment.si().powi(2);
    for row in survey(None).rows {
        let ratio = row.thickness_over_radius;
        for difference in [row.reynolds_cross_pa, row.paper_pa] {
            let relative = difference / (scale * ratio) - 1.0;
            assert!(relative.abs() <= 0.5 * ratio + 1e-9, "{row:?}: {relative}");
        }
    }
}

#[test]
fn sliding_walls_leave_the_consistent_film_alone() {
    // At A and E the walls slide. The consistent film hardly notices; the paper's radial momentum,
    // whose parabola does not conserve the flow, loses its meaning there.
    for place in [0.0, 1.0] {
        let survey = survey(Some(place));
        let thin = at(&survey, 1e-7);
        assert!(thin.reynolds_cross_pa.abs() <= 1.0, "{thin:?}");
        assert!(
            thin.paper_pa.abs() > 1e3 * thin.reynolds_cross_pa.abs(),
            "{thin:?}"
        );
    }
}
