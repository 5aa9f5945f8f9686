//! Fig. 8: pressure difference across thin and thick films.

use std::path::Path;

use asperity::case::LoadedCase;
use asperity::pipeline::{FilmRow, film};
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::tables::write;

use super::figure::{Figure, FigureError};

pub(super) fn figures(case: &LoadedCase, folder: &Path) -> Result<Vec<Figure>, FigureError> {
    let at_pitch = chart(
        case,
        None,
        "fig08a_pitch.csv",
        "Fig. 8a: difference across the film, rolling (pitch point)",
        folder,
    )?;
    let position = Some(case.case.model.position);
    let sliding = chart(
        case,
        position,
        "fig08b_sliding.csv",
        "Fig. 8b: the same where the flanks slide",
        folder,
    )?;
    Ok(vec![
        Figure {
            name: "fig08a_pitch",
            drawing: Drawing::Curves(at_pitch),
        },
        Figure {
            name: "fig08b_sliding",
            drawing: Drawing::Curves(sliding),
        },
    ])
}

fn chart(
    case: &LoadedCase,
    position: Option<f64>,
    table: &str,
    title: &str,
    folder: &Path,
) -> Result<Chart, FigureError> {
    let film = film(case, position)?;
    write(&folder.join(table), film.rows.iter())?;
    let thickness: Vec<f64> = film.rows.iter().map(|row| row.thickness_m * 1e6).collect();
    let of = |value: fn(&FilmRow) -> f64| film.rows.iter().map(value).collect::<Vec<f64>>();
    let id = table.trim_end_matches(".csv");
    Ok(Chart::new(
        id,
        title,
        table,
        Axis::new("film thickness", "µm").log(),
        Axis::new("pressure difference, size", "Pa").log(),
    )
    .with(Series::new(
        "the paper's model",
        Line::Solid,
        &thickness,
        &of(|row| row.paper_pa.abs()),
    ))
    .with(Series::new(
        "Reynolds across",
        Line::Dashed,
        &thickness,
        &of(|row| row.reynolds_cross_pa.abs()),
    ))
    .level(film.hertz_pressure_pa, "Hertz pressure"))
}
