//! Page of a study: tornado charts and table of effects.

use asperity_report::chart::{Axis, Bar, BarChart, Drawing};
use asperity_report::html::{figure, page};
use maud::{Markup, html};

use super::merged::{EffectRow, Merged};

pub(super) fn render(merged: &Merged) -> String {
    let mut outputs: Vec<&str> = merged
        .effects
        .iter()
        .map(|row| row.output.as_str())
        .collect();
    outputs.dedup();
    let tornados = html! {
        p { "Change of the mean of a result from the lowest to the highest quarter of an input, with its 5 and 95 % quantiles." }
        div.charts { @for output in &outputs { @if let Some(chart) = tornado(merged, output) { (figure(&chart)) } } }
    };
    let sections = [
        ("Study", study(merged)),
        (
            "Tornado",
            if outputs.is_empty() {
                html! {}
            } else {
                tornados
            },
        ),
        ("Effects", table(merged)),
    ];
    let subtitle = format!("sweep {} · {} cases", merged.name, merged.cases);
    page(&merged.title, &subtitle, &sections)
}

fn study(merged: &Merged) -> Markup {
    html! {
        p { (merged.cases) " cases, " (merged.failed) " without a result. SHA-256 of sweep.csv "
            code { (merged.sha256) } ", study " code { (merged.study) } "." }
    }
}

/// Inputs by the size of their effect, largest first.
fn tornado(merged: &Merged, output: &str) -> Option<Drawing> {
    let mut rows: Vec<(&EffectRow, f64, f64)> = merged
        .effects
        .iter()
        .filter(|row| row.output == output)
        .filter_map(|row| {
            Some((
                row,
                row.effect?.difference,
                0.5 * (row.effect?.quantiles[1] - row.effect?.quantiles[0]),
            ))
        })
        .collect();
    rows.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    let bars: Vec<Bar> = rows
        .iter()
        .map(|(row, difference, half)| Bar {
            name: row
                .input
                .rsplit('.')
                .next()
                .unwrap_or(&row.input)
                .to_owned(),
            value: Some(difference.abs()),
            spread: Some([difference.abs() - half, difference.abs() + half]),
            text: format!("{difference:+.3e}"),
        })
        .collect();
    (!bars.is_empty()).then(|| {
        Drawing::Bars(BarChart {
            id: format!("tornado-{output}"),
            title: format!("Effect on {output}"),
            source: "effects.csv".to_owned(),
            axis: Axis::new("size of the change", ""),
            bars,
        })
    })
}

fn table(merged: &Merged) -> Markup {
    let index = |value: f64, [low, high]: [f64; 2]| format!("{value:.3} ({low:.3} .. {high:.3})");
    html! { div.scroll { table {
        thead { tr { th { "result" } th { "input" } th.number { "change" } th.number { "correlation" }
            th.number { "first index" } th.number { "total index" } } }
        tbody { @for row in &merged.effects { tr {
            td { (row.output) } td { code { (row.input) } }
            td.number { @if let Some(e) = row.effect { (e.text()) } }
            td.number { @if let Some(e) = row.effect { (format!("{:+.2}", e.correlation)) } }
            td.number { @if let Some(i) = row.indices { (index(i.first, i.first_interval)) } }
            td.number { @if let Some(i) = row.indices { (index(i.total, i.total_interval)) } }
        } } }
    } } }
}
