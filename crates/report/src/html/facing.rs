//! The mesh at a glance: the pair in mesh, and the flanks facing each other at the position of a slider.

use asperity::result::{ContactView, FlankRecord, PositionRow, RunResult};
use maud::{Markup, PreEscaped, html};

use super::along::points;
use super::page::{embedded, legend, source};
use super::policy::PATH;
use super::{mesh, temperatures};
use crate::chart::{Drawing, Dress, Facing, FacingFrame};
use crate::page_tables::{PageTables, shown_position};

/// The flanks facing each other along the path; `None` if no rough contact was solved.
pub(super) fn flanks(result: &RunResult, tables: &PageTables) -> Option<Markup> {
    facing(result, tables).map(slider)
}

/// The pair in mesh with its slider and its button, which the script enables; `None` if it cannot be drawn.
pub(super) fn in_mesh(result: &RunResult) -> Option<Markup> {
    /// Steps of the slider.
    const STEPS: u32 = 250;
    let picture = mesh::picture(result)?;
    let motion = picture.motion();
    let drawing = Drawing::Mesh(picture);
    let is_placed = |flank: &FlankRecord| flank.roll_lengths_mm.is_some();
    Some(html! {
        figure.mesh id=(drawing.id()) {
            figcaption { (drawing.title()) }
            (PreEscaped(drawing.svg(Dress::Page)))
            label.slider hidden {
                button type="button" { "Play" }
                input type="range" min="0" max=(STEPS) step="1" value="0" aria-label="Place of the contact on the path, from A to E";
            }
            p.under { output.caption { "Contact at the pitch point C" } }
            (legend(&drawing))
            @if !result.flanks.iter().any(is_placed) {
                p.sub { "The places of the traces on their flanks are unknown: the keys " code { "surface.pinion.at" } " and "
                    code { "surface.wheel.at" } " are not stated." }
            }
            (source(drawing.source()))
            (embedded(&motion))
        }
    })
}

/// The script that moves along the path.
pub(super) fn script() -> Markup {
    html! { script { (PreEscaped(PATH)) } }
}

/// The figure with its slider, which the script enables.
fn slider(facing: Facing) -> Markup {
    let first = facing.first;
    let last = facing.frames.len() - 1;
    let text = facing.frames[first].text.clone();
    let frames = facing.frames();
    let drawing = Drawing::Facing(facing);
    html! {
        figure.facing id=(drawing.id()) {
            figcaption { (drawing.title()) }
            (legend(&drawing))
            @if last > 0 {
                label.slider hidden {
                    span { "position" }
                    input type="range" min="0" max=(last) step="1" value=(first) aria-label="Position along the path of contact, from A to E";
                }
            }
            (PreEscaped(drawing.svg(Dress::Page)))
            p.under { output.caption aria-live="polite" { (text) } }
            (source(drawing.source()))
            (embedded(&frames))
        }
    }
}

/// The flanks facing each other along the path; `None` if no rough contact was solved.
fn facing(result: &RunResult, tables: &PageTables) -> Option<Facing> {
    let row = |view: &ContactView| {
        let mut rows = result.path.iter();
        rows.find(|row| row.position == view.position)
    };
    let pairs: Vec<(&ContactView, &PositionRow)> = (tables.views.iter())
        .filter_map(|view| Some((view, row(view)?)))
        .filter(|(view, row)| view.x_um.len() > 1 && row.half_width_um > 0.0)
        .collect();
    let highest = || {
        shown_position(result, None)
            .ok()
            .flatten()
            .map(|row| row.position)
    };
    let shown = tables
        .contact
        .as_ref()
        .map(|at| at.position)
        .or_else(highest);
    let first = pairs
        .iter()
        .position(|(view, _)| Some(view.position) == shown);
    let frames: Vec<FacingFrame> = pairs.iter().map(|(view, row)| frame(view, row)).collect();
    if frames.is_empty() {
        return None;
    }
    let mut facing = Facing {
        id: "facing".to_owned(),
        title: "The flanks facing each other under load".to_owned(),
        source: tables.source("page.json"),
        frames,
        first: first.unwrap_or(0),
        marks: points(result),
        reach: ContactView::REACH,
    };
    let exaggeration = facing.exaggeration();
    let texts: Vec<String> = pairs
        .iter()
        .map(|(view, row)| caption(result, view, row, exaggeration * row.half_width_um))
        .collect();
    for (frame, text) in facing.frames.iter_mut().zip(texts) {
        frame.text = text;
    }
    Some(facing)
}

fn frame(view: &ContactView, row: &PositionRow) -> FacingFrame {
    FacingFrame {
        text: String::new(),
        at: row.s_mm,
        x: view.x_um.iter().map(|x| x / row.half_width_um).collect(),
        lower: view.pinion_um.clone(),
        upper: view.wheel_um.clone(),
        solid: view.pressure_solid_mpa.clone(),
        fluid: view.pressure_fluid_mpa.clone(),
        hertz: row.hertz_pressure_mpa,
    }
}

/// Load on asperities over the whole load, of points that are evenly spaced.
fn asperity_share(view: &ContactView) -> f64 {
    let [solid, fluid] = [&view.pressure_solid_mpa, &view.pressure_fluid_mpa]
        .map(|pressure| pressure.iter().filter(|p| p.is_finite()).sum::<f64>());
    // Without a load there is nothing to share.
    if solid + fluid > 0.0 {
        solid / (solid + fluid)
    } else {
        0.0
    }
}

/// Caption of a position: position, contact, and exaggeration of the heights.
fn caption(result: &RunResult, view: &ContactView, row: &PositionRow, exaggeration: f64) -> String {
    let mut parts = vec![
        format!("Position {} of {}", row.position, result.path.len()),
        format!("{:.2} mm from T₁", row.s_mm),
        format!("half-width {:.0} µm", row.half_width_um),
        format!("p₀ {:.0} MPa", row.hertz_pressure_mpa),
    ];
    if let Some(gap) = row.mean_gap_um {
        parts.push(format!("mean gap {gap:.3} µm"));
    }
    let mean = format!("{:.0} %", 100.0 * (1.0 - row.film_share));
    parts.push(match result.summary.offsets {
        1 => format!("{mean} of the load on asperities"),
        offsets => format!(
            "{:.0} % of the load on asperities here, {mean} in the mean of {offsets} offsets",
            100.0 * asperity_share(view)
        ),
    });
    let contact = temperatures::bulk(result) + row.flash_k;
    parts.push(format!("mean contact temperature {contact:.0} °C"));
    format!(
        "{}. Heights are shown {exaggeration:.0} times as large as lengths.",
        parts.join("; ")
    )
}
