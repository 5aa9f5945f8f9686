//! Charts along the path of contact, with its points A to E.

use maud::{Markup, html};

use super::data::{ResultFolder, Table};
use super::figure;
use crate::report::ReportError;
use crate::report::chart::{Axis, Chart, Drawing, Line, Mark, Series, Strip};

/// The table of this section.
const SOURCE: &str = "path.csv";

pub(super) fn section(result: &ResultFolder) -> Result<Markup, ReportError> {
    let Some(table) = result.table(SOURCE)? else {
        return Ok(html! { p { "path.csv is not beside result.json: no charts along the path." } });
    };
    let drawings = drawings(result, &table);
    Ok(html! {
        @if table.column("s_mm").len() < 2 {
            p { "One position was computed; it is shown as a dot between A and E." }
        }
        div.charts { @for drawing in &drawings { (figure(drawing)) } }
    })
}

/// The points A to E [mm from T₁].
pub(super) fn points(result: &ResultFolder) -> Vec<Mark> {
    let named = ["a", "b", "c", "d", "e"].iter().filter_map(|name| {
        let at = result.length(&format!("/gears/path/{name}"))?;
        Some(Mark {
            at: 1e3 * at,
            label: name.to_uppercase(),
        })
    });
    let mut points: Vec<Mark> = named.collect();
    points.sort_by(|a, b| a.at.total_cmp(&b.at));
    points
}

fn drawings(result: &ResultFolder, table: &Table) -> Vec<Drawing> {
    let marks = points(result);
    let s = table.column("s_mm");
    let (line, other) = match s.len() {
        1 => (Line::Scatter, Line::Scatter),
        _ => (Line::Solid, Line::Dashed),
    };
    let of =
        |name: &str, column: &str, line: Line| Series::new(name, line, s, table.column(column));
    let scaled = |name: &str, column: &str, factor: f64, line: Line| {
        let values: Vec<f64> = table.column(column).iter().map(|v| v * factor).collect();
        Series::new(name, line, s, &values)
    };
    let chart =
        |id: &str, title: &str, y: Axis| Chart::new(id, title, SOURCE, along(), y).marked(&marks);
    let charts = vec![
        chart(
            "load",
            "Load per length of contact line",
            Axis::new("line load", "N/mm").from_zero(),
        )
        .with(of("line load", "line_load_n_per_mm", line)),
        chart(
            "pressure-path",
            "Hertz pressure of smooth flanks",
            Axis::new("p₀", "MPa").from_zero(),
        )
        .with(of("p₀", "hertz_pressure_mpa", line)),
        chart(
            "speeds",
            "Sliding and entrainment",
            Axis::new("speed", "m/s").from_zero(),
        )
        .with(of("sliding V_s", "sliding_m_per_s", line))
        .with(of("entrainment V_e", "entrainment_m_per_s", other)),
        chart(
            "film",
            "Film thickness, with thermal reduction",
            Axis::new("film", "µm").from_zero(),
        )
        .with(of("central", "film_central_um", line))
        .with(of("minimum", "film_minimum_um", other)),
        chart(
            "lambda-star",
            "Lambda*: film over reduced peaks",
            Axis::new("Λ*", "").from_zero(),
        )
        .with(of("Λ*", "lambda_star", line))
        .level(1.0, "full film from 1"),
        chart(
            "friction",
            "Friction coefficient",
            Axis::new("μ", "").from_zero(),
        )
        .with(of("whole contact", "mu", line))
        .with(of("in the film", "mu_film", other)),
        chart(
            "local-loss",
            "Local loss per length of contact line",
            Axis::new("loss", "kW/m").from_zero(),
        )
        .with(scaled("sliding", "sliding_w_per_m", 1e-3, line))
        .with(scaled("rolling", "rolling_w_per_m", 1e-3, other)),
        chart(
            "flash",
            "Flash temperature",
            Axis::new("above the bulk", "K").from_zero(),
        )
        .with(of("flash", "flash_k", line)),
    ];
    charts.into_iter().map(Drawing::Curves).collect()
}

/// The regime along the path.
pub(super) fn strip(result: &ResultFolder) -> Result<Option<Drawing>, ReportError> {
    let Some(table) = result.table(SOURCE)? else {
        return Ok(None);
    };
    Ok(Some(Drawing::Strip(Strip {
        id: "regime".to_owned(),
        title: "Lubrication regime along the path of contact".to_owned(),
        source: SOURCE.to_owned(),
        axis: along(),
        at: table.column("s_mm").to_vec(),
        mixed: table.column("mixed_share").to_vec(),
        film: table.column("film_share").to_vec(),
        marks: points(result),
    })))
}

fn along() -> Axis {
    Axis::new("distance from T₁ along the line of action", "mm")
}
