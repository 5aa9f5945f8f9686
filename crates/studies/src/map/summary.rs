//! Extremes of a map and its notes, in words.

use asperity_core::{Code, Estimate};
use std::collections::BTreeMap;

use asperity::message::Warning;
use asperity::result::loss_band::Digits;
use asperity_core::numerics::range;
use asperity_report::{Cell, Table, columns};

use super::axes::Axes;
use super::grid::difference as difference_of;
use super::point::{EXTENDED, FinishMap, Map, MeshPart, Numbers, Point};

/// Largest loss, best efficiency and largest loss torque of each finish.
pub(super) fn extremes(map: &Map) -> Table {
    let finishes = map.finishes.iter();
    let rows = finishes.filter_map(|finish| Some((finish, Extremes::new(finish)?)));
    let table = columns! { (finish, extremes) in rows;
        head finish "finish" "" = Cell::shown(in_words(&finish.name), finish.name.as_str().into());
        interval loss_w "largest loss" "W" = extremes.loss();
        file loss_at_medians_w = Cell::optional(extremes.most.loss_at_medians_w);
        number share_percent "share of power" "%" = extremes.share();
        number torque_nm "at torque" "N m" "{:.2}" = extremes.point.torque_nm;
        number speed_rpm "and speed" "1/min" "{:.0}" = extremes.point.speed_rpm;
        number efficiency_percent "best efficiency" "%" = extremes.efficiency();
        number loss_torque_nm "largest loss torque" "N m" = extremes.torque();
        interval difference_w "minus the first" "W" = difference(finish);
    };
    let table = match map.finishes.len() {
        1 => table.unshown_of(&["minus the first"]),
        _ => table,
    };
    table.renamed("finish", map.noun()).in_file("extremes.csv")
}

/// The difference of each finish from the first, then the loss and the efficiency of each, at the operating point of the case, in
/// words.
pub(super) fn verdicts(map: &Map) -> impl Iterator<Item = String> {
    let compared = map.finishes.iter().skip(1).filter_map(move |finish| {
        let first = map.finishes.first()?;
        let [of_first, own] = [first, finish].map(|of| map.typical(of));
        let (of_first, own) = (of_first?, own?);
        Some(format!(
            "{} {}, {}.",
            loss_with(&finish.name),
            against(
                difference_of((first, &of_first), (finish, &own))?,
                "W",
                &first.name
            ),
            place(&map.axes, &own)
        ))
    });
    let each = map.finishes.iter().filter_map(move |finish| {
        let point = &map.typical(finish)?;
        let numbers = point.numbers?;
        let power = power_w(point);
        let loss = numbers.loss_w;
        let efficiency = if power > 0.0 && loss < power {
            let digits = percent_digits(&numbers, power);
            let efficiency = digits.rounded(100.0 * (1.0 - loss / power));
            format!(" and the efficiency {efficiency} %")
        } else {
            String::new()
        };
        Some(format!(
            "{} {} W{efficiency}, {}.",
            loss_with(&finish.name),
            banded(numbers.loss_w, numbers.drawn_w),
            place(&map.axes, point)
        ))
    });
    compared.chain(each)
}

/// Torque and speed of a point, and its temperature among several, in words.
fn place(axes: &Axes, point: &Point) -> String {
    let torque = (100.0 * point.torque_nm).round() / 100.0;
    let at = format!("at {torque} N m and {:.0} 1/min", point.speed_rpm);
    match axes.temperature_c.len() {
        1 => at,
        _ => format!("{at}, {:.0} °C", point.temperature_c),
    }
}

/// Difference of a finish from the first at its largest loss.
fn difference(finish: &FinishMap) -> Cell {
    let text = |drawn: Estimate| banded(drawn.value, Some(drawn));
    let text = finish.difference_w.map_or("-".to_owned(), text);
    Cell::estimate(text, finish.difference_w)
}

/// Loss of each mesh of a gear train at the largest loss of its finish.
pub(super) fn of_meshes(map: &Map) -> Table {
    let rows = map.finishes.iter().flat_map(|finish| {
        let parts = parts_at_largest(finish).into_iter();
        parts.map(move |part| (finish, part))
    });
    columns! { (finish, [mesh, count, loss]) in rows;
        head name "finish" "" = &finish.name;
        text mesh "mesh" "" = mesh;
        number count "equal meshes" "" = count;
        number loss "part of the largest loss" "W" = loss;
    }
    .renamed("finish", map.noun())
}

/// The extremes of a finish over the map.
struct Extremes<'a> {
    /// Index of the point with the largest loss.
    at: usize,
    point: &'a Point,
    most: Numbers,
    /// Best efficiency, the power in and the losses there.
    best: Option<(f64, f64, Numbers)>,
    /// The losses with the largest loss torque.
    torque: Numbers,
}

impl<'a> Extremes<'a> {
    fn new(finish: &'a FinishMap) -> Option<Self> {
        let numbers = || {
            let points = finish.points.iter();
            points.filter_map(|point| Some((point, point.numbers?)))
        };
        let (at, most) = finish.largest()?;
        let efficient = numbers()
            .filter_map(|(point, numbers)| Some((numbers.efficiency?, power_w(point), numbers)));
        let torque = numbers().map(|(_, numbers)| numbers);
        Some(Self {
            at,
            point: &finish.points[at],
            most,
            best: efficient.max_by(|a, b| a.0.total_cmp(&b.0)),
            torque: torque.max_by(|a, b| a.loss_torque_nm.total_cmp(&b.loss_torque_nm))?,
        })
    }

    /// The largest loss \[W\].
    fn loss(&self) -> Cell {
        let most = &self.most;
        let ends = most.drawn_w.map(Estimate::ends);
        Cell::with_ends(banded(most.loss_w, most.drawn_w), Some(most.loss_w), ends)
    }

    /// The largest loss over the power there \[%\].
    fn share(&self) -> Cell {
        let power = power_w(self.point);
        let share = (power != 0.0).then(|| 100.0 * self.most.loss_w / power);
        Cell::number(share, |share| {
            percent_digits(&self.most, power).rounded(share)
        })
    }

    /// The best efficiency \[%\].
    fn efficiency(&self) -> Cell {
        let cell = |(efficiency, power, numbers): (f64, f64, Numbers)| {
            let digits = percent_digits(&numbers, power);
            Cell::number(100.0 * efficiency, |percent| digits.rounded(percent))
        };
        Cell::optional(self.best.map(cell))
    }

    /// The largest loss torque \[N m\].
    fn torque(&self) -> Cell {
        let numbers = &self.torque;
        let relative = |of: &Numbers| {
            let drawn = of.drawn_w?;
            (of.loss_w > 0.0).then(|| drawn.half_width() / of.loss_w)
        };
        // At rest there is a torque and no loss to draw.
        let relative = relative(numbers).or_else(|| relative(&self.most));
        let half = relative.unwrap_or(0.0) * numbers.loss_torque_nm;
        Cell::number(numbers.loss_torque_nm, |torque| {
            Digits::of_uncertainty(half).rounded(torque)
        })
    }
}

/// Name, number and loss \[W\] of the meshes of a gear train at the largest loss of a finish, which add up to it as printed;
/// empty of a single mesh.
fn parts_at_largest(finish: &FinishMap) -> Vec<[String; 3]> {
    let Some(extremes) = Extremes::new(finish) else {
        return Vec::new();
    };
    let most = &extremes.most;
    let omega = extremes.point.speed_rpm * std::f64::consts::PI / 30.0;
    let part = |mesh: &MeshPart| Some(omega * mesh.loss_torque_nm.get(extremes.at).copied()??);
    let Some(parts) = finish.meshes.iter().map(part).collect::<Option<Vec<f64>>>() else {
        return Vec::new();
    };
    let digits = Digits::of_drawn(most.drawn_w, Digits::of_decimals(1));
    let parts = digits.parts(digits.steps(most.loss_w), &parts);
    let row = |(mesh, part): (&MeshPart, f64)| {
        [mesh.name.clone(), mesh.count.to_string(), digits.text(part)]
    };
    finish.meshes.iter().zip(parts).map(row).collect()
}

/// Power at a point \[W\].
fn power_w(point: &Point) -> f64 {
    point.torque_nm.abs() * point.speed_rpm * std::f64::consts::PI / 30.0
}

/// Digits of a percentage of `power` by the quantiles of the loss; four decimals without.
fn percent_digits(numbers: &Numbers, power: f64) -> Digits {
    match numbers.drawn_w {
        Some(drawn) => Digits::of_interval(drawn.ends()).of_percent(power),
        None => Digits::of_decimals(4),
    }
}

/// Name of the only finish of a map of `case.toml`: the name of the file says nothing.
const UNNAMED: &str = "case";

/// Name of a finish in sentences and tables.
pub(crate) fn in_words(finish: &str) -> &str {
    match finish {
        UNNAMED => "these flanks",
        named => named,
    }
}

/// Subject and verb of a sentence about the loss with a finish, whose name may be a plural.
pub(crate) fn loss_with(finish: &str) -> String {
    format!("With {} the loss is", in_words(finish))
}

/// A difference from the finish `first` in words, as the object of a sentence with [`loss_with`].
pub(crate) fn against(difference: Estimate, unit: &str, first: &str) -> String {
    let Estimate { value, low, high } = difference;
    let first = in_words(first);
    match (high < 0.0, low > 0.0) {
        (true, _) => {
            let less = Estimate::new(-value, [-high, -low]);
            format!(
                "{} {unit} lower than with {first}",
                banded(-value, Some(less))
            )
        }
        (_, true) => format!(
            "{} {unit} higher than with {first}",
            banded(value, Some(difference))
        ),
        _ => format!(
            "lower or higher than with {first}, by {} {unit}",
            banded(value, Some(difference))
        ),
    }
}

/// A mark of points in words.
pub(super) fn words(mark: &str) -> &str {
    match mark {
        EXTENDED => {
            "torque below the smallest that the traces resolve, where the sliding loss is scaled"
        }
        mark => mark,
    }
}

/// A median with its quantiles, or the `value` of a map without draws.
pub(crate) fn banded(value: f64, drawn: Option<Estimate>) -> String {
    let by_interval = |drawn: Estimate| Digits::of_interval(drawn.ends()).interval(drawn);
    drawn.map_or_else(|| format!("{value:.1}"), by_interval)
}

/// W431, if the case states a gearbox.
pub(super) fn left_aside(map: &Map) -> Option<Warning> {
    let gearbox = map.gearbox.as_ref()?;
    let text = format!(
        "losses are of the mesh; the other losses of the case ({}) are a separate part in exports",
        gearbox.parts.join(", ")
    );
    Some(Warning::new(Code::W431, text))
}

/// Largest distances of the quantiles from the median, in percent.
pub(super) fn bands(map: &Map) -> impl Iterator<Item = String> {
    let of = |finish: &FinishMap| {
        let shares = finish.points.iter().filter_map(|point| {
            let numbers = point.numbers?;
            let drawn = numbers.drawn_w.filter(|drawn| drawn.value > 0.0)?;
            Some(drawn.ends().map(|end| 100.0 * (end / drawn.value - 1.0)))
        });
        let shares: Vec<[f64; 2]> = shares.collect();
        let points = shares.len();
        let [low, high] = range(shares.into_iter().flatten());
        (points > 0).then(|| {
            format!(
                "The 90 % interval of the loss of {} reaches from {low:+.0} to {high:+.0} % about its median, over {points} points.",
                in_words(&finish.name)
            )
        })
    };
    map.finishes.iter().filter_map(of)
}

/// Distinct warnings of the points, with their finishes unless they apply to all.
pub(super) fn notes(map: &Map) -> Vec<String> {
    let mut notes: BTreeMap<&str, Vec<(&str, usize)>> = BTreeMap::new();
    for warning in &map.warnings {
        let entry = notes.entry(&warning.text).or_default();
        entry.push((&warning.finish, warning.count));
    }
    let lines = notes.iter().map(|(text, finishes)| {
        let counts: Vec<String> = finishes
            .iter()
            .map(|(name, count)| match map.finishes.len() {
                1 => format!("{count}"),
                _ => format!("{count} ({name})"),
            })
            .collect();
        format!("{}: {} points", words(text), counts.join(", "))
    });
    lines.collect()
}
