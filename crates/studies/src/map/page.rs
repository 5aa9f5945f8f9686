//! Page of a map.

use asperity_report::chart::{Axis, Contour, Drawing};
use asperity_report::html::{figure, page};
use maud::{Markup, html};

use super::axes::Axes;
use super::point::{FinishMap, Map, Numbers, Point};
use super::summary::{banded, left_aside};

/// Contour levels of the efficiency \[%\].
const EFFICIENCIES: [f64; 11] = [
    0.0, 90.0, 95.0, 97.0, 98.0, 98.5, 99.0, 99.2, 99.4, 99.6, 99.8,
];
/// Approximate number of bands of a field.
const BANDS: f64 = 10.0;
/// Largest number of temperatures that are drawn.
const TEMPERATURES: usize = 3;

pub(super) fn render(map: &Map, visited: &[[f64; 2]]) -> String {
    let drawn = drawn(&map.axes);
    let each = |draw: &dyn Fn(&FinishMap, usize) -> Option<Drawing>| -> Markup {
        html! { div.charts {
            @for finish in &map.finishes { @for temperature in &drawn {
                @if let Some(drawing) = draw(finish, *temperature) { (figure(&drawing)) }
            } }
        } }
    };
    let sections = [
        (
            "Loss",
            html! {
                p { "Loss of the " (map.scope) " over torque and speed of the pinion; negative torque: the wheel drives. "
                    "Hatched: a correlation is extrapolated, or the sliding loss is scaled." }
                (each(&|finish, at| loss(map, finish, at, visited)))
            },
        ),
        (
            "Efficiency",
            each(&|finish, at| efficiency(map, finish, at, visited)),
        ),
        ("Differences", differences(map, &drawn, visited)),
        ("Bands", bands(map)),
        ("Ranges", ranges(map)),
        ("Provenance", provenance(map)),
    ];
    let names: Vec<&str> = map.finishes.iter().map(|f| f.name.as_str()).collect();
    let subtitle = format!("{} · map of {}", map.program, names.join(", "));
    page(&map.title, &subtitle, &sections)
}

/// Temperatures that are drawn: the lowest, the middle and the highest.
fn drawn(axes: &Axes) -> Vec<usize> {
    let count = axes.temperature_c.len();
    match count <= TEMPERATURES {
        true => (0..count).collect(),
        false => vec![0, count / 2, count - 1],
    }
}

/// Field of a finish over torque and speed.
fn field(map: &Map, finish: &FinishMap, temperature: usize, of: &dyn Fn(&Point) -> f64) -> Contour {
    let axes = &map.axes;
    let (torques, speeds) = (axes.torque_nm.len(), axes.speed_rpm.len());
    let nodes =
        || (0..speeds).flat_map(move |speed| (0..torques).map(move |torque| (torque, speed)));
    let at =
        |(torque, speed): (usize, usize)| &finish.points[axes.index(temperature, torque, speed)];
    let usual = usual(map, finish);
    let is_hatched = |point: &Point| {
        point
            .outside
            .iter()
            .any(|mark| !usual.contains(&mark.as_str()))
    };
    let values: Vec<f64> = nodes().map(|node| of(at(node))).collect();
    Contour {
        id: String::new(),
        title: String::new(),
        source: "map.csv".to_owned(),
        x: Axis::new("torque", "N m"),
        y: Axis::new("speed", "1/min"),
        value: String::new(),
        columns: axes.torque_nm.clone(),
        rows: axes.speed_rpm.clone(),
        hatched: nodes().map(|node| is_hatched(at(node))).collect(),
        dots: Vec::new(),
        levels: Some(levels(&values)),
        values,
        isoline: None,
        height: 300.0,
    }
}

/// Marks that also apply at the operating point of the case, and so to the full map.
fn usual<'a>(map: &Map, finish: &'a FinishMap) -> Vec<&'a str> {
    let operation = &map.input.operation;
    let speed = operation.speed.si() * 30.0 / std::f64::consts::PI;
    let nearest = [
        operation.torque.si(),
        speed,
        operation.temperature.celsius(),
    ];
    let far = |point: &&Point| {
        let at = [point.torque_nm, point.speed_rpm, point.temperature_c];
        let reach = [0, 1, 2].map(|k| (at[k] - nearest[k]).abs() / nearest[k].abs().max(1.0));
        reach.iter().sum::<f64>()
    };
    let nearest = finish
        .points
        .iter()
        .min_by(|a, b| far(a).total_cmp(&far(b)));
    nearest.map_or(Vec::new(), |point| {
        point.outside.iter().map(String::as_str).collect()
    })
}

/// Lower edges of bands at round numbers within the range of the values.
fn levels(values: &[f64]) -> Vec<f64> {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let (low, high) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
        (a.min(v), b.max(v))
    });
    if low >= high {
        return vec![if low.is_finite() { low } else { 0.0 }];
    }
    let raw = (high - low) / BANDS;
    let power = 10f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|factor| factor * power)
        .find(|step| *step >= raw * (1.0 - 1e-9))
        .unwrap_or(raw);
    let digits = (-step.log10().floor()).max(0.0) as usize;
    let first = (low / step).floor();
    let level = |k: usize| {
        let value = (first + k as f64) * step;
        format!("{value:.digits$}").parse().unwrap_or(value) + 0.0
    };
    (0..)
        .map(level)
        .take_while(|level: &f64| *level < high)
        .collect()
}

fn number(of: fn(&Numbers) -> Option<f64>) -> impl Fn(&Point) -> f64 {
    move |point| point.numbers.as_ref().and_then(of).unwrap_or(f64::NAN)
}

/// Finish and, if there are several, temperature: "ground, 90 °C".
fn named(map: &Map, finish: &FinishMap, temperature: usize) -> String {
    match map.axes.temperature_c.len() {
        1 => finish.name.clone(),
        _ => format!(
            "{}, {} °C",
            finish.name, map.axes.temperature_c[temperature]
        ),
    }
}

fn id(map: &Map, what: &str, finish: &FinishMap, temperature: usize) -> String {
    let number = map
        .finishes
        .iter()
        .position(|other| std::ptr::eq(other, finish));
    format!("{what}-{}-{temperature}", number.unwrap_or_default())
}

/// Loss of a finish over torque and speed with the points of a cycle; `None` if the finish does not exist.
#[must_use]
pub fn loss_field(
    map: &Map,
    finish: usize,
    temperature: usize,
    visited: &[[f64; 2]],
) -> Option<Drawing> {
    loss(map, map.finishes.get(finish)?, temperature, visited)
}

fn loss(map: &Map, finish: &FinishMap, at: usize, visited: &[[f64; 2]]) -> Option<Drawing> {
    let of = number(|numbers| Some(numbers.loss_w));
    Some(Drawing::Contour(Contour {
        id: id(map, "loss", finish, at),
        title: format!("Loss, {}", named(map, finish, at)),
        value: "loss [W]".to_owned(),
        dots: visited.to_vec(),
        ..field(map, finish, at, &of)
    }))
}

fn efficiency(map: &Map, finish: &FinishMap, at: usize, visited: &[[f64; 2]]) -> Option<Drawing> {
    let of = number(|numbers| numbers.efficiency.map(|value| 100.0 * value));
    let field = field(map, finish, at, &of);
    let finite = || {
        field
            .values
            .iter()
            .copied()
            .filter(|value| value.is_finite())
    };
    let most = finite().fold(0.0, f64::max);
    // The first band includes the points without efficiency.
    let levels = EFFICIENCIES.into_iter().filter(|level| *level < most);
    Some(Drawing::Contour(Contour {
        id: id(map, "efficiency", finish, at),
        title: format!("Efficiency, {}", named(map, finish, at)),
        value: "efficiency [%]".to_owned(),
        levels: Some(levels.collect()),
        dots: visited.to_vec(),
        ..field
    }))
}

fn differences(map: &Map, drawn: &[usize], visited: &[[f64; 2]]) -> Markup {
    let Some((first, others)) = map.finishes.split_first() else {
        return html! {};
    };
    if others.is_empty() {
        return html! {};
    }
    let drawing = |finish: &FinishMap, at: usize| {
        let of = number(|numbers| Some(numbers.loss_w));
        let mut field = field(map, finish, at, &of);
        let base = self::field(map, first, at, &of).values;
        for (value, base) in field.values.iter_mut().zip(base) {
            *value -= base;
        }
        Drawing::Contour(Contour {
            id: id(map, "difference", finish, at),
            title: format!(
                "Loss of {} minus that of {}",
                named(map, finish, at),
                first.name
            ),
            value: "difference [W]".to_owned(),
            levels: Some(levels(&field.values)),
            isoline: Some(0.0),
            dots: visited.to_vec(),
            ..field
        })
    };
    html! { div.charts {
        @for finish in others { @for at in drawn { (figure(&drawing(finish, *at))) } }
    } }
}

/// Largest number of rows of the table of bands.
const MOST_BANDS: usize = 40;

/// Losses with their quantiles at the nodes of the draws: the first points, and a reference to the others.
fn bands(map: &Map) -> Markup {
    let is_node = |finish: &FinishMap, point: &Point| {
        let side = usize::from(point.torque_nm < 0.0);
        finish.draws.get(side).is_some_and(|draws| {
            draws.torque_nm.contains(&point.torque_nm.abs())
                && draws.speed_rpm.contains(&point.speed_rpm)
                && draws.temperature_c.contains(&point.temperature_c)
        })
    };
    let rows: Vec<_> = map
        .finishes
        .iter()
        .flat_map(|finish| finish.points.iter().map(move |point| (finish, point)))
        .filter(|(finish, point)| is_node(finish, point))
        .filter_map(|(finish, point)| {
            let numbers = point.numbers?;
            let drawn = numbers.loss_median_w.zip(numbers.loss_quantiles_w)?;
            Some((finish, point, banded(numbers.loss_w, Some(drawn))))
        })
        .collect();
    if rows.is_empty() {
        return html! {};
    }
    html! {
        p { "Median of the loss with its 5 and 95 % quantiles, as for a run, at the nodes of torque and speed whose draws were "
            "computed; between them the logarithms of the draws are interpolated. The same at negative torque, unless there are "
            "coast flanks. All points are in map.csv." }
        div.scroll { table {
            thead { tr { th { "finish" } th.number { "torque, N m" } th.number { "speed, 1/min" }
                th.number { "temperature, °C" } th.number { "loss, W" } } }
            tbody { @for (finish, point, loss) in rows.iter().take(MOST_BANDS) { tr {
                td { (finish.name) }
                td.number { (format!("{:.2}", point.torque_nm)) } td.number { (format!("{:.0}", point.speed_rpm)) }
                td.number { (point.temperature_c) } td.number { (loss) }
            } } }
        } }
        @if rows.len() > MOST_BANDS { p { (rows.len() - MOST_BANDS) " more in map.csv." } }
    }
}

fn ranges(map: &Map) -> Markup {
    if map.warnings.is_empty() {
        return html! {};
    }
    html! {
        div.scroll { table {
            thead { tr { th { "what" } th { "finish" } th.number { "points" } th { "rows of map.csv" } } }
            tbody { @for warning in &map.warnings { tr {
                td { (warning.text) } td { (warning.finish) } td.number { (warning.count) }
                td { (shortened(&warning.points)) }
            } } }
        } }
    }
}

/// The list of points, shortened; the JSON has the full list.
fn shortened(points: &str) -> String {
    /// Largest number of characters of a cell.
    const MOST: usize = 60;
    match points.char_indices().nth(MOST) {
        None => points.to_owned(),
        Some((end, _)) => format!("{} … (map.json)", &points[..end]),
    }
}

fn provenance(map: &Map) -> Markup {
    let pairs = |finish: &FinishMap| {
        let drive = finish.files.iter().map(|pair| ("drive", pair.clone()));
        let coast = finish
            .coast_files
            .iter()
            .map(|pair| ("coast", pair.clone()));
        drive.chain(coast).collect::<Vec<_>>()
    };
    html! {
        p { "Scope: " (map.scope) " only; no bearings, seals, churning. Points below "
            @for (k, finish) in map.finishes.iter().enumerate() {
                @if k > 0 { ", " } (format!("{:.3} N m ({})", finish.resolved_from_nm[0], finish.name))
            } " are extended." }
        @if let Some(note) = left_aside(map) { p { (note) "." } }
        div.scroll { table {
            thead { tr { th { "finish" } th { "flanks" } th { "file" } th { "SHA-256" } } }
            tbody { @for finish in &map.finishes { @for (side, [file, sum]) in pairs(finish) {
                tr { td { (finish.name) } td { (side) } td { code { (file) } } td { code { (sum) } } }
            } } }
        } }
    }
}
