//! Fig. 9 to 13: reference case of the paper's Table 2.

use std::path::Path;

use asperity::case::LoadedCase;
use asperity::result::PositionFields;
use asperity_core::Fault;
use asperity_report::PageTables;
use asperity_report::chart::{Axis, Chart, Drawing};
use asperity_report::html::drawings_of_contact;
use asperity_report::tables::write;

use super::figure;
use super::figure::PaperFigure;
use super::parts;

/// File, chart of the report, title, table.
const FIGURES: &[(&str, &str, &str, &str)] = &[
    (
        "fig09a_touch",
        "flanks-touch",
        "Fig. 9a: both flanks before the contact, facing each other",
        SURFACE,
    ),
    (
        "fig09b_load",
        "flanks-load",
        "Fig. 9b: both flanks in contact, facing each other",
        SURFACE,
    ),
    (
        "fig09c_change",
        "flanks-change",
        "Fig. 9c: change of the flanks, from before to after",
        SURFACE,
    ),
    (
        "fig10a_contact_stress",
        "pressure",
        "Fig. 10a: contact stress; symmetric, since the trace meets itself (the paper's is asymmetric)",
        SURFACE,
    ),
    (
        "fig11a_subsurface",
        "von-mises",
        "Fig. 11a: von Mises stress below the surface; white: elastic limit",
        SUBSURFACE,
    ),
    (
        "fig13a_load",
        "approach",
        "Fig. 13a: load while the surfaces are lowered",
        MARCHING,
    ),
    (
        "fig13b_convergence",
        "convergence",
        "Fig. 13b: load error of each step; the paper states 28 iterations and an error of 4 %",
        MARCHING,
    ),
];
const SURFACE: &str = "fig09_fig10_surface.csv";
const SUBSURFACE: &str = "fig11_subsurface.csv";
const REFLECTED: &str = "fig10c_surface.csv";
const MARCHING: &str = "fig13_convergence.csv";
/// Range of a zoom into the contact [µm] and below it.
const ZOOM_UM: [f64; 2] = [-110.0, -70.0];
const ZOOM_DEPTH_UM: f64 = 20.0;

pub(super) fn figures(case: &LoadedCase, folder: &Path) -> Result<Vec<PaperFigure>, Fault> {
    let outcome = asperity::Run::new(case).execute()?.into_only()?;
    let result = &outcome.result;
    let tables = PageTables::new(&outcome, Some(1))?;
    let drawings = drawings_of_contact(result, &tables)?;
    if let Some(contact) = &tables.contact {
        write(&folder.join(SURFACE), &contact.surface)?;
        write(&folder.join(SUBSURFACE), &contact.subsurface)?;
        write(&folder.join(MARCHING), &contact.convergence)?;
    }
    let engagements = engagements(case, outcome.fields.first());
    let mut figures = parts::figures(&result.summary, engagements, folder)?;
    figures.push(reflected(case, folder)?);
    for &(name, id, title, table) in FIGURES {
        let drawing = drawings.iter().find(|drawing| drawing.id() == id);
        let drawing = drawing.ok_or_else(|| figure::no_contact(table))?;
        let drawing = renamed(drawing.clone(), title, table);
        if let Some(near) = zoomed(&drawing) {
            figures.push(near);
        }
        figures.push(PaperFigure { name, drawing });
    }
    Ok(figures)
}

/// Cells across the face width times engagements of a tooth in a revolution of the pinion.
fn engagements(case: &LoadedCase, fields: Option<&PositionFields>) -> f64 {
    let gears = &case.case.gears;
    let cell = fields.and_then(|fields| Some(fields.x.get(1)? - fields.x.first()?));
    let cells = gears.face_width.si() / cell.unwrap_or(f64::INFINITY);
    f64::from(gears.teeth[0]) * cells
}

/// Contact stress where the wheel's flank is the pinion's, reflected across the contact instead of read from its other end.
fn reflected(case: &LoadedCase, folder: &Path) -> Result<PaperFigure, Fault> {
    let case = case.with_key("surface.wheel.mirrored", "false")?;
    let outcome = asperity::Run::new(&case).execute()?.into_only()?;
    let tables = PageTables::new(&outcome, Some(1))?;
    let drawings = drawings_of_contact(&outcome.result, &tables)?;
    let drawing = drawings
        .into_iter()
        .find(|drawing| drawing.id() == "pressure");
    let drawing = drawing.ok_or_else(|| figure::no_contact(REFLECTED))?;
    if let Some(contact) = &tables.contact {
        write(&folder.join(REFLECTED), &contact.surface)?;
    }
    let title = "Fig. 10c: contact stress with the trace reflected across the contact: asymmetric, as the paper's";
    Ok(PaperFigure {
        name: "fig10c_contact_stress_reflected",
        drawing: renamed(drawing, title, REFLECTED),
    })
}

fn renamed(mut drawing: Drawing, title: &str, table: &str) -> Drawing {
    let (own_title, source) = match &mut drawing {
        Drawing::Curves(chart) => (&mut chart.title, &mut chart.source),
        Drawing::Bars(chart) => (&mut chart.title, &mut chart.source),
        Drawing::Tornado(chart) => (&mut chart.title, &mut chart.source),
        Drawing::Strip(chart) => (&mut chart.title, &mut chart.source),
        Drawing::Contour(chart) => (&mut chart.title, &mut chart.source),
        Drawing::Mesh(chart) => (&mut chart.title, &mut chart.source),
        Drawing::Facing(chart) => (&mut chart.title, &mut chart.source),
        Drawing::Symbol(symbol) => (&mut symbol.title, &mut symbol.source),
    };
    title.clone_into(own_title);
    table.clone_into(source);
    drawing
}

/// Contact stress and subsurface stress of a few asperities.
fn zoomed(drawing: &Drawing) -> Option<PaperFigure> {
    let [low, high] = ZOOM_UM;
    let near = |axis: &Axis| axis.clone().within(low, high);
    match drawing {
        Drawing::Curves(chart) if chart.id == "pressure" => {
            let chart = Chart {
                id: format!("{}-near", chart.id),
                x: near(&chart.x),
                title: "Fig. 10b: contact stress, near".to_owned(),
                ..chart.clone()
            };
            Some(PaperFigure::curves("fig10b_contact_stress_near", chart))
        }
        Drawing::Contour(contour) => {
            let mut contour = contour.clone();
            contour.id.push_str("-near");
            contour.x = near(&contour.x);
            contour.y = contour.y.clone().within(contour.rows[0], ZOOM_DEPTH_UM);
            contour.title = "Fig. 11b: von Mises stress below the surface, near".to_owned();
            Some(PaperFigure {
                name: "fig11b_subsurface_near",
                drawing: Drawing::Contour(contour),
            })
        }
        _ => None,
    }
}
