//! Page of a call-out: the limit, how it follows from the number of traces, and the loss by the height of the flanks.

use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::html::{figure, page};
use maud::html;

use super::study::CallOut;
use super::summary::{NOTE, headline, inspection, limit_line, losses, table};

pub(super) fn render(study: &CallOut) -> String {
    let limit = html! {
        @for limit in &study.limits { p { strong { (limit_line(limit)) "." } } }
        p { (inspection(study)) "." }
        p { (losses(study)) "." }
        p { (NOTE) }
        (table(study))
    };
    let traces = html! { div.charts { (figure(&traces_chart(study))) } };
    let curve = html! { div.charts { (figure(&curve_chart(study))) } };
    let sections = [
        ("Limit", limit),
        ("By the number of traces", traces),
        ("By the height of the flanks", curve),
    ];
    page(
        &study.title,
        &format!("call-out · {}", headline(study)),
        &sections,
    )
}

fn traces_chart(study: &CallOut) -> Drawing {
    let title = format!("Limit of the mean {}", study.parameter.symbol());
    let (x, y) = (
        Axis::new("inspected traces", ""),
        Axis::new("limit over recipe", ""),
    );
    let chart = Chart::new("traces", &title, "traces.csv", x, y);
    let points = study.by_traces.iter();
    let points = points.map(|row| [row.traces as f64, row.limit_over_recipe]);
    Drawing::Curves(chart.with(Series::through("limit", Line::Dots, points)))
}

fn curve_chart(study: &CallOut) -> Drawing {
    let (x, y) = (
        Axis::new("height of the flanks over the recipe", ""),
        Axis::new("mean loss of lots of the recipe", "W"),
    );
    let title = "Loss by the height of the flanks";
    let points = study.curve.iter().map(|point| [point.height, point.loss_w]);
    let chart = Chart::new("curve", title, "curve.csv", x, y)
        .with(Series::through("loss", Line::Dots, points))
        .level(study.loss_w, "stated loss");
    Drawing::Curves(chart)
}
