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

/// A chart along the path.
struct Along {
    id: &'static str,
    title: &'static str,
    axis: [&'static str; 2],
    /// Name, column, and factor on it.
    curves: &'static [(&'static str, &'static str, f64)],
}

const CHARTS: &[Along] = &[
    Along {
        id: "load-share",
        title: "Share of the tooth force on one pair",
        axis: ["share", "-"],
        curves: &[("share", "load_share", 1.0)],
    },
    Along {
        id: "load",
        title: "Load per length of contact line",
        axis: ["line load", "N/mm"],
        curves: &[("line load", "line_load_n_per_mm", 1.0)],
    },
    Along {
        id: "pressure-path",
        title: "Hertz pressure of smooth flanks",
        axis: ["p₀", "MPa"],
        curves: &[("p₀", "hertz_pressure_mpa", 1.0)],
    },
    Along {
        id: "speeds",
        title: "Sliding and entrainment",
        axis: ["speed", "m/s"],
        curves: &[
            ("sliding V_s", "sliding_m_per_s", 1.0),
            ("entrainment V_e", "entrainment_m_per_s", 1.0),
        ],
    },
    Along {
        id: "film",
        title: "Film thickness, with thermal reduction",
        axis: ["film", "µm"],
        curves: &[
            ("central", "film_central_um", 1.0),
            ("minimum", "film_minimum_um", 1.0),
        ],
    },
    Along {
        id: "lambda-star",
        title: "Lambda*: film over reduced peaks",
        axis: ["Λ*", ""],
        curves: &[("Λ*", "lambda_star", 1.0)],
    },
    Along {
        id: "friction",
        title: "Friction coefficient",
        axis: ["μ", ""],
        curves: &[
            ("whole contact", "mu", 1.0),
            ("in the film", "mu_film", 1.0),
        ],
    },
    Along {
        id: "local-loss",
        title: "Local loss per length of contact line",
        axis: ["loss", "kW/m"],
        curves: &[
            ("sliding", "sliding_w_per_m", 1e-3),
            ("rolling", "rolling_w_per_m", 1e-3),
        ],
    },
    Along {
        id: "flash",
        title: "Flash temperature",
        axis: ["above the bulk", "K"],
        curves: &[("flash", "flash_k", 1.0)],
    },
];

fn drawings(result: &ResultFolder, table: &Table) -> Vec<Drawing> {
    let marks = points(result);
    let s = table.column("s_mm");
    let line = |number: usize| match (s.len(), number) {
        (1, _) => Line::Scatter,
        (_, 0) => Line::Solid,
        _ => Line::Dashed,
    };
    let draw = |along_path: &Along| {
        let [label, unit] = along_path.axis;
        let y = Axis::new(label, unit).from_zero();
        let mut chart =
            Chart::new(along_path.id, along_path.title, SOURCE, along(), y).marked(&marks);
        for (number, (name, column, factor)) in along_path.curves.iter().enumerate() {
            let values: Vec<f64> = table.column(column).iter().map(|v| v * factor).collect();
            chart = chart.with(Series::new(name, line(number), s, &values));
        }
        if along_path.id == "lambda-star" {
            chart = chart.level(1.0, "full film from 1");
        }
        Drawing::Curves(chart)
    };
    CHARTS.iter().map(draw).collect()
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
