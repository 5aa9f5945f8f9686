//! Page layout: complete without a network; a small script adds zoom and read-off.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::policy::{CHARTS, policy, style};
use crate::chart::{Drawing, Dress};
use crate::terms;

/// Section of a page.
pub(crate) struct PageSection<'a> {
    /// Heading.
    pub name: &'a str,
    /// Content; an empty section is omitted.
    pub body: Markup,
    /// Whether the section is folded on the screen; on paper it is open.
    pub is_folded: bool,
}

impl<'a> PageSection<'a> {
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
    let open = sections.iter().map(|(name, body)| PageSection {
        name,
        body: body.clone(),
        is_folded: false,
    });
    page_of(title, subtitle, None, &open.collect::<Vec<_>>())
}

/// Name of the section with the terms of a page.
const TERMS: &str = "Terms";

/// Renders a page of sections that may be folded, with a `class` of the style. The terms that they use follow the first one.
pub(crate) fn page_of(
    title: &str,
    subtitle: &str,
    class: Option<&str>,
    sections: &[PageSection<'_>],
) -> String {
    let text: String = sections.iter().map(|of| text_of(&of.body.0)).collect();
    let mut used = terms::used(&(text + subtitle)).peekable();
    let mut terms = PageSection::new(TERMS, true);
    if used.peek().is_some() {
        terms.body = terms::list(used);
    }
    let is_filled = |section: &&PageSection<'_>| !section.body.0.is_empty();
    let shown = || {
        let mut filled = sections.iter().filter(is_filled);
        let first = filled.next();
        let terms = Some(&terms).filter(is_filled);
        first.into_iter().chain(terms).chain(filled)
    };
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
    typeset(&markup.into_string())
}

/// Elements whose text is copied or run, and stays as it is.
const VERBATIM: [&str; 4] = ["script", "style", "pre", "code"];
/// Units in plain letters, as inputs and the terminal have them, and as they are printed.
const UNITS: [(&str, &str); 2] = [(" um", " µm"), (" mm2/s", " mm²/s")];

/// The text of `markup` without tags, scripts and styles.
fn text_of(markup: &str) -> String {
    let mut text = String::new();
    for part in parts_of(markup) {
        match part {
            PagePart::Text(part) => text += part,
            // Words of neighbouring elements stay apart.
            PagePart::Tag(_) => text.push(' '),
        }
    }
    text
}

/// Prints the units in the text of a page with their own letters; code stays as it is.
fn typeset(page: &str) -> String {
    let mut written = String::with_capacity(page.len());
    for part in parts_of(page) {
        match part {
            PagePart::Text(text) => written += &with_units(text),
            PagePart::Tag(tag) => written += tag,
        }
    }
    written
}

/// Part of a page.
enum PagePart<'a> {
    /// Text between tags.
    Text(&'a str),
    /// A tag, with its content if that is verbatim.
    Tag(&'a str),
}

/// The parts of a page in turn.
fn parts_of(page: &str) -> impl Iterator<Item = PagePart<'_>> {
    let mut rest = page;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        if !rest.starts_with('<') {
            let (text, after) = rest.split_at(rest.find('<').unwrap_or(rest.len()));
            rest = after;
            return Some(PagePart::Text(text));
        }
        let name = rest[1..].split(|letter: char| !letter.is_ascii_alphanumeric());
        let end = match name.into_iter().next() {
            Some(name) if VERBATIM.contains(&name) => rest.find(&format!("</{name}>")),
            _ => rest.find('>').map(|last| last + 1),
        };
        let (tag, after) = rest.split_at(end.filter(|end| *end > 0).unwrap_or(rest.len()));
        rest = after;
        Some(PagePart::Tag(tag))
    })
}

fn with_units(text: &str) -> String {
    let mut text = text.to_owned();
    for (plain, printed) in UNITS {
        let mut parts = text.split(plain);
        let mut replaced = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let is_word =
                !part.starts_with(|letter: char| letter.is_alphanumeric() || letter == '_');
            replaced += if is_word { printed } else { plain };
            replaced += part;
        }
        text = replaced;
    }
    text
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_printed_in_the_text_of_a_page_only() {
        let page = "<p title=\"2 um\">10 um of 15 mm2/s, 3 umbrellas</p><code>5 um</code><script>a < ' um'</script><b>1 um</b>";
        let due = "<p title=\"2 um\">10 µm of 15 mm²/s, 3 umbrellas</p><code>5 um</code><script>a < ' um'</script><b>1 µm</b>";
        assert_eq!(typeset(page), due);
    }
}
