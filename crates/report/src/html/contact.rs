//! One contact: flanks before, in and after contact, pressure, subsurface stress, convergence.

use crate::error;
use asperity::result::{PositionRow, RunResult};
use asperity_core::Fault;
use asperity_core::numerics::range;
use asperity_core::quantity::{Pressure, Ratio};
use maud::{Markup, html};
use serde::de::DeserializeOwned;

use super::page::figure;
use super::patch;
use crate::chart::{Axis, Chart, Contour, Drawing, Line, Series};
use crate::page_tables::{PageTables, shown_position};
use crate::tables::{
    CONVERGENCE, ContactTables, ConvergenceRow, NEAR, PATCH, SubsurfaceRow, SurfaceRow, folder_of,
};

pub(super) fn section(result: &RunResult, tables: &PageTables) -> Result<Markup, Fault> {
    let Some(contact) = &tables.contact else {
        return Ok(html! {});
    };
    let row = row_of(result, contact)?;
    let drawings = solution(result, tables, contact, row)?;
    let count = result.path.len();
    let drawn = contact.surface.iter();
    let largest = drawn.map(|at| at.pressure_solid_mpa + at.pressure_fluid_mpa);
    let patch = contact.patch.as_ref();
    let largest = patch.map_or_else(|| largest.fold(0.0, f64::max), patch::largest_pressure);
    let of_patch = source_of(tables, contact, PATCH);
    Ok(html! {
        p {
            "Position " (contact.position) " of " (count) ", at " (format!("{:.0} %", 100.0 * row.path_fraction))
            " of the path from A to E. The charts show the first offset of the traces. On single asperities the pressure reaches "
            (format!("{largest:.0}")) " MPa. Smooth flanks under the same load would have at most p₀ = "
            (format!("{:.0}", row.hertz_pressure_mpa)) " MPa (Hertz)."
            @if let Some(mean) = row.p_max_mpa.filter(|_| count > 1) {
                " The mean of this maximum over all offsets is " (format!("{mean:.0}"))
                " MPa. By default this page shows the position where it is highest."
            }
            @if let (Some(depth), Some(share)) = (row.yield_depth_um, row.yield_share) {
                @let limit = format!("{:.0}", elastic_limit(result)?.si() * 1e-6);
                @if share > 0.0 {
                    " The von Mises stress exceeds the elastic limit of " (limit) " MPa down to "
                    (format!("{depth:.0}")) " µm. It does so in " (format!("{:.1}", 100.0 * share))
                    " % of the section below the contact, which is as wide as the contact and half as deep."
                } @else {
                    " The von Mises stress stays below the elastic limit of " (limit) " MPa."
                }
            }
        }
        @if let Some(patch) = patch {
            (patch::words(patch))
            div.charts { @for drawing in &patch::drawings(patch, &of_patch) { (figure(drawing)) } }
        }
        div.charts { @for drawing in &drawings { (figure(drawing)) } }
    })
}

/// The position that the page shows instead of the one with the highest pressure, in words.
pub(super) fn chosen(result: &RunResult, tables: &PageTables) -> Result<Option<String>, Fault> {
    let Some(contact) = &tables.contact else {
        return Ok(None);
    };
    let usual = shown_position(result, None)?;
    let is_chosen = usual.is_some_and(|usual| usual.position != contact.position);
    let (number, count) = (contact.position, result.path.len());
    Ok(is_chosen.then(|| format!(" · contact at position {number} of {count}")))
}

fn row_of<'a>(result: &'a RunResult, contact: &ContactTables) -> Result<&'a PositionRow, Fault> {
    let mut rows = result.path.iter();
    rows.find(|row| row.position == contact.position)
        .ok_or(error::no_such_position(contact.position, result.path.len()))
}

/// All charts of one position: its solution, both flanks before and in contact, and the way to the solution.
///
/// # Errors
/// When the result lacks the position or the tolerance of its solution.
pub fn drawings(result: &RunResult, tables: &PageTables) -> Result<Vec<Drawing>, Fault> {
    let Some(contact) = &tables.contact else {
        return Ok(Vec::new());
    };
    let row = row_of(result, contact)?;
    let surface = source_of(tables, contact, "surface.csv");
    let mut drawings = flank_charts(row, &contact.surface, &surface);
    drawings.extend(solution(result, tables, contact, row)?);
    if !contact.convergence.is_empty() {
        let steps = tables.source(CONVERGENCE);
        drawings.push(load(row, &contact.convergence, &steps));
        drawings.push(load_error(result, &contact.convergence, &steps)?);
    }
    Ok(drawings)
}

fn source_of(tables: &PageTables, contact: &ContactTables, file: &str) -> String {
    tables.source(&format!("{}/{file}", folder_of(contact.position)))
}

/// Pressure, stress below the surface, and permanent change of the flanks.
fn solution(
    result: &RunResult,
    tables: &PageTables,
    contact: &ContactTables,
    row: &PositionRow,
) -> Result<Vec<Drawing>, Fault> {
    let surface = source_of(tables, contact, "surface.csv");
    let below = source_of(tables, contact, "subsurface.csv");
    let mut drawings = vec![pressure(&contact.surface, &surface)];
    let limit = elastic_limit(result)?;
    drawings.extend(von_mises(row, limit, &contact.subsurface, &below));
    drawings.extend(change(row, &contact.surface, &surface));
    Ok(drawings)
}

fn across() -> Axis {
    Axis::new("distance from the middle of the contact", "µm")
}

fn column<R>(rows: &[R], value: impl Fn(&R) -> f64) -> Vec<f64> {
    rows.iter().map(value).collect()
}

/// The rows in and near the contact.
fn near(at: &PositionRow, all: &[SurfaceRow]) -> Vec<SurfaceRow> {
    let reach = NEAR * at.half_width_um;
    let near = |row: &&SurfaceRow| row.x_um.abs() <= reach;
    all.iter().filter(near).copied().collect()
}

/// Both flanks at first touch and under load.
fn flank_charts(at: &PositionRow, all: &[SurfaceRow], source: &str) -> Vec<Drawing> {
    let rows = near(at, all);
    let x = column(&rows, |row| row.x_um);
    let pinion = column(&rows, |row| row.height_pinion_um);
    let open = |row: &SurfaceRow| row.wheel_facing_um(at) - row.height_pinion_um;
    let least = all.iter().map(open).fold(f64::INFINITY, f64::min);
    let first_touch = facing(
        ["flanks-touch", "Flanks facing each other at first touch"],
        &x,
        &pinion,
        &column(&rows, |row| open(row) - least),
        source,
    );
    // Heights are relative to the middle between the highest and the lowest point of the pinion, which thinning preserves.
    let pressed = column(&rows, SurfaceRow::pinion_pressed_um);
    let [low, high] = range(pressed.iter().copied());
    let middle = 0.5 * (low + high);
    let pressed: Vec<f64> = pressed.iter().map(|height| height - middle).collect();
    let gap = column(&rows, |row| row.gap_um);
    let loaded = facing(
        ["flanks-load", "Flanks facing each other under load"],
        &x,
        &pressed,
        &gap,
        source,
    );
    vec![first_touch, loaded]
}

/// The flank of the pinion below and of the wheel above, separated by `gap`.
fn facing([id, title]: [&str; 2], x: &[f64], pinion: &[f64], gap: &[f64], source: &str) -> Drawing {
    let wheel: Vec<f64> = pinion.iter().zip(gap).map(|(z, g)| z + g).collect();
    let heights = Axis::new("height", "µm");
    let chart = Chart::new(id, title, source, across(), heights)
        .curve("pinion, below", Line::Solid, x, pinion)
        .curve("wheel, above", Line::Solid, x, &wheel);
    Drawing::Curves(chart)
}

/// Plastic change of both flanks by the contact; `None` without plastic flow.
fn change(at: &PositionRow, all: &[SurfaceRow], source: &str) -> Option<Drawing> {
    const NANOMETRES: f64 = 1e3;
    let rows = near(at, all);
    let flows = |row: &SurfaceRow| row.plastic_pinion_um > 0.0 || row.plastic_wheel_um > 0.0;
    if !rows.iter().any(flows) {
        return None;
    }
    let title = "Change of the flanks by the contact: height after minus before";
    let axis = Axis::new("change", "nm").from_zero();
    let x = column(&rows, |row| row.x_um);
    let pinion = column(&rows, |row| -NANOMETRES * row.plastic_pinion_um);
    let wheel = column(&rows, |row| -NANOMETRES * row.plastic_wheel_um);
    let chart = Chart::new("flanks-change", title, source, across(), axis)
        .curve("pinion", Line::Solid, &x, &pinion)
        .curve("wheel", Line::Dashed, &x, &wheel);
    Some(Drawing::Curves(chart))
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

/// Stress below the contact. The table extends further down and to the sides, where the stress is smooth.
fn von_mises(
    row: &PositionRow,
    limit: Pressure,
    cells: &[SubsurfaceRow],
    source: &str,
) -> Option<Drawing> {
    let reach = NEAR * row.half_width_um;
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
    let values: Vec<f64> = levels
        .iter()
        .flat_map(|level| level.iter().filter(shown).map(|cell| cell.von_mises_mpa))
        .collect();
    let limit_mpa = limit.si() * 1e-6;
    let passes = values.iter().any(|stress| *stress > limit_mpa);
    Some(Drawing::Contour(Contour {
        id: "von-mises".to_owned(),
        title: if passes {
            format!("Von Mises stress below the surface; line: elastic limit {limit_mpa:.0} MPa")
        } else {
            format!(
                "Von Mises stress below the surface; elastic limit {limit_mpa:.0} MPa not reached"
            )
        },
        isoline: passes.then_some(limit_mpa),
        source: source.to_owned(),
        x: across(),
        y: Axis::new("depth", "µm").downward(),
        value: "von Mises stress [MPa]".to_owned(),
        columns,
        rows: levels.iter().map(|level| level[0].depth_um).collect(),
        values,
        height: 250.0,
        ..Contour::default()
    }))
}

/// Elastic limit of the softer steel.
fn elastic_limit(result: &RunResult) -> Result<Pressure, Fault> {
    let material = &result.inputs.material;
    let pinion = material.pinion.elastic_limit;
    let pinion: Pressure = choice(result, pinion, "material.pinion.elastic_limit")?;
    let Some(wheel) = &material.wheel else {
        return Ok(pinion);
    };
    let wheel = choice(result, wheel.elastic_limit, "material.wheel.elastic_limit")?;
    Ok(if wheel < pinion { wheel } else { pinion })
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
    .curve("film and asperities", Line::Dots, &approach, &total)
    .curve("film", Line::Dashed, &approach, &fluid)
    .level(row.line_load_n_per_mm, "load to carry");
    Drawing::Curves(chart)
}

/// Load error by step: logarithmic for steps that seek the load, from zero for the loading path.
fn load_error(
    result: &RunResult,
    steps: &[ConvergenceRow],
    source: &str,
) -> Result<Drawing, Fault> {
    let model = &result.inputs.model;
    let (title, axis, tolerance) = if result.formulation.pressures().is_some() {
        let given = result.inputs.paper.numerical_error;
        (
            "Convergence: load error of each step",
            Axis::new("load error |F − F_target|/F_target", "").log(),
            choice::<Ratio>(result, given, "paper.numerical_error")?.value(),
        )
    } else {
        // The last error is round-off, which would dominate a logarithmic axis.
        (
            "Load still missing along the loading path",
            Axis::new("|F − F_target|/F_target", "").from_zero(),
            choice(result, model.tolerance, "model.tolerance")?,
        )
    };
    let chart = Chart::new("convergence", title, source, Axis::new("step", ""), axis)
        .curve(
            "load error",
            Line::Dots,
            &column(steps, |step| step.step as f64),
            &column(steps, |step| step.load_error),
        )
        .level(tolerance, "tolerance");
    Ok(Drawing::Curves(chart))
}

/// Model choice: the value of the case, or else the default.
fn choice<T: DeserializeOwned>(
    result: &RunResult,
    given: Option<T>,
    key: &'static str,
) -> Result<T, Fault> {
    if let Some(value) = given {
        return Ok(value);
    }
    let mut defaults = result.defaults.iter();
    let default = defaults
        .find(|entry| entry.key == key)
        .ok_or_else(|| error::no_value(key))?;
    serde_json::from_str(&default.value).map_err(error::of_json)
}
