//! Page layout: complete without a network; a small script adds zoom and read-off.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::policy::{CHARTS, policy, style};
use crate::chart::{Drawing, Dress};

/// Section of a page.
pub(crate) struct Section<'a> {
    /// Heading.
    pub name: &'a str,
    /// Content; an empty section is omitted.
    pub body: Markup,
    /// Whether the section is folded on the screen; on paper it is open.
    pub is_folded: bool,
}

impl<'a> Section<'a> {
    /// A section without content.
    pub(crate) fn new(name: &'a str, is_folded: bool) -> Self {
        Self {
            name,
            body: html! {},
            is_folded,
        }
    }
}

/// Renders a page of titled sections; empty sections are omitted.
pub fn page(title: &str, subtitle: &str, sections: &[(&str, Markup)]) -> String {
    let open = sections.iter().map(|(name, body)| Section {
        name,
        body: body.clone(),
        is_folded: false,
    });
    page_of(title, subtitle, None, &open.collect::<Vec<_>>())
}

/// Renders a page of sections that may be folded, with a `class` of the style.
pub(crate) fn page_of(
    title: &str,
    subtitle: &str,
    class: Option<&str>,
    sections: &[Section<'_>],
) -> String {
    let shown = || sections.iter().filter(|section| !section.body.0.is_empty());
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
            body class=[class] {
                header {
                    h1 { (title) }
                    p.sub { (subtitle) span.written {} }
                    nav aria-label="Sections" {
                        @for section in shown() { a href={ "#" (anchor(section.name)) } { (section.name) } }
                    }
                }
                main {
                    @for section in shown() {
                        section id=(anchor(section.name)) {
                            @if section.is_folded {
                                details { summary { h2 { (section.name) } } (section.body) }
                            } @else {
                                h2 { (section.name) } (section.body)
                            }
                        }
                    }
                }
                script { (PreEscaped(CHARTS)) }
            }
        }
    };
    markup.into_string()
}

/// A chart with title, legend, link to its data file and, if it can be zoomed, its data.
pub fn figure(drawing: &Drawing) -> Markup {
    let data = drawing.data();
    html! {
        figure.zoomable[data.is_some()] id=(drawing.id()) {
            figcaption { (drawing.title()) }
            (legend(drawing))
            (PreEscaped(drawing.svg(Dress::Page)))
            (source(drawing.source()))
            @if let Some(data) = data { (embedded(&data)) }
        }
    }
}

/// Line below a chart with the file of its data.
pub(crate) fn source(file: &str) -> Markup {
    html! {
        p.under {
            span.source {
                "data: "
                // "this page" is not a file.
                @if file.contains('.') { a href=(file) { (file) } } @else { (file) }
            }
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
