//! The flanks as measured and prepared: trace, material ratio curve with its construction, spectrum,
//! parameters.

use asperity_core::quantity::Length;
use maud::{Markup, html};

use super::data::{ResultFolder, Table};
use super::figure;
use crate::report::chart::{Axis, Chart, Drawing, Line, Series};
use crate::report::flanks::BODIES;
use crate::report::{MICRO, ReportError};

pub(super) fn section(result: &ResultFolder) -> Result<Markup, ReportError> {
    // Side by side: pinion and wheel.
    let [pinion, wheel] = [charts(result, 0)?, charts(result, 1)?];
    let longest = pinion.len().max(wheel.len());
    let drawings: Vec<&Drawing> = (0..longest)
        .flat_map(|k| [pinion.get(k), wheel.get(k)])
        .flatten()
        .collect();
    if drawings.is_empty() {
        return Ok(
            html! { p { "The flanks are given by roughness values: there are no traces to show." } },
        );
    }
    Ok(html! {
        (parameters(result))
        div.charts { @for drawing in &drawings { (figure(drawing)) } }
    })
}

fn charts(result: &ResultFolder, index: usize) -> Result<Vec<Drawing>, ReportError> {
    let body = BODIES[index];
    let mut drawings = Vec::new();
    let trace = format!("flank_{body}.csv");
    if let Some(table) = result.table(&trace)? {
        drawings.push(profile(&table, body, &trace));
    }
    let curve = format!("abbott_{body}.csv");
    if let Some(table) = result.table(&curve)? {
        drawings.push(abbott(result, &table, index, body, &curve));
    }
    let spectrum = format!("psd_{body}.csv");
    if let Some(table) = result.table(&spectrum)? {
        drawings.push(psd(&table, body, &spectrum));
    }
    Ok(drawings)
}

fn profile(table: &Table, body: &str, source: &str) -> Drawing {
    let x: Vec<f64> = table.column("x_um").iter().map(|x| 1e-3 * x).collect();
    let of = |name: &str, column: &str| Series::new(name, Line::Solid, &x, table.column(column));
    let title = format!("Trace of the {body}");
    let chart = Chart::new(
        &format!("trace-{body}"),
        &title,
        source,
        Axis::new("position", "mm"),
        Axis::new("height", "µm"),
    )
    .with(of("as measured", "measured_um"))
    .with(of("form removed", "form_removed_um"))
    .with(of("roughness, filtered", "roughness_um"));
    Drawing::Curves(chart)
}

fn abbott(result: &ResultFolder, table: &Table, index: usize, body: &str, source: &str) -> Drawing {
    let (ratio, height) = (
        table.column("material_ratio_percent"),
        table.column("height_um"),
    );
    let of = |key: &str| format!("/flanks/{index}/parameters/material/{key}");
    let mut chart = Chart::new(
        &format!("abbott-{body}"),
        &format!("Material ratio curve of the {body}"),
        source,
        Axis::new("material ratio", "%"),
        Axis::new("height", "µm"),
    )
    .with(Series::new("material ratio", Line::Solid, ratio, height));
    let lengths = (result.length(&of("upper")), result.length(&of("lower")));
    let cuts = (result.number(&of("mr1")), result.number(&of("mr2")));
    if let ((Some(upper), Some(lower)), (Some(mr1), Some(mr2))) = (lengths, cuts) {
        let (upper, lower) = (upper * MICRO, lower * MICRO);
        chart = chart.with(Series::new(
            "line of Rk",
            Line::Dashed,
            &[0.0, 100.0],
            &[upper, lower],
        ));
        let (peak, valley) = (result.length(&of("rpk")), result.length(&of("rvk")));
        if let (Some(peak), Some(valley)) = (peak, valley) {
            let (top, floor) = (upper + peak * MICRO, lower - valley * MICRO);
            // Triangles of the same area as the peaks and the valleys.
            chart = chart
                .with(Series::new(
                    "Rpk",
                    Line::Solid,
                    &[0.0, 0.0, mr1, 0.0],
                    &[upper, top, upper, upper],
                ))
                .with(Series::new(
                    "Rvk",
                    Line::Solid,
                    &[mr2, 100.0, 100.0, mr2],
                    &[lower, floor, lower, lower],
                ));
        }
    }
    Drawing::Curves(chart)
}

fn psd(table: &Table, body: &str, source: &str) -> Drawing {
    let chart = Chart::new(
        &format!("psd-{body}"),
        &format!("Power spectral density of the roughness of the {body}"),
        source,
        Axis::new("spatial frequency", "1/mm").log(),
        Axis::new("density", "µm³").log(),
    )
    .with(Series::new(
        "density",
        Line::Solid,
        table.column("frequency_per_mm"),
        table.column("density_um3"),
    ));
    Drawing::Curves(chart)
}

/// Names and keys of the parameters in the table.
const HEIGHTS: &[&str] = &["ra", "rq", "rz", "rp", "rv", "rt", "rsm"];
const MATERIAL: &[&str] = &["rk", "rpk", "rvk"];

fn parameters(result: &ResultFolder) -> Markup {
    let groups = [("heights", HEIGHTS), ("material", MATERIAL)];
    let value = |index: usize, group: &str, key: &str| {
        let found: Option<f64> =
            result.length(&format!("/flanks/{index}/parameters/{group}/{key}"));
        found.map_or("–".to_owned(), |length| {
            format!("{:.4}", Length::from_si(length).si() * MICRO)
        })
    };
    let share = |index: usize, key: &str| {
        let found = result.number(&format!("/flanks/{index}/parameters/material/{key}"));
        found.map_or("–".to_owned(), |value| format!("{value:.2}"))
    };
    let capital = |key: &str| {
        if key == "rsm" {
            "RSm".to_owned()
        } else {
            format!("R{}", &key[1..])
        }
    };
    html! {
        div.scroll { table {
            thead { tr { th { "parameter" } th { "unit" } @for body in BODIES { th.number { (body) } } } }
            tbody {
                @for (group, keys) in groups { @for key in keys {
                    tr { th scope="row" { (capital(key)) } td { "µm" } @for index in 0..2 { td.number { (value(index, group, key)) } } }
                } }
                @for key in ["mr1", "mr2"] {
                    tr { th scope="row" { (format!("M{}", &key[1..])) } td { "%" } @for index in 0..2 { td.number { (share(index, key)) } } }
                }
            }
        } }
    }
}
