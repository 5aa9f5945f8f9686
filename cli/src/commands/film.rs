//! `asperity film`: fluid pressure across the film over its thickness, Fig. 8 of the paper.

use asperity_core::by_size;
use asperity_paper_2022::{FilmRow, FilmSurvey, film as survey};
use asperity_report::{Cell, Report, columns};

use super::{load_case, on_the_path};
use crate::args::{Common, FilmArgs};
use crate::failure::Failure;
use crate::output::print_report;

/// `asperity film`
pub fn film(args: &FilmArgs, common: &Common) -> Result<(), Failure> {
    let loaded = load_case(&args.case, &args.set, None)?;
    let position = on_the_path(&loaded, args.position)?;
    let survey = survey(&loaded, position).map_err(|error| Failure::about(&args.case, &error))?;
    let title = &loaded.case.title;
    print_report(common, || &survey, || report(title, &survey), None)
}

fn report<'a>(title: &str, survey: &FilmSurvey) -> Report<'a> {
    /// Share of the Hertz pressure from which a difference matters.
    const MUCH: f64 = 0.01;
    let micrometres = |row: &FilmRow| row.thickness_m * 1e6;
    let mut rows = survey.rows.iter();
    let own = rows.find(|row| row.thickness_m >= survey.film_central_m);
    let own = own.map(|row| {
        format!(
            "Across a film of {:.3} µm the pressure differs by {:.1e} of the Hertz pressure.",
            micrometres(row),
            row.ratio_to_hertz
        )
    });
    let mut rows = survey.rows.iter();
    let much = rows.find(|row| row.ratio_to_hertz >= MUCH).map(|row| {
        format!(
            "The difference reaches {:.0} % of it in a film of {:.3} µm.",
            100.0 * MUCH,
            micrometres(row)
        )
    });
    let place = format!(
        "Central film {:.3} µm and Hertz pressure {:.0} MPa at {:.4} of the path.",
        survey.film_central_m * 1e6,
        survey.hertz_pressure_pa * 1e-6,
        survey.path_fraction
    );
    let table = columns! { row in &survey.rows;
        number thickness "film" "µm" = Cell::number(row.thickness_m * 1e6, |um| by_size(um, 4));
        number reynolds_cross_pa "reynolds-cross" "Pa" "{:.4e}";
        number paper_pa "paper" "Pa" "{:.4e}";
        number ratio_to_hertz "ratio to p0" "" "{:.2e}";
        number thickness_over_radius "film over radius" "" "{:.1e}";
    };
    Report::new(title, "")
        .verdict(own)
        .verdict(much)
        .verdict([place])
        .heading("Pressure difference across the film, by two models")
        .table(table)
}
