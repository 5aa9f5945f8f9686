//! Fig. 8: pressure difference across thin and thick films.

use std::path::Path;

use asperity::case::LoadedCase;
use asperity_core::Fault;
use asperity_report::chart::{Axis, Chart, Line, Series};
use asperity_report::tables::write;

use super::figure::PaperFigure;
use crate::film_survey::{FilmRow, film};

pub(super) fn figures(case: &LoadedCase, folder: &Path) -> Result<Vec<PaperFigure>, Fault> {
    let at_pitch = "Fig. 8a: difference across the film, rolling (pitch point)";
    let sliding = "Fig. 8b: the same where the flanks slide";
    let position = Some(case.case.paper.position);
    Ok(vec![
        figure(case, None, "fig08a_pitch.csv", at_pitch, folder)?,
        figure(case, position, "fig08b_sliding.csv", sliding, folder)?,
    ])
}

fn figure(
    case: &LoadedCase,
    position: Option<f64>,
    table: &'static str,
    title: &str,
    folder: &Path,
) -> Result<PaperFigure, Fault> {
    let film = film(case, position)?;
    write(&folder.join(table), film.rows.iter())?;
    let curve = |name: &str, line: Line, pascals: fn(&FilmRow) -> f64| {
        let points = film.rows.iter();
        let points = points.map(|row| [row.thickness_m * 1e6, pascals(row).abs()]);
        Series::through(name, line, points)
    };
    let id = table.trim_end_matches(".csv");
    let chart = Chart::new(
        id,
        title,
        table,
        Axis::new("film thickness", "µm").log(),
        Axis::new("pressure difference, size", "Pa").log(),
    )
    .with(curve("the paper's model", Line::Solid, |row| row.paper_pa))
    .with(curve("Reynolds across", Line::Dashed, |row| {
        row.reynolds_cross_pa
    }))
    .level(film.hertz_pressure_pa, "Hertz pressure");
    Ok(PaperFigure::curves(id, chart))
}
