//! Page of a cycle.

use asperity_core::decimals;
use asperity_core::numerics::range;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::html::{figure, page};
use maud::{Markup, html};

use super::energy::CycleResult;
use super::summary::{is_banded, left_aside, table, verdicts};
use super::trace::CyclePoint;
use crate::map::{Map, loss_fields, round_step};

/// Approximate number of torque bins.
const BINS: f64 = 30.0;

pub(super) fn render(result: &CycleResult, map: &Map) -> String {
    let sections = [
        ("Energy", energy(result, map)),
        ("Operating points", operating_points(result, map)),
        (
            "Over time",
            html! { div.charts { (figure(&over_time(result))) } },
        ),
    ];
    let subtitle = format!("{} · cycle {}", result.program, result.cycle);
    page(&result.title, &subtitle, &sections)
}

fn energy(result: &CycleResult, map: &Map) -> Markup {
    let [pinion, wheel] = map.shafts();
    let percent = |share: f64| format!("{:.1} %", 100.0 * share);
    html! {
        @for verdict in verdicts(result) { p { strong { (verdict) } } }
        @if let Some(note) = left_aside(result) { p { (note) "." } }
        @for warning in &result.warnings { p { (warning) "." } }
        p { "Scope: " (result.scope) " only. " (decimals(result.drive_wh, 1)) " Wh at the " (pinion) " while it drives, "
            (decimals(result.coast_wh, 1)) " Wh while the " (wheel) " drives, " (decimals(result.duration_s, 0)) " s, flanks at "
            (result.temperature_c) " °C."
            @if result.outside_share > 0.0 {
                " Outside of the map, where the ratio of loss to torque is that of its edge: " (percent(result.outside_energy_share))
                " of the energy, " (percent(result.outside_share)) " of the moving time."
            }
            @if result.extended_share > 0.0 {
                " At torques whose sliding loss is scaled from the smallest resolved one: " (percent(result.extended_share)) " of the moving time."
            } }
        (table(result))
        @if is_banded(result) {
            p { "Medians, in brackets 5 and 95 % quantiles over the draws of the map, which are common to all points of the cycle and to "
                "both finishes of a difference." }
        }
    }
}

fn operating_points(result: &CycleResult, map: &Map) -> Markup {
    let visited: Vec<[f64; 2]> = result.points.iter().map(CyclePoint::forwards).collect();
    let nearest = map
        .axes
        .temperature_c
        .iter()
        .position(|temperature| *temperature == result.temperature_c);
    let fields = loss_fields(map, nearest.unwrap_or_default(), &visited);
    html! { div.charts {
        @for field in &fields { (figure(field)) }
        @if let Some(chart) = by_torque(result) { (figure(&chart)) }
    } }
}

/// Energy lost with each finish by torque, in steps of a round width.
fn by_torque(result: &CycleResult) -> Option<Drawing> {
    let torques = || result.points.iter().map(|point| point.forwards()[0]);
    let [low, high] = range(torques());
    let width = round_step((high - low) / BINS);
    if !width.is_finite() || width <= 0.0 {
        return None;
    }
    let bin = |torque: f64| (torque / width).floor();
    let (first, last) = (bin(low), bin(high));
    let edge = |k: usize| (first + k as f64) * width;
    let count = (last - first) as usize + 1;
    let mut chart = Chart::new(
        "torque",
        &format!("Energy lost by torque, in steps of {width} N m"),
        "cycle.csv",
        Axis::new("torque", "N m"),
        Axis::new("energy lost", "Wh").from_zero(),
    );
    for finish in &result.finishes {
        let mut bins = vec![0.0; count];
        for (point, loss) in result.points.iter().zip(&finish.loss_w) {
            bins[(bin(point.forwards()[0]) - first) as usize] += loss * point.weight_s / 3600.0;
        }
        let steps = bins.iter().enumerate();
        let steps = steps.flat_map(|(k, energy)| [[edge(k), *energy], [edge(k + 1), *energy]]);
        let outline = [[edge(0), 0.0]].into_iter().chain(steps);
        let outline = outline.chain([[edge(count), 0.0]]);
        chart = chart.with(Series::through(&finish.name, Line::Solid, outline));
    }
    Some(Drawing::Curves(chart))
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
        chart = chart.curve(&finish.name, Line::Solid, &time, &finish.loss_w);
    }
    Drawing::Curves(chart)
}
