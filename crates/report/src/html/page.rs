//! Page layout: complete without a network; a small script adds zoom and read-off.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::policy::{CHARTS, policy, style};
use crate::chart::{Drawing, Dress};

/// Renders a page of titled sections; empty sections are omitted.
pub fn page(title: &str, subtitle: &str, sections: &[(&str, Markup)]) -> String {
    let shown = || sections.iter().filter(|(_, body)| !body.0.is_empty());
    let anchor = |name: &str| name.to_lowercase().replace(' ', "-");
    let markup = html! {
        (DOCTYPE)
        html.page lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta http-equiv="Content-Security-Policy" content=(policy());
                title { (title) }
                style { (PreEscaped(style())) }
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
                script { (PreEscaped(CHARTS)) }
            }
        }
    };
    markup.into_string()
}

/// A chart with title, legend, name of its data file and, if it can be zoomed, its data.
pub fn figure(drawing: &Drawing) -> Markup {
    let data = drawing.data();
    html! {
        figure.zoomable[data.is_some()] id=(drawing.id()) {
            figcaption { (drawing.title()) }
            (legend(drawing))
            (PreEscaped(drawing.svg(Dress::Page)))
            p.under {
                span.source { "data: " code { (drawing.source()) } }
                @if data.is_some() { output.read aria-live="polite" {} }
            }
            @if let Some(data) = data { (embedded(&data)) }
        }
    }
}

/// Legend of a drawing with more than one line.
pub(super) fn legend(drawing: &Drawing) -> Markup {
    let legend = drawing.legend();
    html! {
        @if legend.len() > 1 {
            ul.legend {
                @for (name, class) in &legend {
                    li { (PreEscaped(sample(drawing.kind(), class))) (name) }
                }
            }
        }
    }
}

/// Data for the scripts of the page.
pub(super) fn embedded(data: &serde_json::Value) -> Markup {
    let text = data.to_string().replace('<', "\\u003c");
    html! { script type="application/json" { (PreEscaped(text)) } }
}

fn sample(kind: &str, class: &str) -> String {
    let is_area = ["area", "oil"].iter().any(|kind| class.starts_with(kind));
    let d = match class.ends_with("scatter") {
        true => "M10 6a4 4 0 1 0 8 0a4 4 0 1 0 -8 0",
        false if is_area => "M1 1h26v10h-26z",
        false => "M1 6h26",
    };
    format!(
        "<svg class=\"sample {kind}\" viewBox=\"0 0 28 12\" aria-hidden=\"true\"><path class=\"{class}\" d=\"{d}\"/></svg>"
    )
}
