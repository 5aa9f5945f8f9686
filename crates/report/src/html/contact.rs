//! One contact: flanks before, in and after it, pressure, stress below, convergence.

use asperity::case::Formulation;
use asperity::result::{PositionRow, RunResult};
use asperity_core::quantity::Ratio;
use maud::{Markup, html};
use serde::de::DeserializeOwned;

use super::page::figure;
use crate::chart::{Axis, Chart, Contour, Drawing, Line, Series};
use crate::error::ReportError;
use crate::page_tables::PageTables;
use crate::tables::{BODIES, ContactTables, ConvergenceRow, SubsurfaceRow, SurfaceRow, folder_of};

pub(super) fn section(result: &RunResult, tables: &PageTables) -> Result<Markup, ReportError> {
    let Some(contact) = &tables.contact else {
        return Ok(html! {});
    };
    let row = row_of(result, contact)?;
    let drawings = drawings(result, tables)?;
    let count = result.path.len();
    Ok(html! {
        p {
            "Position " (contact.position) " of " (count)
            @if count > 1 { ", the one with the highest pressure unless another was asked for" }
            ", at " (format!("{:.3}", row.path_fraction))
            " of the way from A to E; first offset of the traces."
        }
        div.charts { @for drawing in &drawings { (figure(drawing)) } }
    })
}

fn row_of<'a>(
    result: &'a RunResult,
    contact: &ContactTables,
) -> Result<&'a PositionRow, ReportError> {
    let mut rows = result.path.iter();
    rows.find(|row| row.position == contact.position)
        .ok_or(ReportError::NoSuchPosition {
            number: contact.position,
            count: result.path.len(),
        })
}

/// Every chart of one position.
///
/// # Errors
/// When the result lacks the position or the tolerance of its solution.
pub fn drawings(result: &RunResult, tables: &PageTables) -> Result<Vec<Drawing>, ReportError> {
    let Some(contact) = &tables.contact else {
        return Ok(Vec::new());
    };
    let row = row_of(result, contact)?;
    let folder = folder_of(contact.position);
    let surface = tables.source(&format!("{folder}/surface.csv"));
    let mut drawings = flank_charts(&contact.surface, &surface);
    drawings.push(pressure(&contact.surface, &surface));
    let below = tables.source(&format!("{folder}/subsurface.csv"));
    drawings.extend(von_mises(row, &contact.subsurface, &below));
    if !contact.convergence.is_empty() {
        let steps = tables.source("convergence.csv");
        drawings.push(load(row, &contact.convergence, &steps));
        drawings.push(load_error(result, &contact.convergence, &steps)?);
    }
    Ok(drawings)
}

fn across() -> Axis {
    Axis::new("distance from the middle of the contact", "µm")
}

fn column<R>(rows: &[R], value: impl Fn(&R) -> f64) -> Vec<f64> {
    rows.iter().map(value).collect()
}

/// Height, displacement and plastic displacement of a flank.
type Flank = fn(&SurfaceRow) -> [f64; 3];

fn flank_charts(rows: &[SurfaceRow], source: &str) -> Vec<Drawing> {
    let x = column(rows, |row| row.x_um);
    let flanks: [Flank; 2] = [
        |row| {
            [
                row.height_pinion_um,
                row.displacement_pinion_um,
                row.plastic_pinion_um,
            ]
        },
        |row| {
            [
                row.height_wheel_um,
                row.displacement_wheel_um,
                row.plastic_wheel_um,
            ]
        },
    ];
    let mut drawings: Vec<Drawing> = BODIES
        .iter()
        .zip(flanks)
        .map(|(body, of)| {
            let title = format!("Flank of the {body} before, in and after contact");
            let before = column(rows, |row| of(row)[0]);
            let pressed = column(rows, |row| of(row)[0] - of(row)[1]);
            let after = column(rows, |row| of(row)[0] - of(row)[2]);
            let chart = Chart::new(
                &format!("flank-contact-{body}"),
                &title,
                source,
                across(),
                Axis::new("height", "µm"),
            )
            .with(Series::new("before", Line::Solid, &x, &before))
            .with(Series::new("in contact", Line::Solid, &x, &pressed))
            .with(Series::new("after", Line::Dashed, &x, &after));
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
    .with(Series::new(
        "gap",
        Line::Solid,
        &x,
        &column(rows, |row| row.gap_um),
    ));
    drawings.push(Drawing::Curves(gap));
    drawings
}

fn pressure(rows: &[SurfaceRow], source: &str) -> Drawing {
    let x = column(rows, |row| row.x_um);
    let series = |name: &str, line, value: fn(&SurfaceRow) -> f64| {
        Series::new(name, line, &x, &column(rows, value))
    };
    let chart = Chart::new(
        "pressure",
        "Pressure on the flanks",
        source,
        across(),
        Axis::new("pressure", "MPa").from_zero(),
    )
    .with(series("asperities", Line::Solid, |row| {
        row.pressure_solid_mpa
    }))
    .with(series("fluid", Line::Solid, |row| row.pressure_fluid_mpa))
    .with(series("Hertz, smooth and dry", Line::Dashed, |row| {
        row.pressure_hertz_mpa
    }));
    Drawing::Curves(chart)
}

/// Stress below the contact. The table reaches further down and to the sides, where it is smooth.
fn von_mises(row: &PositionRow, cells: &[SubsurfaceRow], source: &str) -> Option<Drawing> {
    /// What is shown, in Hertz half widths to either side and down.
    const REACH: f64 = 1.6;
    let reach = REACH * row.half_width_um;
    let top = cells.first()?.depth_um;
    let stride = cells.iter().take_while(|cell| cell.depth_um == top).count();
    let shown = |cell: &&SubsurfaceRow| cell.x_um.abs() <= reach;
    let levels: Vec<&[SubsurfaceRow]> = cells
        .chunks(stride)
        .take_while(|level| level[0].depth_um <= reach)
        .collect();
    let columns: Vec<f64> = cells[..stride]
        .iter()
        .filter(shown)
        .map(|c| c.x_um)
        .collect();
    if columns.len() < 2 || levels.len() < 2 {
        return None;
    }
    let values = levels
        .iter()
        .flat_map(|level| level.iter().filter(shown).map(|cell| cell.von_mises_mpa))
        .collect();
    Some(Drawing::Contour(Contour {
        id: "von-mises".to_owned(),
        title: "Von Mises stress below the surface".to_owned(),
        source: source.to_owned(),
        x: across(),
        y: Axis::new("depth", "µm").downward(),
        value: "von Mises stress [MPa]".to_owned(),
        columns,
        rows: levels.iter().map(|level| level[0].depth_um).collect(),
        values,
        height: 250.0,
    }))
}

fn load(row: &PositionRow, steps: &[ConvergenceRow], source: &str) -> Drawing {
    let approach = column(steps, |step| step.approach_um);
    let fluid = column(steps, |step| step.load_fluid_n_per_mm);
    let total = column(steps, |step| {
        step.load_solid_n_per_mm + step.load_fluid_n_per_mm
    });
    let chart = Chart::new(
        "approach",
        "Load against approach",
        source,
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
    .level(row.line_load_n_per_mm, "load to carry");
    Drawing::Curves(chart)
}

/// Error against step: of the marching on a log axis, of the load path from zero.
fn load_error(
    result: &RunResult,
    steps: &[ConvergenceRow],
    source: &str,
) -> Result<Drawing, ReportError> {
    let model = &result.inputs.model;
    let (title, axis, tolerance) = if result.formulation == Formulation::Paper {
        let given = model.numerical_error;
        (
            "Convergence: load error of each step",
            Axis::new("load error |F − F_target|/F_target", "").log(),
            choice::<Ratio>(result, given, "model.numerical_error")?.value(),
        )
    } else {
        // The last error is one of rounding, which a log axis would blow up.
        (
            "Load still missing along the load path",
            Axis::new("|F − F_target|/F_target", "").from_zero(),
            choice(result, model.tolerance, "model.tolerance")?,
        )
    };
    let chart = Chart::new("convergence", title, source, Axis::new("step", ""), axis)
        .with(Series::new(
            "load error",
            Line::Dots,
            &column(steps, |step| step.step as f64),
            &column(steps, |step| step.load_error),
        ))
        .level(tolerance, "tolerance");
    Ok(Drawing::Curves(chart))
}

/// A choice of the model: as given in the case, or the default that was used.
fn choice<T: DeserializeOwned>(
    result: &RunResult,
    given: Option<T>,
    key: &'static str,
) -> Result<T, ReportError> {
    if let Some(value) = given {
        return Ok(value);
    }
    let mut defaults = result.defaults.iter();
    let default = defaults
        .find(|entry| entry.key == key)
        .ok_or(ReportError::NoValue { key })?;
    Ok(serde_json::from_str(&default.value)?)
}
