//! Page of a study of ridges: the dearest ridges, both traces with these marked, and the loss by wavelength.

use asperity_report::chart::{Axis, Bar, BarChart, Chart, Drawing, Line, Series};
use asperity_report::html::{figure, page};
use maud::{Markup, html};

use super::study::{FLANKS, Ridges};
use super::summary::{NOTE, headline, mean_saving, notes, saving, watts, wavelengths};

pub(super) fn render(study: &Ridges) -> String {
    let dearest = html! {
        p { strong { (saving(study)) "." } }
        p { (NOTE) }
        @for note in notes(study) { p { (note) } }
        div.charts { (figure(&ridge_chart(study))) }
        (table(study))
    };
    let traces =
        html! { div.charts { @for body in [0, 1] { (figure(&trace_chart(study, body))) } } };
    let octaves = html! { div.charts { (figure(&octave_chart(study))) } };
    let sections = [
        ("Dearest ridges", dearest),
        ("Where they are", traces),
        ("By wavelength", octaves),
    ];
    page(
        &study.title,
        &format!("ridges · {}", headline(study)),
        &sections,
    )
}

fn ridge_chart(study: &Ridges) -> Drawing {
    let bars = study.rows.iter().map(|row| Bar {
        name: format!("{} at {:.3} mm", row.flank, row.place_mm),
        value: Some(row.first_order_w),
        spread: None,
        text: format!("{} W", watts(row.first_order_w)),
    });
    Drawing::Bars(BarChart {
        id: "ridges".to_owned(),
        title: "Saving by each ridge, by the gradient".to_owned(),
        source: "ridges.csv".to_owned(),
        axis: Axis::new("saving", "W"),
        bars: bars.collect(),
    })
}

fn octave_chart(study: &Ridges) -> Drawing {
    let bars = study.octaves.iter().map(|octave| {
        let both = octave.pinion_w + octave.wheel_w;
        Bar {
            name: format!("{} µm", wavelengths(octave)),
            value: Some(both),
            spread: None,
            text: format!("{} W", watts(both)),
        }
    });
    Drawing::Bars(BarChart {
        id: "octaves".to_owned(),
        title: "Loss over the logarithm of the heights, both flanks".to_owned(),
        source: "octaves.csv".to_owned(),
        axis: Axis::new("d(loss)/d ln(height)", "W"),
        bars: bars.collect(),
    })
}

fn trace_chart(study: &Ridges, body: usize) -> Drawing {
    let trace = &study.flanks[body].trace;
    let dx = trace.spacing().si();
    let point = |i: usize| [1e3 * dx * i as f64, 1e6 * trace.heights()[i]];
    let (x, y) = (Axis::new("place", "mm"), Axis::new("height", "µm"));
    let name = FLANKS[body];
    let mut chart = Chart::new(
        name,
        &format!("Trace of the {name}"),
        &format!("{name}.csv"),
        x,
        y,
    );
    let whole = (0..trace.len()).map(point);
    chart
        .series
        .push(Series::through("trace", Line::Solid, whole));
    let mut dear: Vec<[f64; 2]> = (0..trace.len()).map(|i| [point(i)[0], f64::NAN]).collect();
    for row in study.rows.iter().filter(|row| row.flank == name) {
        let [first, last] = row.points;
        for (i, place) in dear.iter_mut().enumerate().take(last + 1).skip(first) {
            *place = point(i);
        }
    }
    chart
        .series
        .push(Series::through("dearest ridges", Line::Ink, dear));
    Drawing::Curves(chart)
}

fn table(study: &Ridges) -> Markup {
    html! { div.scroll { table {
        thead { tr { th { "flank" } th.number { "place [mm]" } th.number { "width [µm]" } th.number { "height [µm]" }
            th.number { "first order [W]" } th.number { "mean gradient [W]" } } }
        tbody { @for row in &study.rows { tr {
            td { (row.flank) } td.number { (format!("{:.4}", row.place_mm)) } td.number { (format!("{:.1}", row.width_um)) }
            td.number { (format!("{:.3}", row.height_um)) } td.number { (watts(row.first_order_w)) }
            td.number { (mean_saving(row)) }
        } } }
    } } }
}
