//! What happens in one contact: flanks before, in and after it, pressure, stress below, convergence.

use maud::{Markup, html};

use super::data::{ResultFolder, Table, combined};
use super::figure;
use crate::report::ReportError;
use crate::report::chart::{Axis, Chart, Contour, Drawing, Line, Series};

pub(super) fn section(
    result: &ResultFolder,
    position: Option<usize>,
) -> Result<Markup, ReportError> {
    let Some(number) = shown_position(result, position)? else {
        return Ok(html! {});
    };
    let drawings = drawings(result, number)?;
    if drawings.is_empty() {
        return Ok(html! {});
    }
    let count = result.rows("/path").len();
    let row = &result.rows("/path")[number - 1];
    Ok(html! {
        p {
            "Position " (number) " of " (count)
            @if count > 1 { ", the one with the highest pressure unless another was asked for (" code { "asperity report --position" } ")" }
            ", at " (format!("{:.3}", row["path_fraction"].as_f64().unwrap_or(f64::NAN)))
            " of the way from A to E; first offset of the traces."
        }
        div.charts { @for drawing in &drawings { (figure(drawing)) } }
    })
}

fn shown_position(
    result: &ResultFolder,
    wanted: Option<usize>,
) -> Result<Option<usize>, ReportError> {
    let rows = result.rows("/path");
    if let Some(number) = wanted {
        return match (1..=rows.len()).contains(&number) {
            true => Ok(Some(number)),
            false => Err(ReportError::NoSuchPosition {
                number,
                count: rows.len(),
            }),
        };
    }
    let pressure = |row: &serde_json::Value| {
        row["p_max_mpa"]
            .as_f64()
            .or(row["hertz_pressure_mpa"].as_f64())
            .unwrap_or(0.0)
    };
    let highest = rows
        .iter()
        .enumerate()
        .max_by(|a, b| pressure(a.1).total_cmp(&pressure(b.1)));
    Ok(highest.map(|(index, _)| index + 1))
}

/// Every chart of one position.
pub(crate) fn drawings(result: &ResultFolder, number: usize) -> Result<Vec<Drawing>, ReportError> {
    let mut drawings = Vec::new();
    let surface = format!("position_{number:02}/surface.csv");
    if let Some(table) = result.table(&surface)? {
        drawings.extend(flank_charts(&table, &surface));
        drawings.push(pressure(&table, &surface));
    }
    let below = format!("position_{number:02}/subsurface.csv");
    if let Some(table) = result.table(&below)? {
        drawings.extend(von_mises(result, &table, &below, number));
    }
    if let Some(table) = result.table("convergence.csv")? {
        drawings.extend(convergence(result, &table, number));
    }
    Ok(drawings)
}

fn across() -> Axis {
    Axis::new("distance from the middle of the contact", "µm")
}

fn flank_charts(table: &Table, source: &str) -> Vec<Drawing> {
    let x = table.column("x_um");
    let mut drawings: Vec<Drawing> = crate::report::flanks::BODIES
        .iter()
        .map(|body| {
            let before = table.column(&format!("height_{body}_um"));
            let pressed = combined(
                before,
                table.column(&format!("displacement_{body}_um")),
                |z, u| z - u,
            );
            let after = combined(
                before,
                table.column(&format!("plastic_{body}_um")),
                |z, u| z - u,
            );
            let title = format!("Flank of the {body} before, in and after contact");
            let chart = Chart::new(
                &format!("flank-contact-{body}"),
                &title,
                source,
                across(),
                Axis::new("height", "µm"),
            )
            .with(Series::new("before", Line::Solid, x, before))
            .with(Series::new("in contact", Line::Solid, x, &pressed))
            .with(Series::new("after", Line::Dashed, x, &after));
            Drawing::Curves(chart)
        })
        .collect();
    let gap = Chart::new(
        "gap",
        "Gap in contact",
        source,
        across(),
        Axis::new("gap", "µm").from_zero(),
    )
    .with(Series::new("gap", Line::Solid, x, table.column("gap_um")));
    drawings.push(Drawing::Curves(gap));
    drawings
}

fn pressure(table: &Table, source: &str) -> Drawing {
    let x = table.column("x_um");
    let chart = Chart::new(
        "pressure",
        "Pressure on the flanks",
        source,
        across(),
        Axis::new("pressure", "MPa").from_zero(),
    )
    .with(Series::new(
        "asperities",
        Line::Solid,
        x,
        table.column("pressure_solid_mpa"),
    ))
    .with(Series::new(
        "fluid",
        Line::Solid,
        x,
        table.column("pressure_fluid_mpa"),
    ))
    .with(Series::new(
        "Hertz, smooth and dry",
        Line::Dashed,
        x,
        table.column("pressure_hertz_mpa"),
    ));
    Drawing::Curves(chart)
}

/// Stress below the contact. The table reaches further down and to the sides, where it is smooth.
fn von_mises(result: &ResultFolder, table: &Table, source: &str, number: usize) -> Option<Drawing> {
    /// What is shown, in Hertz half widths to either side and down.
    const REACH: f64 = 1.6;
    let reach = REACH * result.rows("/path")[number - 1]["half_width_um"].as_f64()?;
    let depth = table.column("depth_um");
    let across_all = table.where_equal("depth_um", *depth.first()?, "x_um");
    let stride = across_all.len();
    let kept: Vec<usize> = (0..stride)
        .filter(|i| across_all[*i].abs() <= reach)
        .collect();
    let rows: Vec<f64> = depth
        .iter()
        .step_by(stride)
        .copied()
        .take_while(|z| *z <= reach)
        .collect();
    if kept.len() < 2 || rows.len() < 2 {
        return None;
    }
    let all = table.column("von_mises_mpa");
    let values = (0..rows.len())
        .flat_map(|j| kept.iter().map(move |i| all[j * stride + i]))
        .collect();
    Some(Drawing::Contour(Contour {
        id: "von-mises".to_owned(),
        title: "Von Mises stress below the surface".to_owned(),
        source: source.to_owned(),
        x: across(),
        y: Axis::new("depth", "µm").downward(),
        value: "von Mises stress [MPa]".to_owned(),
        columns: kept.iter().map(|i| across_all[*i]).collect(),
        rows,
        values,
        height: 250.0,
    }))
}

fn convergence(result: &ResultFolder, table: &Table, number: usize) -> Vec<Drawing> {
    let of = |column: &str| table.where_equal("position", number as f64, column);
    let (step, error) = (of("step"), of("load_error"));
    if step.is_empty() {
        return Vec::new();
    }
    let row = &result.rows("/path")[number - 1];
    let target = row["line_load_n_per_mm"].as_f64().unwrap_or(f64::NAN);
    let (solid, fluid) = (of("load_solid_n_per_mm"), of("load_fluid_n_per_mm"));
    let total = combined(&solid, &fluid, |s, f| s + f);
    let approach = of("approach_um");
    let load = Chart::new(
        "approach",
        "Load against approach",
        "convergence.csv",
        Axis::new("approach from first touch", "µm"),
        Axis::new("load", "N/mm").from_zero(),
    )
    .with(Series::new(
        "film and asperities",
        Line::Dots,
        &approach,
        &total,
    ))
    .with(Series::new("film", Line::Dashed, &approach, &fluid))
    .level(target, "load to carry");
    vec![
        Drawing::Curves(load),
        Drawing::Curves(load_error(result, &step, &error)),
    ]
}

/// Error against step: of the marching on a log axis, of the load path from zero.
fn load_error(result: &ResultFolder, step: &[f64], error: &[f64]) -> Chart {
    let (title, axis, tolerance) = match result.text("/formulation") {
        "paper" => (
            "Convergence: load error of each step",
            Axis::new("load error |F − F_target|/F_target", "").log(),
            result
                .choice("model.numerical_error")
                .and_then(|v| ratio(&v)),
        ),
        // The last error is one of rounding, which a log axis would blow up.
        _ => (
            "Load still missing along the load path",
            Axis::new("|F − F_target|/F_target", "").from_zero(),
            result.choice("model.tolerance").and_then(|v| v.as_f64()),
        ),
    };
    let chart = Chart::new(
        "convergence",
        title,
        "convergence.csv",
        Axis::new("step", ""),
        axis,
    )
    .with(Series::new("load error", Line::Dots, step, error));
    match tolerance {
        Some(tolerance) => chart.level(tolerance, "tolerance"),
        None => chart,
    }
}

/// A share written as a number or as text with its unit.
fn ratio(value: &serde_json::Value) -> Option<f64> {
    use asperity_core::quantity::Ratio;
    value
        .as_f64()
        .or_else(|| value.as_str()?.parse::<Ratio>().ok().map(Ratio::value))
}
