//! Tables and sentences of a comparison.

use asperity_core::Estimate;
use asperity_report::{Cell, Table, Value, columns, stated, stated_parts};

use asperity::result::Summary;
use asperity::result::loss_band::{Digits, rounded};
use asperity::uncertainty::{DecidingMeasurement, PairedDifference, Predictive, Verdict};
use asperity_core::{capitalised, unique};

use super::comparison::{Comparison, FinishResult, MeshOfFinish, PairOfFinish};

/// Efficiency and loss of each finish; of a single mesh also its lubrication.
pub(super) fn table(comparison: &Comparison) -> Table {
    let finishes = comparison.finishes.iter();
    let rows = finishes.map(|finish| {
        let losses = OfFinish {
            loss_w: finish.loss_w,
            first_w: comparison.first_w(finish),
            drawn: finish.drawn_w(),
            difference: finish.difference.as_ref(),
        };
        (finish, losses)
    });
    let table = columns! { (finish, losses) in rows;
        head finish "finish" "" = &finish.name;
        number efficiency_percent "efficiency" "%" = efficiency(finish);
        interval loss_w "loss" "W" = losses.loss();
        file loss_at_medians_w = Cell::optional(finish.loss_at_medians_w);
        interval difference_w "minus the first" "W" = losses.difference();
        text verdict "sign" "" = finish.difference.as_ref().map_or("", |found| sign(&found.verdict));
        interval change_percent "of the first" "%" = losses.change();
        number mixed_share_percent "mixed" "%" "{:.0}" = finish.mixed_share.map(|share| 100.0 * share);
        text regime "regime" "" = regime(finish);
        text base_oil "base oil" "" = finish.base_oil.unwrap_or("-");
        number viscosity_mm2_per_s "viscosity at bulk temperature" "mm²/s" = Cell::number(finish.viscosity_mm2_per_s, viscosity);
        file gearbox_efficiency_percent = Cell::optional(finish.gearbox.as_ref().map(|g| 100.0 * g.efficiency));
        file gearbox_loss_w = Cell::optional(finish.gearbox.as_ref().map(|g| g.loss_w));
        file outside = finish.outside();
    };
    let table = match comparison.pairs().next() {
        Some(_) => table.brief(&["mixed", "regime"]),
        None => table.unshown_of(&["mixed", "regime"]),
    };
    // The verdict on a single difference is a sentence above the table.
    let table = match comparison.finishes.len() {
        ..=2 => table.brief(&["sign"]),
        _ => table,
    };
    let table = if comparison.has_equal_oils() {
        table.unshown_of(&OIL)
    } else {
        table.brief(&OIL)
    };
    table
        .renamed("finish", comparison.noun())
        .in_file("compare.csv")
        .answer()
}

/// Whether the sign of a difference holds, in a word or two.
const fn sign(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Equal => "no change",
        Verdict::Holds => "holds",
        Verdict::Except(_) => "exceptions",
        _ => "inconclusive",
    }
}

/// Columns of variants with other oils.
const OIL: [&str; 2] = ["base oil", "viscosity at bulk temperature"];

/// A kinematic viscosity with three digits.
fn viscosity(mm2_per_s: f64) -> String {
    rounded(mm2_per_s, 0.01 * mm2_per_s)
}

/// The oils of the variants in words, if they differ.
pub(super) fn oils(comparison: &Comparison) -> Option<String> {
    let of = |finish: &FinishResult| {
        let base = finish
            .base_oil
            .map_or(String::new(), |base| format!("{base}, "));
        format!(
            "{}: {base}{} mm²/s",
            finish.name,
            viscosity(finish.viscosity_mm2_per_s)
        )
    };
    let oils: Vec<String> = comparison.finishes.iter().map(of).collect();
    (!comparison.has_equal_oils()).then(|| {
        format!(
            "Base oil, and viscosity at the bulk temperature: {}.",
            oils.join("; ")
        )
    })
}

/// Lubrication regime of a single mesh in words, in the file its name.
fn regime(finish: &FinishResult) -> Cell {
    let summary = finish.pair.as_ref().map(|pair| &pair.result.summary);
    let cell =
        |summary: &Summary| Cell::shown(summary.regime_words(), summary.regime.name().into());
    Cell::optional(summary.map(cell))
}

/// Loss of every mesh of a gear train with every finish, mesh by mesh.
pub(super) fn meshes(comparison: &Comparison) -> Table {
    let finishes = comparison.finishes.iter();
    let all = finishes.clone().flat_map(|finish| &finish.meshes);
    let names = unique(all.map(|mesh| &*mesh.mesh));
    let rows = names.into_iter().flat_map(|name| {
        finishes.clone().filter_map(move |finish| {
            let of_name = |of: &'_ &MeshOfFinish| of.mesh == name;
            let mesh = finish.meshes.iter().find(of_name)?;
            let mut of_first = comparison.finishes[0].meshes.iter();
            let times = match mesh.count {
                1 => String::new(),
                count => format!("{count} × "),
            };
            let losses = OfFinish {
                loss_w: mesh.loss_w,
                first_w: of_first
                    .find(of_name)
                    .filter(|_| comparison.is_later(finish))
                    .map(|first| first.loss_w),
                drawn: (mesh.loss_quantiles_w).map(|ends| Estimate::new(mesh.loss_w, ends)),
                difference: mesh.difference.as_ref(),
            };
            let name = format!("{times}{}, {}", mesh.mesh, finish.name);
            Some((finish, mesh, name, losses))
        })
    });
    let table = columns! { (finish, mesh, name, losses) in rows;
        shown name "mesh" "" = name;
        file finish = &finish.name;
        file mesh = &mesh.mesh;
        file count = mesh.count;
        interval loss_w "loss" "W" = losses.loss();
        file loss_at_medians_w = Cell::optional(mesh.loss_at_medians_w);
        interval difference_w "minus the first" "W" = losses.difference();
        interval change_percent "of the first" "%" = losses.change();
        file mixed_share_percent = 100.0 * mesh.mixed_share;
        file regime = mesh.regime.name();
    };
    table.in_file("meshes.csv")
}

/// Efficiency in percent, with the digits that its interval leaves.
fn efficiency(finish: &FinishResult) -> Cell {
    let percent = 100.0 * finish.efficiency;
    let digits = match finish.drawn_w() {
        Some(drawn) => Digits::of_interval(drawn.ends()).of_percent(finish.power_in_w),
        None => Digits::of_decimals(4),
    };
    Cell::shown(digits.rounded(percent), Value::Number(percent))
}

/// The loss of a finish as it is shown: the median with its quantiles if it is drawn.
pub(super) fn loss(finish: &FinishResult) -> String {
    shown_loss(finish.loss_w, finish.drawn_w())
}

fn shown_loss(loss_w: f64, drawn: Option<Estimate>) -> String {
    match drawn {
        Some(drawn) => interval(drawn, false),
        None => Digits::of_decimals(1).rounded(loss_w),
    }
}

/// Losses of a finish or of one of its meshes.
struct OfFinish<'a> {
    loss_w: f64,
    /// Loss with the first finish; `None` of the first itself.
    first_w: Option<f64>,
    drawn: Option<Estimate>,
    difference: Option<&'a PairedDifference>,
}

impl OfFinish<'_> {
    fn loss(&self) -> Cell {
        let ends = self.drawn.map(Estimate::ends);
        Cell::with_ends(shown_loss(self.loss_w, self.drawn), Some(self.loss_w), ends)
    }

    fn difference(&self) -> Cell {
        let drawn = self.difference.map(|of| of.watts);
        self.against_first(drawn, |first| self.loss_w - first)
    }

    fn change(&self) -> Cell {
        let drawn = self.difference.map(in_percent);
        self.against_first(drawn, |first| 100.0 * (self.loss_w - first) / first)
    }

    fn against_first(&self, drawn: Option<Estimate>, of_runs: impl Fn(f64) -> f64) -> Cell {
        match (drawn, self.first_w.map(of_runs)) {
            (Some(drawn), _) => Cell::estimate(interval(drawn, true), Some(drawn)),
            (None, Some(value)) => {
                Cell::with_ends(Digits::of_decimals(1).signed(value), Some(value), None)
            }
            (None, None) => Cell::estimate("reference", None),
        }
    }
}

/// The relative difference in percent.
fn in_percent(difference: &PairedDifference) -> Estimate {
    difference.share.map(|share| 100.0 * share)
}

/// A difference in watts and in percent, each with its quantiles and its sign, without units.
#[must_use]
pub fn difference_with_interval(difference: &PairedDifference) -> [String; 2] {
    [difference.watts, in_percent(difference)].map(|of| interval(of, true))
}

/// A median with its interval and the digits that this leaves, with signs if `is_signed`; a difference that is exactly 0 has
/// no interval.
fn interval(estimate: Estimate, is_signed: bool) -> String {
    if estimate == Estimate::new(0.0, [0.0; 2]) {
        return "0".to_owned();
    }
    let digits = Digits::of_difference(estimate.ends());
    if is_signed {
        digits.signed_interval(estimate)
    } else {
        digits.interval(estimate)
    }
}

/// Heading of the names of what is compared.
pub(crate) fn noun(are_finishes: bool) -> &'static str {
    if are_finishes { "finish" } else { "variant" }
}

impl Comparison {
    /// Loss of the first finish, from which the difference of `finish` is taken \[W\]; `None` for the first itself.
    pub(super) fn first_w(&self, finish: &FinishResult) -> Option<f64> {
        self.is_later(finish).then(|| self.finishes[0].loss_w)
    }

    /// Heading of the names.
    pub(super) fn noun(&self) -> &'static str {
        noun(self.are_finishes)
    }

    /// Whether the variants have equal flanks and differ by other keys.
    pub(super) fn has_equal_flanks(&self) -> bool {
        let of = |pair: &PairOfFinish| {
            let flanks = pair.result.flanks.each_ref();
            flanks.map(|flank| flank.parameters.as_ref().map(|of| of.heights.rq))
        };
        let mut all = self.pairs().map(|(_, pair)| of(pair));
        let first = all.next();
        !self.are_finishes && all.all(|flanks| Some(flanks) == first)
    }

    /// Whether all variants have one oil of one viscosity at their bulk temperatures.
    pub(super) fn has_equal_oils(&self) -> bool {
        let of = |finish: &FinishResult| (finish.base_oil, finish.viscosity_mm2_per_s);
        let mut all = self.finishes.iter().map(of);
        let first = all.next();
        all.all(|oil| Some(oil) == first)
    }

    /// Whether `finish` is not the first one, from which the differences are taken.
    fn is_later(&self, finish: &FinishResult) -> bool {
        self.finishes
            .first()
            .is_some_and(|first| first.name != finish.name)
    }

    /// The decision of each difference from the first finish, in words.
    #[must_use]
    pub fn verdicts(&self) -> Vec<String> {
        let first = self.finishes.first().map_or("", |first| &first.name);
        let of = |finish: &FinishResult| {
            let difference = finish.difference.as_ref()?;
            Some(verdict([first, &finish.name], difference))
        };
        self.finishes.iter().filter_map(of).collect()
    }
}

/// The decision of a difference between two named finishes or cases, in words.
#[must_use]
pub fn verdict([first, other]: [&str; 2], difference: &PairedDifference) -> String {
    // The words name savings, which are positive.
    let sign = if difference.watts.value < 0.0 {
        -1.0
    } else {
        1.0
    };
    let saved = |of: Estimate| interval(of.map(|value| sign * value), false);
    let [watts, share] = [difference.watts, in_percent(difference)].map(saved);
    let lower = if sign < 0.0 { "lower" } else { "higher" };
    let by = format!("With {other} the loss is {share} % {lower} than with {first}, by {watts} W");
    let digits = Digits::of_interval(difference.watts.ends());
    let count = difference.models.len();
    let all = match count {
        1 => "the one other model".to_owned(),
        count => format!("all {count} models"),
    };
    let range = difference.model_range_w().map_or(String::new(), |range| {
        let turned = if sign < 0.0 {
            [-range[1], -range[0]]
        } else {
            range
        };
        match count {
            1 => format!(" ({} W)", digits.rounded(turned[0])),
            _ => format!(" ({} W)", digits.range(turned)),
        }
    });
    match &difference.verdict {
        Verdict::Equal => format!("With {other} the loss is exactly as with {first}"),
        Verdict::Holds if count == 0 => format!("{by}; the sign holds"),
        Verdict::Holds => format!("{by}; the sign holds under {all}{range}"),
        Verdict::Except(models) => format!(
            "{by}; the sign holds under {all}{range} except {}",
            models.join(", ")
        ),
        _ => {
            let change = digits.signed_interval(difference.watts);
            format!("Inconclusive: with {other} the loss differs from {first} by {change} W")
        }
    }
}

/// The measurement that narrows the least certain difference most, and what it leaves at best, in words, with the name of its
/// variant; one that is made once is preferred where it narrows nearly as much.
fn decided_by(comparison: &Comparison) -> Option<(&str, String)> {
    /// Largest difference of widths that are nearly the same.
    const NEARLY: f64 = 0.03;
    let (first, others) = comparison.finishes.split_first()?;
    let differences = others.iter();
    let differences = differences.filter_map(|of| Some((of, of.difference.as_ref()?)));
    let least = differences.min_by(|a, b| a.1.probability.total_cmp(&b.1.probability));
    let (finish, difference) = least?;
    let narrowest = finish.deciding.first()?;
    let is_once = |row: &&DecidingMeasurement| row.is_common || row.of != [true; 2];
    let mut once = finish.deciding.iter().filter(is_once);
    let best = once.find(|row| row.width <= narrowest.width + NEARLY);
    let best = best.unwrap_or(narrowest);
    let words = format!(
        "would narrow to {} W at best by {}",
        Digits::of_interval(difference.watts.ends()).range(best.quantiles_w),
        measured(best, [&first.name, &finish.name]),
    );
    Some((&finish.name, words))
}

/// The decision of the surest difference, and the other decisions. Of equally sure differences the largest counts.
pub(super) fn surest(comparison: &Comparison) -> (Vec<String>, Vec<String>) {
    let mut others = verdicts(comparison);
    let differences = comparison.finishes.iter();
    let differences = differences.filter_map(|finish| finish.difference.as_ref());
    let of = |found: &PairedDifference| (found.probability, found.watts.value.abs());
    let surest = differences.enumerate().max_by(|(_, a), (_, b)| {
        let (a, b) = (of(a), of(b));
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    let first = surest.map(|(k, _)| others.remove(k));
    let others = others.iter().map(|line| capitalised(line)).collect();
    (first.into_iter().collect(), others)
}

/// The decision of each difference, one that is undecided with what would narrow it.
fn verdicts(comparison: &Comparison) -> Vec<String> {
    let decided_by = decided_by(comparison);
    let first = comparison.finishes.first().map_or("", |first| &first.name);
    let of = |finish: &FinishResult| {
        let difference = finish.difference.as_ref()?;
        let own = verdict([first, &finish.name], difference);
        let is_open = difference.verdict == Verdict::Undecided;
        let narrowed = decided_by
            .as_ref()
            .filter(|(name, _)| is_open && *name == finish.name);
        Some(match narrowed {
            Some((_, words)) => format!("{own}; it {words}."),
            None => format!("{own}."),
        })
    };
    comparison.finishes.iter().filter_map(of).collect()
}

/// The measurement that narrows a difference that is decided.
pub(super) fn narrowed_by(comparison: &Comparison) -> Option<String> {
    let (name, words) = decided_by(comparison)?;
    let mut finishes = comparison.finishes.iter();
    let difference = finishes
        .find(|finish| finish.name == name)?
        .difference
        .as_ref()?;
    let is_open = difference.verdict == Verdict::Undecided;
    (!is_open).then(|| format!("The difference of {name} {words}."))
}

/// Constants that one run of a difference states and the other leaves drawn, in words.
pub(super) fn known(comparison: &Comparison) -> Vec<String> {
    let of = |finish: &FinishResult| {
        let common = &finish.difference.as_ref()?.common;
        let stated = common.iter().filter(|row| row.stated_in_one);
        let names: Vec<&str> = stated.map(|row| &*row.name).collect();
        (!names.is_empty()).then(|| {
            format!(
                "{}: one case states {}, the other has its range. The difference counts the shift of the median only.",
                finish.name,
                names.join(", ")
            )
        })
    };
    comparison.finishes.iter().filter_map(of).collect()
}

/// A measurement in words, with the names of the variants that it is made for.
pub(super) fn measured(row: &DecidingMeasurement, names: [&str; 2]) -> String {
    match (row.is_common, row.of) {
        (true, _) => row.measurement.clone(),
        (false, [true, true]) => format!("{} with {} and {}", row.measurement, names[0], names[1]),
        (false, [true, false]) => format!("{} with {}", row.measurement, names[0]),
        (false, _) => format!("{} with {}", row.measurement, names[1]),
    }
}

/// Explanation of the intervals.
pub(super) fn note(comparison: &Comparison) -> String {
    let is_drawn = comparison
        .finishes
        .iter()
        .any(|finish| finish.drawn_w().is_some());
    match is_drawn.then(Predictive::count) {
        None => "Without an uncertainty of the loss.".to_owned(),
        Some(draws) => format!(
            "Medians of {draws} samples, in brackets their 5 and 95 % quantiles. Two variants share the samples of what is the same in both. The median of a difference is not the difference of the medians."
        ),
    }
}

/// Losses of the finishes run in; empty without `operation.running_in`.
pub(super) fn run_in(comparison: &Comparison) -> Vec<String> {
    let of = |finish: &FinishResult| {
        let after = finish.run_in_loss_w?;
        let digits = Digits::of_drawn(finish.drawn_w(), Digits::of_decimals(1));
        Some(format!(
            "With {} run in: {} W instead of {} W.",
            finish.name,
            digits.rounded(after),
            digits.rounded(finish.loss_w)
        ))
    };
    let mut lines: Vec<String> = comparison.finishes.iter().filter_map(of).collect();
    if !lines.is_empty() {
        lines.insert(
            0,
            "The table and the verdict are of the flanks as measured.".to_owned(),
        );
    }
    lines
}

/// Scope of the comparison, with the efficiency of the gearbox if it is included.
pub(super) fn scope(comparison: &Comparison) -> String {
    let first = comparison.finishes.first();
    let Some(first) = first.and_then(|finish| finish.gearbox.as_ref()) else {
        return format!(
            "Scope mesh: without bearings, seals, churning{}.",
            resolution(comparison)
        );
    };
    let with = |finish: &FinishResult| {
        let gearbox = finish.gearbox.as_ref()?;
        let digits = match finish.drawn_w() {
            Some(drawn) => Digits::of_interval(drawn.ends()).of_percent(gearbox.power_in_w),
            None => Digits::of_decimals(4),
        };
        let efficiency = digits.rounded(100.0 * gearbox.efficiency);
        Some(format!("{} {efficiency} %", finish.name))
    };
    let efficiencies: Vec<String> = comparison.finishes.iter().filter_map(with).collect();
    let losses: Vec<f64> = first.parts.iter().map(|part| part.loss_w).collect();
    let parts = first.parts.iter().zip(stated_parts(&losses));
    let parts = parts.map(|(part, loss)| format!("{} {loss}", part.name));
    format!(
        "Scope gearbox: the values above are of the {}; with {} from the input and without an interval ({}), the efficiency of the gearbox is {}.",
        if comparison
            .finishes
            .iter()
            .any(|finish| finish.meshes.is_empty())
        {
            "mesh"
        } else {
            "meshes"
        },
        stated(first.parts_w),
        parts.collect::<Vec<_>>().join(", "),
        efficiencies.join(", "),
    )
}

/// Positions and offsets of the runs of pairs: a run with other numbers of them has another loss.
fn resolution(comparison: &Comparison) -> String {
    let first = comparison.pairs().next();
    first.map_or(String::new(), |(_, pair)| {
        let s = &pair.result.summary;
        format!("; {} positions, {} offsets", s.positions, s.offsets)
    })
}

/// Distinct warnings, with their finishes unless they apply to all.
pub(super) fn warnings(comparison: &Comparison) -> Vec<String> {
    let mut finishes_of: Vec<(&str, Vec<&str>)> = Vec::new();
    for finish in &comparison.finishes {
        for warning in &finish.warnings {
            match finishes_of.iter_mut().find(|(text, _)| text == warning) {
                Some((_, names)) => names.push(&finish.name),
                None => finishes_of.push((warning, vec![&finish.name])),
            }
        }
    }
    let lines = finishes_of.iter();
    let lines = lines.map(|(warning, names)| {
        if names.len() == comparison.finishes.len() {
            (*warning).to_owned()
        } else {
            format!("{warning} ({})", names.join(", "))
        }
    });
    lines.collect()
}

#[cfg(test)]
mod tests {
    use super::OfFinish;

    #[test]
    fn a_later_finish_has_a_difference_with_and_without_draws() {
        let texts = |loss_w, first_w| {
            let losses = OfFinish {
                loss_w,
                first_w,
                drawn: None,
                difference: None,
            };
            [losses.loss(), losses.difference(), losses.change()].map(|cell| cell.text().to_owned())
        };
        assert_eq!(texts(414.1, Some(6736.4)), ["414.1", "-6322.3", "-93.9"]);
        assert_eq!(texts(6736.4, None), ["6736.4", "reference", "reference"]);
    }
}
