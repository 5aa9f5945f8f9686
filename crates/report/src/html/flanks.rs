//! The flanks as measured and prepared: trace, material ratio curve with its construction, spectrum and
//! parameters.

use asperity::gear::{FlankPoint, Gear};
use asperity::result::{FlankRecord, RunResult};
use asperity_core::quantity::Length;
use asperity_roughness::Parameters;
use asperity_roughness::material_ratio::RkParameters;
use maud::{Markup, html};

use super::along::on_flank;
use super::page::figure;
use crate::chart::{Axis, Chart, Drawing, Line, Mark, Series};
use crate::page_tables::PageTables;
use crate::tables::{BODIES, FlankTables, MaterialRatioRow, TraceRow, files_of};
use crate::units::MICRO;
use crate::{Cell, Column, Kind, Table, columns};

pub(super) fn section(result: &RunResult, tables: &PageTables) -> Markup {
    // Pinion and wheel in two columns.
    let [pinion, wheel] = [0, 1].map(|body| charts(result, tables, body));
    let longest = pinion.len().max(wheel.len());
    let spectra = spectra(result, tables);
    let drawings: Vec<&Drawing> = (0..longest)
        .flat_map(|k| [pinion.get(k), wheel.get(k)])
        .flatten()
        .chain(&spectra)
        .collect();
    if drawings.is_empty() {
        return html! { p { "The flanks are given only by roughness values: no trace was measured." } };
    }
    html! {
        @if let Some(pairs) = &result.pairs { (super::pairs::traces(pairs)) }
        @if result.flanks.iter().any(|flank| flank.file.is_some() && flank.roll_lengths_mm.is_none()) {
            p { "The contact runs from the root to the tip of the pinion and from the tip to the root of the wheel. Each trace is "
                "drawn as it was used. If its file begins at the other end of the flank, state " code { "from" } "." }
        }
        (parameters(result))
        div.charts { @for drawing in &drawings { (figure(drawing)) } }
    }
}

fn charts(result: &RunResult, tables: &PageTables, index: usize) -> Vec<Drawing> {
    let Some(flank) = &tables.flanks[index] else {
        return Vec::new();
    };
    let body = BODIES[index];
    let FlankTables {
        trace,
        material_ratio,
        ..
    } = flank;
    let parameters = result.flanks[index].parameters.as_ref();
    let material = parameters.map(|parameters| &parameters.material);
    let [of_trace, of_curve, _] = files_of(body).map(|own| tables.source(&own));
    vec![
        profile(trace, result, index, &of_trace),
        abbott(material_ratio, material, body, &of_curve),
    ]
}

fn column<R>(rows: &[R], value: impl Fn(&R) -> f64) -> Vec<f64> {
    rows.iter().map(value).collect()
}

/// The trace in the direction of the contact, which runs from the root of the pinion to its tip.
fn profile(trace: &[TraceRow], result: &RunResult, index: usize, source: &str) -> Drawing {
    let body = BODIES[index];
    let flank = &result.flanks[index];
    let x = column(trace, |row| 1e-3 * row.x_um);
    let of = |name: &str, value: fn(&TraceRow) -> f64| {
        Series::new(name, Line::Solid, &x, &column(trace, value))
    };
    let (title, made) = match flank.generated {
        Some(_) => (format!("Generated trace of the {body}"), "as generated"),
        None => (format!("Trace of the {body}"), "as measured"),
    };
    let chart = Chart::new(
        &format!("trace-{body}"),
        &title,
        source,
        on_flank(index, flank.mirrored),
        Axis::new("height", "µm"),
    )
    .marked(&places(trace, result, flank, index))
    .with(of(made, |row| row.measured_um))
    .with(of("form removed", |row| row.form_removed_um))
    // The filter drops the ends of the trace: no line there.
    .with(of("roughness, filtered", |row| {
        row.roughness_um.unwrap_or(f64::NAN)
    }));
    Drawing::Curves(chart)
}

/// Points A to E of the path of contact on a trace whose place is known.
fn places(trace: &[TraceRow], result: &RunResult, flank: &FlankRecord, index: usize) -> Vec<Mark> {
    let gear = [Gear::Pinion, Gear::Wheel][index];
    let gears = &result.gears;
    let arc = |point| Some(gears.arc_of(gear, point).ok()?.si());
    let first = trace.iter().find(|row| row.roughness_um.is_some());
    let last = trace.iter().rfind(|row| row.roughness_um.is_some());
    let (Some([begin, _]), Some(first), Some(last)) = (flank.roll_lengths_mm, first, last) else {
        return Vec::new();
    };
    let Some(begin) = arc(FlankPoint::RollLength(Length::from_si(1e-3 * begin))) else {
        return Vec::new();
    };
    let points = gears
        .path
        .named_points()
        .into_iter()
        .filter_map(|(label, s)| {
            let along = gears.arc_direction(gear) * (arc(FlankPoint::Position(s))? - begin);
            let x_um = first.x_um + along * MICRO;
            (first.x_um..=last.x_um).contains(&x_um).then(|| Mark {
                at: 1e-3 * x_um,
                label: label.to_owned(),
            })
        });
    points.collect()
}

fn abbott(
    rows: &[MaterialRatioRow],
    material: Option<&RkParameters>,
    body: &str,
    source: &str,
) -> Drawing {
    let chart = Chart::new(
        &format!("abbott-{body}"),
        &format!("Material ratio curve of the {body}"),
        source,
        Axis::new("material ratio", "%"),
        Axis::new("height", "µm"),
    )
    .curve(
        "material ratio",
        Line::Solid,
        &column(rows, |row| row.material_ratio_percent),
        &column(rows, |row| row.height_um),
    );
    Drawing::Curves(match material {
        Some(material) => with_construction(chart, material),
        None => chart,
    })
}

/// Adds the line of Rk and the triangles with the areas of the peaks and the valleys.
fn with_construction(chart: Chart, material: &RkParameters) -> Chart {
    let um = |length: Length| length.si() * MICRO;
    let (upper, lower) = (um(material.upper), um(material.lower));
    let (top, floor) = (upper + um(material.rpk), lower - um(material.rvk));
    let (mr1, mr2) = (material.mr1, material.mr2);
    chart
        .curve(
            "equivalent line",
            Line::Dashed,
            &[0.0, 100.0],
            &[upper, lower],
        )
        .curve(
            "Rpk",
            Line::Solid,
            &[0.0, 0.0, mr1, 0.0],
            &[upper, top, upper, upper],
        )
        .curve(
            "Rvk",
            Line::Solid,
            &[mr2, 100.0, 100.0, mr2],
            &[lower, floor, lower, lower],
        )
}

/// Power spectral densities of both flanks, with the cut-offs of the filters; `None` without a trace.
fn spectra(result: &RunResult, tables: &PageTables) -> Option<Drawing> {
    let mut chart = Chart::new(
        "psd",
        "Power spectral density of the roughness, mean in bands of a twelfth of a decade",
        &tables.source(&files_of(BODIES[0])[2]),
        Axis::new("spatial frequency", "1/mm").log(),
        Axis::new("density", "µm³").log(),
    );
    for (body, flank) in BODIES.iter().zip(&tables.flanks) {
        let Some(flank) = flank else { continue };
        chart = chart.curve(
            body,
            Line::Solid,
            &column(&flank.spectrum, |row| row.frequency_per_mm),
            &column(&flank.spectrum, |row| row.density_um3),
        );
    }
    let mut records = result.flanks.iter();
    let recipe = &records.find_map(|flank| flank.preparation.as_ref())?.recipe;
    let mark = |(label, cutoff): (&str, Option<Length>)| {
        let cutoff = cutoff?;
        Some(Mark {
            at: 1e-3 / cutoff.si(),
            label: format!("{label} {} µm", (1e3 * cutoff.si() * MICRO).round() / 1e3),
        })
    };
    let cutoffs = [("λc", recipe.lambda_c), ("λs", recipe.lambda_s)];
    let marks: Vec<Mark> = cutoffs.into_iter().filter_map(mark).collect();
    Some(Drawing::Curves(chart.marked(&marks)))
}

/// A length among the parameters.
type OfLength = fn(&Parameters) -> Option<Length>;

const LENGTHS: &[(&str, OfLength)] = &[
    ("Ra", |parameters| Some(parameters.heights.ra)),
    ("Rq", |parameters| Some(parameters.heights.rq)),
    ("Rz", |parameters| Some(parameters.heights.rz)),
    ("Rp", |parameters| Some(parameters.heights.rp)),
    ("Rv", |parameters| Some(parameters.heights.rv)),
    ("Rt", |parameters| Some(parameters.heights.rt)),
    ("RSm", |parameters| parameters.heights.rsm),
    ("Rk", |parameters| Some(parameters.material.rk)),
    ("Rpk", |parameters| Some(parameters.material.rpk)),
    ("Rvk", |parameters| Some(parameters.material.rvk)),
];

/// A material ratio among the parameters.
type OfRatio = fn(&Parameters) -> f64;

const RATIOS: &[(&str, OfRatio)] = &[
    ("Mr1", |parameters| parameters.material.mr1),
    ("Mr2", |parameters| parameters.material.mr2),
];

fn parameters(result: &RunResult) -> Table {
    let of_flank = |index: usize| {
        let parameters = result.flanks[index].parameters.as_ref();
        let lengths = LENGTHS.iter().map(move |(_, value)| {
            let length = parameters.and_then(value);
            Cell::number(length.map(|length| length.si() * MICRO), |um| {
                format!("{um:.4}")
            })
        });
        let ratios = RATIOS.iter().map(move |(_, value)| {
            Cell::number(parameters.map(value), |percent| format!("{percent:.2}"))
        });
        Column::new(Kind::Number, BODIES[index], "", lengths.chain(ratios))
    };
    let lengths = LENGTHS.iter().map(|(name, _)| (name, "µm"));
    let names = lengths.chain(RATIOS.iter().map(|(name, _)| (name, "%")));
    let names = columns! { row in names;
        head name "parameter" "" = row.0;
        text unit "unit" "" = row.1;
    };
    names.with([0, 1].map(of_flank))
}
