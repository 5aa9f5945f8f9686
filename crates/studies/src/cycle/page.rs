//! Page of a cycle.

use asperity_report::chart::{Axis, Bar, BarChart, Chart, Drawing, Line, Series};
use asperity_report::html::{figure, page};
use maud::{Markup, html};

use super::energy::CycleResult;
use super::summary::{difference, left_aside, lost};
use crate::map::{Map, loss_field};

/// Number of torque bins.
const BINS: usize = 30;

pub(super) fn render(result: &CycleResult, map: &Map) -> String {
    let sections = [
        ("Energy", energy(result)),
        ("Operating points", operating_points(result, map)),
        (
            "Over time",
            html! { div.charts { (figure(&over_time(result))) } },
        ),
    ];
    let subtitle = format!("{} · cycle {}", result.program, result.cycle);
    page(&result.title, &subtitle, &sections)
}

fn energy(result: &CycleResult) -> Markup {
    let percent = |share: f64| format!("{:.3} %", 100.0 * share);
    let or_none = |text: Option<String>| text.unwrap_or_else(|| "-".to_owned());
    html! {
        @if let Some(note) = left_aside(result) { p { (note) "." } }
        p { "Scope: " (result.scope) " only. " (format!("{:.1}", result.drive_wh)) " Wh at the pinion while it drives, "
            (format!("{:.1}", result.coast_wh)) " Wh while the wheel drives, " (format!("{:.0}", result.duration_s)) " s, flanks at "
            (result.temperature_c) " °C. Outside of the map, where the ratio of loss to torque is that of its edge, " (percent(result.outside_energy_share)) " of the energy and "
            (percent(result.outside_share)) " of the moving time; "
            (percent(result.extended_share)) " at torques whose sliding loss is scaled from the smallest resolved one." }
        div.scroll { table {
            thead { tr { th { "finish" } th.number { "lost" } th.number { "driving" } th.number { "braking" }
                th.number { "of drive energy" } th.number { "per 100 km" } th.number { "minus the first" } } }
            tbody { @for finish in &result.finishes { tr {
                th scope="row" { (finish.name) }
                @for text in lost(finish) { td.number { (text) " Wh" } }
                td.number { (or_none(finish.share_of_drive.map(|share| percent(share * finish.median_over_medians())))) }
                td.number { (or_none(finish.wh_per_100_km.map(|value| format!("{:.1} Wh", value * finish.median_over_medians())))) }
                td.number { (difference(finish)) @if finish.difference_wh.is_some() { " Wh" } }
            } } }
        } }
        p { "Medians, in brackets 5 and 95 % quantiles over the draws of the map, which are common to all points of the cycle and to "
            "both finishes of a difference." }
    }
}

fn operating_points(result: &CycleResult, map: &Map) -> Markup {
    let visited: Vec<[f64; 2]> = result
        .points
        .iter()
        .map(|point| [point.torque_nm, point.speed_rpm.abs()])
        .collect();
    let nearest = map
        .axes
        .temperature_c
        .iter()
        .position(|temperature| *temperature == result.temperature_c);
    let field = loss_field(map, 0, nearest.unwrap_or_default(), &visited);
    html! { div.charts {
        @if let Some(field) = field { (figure(&field)) }
        @if let Some(bars) = by_torque(result) { (figure(&bars)) }
    } }
}

/// Energy lost with the first finish, by torque.
fn by_torque(result: &CycleResult) -> Option<Drawing> {
    let finish = result.finishes.first()?;
    let torques = || result.points.iter().map(|point| point.torque_nm);
    let (low, high) = torques().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
        (a.min(v), b.max(v))
    });
    let width = (high - low) / BINS as f64;
    if width.is_nan() || width <= 0.0 {
        return None;
    }
    let mut bins = vec![0.0; BINS];
    for (point, loss) in result.points.iter().zip(&finish.loss_w) {
        let bin = ((point.torque_nm - low) / width) as usize;
        bins[bin.min(BINS - 1)] += loss * point.weight_s / 3600.0;
    }
    let bars = bins.iter().enumerate().filter(|(_, energy)| **energy > 0.0);
    Some(Drawing::Bars(BarChart {
        id: "torque".to_owned(),
        title: format!("Energy lost by torque, {}", finish.name),
        source: "cycle.csv".to_owned(),
        axis: Axis::new("energy lost", "Wh"),
        bars: bars
            .map(|(bin, energy)| Bar {
                name: format!(
                    "{:.0} .. {:.0} N m",
                    low + bin as f64 * width,
                    low + (bin + 1) as f64 * width
                ),
                value: Some(*energy),
                spread: None,
                text: format!("{energy:.2} Wh"),
            })
            .collect(),
    }))
}

fn over_time(result: &CycleResult) -> Drawing {
    let time: Vec<f64> = result.points.iter().map(|point| point.time_s).collect();
    let mut chart = Chart::new(
        "time",
        "Loss over time",
        "cycle.csv",
        Axis::new("time", "s"),
        Axis::new("loss", "W").from_zero(),
    );
    for finish in &result.finishes {
        chart = chart.with(Series::new(
            &finish.name,
            Line::Solid,
            &time,
            &finish.loss_w,
        ));
    }
    Drawing::Curves(chart)
}
