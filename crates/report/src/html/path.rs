//! Charts along the path of contact, with the points A to E.

use asperity::result::{PositionRow, RunResult};
use asperity_core::number_with_unit;
use maud::{Markup, html};

use super::along::{SOURCE, along, points};
use super::page::{figure, source};
use super::{facing, load, relief, temperatures};
use crate::axis::rounded_to;
use crate::chart::{Axis, Chart, Drawing, Line, Strip};
use crate::columns;
use crate::page_tables::PageTables;

pub(super) fn section(result: &RunResult, tables: &PageTables) -> Markup {
    let marks = points(result);
    let mut drawings = vec![load::along_the_path(result, along(), &marks)];
    drawings.extend(load::map(tables, along()));
    let first = match result.path.as_slice() {
        [one] => at_one_position(result, one),
        _ => {
            drawings.extend(curves(result));
            let temperatures = temperatures::along_the_path(result, along(), &marks);
            html! { (figure(&strip(result))) (figure(&temperatures)) }
        }
    };
    drawings.extend(relief::along_the_path(result));
    html! {
        div.verdict {
            @if let Some(flanks) = facing::flanks(result, tables) { (flanks) }
            div { (first) }
        }
        div.charts { @for drawing in &drawings { (figure(drawing)) } }
        (records(result))
    }
}

/// Table of the reference solutions on which the load share is based.
fn records(result: &RunResult) -> Markup {
    if result.records.is_empty() {
        return html! {};
    }
    let with_error =
        |value: f64, error: f64, digits: usize| format!("{value:.digits$} ({error:.digits$})");
    html! {
        h3 { "Reference solutions" }
        p { "Means over the travel, in brackets their standard errors; values are interpolated between the reference solutions." }
        (columns! { row in &result.records;
            number path_fraction "place, A to E" "" "{:.3}";
            number hertz_pressure_mpa "p₀" "MPa" "{:.0}";
            number slide_to_roll "slide-to-roll" "" "{:.3}";
            number smooth_film_um "smooth film" "µm" "{:.3}";
            number share "load below 20 nm" "" = with_error(row.solid_share, row.solid_share_standard_error, 3);
            number share_below_50_nm "below 50 nm" "" "{:.3}";
            number gap "mean gap" "µm" = with_error(row.mean_gap_um, row.mean_gap_standard_error_um, 3);
            number friction "friction, isothermal" "" = with_error(row.friction, row.friction_standard_error, 4);
            number mean_p_max_mpa "largest p, mean" "MPa" "{:.0}";
            number travel_half_widths "travel" "half-widths" "{:.0}";
            number steps "steps, cut" "" = format!("{}, {}", row.steps, row.steps_cut);
        })
    }
}

/// A value of a row; `None` if unknown.
type Value = fn(&PositionRow) -> Option<f64>;

/// Chart along the path.
struct Along {
    id: &'static str,
    title: &'static str,
    axis: [&'static str; 2],
    /// Names and values of the curves.
    curves: &'static [(&'static str, Value)],
}

const CHARTS: &[Along] = &[
    Along {
        id: "load-share",
        title: "Share of the normal force on one tooth pair",
        axis: ["share", "-"],
        curves: &[("share", |row| Some(row.load_share))],
    },
    Along {
        id: "pressure-path",
        title: "Hertz pressure p₀ of smooth flanks, at the load of each position",
        axis: ["p₀", "MPa"],
        curves: &[("p₀", |row| Some(row.hertz_pressure_mpa))],
    },
    Along {
        id: "speeds",
        title: "Sliding and entrainment",
        axis: ["speed", "m/s"],
        curves: &[
            ("sliding V_s", |row| Some(row.sliding_m_per_s)),
            ("entrainment V_e", |row| Some(row.entrainment_m_per_s)),
        ],
    },
    Along {
        id: "film",
        title: "Film thickness, with thermal reduction",
        axis: ["film", "µm"],
        curves: &[
            ("central", |row| Some(row.film_central_um)),
            ("minimum", |row| Some(row.film_minimum_um)),
        ],
    },
    Along {
        id: "lambda-star",
        title: "Lambda*: film thickness over reduced peak height",
        axis: ["Λ*", ""],
        curves: &[("Λ*", |row| row.lambda_star)],
    },
    Along {
        id: "friction",
        title: "Friction coefficient",
        axis: ["μ", ""],
        curves: &[
            ("whole contact", |row| Some(row.mu)),
            ("in the film", |row| Some(row.mu_film)),
        ],
    },
];

/// The values of the charts at a single position, to three digits.
fn at_one_position(result: &RunResult, row: &PositionRow) -> Markup {
    let of_chart = |chart: &'static Along| {
        let (unit, title) = (chart.axis[1], chart.title);
        chart.curves.iter().filter_map(move |(name, value)| {
            let value = number_with_unit(rounded_to(value(row)?, 3), unit);
            let name = match chart.curves.len() {
                1 => title.to_owned(),
                _ => format!("{title}: {name}"),
            };
            Some((name, value))
        })
    };
    let contact = temperatures::bulk(result) + row.flash_k;
    let temperature = (
        "Mean contact temperature".to_owned(),
        format!("{contact:.0} °C"),
    );
    let values = CHARTS.iter().flat_map(of_chart).chain([temperature]);
    html! {
        h3 { "At the one position that was computed" }
        (columns! { (name, value) in values;
            head quantity "quantity" "" = name;
            number value "value" "" = value;
        })
        (source(SOURCE))
    }
}

fn curves(result: &RunResult) -> Vec<Drawing> {
    let marks = points(result);
    let s: Vec<f64> = result.path.iter().map(|row| row.s_mm).collect();
    let line = |number: usize| match number {
        0 => Line::Solid,
        _ => Line::Dashed,
    };
    let draw = |along_path: &Along| {
        let [label, unit] = along_path.axis;
        let y = Axis::new(label, unit).from_zero();
        let mut chart =
            Chart::new(along_path.id, along_path.title, SOURCE, along(), y).marked(&marks);
        for (number, (name, value)) in along_path.curves.iter().enumerate() {
            // NaN breaks the line.
            let values: Vec<f64> = result
                .path
                .iter()
                .map(|row| value(row).unwrap_or(f64::NAN))
                .collect();
            chart = chart.curve(name, line(number), &s, &values);
        }
        if along_path.id == "lambda-star" {
            chart = chart.level(1.0, "as high as the peaks");
        }
        Drawing::Curves(chart)
    };
    CHARTS.iter().map(draw).collect()
}

/// Lubrication regime along the path.
fn strip(result: &RunResult) -> Drawing {
    let of = |value: fn(&PositionRow) -> f64| result.path.iter().map(value).collect();
    Drawing::Strip(Strip {
        id: "regime".to_owned(),
        title: "Lubrication regime along the path of contact".to_owned(),
        source: SOURCE.to_owned(),
        axis: along(),
        at: of(|row| row.s_mm),
        mixed: of(|row| row.mixed_share),
        film: of(|row| row.film_share),
        marks: points(result),
    })
}
