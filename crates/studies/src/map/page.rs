//! Fields of a map over torque and speed.

use asperity_core::numerics::range;
use asperity_core::{decimals, number};
use asperity_report::chart::{Axis, Contour, Drawing};
use asperity_report::html::figure;
use asperity_report::{Report, Table, columns};
use maud::{Markup, html};

use super::axes::Axes;
use super::efficiency::{self, DrawnRow, closer};
use super::point::{FinishMap, Map, Numbers, Point};
use super::summary::{banded, in_words, words};

/// Approximate number of bands of a field.
const BANDS: usize = 10;
/// Largest number of temperatures that are drawn.
const TEMPERATURES: usize = 3;

/// Meaning of the shares of extrapolated points.
const OF_GRID: &str = "Each share is of the points of this grid, which lie close together at low torque and speed, not of the operating time.";
/// What a page about losses at many operating points leaves to studies of one.
pub(crate) const HELPFUL: &str = "The command asperity sensitivity lists changes that lower the loss; asperity evidence lists \
    measurements that narrow its interval at the operating point of the case.";

/// File of the efficiencies as drawn.
pub(super) const EFFICIENCIES: &str = "efficiency.csv";

/// Lower edges of the bands by the values around the points of a cycle, and by all values that are drawn.
type Levels = fn([&[f64]; 2]) -> Vec<f64>;

/// A quantity over torque and speed.
struct MapQuantity {
    id: &'static str,
    title: &'static str,
    /// Name of the colour scale, with the unit.
    scale: &'static str,
    of: fn(&Numbers) -> Option<f64>,
    /// Lower edges of the bands.
    levels: Levels,
}

const LOSS: MapQuantity = MapQuantity {
    id: "loss",
    title: "Loss",
    scale: "loss [W]",
    of: |numbers| Some(numbers.loss_w),
    levels: round_levels,
};
const EFFICIENCY: MapQuantity = MapQuantity {
    id: "efficiency",
    title: "Efficiency",
    scale: "efficiency [%]",
    of: |numbers| numbers.efficiency.map(|value| 100.0 * value),
    levels: quantile_levels,
};
const HALF_INTERVAL: MapQuantity = MapQuantity {
    id: "interval",
    title: "Half of the interval of the loss over its median",
    scale: "half the width of the 90 % interval [%]",
    of: |numbers| {
        let drawn = numbers.drawn_w.filter(|drawn| drawn.value > 0.0)?;
        Some(50.0 * (drawn.high - drawn.low) / drawn.value)
    },
    levels: round_levels,
};

impl MapQuantity {
    fn at(&self, point: &Point) -> f64 {
        point.numbers.as_ref().and_then(self.of).unwrap_or(f64::NAN)
    }

    /// The quantity of `finish` at a temperature, at the points of the map.
    fn field(
        &self,
        map: &Map,
        (finish, temperature): FinishPlace<'_>,
        visited: &[[f64; 2]],
    ) -> Contour {
        Contour {
            id: id(map, self.id, finish, temperature),
            title: format!("{}, {}", self.title, named(map, finish, temperature)),
            value: self.scale.to_owned(),
            dots: visited.to_vec(),
            ..field(map, finish, temperature, &|point| self.at(point))
        }
    }

    /// The quantity for every finish and the temperatures `drawn`, all with the same bands.
    fn common(&self, map: &Map, drawn: &[usize], visited: &[[f64; 2]]) -> Vec<Contour> {
        let fields = each(map, drawn).map(|place| self.field(map, place, visited));
        with_common_levels(fields.collect(), self.levels)
    }

    /// The drawings of [`Self::common`].
    fn fields(&self, map: &Map, drawn: &[usize], visited: &[[f64; 2]]) -> Vec<Drawing> {
        let fields = self.common(map, drawn, visited).into_iter();
        fields.map(Drawing::Contour).collect()
    }
}

/// A finish and the number of a temperature.
type FinishPlace<'a> = (&'a FinishMap, usize);

/// Every finish at the temperatures `drawn`.
fn each<'a>(map: &'a Map, drawn: &[usize]) -> impl Iterator<Item = FinishPlace<'a>> {
    let finishes = map.finishes.iter();
    finishes.flat_map(|finish| drawn.iter().map(move |temperature| (finish, *temperature)))
}

/// Values of a field at the nodes around its points, whose colours are to differ; at all nodes without points.
fn visited_values(field: &Contour) -> impl Iterator<Item = f64> {
    let around = |nodes: &[f64], axis: usize| -> [f64; 2] {
        let [low, high] = range(field.dots.iter().map(|point| point[axis]));
        let below = nodes.iter().copied().filter(|node| *node <= low);
        let above = nodes.iter().copied().filter(|node| *node >= high);
        [
            below.fold(f64::NEG_INFINITY, f64::max),
            above.fold(f64::INFINITY, f64::min),
        ]
    };
    let [[left, right], [low, high]] = [around(&field.columns, 0), around(&field.rows, 1)];
    let rows = field.rows.iter().copied();
    let nodes = rows.flat_map(|y| field.columns.iter().map(move |x| [*x, y]));
    let is_all = field.dots.is_empty();
    nodes.zip(&field.values).filter_map(move |([x, y], value)| {
        let is_near = left <= x && x <= right && low <= y && y <= high;
        (is_all || is_near).then_some(*value)
    })
}

/// The fields with the bands of all their values together, without those that have no value.
fn with_common_levels(mut fields: Vec<Contour>, levels: Levels) -> Vec<Contour> {
    fields.retain(|field| field.values.iter().any(|value| value.is_finite()));
    let visited = fields.iter().flat_map(visited_values);
    let visited: Vec<f64> = visited.filter(|value| value.is_finite()).collect();
    let all = fields.iter().flat_map(|field| &field.values).copied();
    let all: Vec<f64> = all.filter(|value| value.is_finite()).collect();
    let levels = levels([&visited, &all]);
    for field in &mut fields {
        field.levels = Some(levels.clone());
    }
    fields
}

/// Loss and efficiency on the page, added to `report`.
pub(super) fn fields<'a>(report: Report<'a>, map: &'a Map, visited: &'a [[f64; 2]]) -> Report<'a> {
    let [pinion, wheel] = map.shafts();
    let axes = format!(
        "Loss of the {} over torque and speed of the {pinion}. At a negative torque the {wheel} drives.{} The efficiency is blank where the loss exceeds the power, next to 0 N m.",
        map.scope,
        match map.finishes.len() {
            1 => "",
            _ => " The pictures of a quantity have the same colours.",
        }
    );
    report
        .text(of_case(map))
        .figures(move || loss_and_efficiency(map, visited))
        .text([
            axes.as_str(),
            "Each colour of the efficiency covers about a tenth of the points of the grid.",
        ])
        .on_page()
        .text(case_point(map, visited).map(|_| "Dot: the operating point of the case."))
        .on_page()
        .text(marks(map, !visited.is_empty()))
        .on_page()
        .text([HELPFUL])
        .on_page()
}

/// The sections of the page after the extremes, added to `report`.
pub(super) fn sections<'a>(
    report: Report<'a>,
    map: &'a Map,
    visited: &'a [[f64; 2]],
) -> Report<'a> {
    let fields =
        |quantity: &'static MapQuantity| move || quantity.fields(map, &drawn(&map.axes), visited);
    report
        .section("Differences")
        .markup(|| differences(map, &drawn(&map.axes), visited))
        .folded("Half of the interval over torque and speed")
        .figures(fields(&HALF_INTERVAL))
        .section("Intervals")
        .markup(|| bands(map))
        .section("Ranges")
        .warning(&map.table_warnings)
        .table(ranges(map))
        .on_page()
        .section("Provenance")
        .text([scope(map)])
        .on_page()
        .table(files(map))
        .on_page()
}

/// Place of the verdicts relative to the operating point of the case.
fn of_case(map: &Map) -> Option<String> {
    /// Largest difference of a temperature that is rounded as a node \[K\].
    const EQUAL: f64 = 0.05;
    let [torque, speed] = map.operating_point;
    let celsius = map.operating_temperature_c;
    let at = map.axes.temperature_c.get(map.case_temperature())?;
    let is_other = (celsius - at).abs() > EQUAL;
    Some(match (map.has_typical(), is_other) {
        (true, false) => "These losses are at the operating point of the case, interpolated between the points of the map.".to_owned(),
        (true, true) => format!(
            "These losses are at torque and speed of the case, interpolated between the points of the map, and at {} °C, the temperature of \
                the map next to the {} °C of the case.",
            number(*at),
            number(celsius)
        ),
        (false, _) => format!(
            "These losses are at the point of the map next to the operating point of the case: {} N m, {} 1/min, {} °C.",
            number(torque),
            decimals(speed, 0),
            number(celsius)
        ),
    })
}

/// The operating point of the case, to be marked on a map without points of a cycle.
fn case_point(map: &Map, visited: &[[f64; 2]]) -> Option<[f64; 2]> {
    let is_marked = visited.is_empty() && map.has_typical();
    is_marked.then_some(map.operating_point)
}

/// Loss and efficiency of every finish and temperature, side by side, with the operating point of the case unless those of a cycle
/// are on them.
fn loss_and_efficiency(map: &Map, visited: &[[f64; 2]]) -> Vec<Drawing> {
    let with_case = |field: Contour| match case_point(map, visited) {
        Some(point) => Drawing::Contour(Contour {
            dots: vec![point],
            ..field
        }),
        None => Drawing::Contour(field),
    };
    let temperatures = drawn(&map.axes);
    let losses = LOSS.common(map, &temperatures, visited).into_iter();
    let losses = losses.map(with_case);
    let mut efficiencies = efficiencies(map, visited)
        .into_iter()
        .map(|(_, field)| with_case(field));
    let both = losses
        .into_iter()
        .flat_map(|loss| [Some(loss), efficiencies.next()]);
    let both: Vec<Drawing> = both.flatten().collect();
    both.into_iter().chain(efficiencies).collect()
}

/// The efficiencies as drawn, with the bands of the points of the map.
fn efficiencies<'a>(map: &'a Map, visited: &[[f64; 2]]) -> Vec<(FinishPlace<'a>, Contour)> {
    let drawn = drawn(&map.axes);
    let fields = each(map, &drawn).map(|place| EFFICIENCY.field(map, place, visited));
    let fields = with_common_levels(fields.collect(), EFFICIENCY.levels);
    let closer = |(place, field): (FinishPlace<'a>, Contour)| {
        let source = EFFICIENCIES.to_owned();
        (
            place,
            closer(map, place.0, place.1, Contour { source, ..field }),
        )
    };
    each(map, &drawn).zip(fields).map(closer).collect()
}

/// Rows of the efficiencies as drawn.
pub(super) fn drawn_efficiencies(map: &Map) -> impl Iterator<Item = DrawnRow<'_>> {
    let fields = efficiencies(map, &[]).into_iter();
    fields.flat_map(|((finish, temperature), field)| {
        efficiency::rows(map, finish, temperature, &field)
    })
}

/// The extrapolations of every finish in words, then the meaning of the dots if there are any.
pub(crate) fn marks(map: &Map, has_dots: bool) -> Vec<String> {
    let finishes = map.finishes.iter();
    let mut extrapolated: Vec<String> = finishes
        .filter_map(|finish| extrapolated(map, finish))
        .collect();
    if !extrapolated.is_empty() {
        extrapolated.push(OF_GRID.to_owned());
    }
    let dots = "Dots: operating points of the cycle. Where they cover a small part of the range, the colours have small steps around \
        them and large steps beyond.";
    let dots = has_dots.then(|| dots.to_owned());
    extrapolated.into_iter().chain(dots).collect()
}

/// The extrapolations of `finish` beyond those at the operating point of the case, in words; `None` if there are none.
fn extrapolated(map: &Map, finish: &FinishMap) -> Option<String> {
    let hatched = extrapolations(map, finish)
        .into_iter()
        .filter(|is_one| *is_one);
    let share = hatched.count() as f64 / finish.points.len().max(1) as f64;
    if share == 0.0 {
        return None;
    }
    Some(format!(
        "Hatched: at {:.0} % of the points of {} the model is extrapolated further than at the operating point of the case.",
        100.0 * share,
        in_words(&finish.name)
    ))
}

/// Whether the model is extrapolated at each point of the map of `finish`, in their order, further than at the operating point of
/// the case.
fn extrapolations(map: &Map, finish: &FinishMap) -> Vec<bool> {
    let usual = usual(map, finish);
    let unusual = |mark: &String| !usual.contains(&mark.as_str());
    let points = finish.points.iter();
    points
        .map(|point| point.outside.iter().any(unusual))
        .collect()
}

/// Whether a node around each of these torques \[N m\] and speeds \[1/min\] is extrapolated on the map of `finish`, as hatched.
pub(crate) fn are_extrapolated(
    map: &Map,
    finish: &FinishMap,
    temperature: usize,
    places: impl Iterator<Item = [f64; 2]>,
) -> Vec<bool> {
    let extrapolated = extrapolations(map, finish);
    let axes = &map.axes;
    let around = |nodes: &[f64], at: f64| {
        let last = nodes.len().saturating_sub(1);
        let above = nodes.partition_point(|node| *node < at).min(last);
        [above.saturating_sub(1), above]
    };
    let is_extrapolated = |[torque, speed]: [f64; 2]| {
        let torques = around(&axes.torque_nm, torque);
        let mut nodes = around(&axes.speed_rpm, speed)
            .into_iter()
            .flat_map(|speed| torques.map(|torque| axes.index(temperature, torque, speed)));
        nodes.any(|node| extrapolated[node])
    };
    places.map(is_extrapolated).collect()
}

/// Temperatures that are drawn: the lowest, the middle and the highest.
fn drawn(axes: &Axes) -> Vec<usize> {
    let count = axes.temperature_c.len();
    if count <= TEMPERATURES {
        (0..count).collect()
    } else {
        vec![0, count / 2, count - 1]
    }
}

/// Field of a finish over torque and speed.
fn field(map: &Map, finish: &FinishMap, temperature: usize, of: &dyn Fn(&Point) -> f64) -> Contour {
    let axes = &map.axes;
    let (torques, speeds) = (axes.torque_nm.len(), axes.speed_rpm.len());
    let nodes =
        || (0..speeds).flat_map(move |speed| (0..torques).map(move |torque| (torque, speed)));
    let index = |(torque, speed): (usize, usize)| axes.index(temperature, torque, speed);
    let at = |node| &finish.points[index(node)];
    let extrapolated = extrapolations(map, finish);
    let hatched = nodes().map(|node| extrapolated[index(node)]).collect();
    Contour {
        source: "map.csv".to_owned(),
        x: Axis::new("torque", "N m"),
        y: Axis::new("speed", "1/min"),
        columns: axes.torque_nm.clone(),
        rows: axes.speed_rpm.clone(),
        values: nodes().map(|node| of(at(node))).collect(),
        hatched,
        height: 300.0,
        ..Contour::default()
    }
}

/// Marks that also apply at the operating point of the case, and so to the full map.
fn usual<'a>(map: &Map, finish: &'a FinishMap) -> Vec<&'a str> {
    let operation = &map.input.operation;
    let speed = operation.speed.si() * 30.0 / std::f64::consts::PI;
    let temperature = operation.stated_temperature().unwrap_or_default();
    let nearest = [operation.torque.si(), speed, temperature.celsius()];
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

/// Most bands whose colours differ.
const COLOURS: usize = 12;

/// Lower edges of bands at round numbers within the range of the visited values, and of wider bands above.
fn round_levels([visited, all]: [&[f64]; 2]) -> Vec<f64> {
    let [low, high] = range(visited.iter().copied());
    if low >= high {
        return vec![if low.is_finite() { low } else { 0.0 }];
    }
    let step = round_step((high - low) / BANDS as f64);
    let first = (low / step).floor();
    let fine = (0..).map(|k| multiple(first + f64::from(k), step));
    let mut levels: Vec<f64> = fine.take_while(|level: &f64| *level < high).collect();
    let [_, highest] = range(all.iter().copied());
    let wider = wider_levels(high + step, highest, COLOURS.saturating_sub(levels.len()));
    levels.extend(wider);
    levels
}

/// At most `count` numbers 1, 2 and 5 times a power of ten from `low` to below `high`, the highest of them included.
fn wider_levels(low: f64, high: f64, count: usize) -> Vec<f64> {
    // The next round number is the first one above a little more.
    let next = |level: &f64| Some(round_step(level * 1.01));
    let first = (low < high).then(|| round_step(low));
    let levels = std::iter::successors(first, next).take_while(|level| *level < high);
    let levels: Vec<f64> = levels.collect();
    let every = levels.len().div_ceil(count.max(1)).max(1);
    let mut few: Vec<f64> = levels
        .into_iter()
        .rev()
        .step_by(every)
        .take(count)
        .collect();
    few.reverse();
    few
}

/// Wider bands on each side of a difference.
const WIDER: usize = 2;

/// Lower edges of bands of one round width for the visited values, one of them about zero and as many below it as above, and of
/// wider bands beyond.
fn levels_about_zero([visited, all]: [&[f64]; 2]) -> Vec<f64> {
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let [most, most_of_all] = [visited, all].map(largest);
    if most_of_all <= 0.0 {
        return vec![0.0];
    }
    // Half the width of a band, and the number of bands on each side of the one about zero.
    let fine = |most: f64, bands: usize| {
        let half = 0.5 * round_step(2.0 * most / bands as f64);
        (half, ((most / half - 1.0) / 2.0).ceil().max(0.0) as i32)
    };
    let edge = |half: f64, k: i32| multiple(f64::from(2 * k - 1), half);
    if most > 0.0 && most_of_all > 2.0 * most {
        let (half, beyond) = fine(most, BANDS - WIDER - 1);
        let wider = wider_levels(edge(half, beyond + 2), most_of_all, WIDER);
        if let [above @ .., _] = &wider[..] {
            let below = wider.iter().rev().map(|level| -level);
            // The upper edge of the last fine band begins the wider ones.
            let fine = (-beyond..=beyond + 1).map(|k| edge(half, k));
            return below.chain(fine).chain(above.iter().copied()).collect();
        }
    }
    let (half, beyond) = fine(most_of_all, BANDS);
    (-beyond..=beyond).map(|k| edge(half, k)).collect()
}

/// Lower edges of bands that hold about as many values each: quantiles, with two digits of what is missing to 100 %.
fn quantile_levels([visited, _]: [&[f64]; 2]) -> Vec<f64> {
    let mut sorted = visited.to_vec();
    sorted.sort_by(f64::total_cmp);
    let level = |k: usize| {
        let missing = 100.0 - sorted.get(k * sorted.len() / BANDS)?;
        let digits = (1.0 - missing.log10().floor()).max(0.0) as usize;
        let is_level = missing > 0.0;
        is_level.then(|| format!("{:.digits$}", 100.0 - missing).parse().ok())?
    };
    let mut levels: Vec<f64> = (0..BANDS).filter_map(level).collect();
    levels.dedup();
    // Rounded up, a level can exceed all values.
    let highest = sorted.last().copied().unwrap_or(0.0);
    levels.retain(|level| *level < highest);
    levels
}

/// The smallest of 1, 2 and 5 times a power of ten that is not below `raw`.
pub(crate) fn round_step(raw: f64) -> f64 {
    let power = 10f64.powf(raw.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power);
    let enough = |step: &f64| *step >= raw * (1.0 - 1e-9);
    steps.into_iter().find(enough).unwrap_or(raw)
}

/// The number `count` times `step`, with the digits of the step.
fn multiple(count: f64, step: f64) -> f64 {
    let digits = (-step.log10().floor()).max(0.0) as usize;
    let value = count * step;
    format!("{value:.digits$}").parse().unwrap_or(value) + 0.0
}

/// Finish and, if there are several, temperature: "ground, 90 °C".
fn named(map: &Map, finish: &FinishMap, temperature: usize) -> String {
    match map.axes.temperature_c.len() {
        1 => in_words(&finish.name).to_owned(),
        _ => format!(
            "{}, {} °C",
            in_words(&finish.name),
            map.axes.temperature_c[temperature]
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

/// Loss of every finish over torque and speed with the points of a cycle, all with the same colours.
#[must_use]
pub fn loss_fields(map: &Map, temperature: usize, visited: &[[f64; 2]]) -> Vec<Drawing> {
    LOSS.fields(map, &[temperature], visited)
}

/// Difference of equal losses, by rounding, over the loss.
const EQUAL: f64 = 1e-9;

fn differences(map: &Map, drawn: &[usize], visited: &[[f64; 2]]) -> Markup {
    let Some((first, others)) = map.finishes.split_first() else {
        return html! {};
    };
    let of = |point: &Point| LOSS.at(point);
    let mut fields = Vec::new();
    for finish in others {
        for &at in drawn {
            let mut field = field(map, finish, at, &of);
            let base = self::field(map, first, at, &of).values;
            for (value, base) in field.values.iter_mut().zip(base) {
                // Losses that differ only by rounding are equal.
                let difference = *value - base;
                *value = if difference.abs() <= EQUAL * base {
                    0.0
                } else {
                    difference
                };
            }
            let names = [&named(map, finish, at), &first.name];
            fields.push(Contour {
                id: id(map, "difference", finish, at),
                title: format!("Loss of {} minus that of {}", names[0], names[1]),
                value: "difference [W]".to_owned(),
                dots: visited.to_vec(),
                ..field
            });
        }
    }
    if fields.is_empty() {
        return html! {};
    }
    let fields = with_common_levels(fields, levels_about_zero);
    let levels = fields.first().and_then(|field| field.levels.as_ref());
    let positive = levels.and_then(|levels| levels.iter().find(|level| **level > 0.0));
    let white = positive.map_or("equal losses".to_owned(), |half| {
        format!("less than {half} W apart, however small the loss")
    });
    html! {
        p { "Blue: the loss is lower than with " (first.name) "; red: higher; white: " (white) "." }
        div.charts { @for field in fields { (figure(&Drawing::Contour(field))) } }
    }
}

/// Largest number of rows of the table of bands.
const MOST_BANDS: usize = 40;

/// Losses with their quantiles at the nodes of the draws: the first points, and a reference to the others.
fn bands(map: &Map) -> Markup {
    let is_node = |finish: &FinishMap, point: &Point| {
        let side = usize::from(point.torque_nm < 0.0) * finish.meshes.len().max(1);
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
            numbers.drawn_w?;
            Some((finish, point, banded(numbers.loss_w, numbers.drawn_w)))
        })
        .collect();
    if rows.is_empty() {
        return html! {};
    }
    let table = columns! { (finish, point, loss) in rows.iter().take(MOST_BANDS);
        head name "finish" "" = in_words(&finish.name);
        number torque_nm "torque" "N m" "{:.2}" = point.torque_nm;
        number speed_rpm "speed" "1/min" "{:.0}" = point.speed_rpm;
        number temperature_c "temperature" "°C" = point.temperature_c;
        number loss "loss" "W" = loss;
    };
    let table = table.renamed("finish", map.noun());
    html! {
        p { "Median of the loss with its 5 and 95 % quantiles, as for a run. The samples were computed at these torques and speeds; "
            "between them their logarithms are interpolated. Negative torques have the same losses, unless there are coast flanks. "
            "All points are in map.csv." }
        (table)
        @if rows.len() > MOST_BANDS { p { (rows.len() - MOST_BANDS) " more in map.csv." } }
    }
}

fn ranges(map: &Map) -> Table {
    columns! { warning in &map.warnings;
        text what "what" "" = words(&warning.text);
        text finish "finish" "" = in_words(&warning.finish);
        number count "points" "";
        text points "rows of map.csv" "" = shortened(&warning.points);
    }
    .renamed("finish", map.noun())
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

fn files(map: &Map) -> Table {
    let files = map.finishes.iter().flat_map(|finish| {
        let drive = finish.files.iter().map(|pair| ("drive", pair));
        let coast = finish.coast_files.iter().map(|pair| ("coast", pair));
        drive.chain(coast).map(move |file| (finish, file))
    });
    columns! { (finish, (side, [file, sum])) in files;
        text finish "finish" "" = in_words(&finish.name);
        text flanks "flanks" "" = side;
        code file "file" "" = file;
        code sum "SHA-256" "" = sum;
    }
    .renamed("finish", map.noun())
}

/// Scope of the losses, and the torques from which contacts are resolved.
fn scope(map: &Map) -> String {
    let from = map.finishes.iter();
    let from = from.map(|finish| {
        format!(
            "{:.3} N m ({})",
            finish.resolved_from_nm[0],
            in_words(&finish.name)
        )
    });
    format!(
        "Scope: {} only; no bearings, seals, churning. Points below {} are extrapolated: the traces do not resolve their contact.",
        map.scope,
        from.collect::<Vec<_>>().join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contour(values: Vec<f64>) -> Contour {
        Contour {
            id: "field".to_owned(),
            title: "Field".to_owned(),
            source: "map.csv".to_owned(),
            x: Axis::new("torque", "N m"),
            y: Axis::new("speed", "1/min"),
            value: "loss [W]".to_owned(),
            columns: vec![0.0, 1.0],
            rows: vec![0.0, 1.0],
            values,
            height: 100.0,
            ..Contour::default()
        }
    }

    #[test]
    fn finishes_have_the_same_colours_and_differences_are_about_zero() {
        let fields = vec![
            contour(vec![0.0, 200.0, 400.0, 780.0]),
            contour(vec![f64::NAN, 100.0, 200.0, 300.0]),
            contour(vec![f64::NAN; 4]),
        ];
        let levels: Vec<Vec<f64>> = with_common_levels(fields, round_levels)
            .into_iter()
            .filter_map(|field| field.levels)
            .collect();
        assert_eq!(levels.len(), 2);
        assert_eq!(levels[0], levels[1]);
        assert_eq!((levels[0][0], levels[0].len()), (0.0, 8));
        let alike = |values: &'static [f64]| [values, values];
        // Fine steps around the visited values, wide ones up to all others.
        assert_eq!(
            round_levels([&[0.0, 95.0], &[0.0, 1220.0]]),
            [
                0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 90.0, 200.0, 1000.0
            ]
        );
        assert_eq!(
            levels_about_zero([&[-90.0, 10.0], &[-370.0, 10.0]]),
            [-200.0, -125.0, -75.0, -25.0, 25.0, 75.0, 125.0]
        );
        assert_eq!(
            levels_about_zero(alike(&[-190.0, -20.0])),
            [
                -225.0, -175.0, -125.0, -75.0, -25.0, 25.0, 75.0, 125.0, 175.0
            ]
        );
        // A tenth of the values each, though most lie within 0.1 of each other.
        let mut efficiencies: Vec<f64> = (0..80).map(|k| 99.5 + 0.001 * f64::from(k)).collect();
        efficiencies.extend((0..20).map(|k| 90.0 + 0.4 * f64::from(k)));
        let levels = quantile_levels([&efficiencies, &efficiencies]);
        assert!(levels.is_sorted() && levels.iter().filter(|level| **level > 99.0).count() > 5);
        assert!(levels[0] >= 90.0 && levels.len() >= 8, "{levels:?}");
    }
}
