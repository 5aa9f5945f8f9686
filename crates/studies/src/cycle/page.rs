//! The page of a cycle.

use asperity_report::chart::{Axis, Bar, BarChart, Chart, Drawing, Line, Series};
use asperity_report::html::{figure, page};
use maud::{Markup, html};

use super::energy::{CycleFinish, CycleResult};
use super::summary::left_aside;
use crate::map::{Map, loss_field};

/// Bins of the torque.
const BINS: usize = 30;

pub(super) fn render(found: &CycleResult, map: &Map) -> String {
    let sections = [
        ("Energy", energy(found)),
        ("Where the cycle lives", places(found, map)),
        (
            "Over time",
            html! { div.charts { (figure(&over_time(found))) } },
        ),
    ];
    let subtitle = format!("{} · cycle {}", found.program, found.cycle);
    page(&found.title, &subtitle, &sections)
}

fn energy(found: &CycleResult) -> Markup {
    let percent = |share: f64| format!("{:.3} %", 100.0 * share);
    let or_none = |text: Option<String>| text.unwrap_or_else(|| "-".to_owned());
    html! {
        @if let Some(note) = left_aside(found) { p { (note) "." } }
        p { "Scope: " (found.scope) " only. " (format!("{:.1}", found.drive_wh)) " Wh at the pinion while it drives, "
            (format!("{:.1}", found.coast_wh)) " Wh while the wheel drives, " (format!("{:.0}", found.duration_s)) " s, flanks at "
            (found.temperature_c) " °C. Outside the map, where loss over torque is that of its edge, " (percent(found.outside_energy_share)) " of the energy and "
            (percent(found.outside_share)) " of the moving time; "
            (percent(found.extended_share)) " at torques whose sliding loss is scaled from the smallest resolved one." }
        div.scroll { table {
            thead { tr { th { "finish" } th.number { "lost" } th.number { "driving" } th.number { "braking" }
                th.number { "of drive energy" } th.number { "on 100 km" } th.number { "minus the first" } } }
            tbody { @for finish in &found.finishes { tr {
                th scope="row" { (finish.name) }
                td.number { (format!("{:.2} ± {:.2} Wh", finish.lost_wh, finish.deviation_wh)) }
                td.number { (format!("{:.2} Wh", finish.lost_drive_wh)) }
                td.number { (format!("{:.2} Wh", finish.lost_coast_wh)) }
                td.number { (or_none(finish.share_of_drive.map(percent))) }
                td.number { (or_none(finish.wh_per_100_km.map(|value| format!("{value:.1} Wh")))) }
                td.number { (difference(finish)) }
            } } }
        } }
        p { "± is the standard deviation over the offsets of the traces, taken as common to all points of the cycle; of a difference both finishes are independent." }
    }
}

fn difference(finish: &CycleFinish) -> String {
    match (finish.difference_wh, finish.difference_deviation_wh) {
        (Some(value), Some(deviation)) => format!("{value:+.2} ± {deviation:.2} Wh"),
        _ => "reference".to_owned(),
    }
}

fn places(found: &CycleResult, map: &Map) -> Markup {
    let visited: Vec<[f64; 2]> = found
        .points
        .iter()
        .map(|point| [point.torque_nm, point.speed_rpm.abs()])
        .collect();
    let nearest = map
        .axes
        .temperature_c
        .iter()
        .position(|temperature| *temperature == found.temperature_c);
    let field = loss_field(map, 0, nearest.unwrap_or_default(), &visited);
    html! { div.charts {
        @if let Some(field) = field { (figure(&field)) }
        @if let Some(bars) = by_torque(found) { (figure(&bars)) }
    } }
}

/// Energy lost with the first finish by torque.
fn by_torque(found: &CycleResult) -> Option<Drawing> {
    let finish = found.finishes.first()?;
    let torques = || found.points.iter().map(|point| point.torque_nm);
    let (low, high) = torques().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
        (a.min(v), b.max(v))
    });
    let width = (high - low) / BINS as f64;
    if width.is_nan() || width <= 0.0 {
        return None;
    }
    let mut bins = vec![0.0; BINS];
    for (point, loss) in found.points.iter().zip(&finish.loss_w) {
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

fn over_time(found: &CycleResult) -> Drawing {
    let time: Vec<f64> = found.points.iter().map(|point| point.time_s).collect();
    let mut chart = Chart::new(
        "time",
        "Loss over time",
        "cycle.csv",
        Axis::new("time", "s"),
        Axis::new("loss", "W").from_zero(),
    );
    for finish in &found.finishes {
        chart = chart.with(Series::new(
            &finish.name,
            Line::Solid,
            &time,
            &finish.loss_w,
        ));
    }
    Drawing::Curves(chart)
}
