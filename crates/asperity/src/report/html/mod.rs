//! `report.html`: one page with the whole result, without a network, made from a result folder.
//!
//! The page is drawn from the files in the folder and from nothing else, so it cannot say another number
//! than they do. Every chart is complete without scripts; a small script adds zoom and read-off.

mod contact;
pub(crate) mod data;
mod flanks;
mod inputs;
mod overview;
mod path;

use std::path::Path;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::ReportError;
use super::chart::{Drawing, Dress, STYLE};
use super::folder::io_at;
use data::ResultFolder;

pub(crate) use contact::drawings as drawings_of_contact;
pub(crate) use overview::losses as drawing_of_losses;

const PAGE_STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("chart.js");

/// Writes `report.html` beside the `result.json` at `path` (or in the folder `path`) and gives its
/// place. Fields are shown at `position`, or where the pressure is highest.
///
/// # Errors
/// When the result cannot be read or the page not be written.
pub fn write(path: &Path, position: Option<usize>) -> Result<std::path::PathBuf, ReportError> {
    let result = ResultFolder::open(path)?;
    let file = result.folder.join("report.html");
    std::fs::write(&file, render(&result, position)?).map_err(io_at(&file))?;
    Ok(file)
}

fn render(result: &ResultFolder, position: Option<usize>) -> Result<String, ReportError> {
    let title = result.text("/title");
    let sections = [
        ("Summary", overview::section(result)?),
        ("Along the path of contact", path::section(result)?),
        ("In the contact", contact::section(result, position)?),
        ("Flanks", flanks::section(result)?),
        ("Inputs", inputs::section(result)),
    ];
    Ok(page(title, &subtitle(result), &sections))
}

fn subtitle(result: &ResultFolder) -> String {
    format!(
        "{} · formulation {}",
        result.text("/program"),
        result.text("/formulation")
    )
}

/// A page of titled sections.
pub(crate) fn page(title: &str, subtitle: &str, sections: &[(&str, Markup)]) -> String {
    let shown = || sections.iter().filter(|(_, body)| !body.0.is_empty());
    let anchor = |name: &str| name.to_lowercase().replace(' ', "-");
    let markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta http-equiv="Content-Security-Policy"
                    content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'";
                title { (title) }
                style { (PreEscaped(STYLE)) (PreEscaped(PAGE_STYLE)) }
            }
            body {
                header {
                    h1 { (title) }
                    p.sub { (subtitle) }
                    nav aria-label="Sections" {
                        @for (name, _) in shown() { a href={ "#" (anchor(name)) } { (name) } }
                    }
                }
                main {
                    @for (name, body) in shown() {
                        section id=(anchor(name)) { h2 { (name) } (body) }
                    }
                }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    };
    markup.into_string()
}

/// A chart with its title, legend, table and, where there is anything to zoom, its data.
pub(crate) fn figure(drawing: &Drawing) -> Markup {
    let data = drawing.data();
    let legend = drawing.legend();
    html! {
        figure.zoomable[data.is_some()] id=(drawing.id()) {
            figcaption { (drawing.title()) }
            @if legend.len() > 1 {
                ul.legend {
                    @for (name, class) in &legend {
                        li { (PreEscaped(sample(class))) (name) }
                    }
                }
            }
            (PreEscaped(drawing.svg(Dress::Page)))
            p.under {
                span.source { "data: " code { (drawing.source()) } }
                @if data.is_some() { output.read aria-live="polite" {} }
            }
            @if let Some(data) = data {
                script type="application/json" { (PreEscaped(data.to_string().replace('<', "\\u003c"))) }
            }
        }
    }
}

fn sample(class: &str) -> String {
    let d = if class.ends_with("scatter") {
        "M10 6a4 4 0 1 0 8 0a4 4 0 1 0 -8 0"
    } else {
        "M1 6h26"
    };
    format!(
        "<svg class=\"sample\" viewBox=\"0 0 28 12\" aria-hidden=\"true\"><path class=\"{class}\" d=\"{d}\"/></svg>"
    )
}
