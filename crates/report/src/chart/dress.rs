//! Style of charts in pages and in separate files.

/// Colours and lines of charts, for the page and for files; Okabe and Ito's palette.
pub const STYLE: &str = include_str!("chart.css");

/// Context in which a chart is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dress {
    /// In a page, which contains title, legend and style.
    Page,
    /// Separate file with title, legend and style.
    Alone,
}

#[cfg(test)]
mod tests {
    use super::STYLE;

    #[test]
    fn every_style_is_of_a_chart_and_one_kind_of_chart_cannot_change_another() {
        let rules = STYLE
            .replace("@media (prefers-color-scheme:dark){", "")
            .replace("@media print{", "");
        let selectors = rules
            .split('}')
            .filter_map(|rule| Some(rule.split_once('{')?.0));
        let mut count = 0;
        for selector in selectors {
            count += 1;
            // A class of a drawing comes below the class of its kind, of all charts, or of all and their samples.
            let parts: Vec<&str> = selector.trim().split(' ').collect();
            let is_kind = |part: &str| part.starts_with('.') && part.ends_with("-chart");
            let is_scope = match parts[0] {
                "svg.chart" | "html.page,svg.chart" | ":is(.chart,.sample)" => true,
                ":is(.facing-chart,.mesh-chart)" => true,
                part => is_kind(part) && parts.len() > 1,
            };
            assert!(is_scope, "{selector}");
        }
        assert!(count > 40);
        // Where no font is named for `system-ui`, it may be any, a monospaced one too.
        let fonts = STYLE.split("font-family:").nth(1).unwrap_or_default();
        assert!(fonts.find("Liberation Sans") < fonts.find("system-ui"));
        // Named like classes of several kinds of charts.
        for class in [".dots", ".band", ".trace", ".film", ".tip"] {
            let rule = format!("{class}{{");
            let before = STYLE.split(&rule).next().unwrap_or_default();
            let selector = before.rsplit('}').next().unwrap_or_default();
            assert!(
                !STYLE.contains(&rule) || selector.contains("-chart "),
                "{selector}"
            );
        }
    }
}
