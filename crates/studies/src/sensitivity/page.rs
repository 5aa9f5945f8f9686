//! Page of a sensitivity study: a bar per change, to the left where the loss falls, and a table.

use asperity_report::chart::{Axis, Bar, BarChart, Drawing};
use asperity_report::html::{figure, page};
use maud::html;

use super::study::{Effect, Sensitivity, SensitivityRow};
use super::summary::{
    NOTE, change, difference, headline, left_aside, named, refused, share, table,
};

pub(super) fn render(study: &Sensitivity) -> String {
    let changes = html! {
        @if let Some(largest) = largest(study) { p { strong { (largest) } } }
        p { (NOTE) }
        @if let Some(note) = left_aside(study) { p { (note) "." } }
        div.charts { (figure(&chart(study))) }
    };
    let parts = html! {
        (table(study))
        @for line in refused(study) { p { (line) } }
    };
    let sections = [("Changes of the loss", changes), ("Parts", parts)];
    let subtitle = format!("sensitivity · {}", headline(study));
    page(&study.title, &subtitle, &sections)
}

/// A change with its effect.
type Changed<'a> = (&'a SensitivityRow, &'a Effect);

/// Changes with an effect by group, the group with the largest change first, and by size within a group.
fn groups(study: &Sensitivity) -> Vec<Vec<Changed<'_>>> {
    let rows = study.rows.iter();
    let rows = rows.filter_map(|row| Some((row, row.effect.as_ref()?)));
    let mut groups: Vec<Vec<Changed<'_>>> = Vec::new();
    for row in rows {
        match groups
            .iter_mut()
            .find(|group| group[0].0.group == row.0.group)
        {
            Some(group) => group.push(row),
            None => groups.push(vec![row]),
        }
    }
    let size = |(_, effect): &Changed<'_>| effect.difference_w.abs();
    for group in &mut groups {
        group.sort_by(|a, b| size(b).total_cmp(&size(a)));
    }
    groups.sort_by(|a, b| size(&b[0]).total_cmp(&size(&a[0])));
    groups
}

/// The change with the largest effect, in words.
fn largest(study: &Sensitivity) -> Option<String> {
    let groups = groups(study);
    let (row, effect) = groups.first()?.first()?;
    Some(format!(
        "The largest change: {}, {} W, {} %.",
        named(row),
        difference(effect),
        share(effect)
    ))
}

/// All changes over one axis, group by group.
fn chart(study: &Sensitivity) -> Drawing {
    let groups = groups(study);
    let bars = groups.iter().flatten().map(|(row, effect)| Bar {
        name: format!("{}: {}", row.group, named(row)),
        value: Some(effect.difference_w),
        spread: effect.sampling_quantiles_w,
        text: format!("{} W, {} %", change(effect), share(effect)),
    });
    Drawing::Bars(BarChart {
        id: "sensitivity".to_owned(),
        title: "Change of the loss, with 5 to 95 % by the sampling of the flanks".to_owned(),
        source: "sensitivity.csv".to_owned(),
        axis: Axis::new("change of the loss", "W"),
        bars: bars.collect(),
    })
}
