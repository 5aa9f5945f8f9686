//! Page of a sensitivity study: one bar per change, and a table.

use asperity_report::chart::{Axis, Bar, BarChart, Drawing};
use asperity_report::html::{figure, page};
use maud::{Markup, html};

use super::study::{Effect, Sensitivity, SensitivityRow};
use super::summary::{NOTE, difference, headline, left_aside, part_text, share};

pub(super) fn render(study: &Sensitivity) -> String {
    let changes = html! {
        p { (NOTE) }
        @if let Some(note) = left_aside(study) { p { (note) "." } }
        div.charts { (figure(&chart(study))) }
    };
    let sections = [("Changes of the loss", changes), ("Parts", table(study))];
    let subtitle = format!("sensitivity of a loss of {} W", headline(study));
    page(&study.title, &subtitle, &sections)
}

/// Changes by size, largest first.
fn chart(study: &Sensitivity) -> Drawing {
    let mut rows: Vec<(&SensitivityRow, &Effect)> = study
        .rows
        .iter()
        .filter_map(|row| Some((row, row.effect.as_ref()?)))
        .collect();
    rows.sort_by(|(_, a), (_, b)| b.difference_w.abs().total_cmp(&a.difference_w.abs()));
    let bars = rows.iter().map(|(row, effect)| {
        let size = effect.difference_w.abs();
        let spread = |[low, high]: [f64; 2]| {
            let half = 0.5 * (high - low);
            [(size - half).max(0.0), size + half]
        };
        Bar {
            name: format!("{} → {}", row.what, row.to),
            value: Some(size),
            spread: effect.sampling_quantiles_w.map(spread),
            text: format!("{} W", difference(effect)),
        }
    });
    Drawing::Bars(BarChart {
        id: "sensitivity".to_owned(),
        title: "Size of the change of the loss".to_owned(),
        source: "sensitivity.csv".to_owned(),
        axis: Axis::new("size of the change", "W"),
        bars: bars.collect(),
    })
}

fn table(study: &Sensitivity) -> Markup {
    html! { div.scroll { table {
        thead { tr { th { "of" } th { "change" } th { "to" } th.number { "W" } th.number { "%" } th.number { "film W" }
            th.number { "lubricated asperities W" } th.number { "boundary layer W" } th.number { "rolling W" } } }
        tbody { @for row in &study.rows { tr {
            td { (row.group) } td { (row.what) } td { (row.to) }
            @if let Some(effect) = &row.effect {
                td.number { (difference(effect)) } td.number { (share(effect)) }
                @for part in [effect.film_w, effect.lubricated_asperity_w, effect.boundary_w, effect.rolling_w] {
                    td.number { (part_text(part, effect)) }
                }
            }
            @if let Some(refused) = &row.refused { td colspan="6" { (refused.code) " " (refused.message) } }
        } } }
    } } }
}
