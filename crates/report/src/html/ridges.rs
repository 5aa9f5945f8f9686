//! The ridges that cost most, drawn: both traces coloured by the loss made there.

use asperity::result::RunResult;
use asperity::result::ridges::{RidgeRow, Ridges, WattsStrip};
use maud::{Markup, html};

use super::page::figure;
use crate::chart::{Axis, Chart, Drawing, Line, Mark, Series};
use crate::ridges::{NOTE, certain, listed, notes, saving_of, verdict, watts};
use crate::tables::BODIES;
use crate::{Table, columns};

/// Explanation of the colours.
const COLOURS: &str = "The colour shows the height above the mean line times the gradient of the loss, per length of the trace. Its sum \
    over a ridge is the saving by the gradient before the removal. Where it is negative, lowering the trace raises the loss: the \
    load is given, and points that are lowered leave theirs to the points around them, whose signs can thus be opposite. A peak \
    far above the others separates them: removing it brings more of them into boundary friction. The cursor shows the value.";

/// The section of a run: the first ridges, or why there are none; empty if they were not sought.
pub(super) fn section(result: &RunResult) -> Markup {
    html! {
        @if let Some(why) = &result.no_ridges { p { "Not computed: " (why) "." } }
        @if let Some(ridges) = &result.ridges {
            p { strong { (verdict(ridges)) } " This refers to a loss of " (watts(ridges.loss_at_medians_w)) " W, with every constant at its median. "
                code { "asperity ridges" } " lists all of these ridges and the loss by wavelength." }
            @if let Some(certain) = certain(ridges) { p { (certain) } }
            @for note in notes(ridges) { p { (note) } }
            (charts(ridges, Some("result.json")))
            (table(listed(ridges)))
            p.note { (NOTE) }
        }
    }
}

/// Table of ridges with their numbers.
pub fn table<'a>(rows: impl IntoIterator<Item = (usize, &'a RidgeRow)>) -> Table {
    columns! { (number, row) in rows;
        shown ridge "ridge" "" = number;
        text flank "flank" "" = &row.flank;
        number place_mm "place" "mm" "{:.4}" = row.place_mm;
        number width_um "width" "µm" "{:.1}" = row.width_um;
        number height_um "height" "µm" "{:.3}" = row.height_um;
        number mean_gradient_w "saving" "W" = saving_of(row);
    }
}

/// Both traces and close-ups of the costliest ridges, coloured on one scale, each with the table of its trace. Of the result of a
/// run, whose `file` holds their data, only the traces.
pub fn charts(ridges: &Ridges, file: Option<&str>) -> Markup {
    let scale = scale(ridges);
    // As many as the table next to the traces has.
    let all = ridges.rows.iter().enumerate().map(|(k, row)| (k + 1, row));
    let numbered: Vec<(usize, &RidgeRow)> = match file {
        Some(_) => listed(ridges).collect(),
        None => all.collect(),
    };
    let traces = BODIES.iter().zip(&ridges.along).map(|(body, strip)| {
        let own = numbered.iter().filter(|(_, row)| row.flank == *body);
        let marks = own.map(|(number, row)| Mark {
            at: row.place_mm,
            label: number.to_string(),
        });
        let mut marks: Vec<Mark> = marks.collect();
        marks.sort_by(|a, b| a.at.total_cmp(&b.at));
        let title =
            format!("Trace of the {body}, coloured by the loss made there, ridges numbered");
        chart(&format!("watts-{body}"), &title, body, strip, scale).marked(&marks)
    });
    let near = if file.is_none() {
        &ridges.near[..]
    } else {
        &[]
    };
    let near = near.iter().zip(&ridges.rows).enumerate();
    let near = near.map(|(k, (strip, row))| {
        let title = format!("Ridge {}: {} at {:.4} mm", k + 1, row.flank, row.place_mm);
        chart(
            &format!("ridge-{}", k + 1),
            &title,
            &row.flank,
            strip,
            scale,
        )
    });
    let named = |mut chart: Chart| {
        chart.source = file.map_or(chart.source, str::to_owned);
        Drawing::Curves(chart)
    };
    html! {
        p { (COLOURS) }
        div.charts { @for chart in traces.chain(near) { (figure(&named(chart))) } }
    }
}

/// Edges of the colours \[W/mm\]: round numbers, each about a third of the next, up to a third of the largest value.
fn scale(ridges: &Ridges) -> [f64; 3] {
    let strips = ridges.along.iter().chain(&ridges.near);
    let cells = strips.flat_map(|strip| &strip.cells);
    let largest = cells.fold(f64::MIN_POSITIVE, |most, [.., w]| most.max(w.abs()));
    // 1, 3, 10, 30, ...
    let last = (2.0 * (largest / 3.0).log10()).floor() as i32;
    [2, 1, 0].map(|down| {
        let k = last - down;
        let lead = if k.rem_euclid(2) == 0 { 1.0 } else { 3.0 };
        lead * 10_f64.powi(k.div_euclid(2))
    })
}

fn chart(id: &str, title: &str, body: &str, strip: &WattsStrip, scale: [f64; 3]) -> Chart {
    let x = Axis::new("place on the prepared trace", "mm");
    let y = Axis::new("height", "µm");
    let mut chart = Chart::new(id, title, &format!("{body}.csv"), x, y);
    let level = |w: f64| {
        let level = scale.iter().filter(|edge| w.abs() >= **edge).count() as i8;
        if w < 0.0 { -level } else { level }
    };
    let place = |cell: usize| strip.begin_mm + strip.cell_mm * cell as f64;
    for (own, name) in names(scale) {
        let cells = strip.cells.iter().enumerate();
        let cells = cells.filter(|(_, [.., w])| level(*w) == own);
        let corners = cells.flat_map(|(k, [low, high, _])| {
            let [x1, x2] = [place(k), place(k + 1)];
            [
                [x1, *low],
                [x1, *high],
                [x2, *high],
                [x2, *low],
                [f64::NAN; 2],
            ]
        });
        let mut series = Series::through(&name, Line::Level(own), corners);
        if own == 0 {
            let readings = strip.cells.iter().enumerate();
            let middle = |k: usize| place(k) + 0.5 * strip.cell_mm;
            series.readings = readings.map(|(k, [.., w])| [middle(k), *w]).collect();
            series.unit = "W/mm";
        }
        if own == 0 || !series.points.is_empty() {
            chart.series.push(series);
        }
    }
    chart
}

/// The levels of the colours with their names.
fn names([first, second, third]: [f64; 3]) -> [(i8, String); 7] {
    [
        (-3, format!("below −{third}")),
        (-2, format!("−{third} to −{second}")),
        (-1, format!("−{second} to −{first}")),
        (0, format!("−{first} to {first} W/mm")),
        (1, format!("{first} to {second}")),
        (2, format!("{second} to {third}")),
        (3, format!("above {third}")),
    ]
}

#[cfg(test)]
mod tests {
    use asperity::result::ridges::{FlankWatts, Kinks};
    use asperity_core::Profile;
    use asperity_core::quantity::Length;

    use super::*;

    /// A ridge of 1 µm on flat traces of 2000 points, 1 µm apart, that makes 4 kW/mm where it is highest.
    fn ridges() -> Ridges {
        let z = |i: usize| if (900..950).contains(&i) { 1e-6 } else { 0.0 };
        let trace = Profile::new(Length::from_si(1e-6), (0..2000).map(z).collect()).unwrap();
        let flank = FlankWatts {
            by_height: (0..2000)
                .map(|i| if z(i) > 0.0 { 4e6 } else { 0.0 })
                .collect(),
            trace,
        };
        let row = RidgeRow {
            flank: "wheel".to_owned(),
            place_mm: 0.9,
            width_um: 50.0,
            height_um: 0.975,
            first_order_w: 195.0,
            measured_first_order_w: Some(180.0),
            mean_gradient_w: 100.0,
            low_w: Some(50.0),
            high_w: Some(150.0),
            first_point: 900,
            last_point: 949,
        };
        Ridges {
            title: "one ridge".to_owned(),
            conditions: String::new(),
            loss_at_medians_w: 500.0,
            pressed_at_medians_w: 400.0,
            sampling_quantiles_w: Some([-150.0, -50.0]),
            saving_quantiles_w: Some([40.0, 160.0]),
            by_log_height_w: 195.0,
            heat_balance: 1.0,
            unresolved_w: 0.0,
            without_gearbox: false,
            first_of_pairs: None,
            kinks: Kinks::default(),
            octaves: Vec::new(),
            along: [flank.along(), flank.along()],
            near: vec![flank.near(&row)],
            rows: vec![row],
        }
    }

    #[test]
    fn the_watts_of_the_cells_add_up_to_those_of_the_ridge_and_their_heights_are_drawn() {
        let ridges = ridges();
        for strip in ridges.along.iter().chain(&ridges.near) {
            let watts: f64 = strip.cells.iter().map(|[.., w]| strip.cell_mm * w).sum();
            // Three digits in each cell.
            assert!(
                (watts / ridges.rows[0].first_order_w - 1.0).abs() < 5e-3,
                "{watts}"
            );
            let high = strip.cells.iter().map(|[_, high, _]| *high);
            assert_eq!(high.fold(0.0, f64::max), 1.0);
        }
        assert_eq!(ridges.near[0].begin_mm, 0.85);
        assert_eq!(scale(&ridges), [100.0, 300.0, 1000.0]);
        let page = charts(&ridges, None).into_string();
        assert!(
            page.contains("area l3") && !page.contains("area m"),
            "{page}"
        );
        assert!(page.contains("above 1000") && page.contains("\"unit\":\"W/mm\""));
    }
}
