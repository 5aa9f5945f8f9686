//! Report of a cycle: the energy lost with each finish, its operating points over the map, and the loss over time.

use asperity::message::Warning;
use asperity::result::loss_band::Digits;
use asperity_core::numerics::range;
use asperity_core::{Code, decimals, number};
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::{Cell, Report, StudyResult, Table, columns};
use serde::Serialize;

use super::energy::{CycleFinish, CycleResult};
use super::trace::CyclePoint;
use crate::map::{
    FinishMap, HELPFUL, against, are_extrapolated, banded, in_words, loss_fields, loss_with, marks,
    round_step,
};

/// Approximate number of torque bins.
const BINS: f64 = 30.0;

/// Content of the brackets.
const NOTE: &str = "Medians, in brackets 5 and 95 % quantiles over the samples of the map. All points of the cycle share \
    the samples, as do both sides of a difference.";

impl StudyResult for CycleResult {
    const KIND: &'static str = "cycle";
    const NAME: &'static str = "cycle";

    fn report(&self) -> Report<'_> {
        let [most, less] = extrapolated(self);
        Report::new(&self.title, format!("cycle {}", self.cycle))
            .section("Energy")
            .verdict(verdicts(self))
            .verdict(most)
            .figures(|| [over_time(self)])
            .text([conditions(self)])
            .text(less)
            .text([HELPFUL])
            .on_page()
            .table(table(self))
            .text(in_pairs(self))
            .on_page()
            .text([outside(self)])
            .warning(left_aside(self))
            .warning(&self.warnings)
            .section("Operating points")
            .text(marks(&self.map, !self.points.is_empty()))
            .on_page()
            .figures(|| operating_points(self))
            .figures(|| by_torque(self))
            .method([DRIVE_ENERGY])
            .on_page()
            .method(is_banded(self).then_some(NOTE))
            .rows("cycle.csv", || rows(self))
    }
}

/// Meaning of the energy that the lost energy is compared with.
const DRIVE_ENERGY: &str = "The drive energy is the energy at the pinion while it drives, without the energy while the wheel drives.";

/// Row of `cycle.csv`: a point with a finish.
#[derive(Serialize)]
struct CyclePointRow<'a> {
    time_s: f64,
    torque_nm: f64,
    speed_rpm: f64,
    loss_w: f64,
    loss_p05_w: Option<f64>,
    loss_p95_w: Option<f64>,
    finish: &'a str,
}

fn rows(result: &CycleResult) -> impl Iterator<Item = CyclePointRow<'_>> {
    result.finishes.iter().flat_map(|finish| {
        let points = result.points.iter().zip(&finish.loss_w);
        points.enumerate().map(move |(k, (point, loss_w))| {
            let drawn = finish.drawn_w.get(k);
            CyclePointRow {
                time_s: point.time_s,
                torque_nm: point.torque_nm,
                speed_rpm: point.speed_rpm,
                loss_w: *loss_w,
                loss_p05_w: drawn.map(|drawn| drawn.low),
                loss_p95_w: drawn.map(|drawn| drawn.high),
                finish: &finish.name,
            }
        })
    })
}

/// The cycle and its energies.
fn conditions(result: &CycleResult) -> String {
    let way = result
        .distance_km
        .map_or(String::new(), |km| format!(", {} km", decimals(km, 2)));
    let [pinion, wheel] = result.map.shafts();
    format!(
        "Cycle {}: {} s{way}, flanks at {} °C; loss of the {} only. At the {pinion} {} Wh while it drives, {} Wh while the {wheel} \
        drives.",
        result.cycle,
        decimals(result.duration_s, 0),
        number(result.temperature_c),
        result.scope,
        decimals(result.drive_wh, 1),
        decimals(result.coast_wh, 1)
    )
}

/// Why a difference may differ from the difference of the energies as printed; `None` without draws or differences.
fn in_pairs(result: &CycleResult) -> Option<&'static str> {
    let is_drawn = |finish: &CycleFinish| finish.difference_quantiles_wh.is_some();
    let mut finishes = result.finishes.iter();
    finishes.any(is_drawn).then_some(
        "Each difference is the median over paired samples, not the difference of the medians.",
    )
}

/// Shares outside of the map and below the resolved torque.
fn outside(result: &CycleResult) -> String {
    let outside = if result.outside_share > 0.0 {
        format!(
            "Outside of the map, with the ratio of loss to torque at its edge: {:.1} % of the energy ({:.1} % of the moving time). ",
            100.0 * result.outside_energy_share,
            100.0 * result.outside_share,
        )
    } else {
        String::new()
    };
    format!(
        "{outside}Below the torque that the traces resolve, with a scaled sliding loss: {:.1} % of the moving time.",
        100.0 * result.extended_share
    )
}

/// Content of the interval of an energy.
const NOT_IN_INTERVAL: &str = " The interval does not widen with it.";

/// Share of the lost energy from which its extrapolation is part of the verdict.
const MOST: f64 = 0.5;

/// Sentences on the share of the lost energy where the model is extrapolated, for each finish with such a share: of at least half of
/// the energy, and of less.
fn extrapolated(result: &CycleResult) -> [Vec<String>; 2] {
    let of_finish = |(own, finish): (&CycleFinish, &FinishMap)| {
        let places = result.points.iter().map(|point| {
            let [torque, speed] = point.forwards();
            [torque, speed.abs()]
        });
        let beyond = are_extrapolated(&result.map, finish, temperature(result), places);
        let energies = result.points.iter().zip(&own.loss_w);
        let energies = energies.map(|(point, loss_w)| loss_w * point.weight_s);
        let all: f64 = energies.clone().sum();
        let beyond = energies.zip(beyond).filter(|(_, is_beyond)| *is_beyond);
        let beyond: f64 = beyond.map(|(energy, _)| energy).sum();
        let sentence = format!(
            "Of the energy lost with {}, {} % is where the model is extrapolated further than at the operating point of the case.{}",
            in_words(&own.name),
            decimals(100.0 * beyond / all, 0),
            own.lost_quantiles_wh.map_or("", |_| NOT_IN_INTERVAL)
        );
        (beyond > 0.0).then_some((beyond >= MOST * all, sentence))
    };
    let finishes = result.finishes.iter().zip(&result.map.finishes);
    let sentences: Vec<(bool, String)> = finishes.filter_map(of_finish).collect();
    let (most, less): (Vec<_>, Vec<_>) = sentences.into_iter().partition(|(is_most, _)| *is_most);
    [most, less].map(|part| part.into_iter().map(|(_, sentence)| sentence).collect())
}

/// Number of the temperature of the map.
fn temperature(result: &CycleResult) -> usize {
    let mut temperatures = result.map.axes.temperature_c.iter();
    let nearest = temperatures.position(|temperature| *temperature == result.temperature_c);
    nearest.unwrap_or_default()
}

/// The map with the points of the cycle.
fn operating_points(result: &CycleResult) -> Vec<Drawing> {
    let visited: Vec<[f64; 2]> = result.points.iter().map(CyclePoint::forwards).collect();
    loss_fields(&result.map, temperature(result), &visited)
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

/// The energies of each finish.
fn table(result: &CycleResult) -> Table {
    let rows = result.finishes.iter().map(|finish| (finish, lost(finish)));
    let table = columns! { (finish, [lost, drive, coast]) in rows;
        head finish "finish" "" = Cell::shown(in_words(&finish.name), finish.name.as_str().into());
        interval lost_wh "lost" "Wh" = Cell::with_ends(lost, Some(finish.lost_wh), finish.lost_quantiles_wh);
        file lost_at_medians_wh = Cell::optional(finish.lost_at_medians_wh);
        shown drive "driving" "Wh" = drive;
        shown coast "braking" "Wh" = coast;
        file lost_drive_wh = finish.lost_drive_wh;
        file lost_coast_wh = finish.lost_coast_wh;
        shown share "of drive energy" "%" = share_of_drive(finish).unwrap_or("-".to_owned());
        shown way "per 100 km" "Wh" = per_100_km(finish).unwrap_or("-".to_owned());
        file share_of_drive = Cell::optional(finish.share_of_drive);
        file wh_per_100_km = Cell::optional(finish.wh_per_100_km);
        interval difference_wh "minus the first" "Wh" = Cell::with_ends(difference(finish), finish.difference_wh, finish.difference_quantiles_wh);
    };
    let table = match result.finishes.len() {
        1 => table.unshown_of(&["minus the first"]),
        _ => table,
    };
    table
        .renamed("finish", result.map.noun())
        .brief(&["braking"])
        .in_file("energies.csv")
}

/// Whether the energies have quantiles.
fn is_banded(result: &CycleResult) -> bool {
    let mut finishes = result.finishes.iter();
    finishes.any(|finish| finish.lost_quantiles_wh.is_some())
}

/// Energy lost with its quantiles, and its parts while the pinion and while the wheel drives, which add up to it as printed.
fn lost(finish: &CycleFinish) -> [String; 3] {
    let parts = [finish.lost_drive_wh, finish.lost_coast_wh];
    let drawn = finish.lost_drawn_wh();
    let digits = Digits::of_drawn(drawn, Digits::of_decimals(2));
    let total = digits.steps(finish.lost_wh);
    let parts = digits.parts(total, &parts);
    let whole = match drawn {
        Some(_) => banded(finish.lost_wh, drawn),
        None => digits.text(total),
    };
    [whole, digits.text(parts[0]), digits.text(parts[1])]
}

/// `value`, in proportion to the energy lost, with the digits that the interval leaves.
fn proportional(finish: &CycleFinish, value: f64) -> String {
    let half = match finish.lost_drawn_wh() {
        Some(drawn) if finish.lost_wh > 0.0 => drawn.half_width() / finish.lost_wh * value,
        _ => 0.0,
    };
    Digits::of_uncertainty(half).rounded(value)
}

/// The energy lost over the energy at the pinion while it drives \[%\].
fn share_of_drive(finish: &CycleFinish) -> Option<String> {
    Some(proportional(finish, 100.0 * finish.share_of_drive?))
}

/// The energy lost per 100 km \[Wh\].
fn per_100_km(finish: &CycleFinish) -> Option<String> {
    Some(proportional(finish, finish.wh_per_100_km?))
}

/// The energy lost with each finish, and its difference from the first, in words.
fn verdicts(result: &CycleResult) -> Vec<String> {
    let verdict = |finish: &CycleFinish| {
        let [whole, ..] = lost(finish);
        let share = share_of_drive(finish).map(|share| format!(", {share} % of the drive energy"));
        let against = finish.difference_wh.and_then(|value| {
            let first = &result.finishes.first()?.name;
            let in_words = match finish.difference_drawn_wh() {
                Some(drawn) => against(drawn, "Wh", first),
                None => {
                    let way = if value < 0.0 { "lower" } else { "higher" };
                    format!("{:.2} Wh {way} than with {}", value.abs(), in_words(first))
                }
            };
            Some(format!("; {in_words}"))
        });
        let [share, against] = [share, against].map(Option::unwrap_or_default);
        format!("{} {whole} Wh{share}{against}.", loss_with(&finish.name))
    };
    result.finishes.iter().map(verdict).collect()
}

/// Difference from the first finish with its quantiles.
fn difference(finish: &CycleFinish) -> String {
    let Some(value) = finish.difference_wh else {
        return "reference".to_owned();
    };
    match finish.difference_drawn_wh() {
        Some(drawn) => banded(value, Some(drawn)),
        None => format!("{value:+.2}"),
    }
}

/// W431, if the case of the map states a gearbox.
fn left_aside(result: &CycleResult) -> Option<Warning> {
    (!result.left_aside.is_empty()).then(|| {
        let text = format!(
            "energies are of the mesh; other losses of the case are ignored: {}",
            result.left_aside.join(", ")
        );
        Warning::new(Code::W431, text)
    })
}
