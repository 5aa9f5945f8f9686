//! Summary of a comparison for the terminal.

use asperity_report::{Cell, Table, columns, stated, stated_parts, wrapped};
use asperity_storage::one_line;

use asperity::result::loss_band::Digits;
use asperity::uncertainty::{PairedDifference, Predictive, Verdict};

use super::comparison::{Comparison, FinishResult};

/// Summary of a comparison for the terminal.
pub(super) fn summary(comparison: &Comparison) -> String {
    let mut text = format!("{}\n", one_line(&comparison.title));
    text.push_str(&table(comparison).without(&["mixed", "regime"]).text(""));
    let meshes = meshes(comparison);
    if !meshes.is_empty() {
        text.push('\n');
    }
    text.push_str(&meshes.text(""));
    for verdict in comparison.verdicts() {
        text.push_str(&format!("{}\n", wrapped(&one_line(&verdict), "  ")));
    }
    text.push_str(&format!("{}\n", wrapped(&note(comparison), "  ")));
    for line in run_in(comparison) {
        text.push_str(&format!("{}\n", wrapped(&one_line(&line), "  ")));
    }
    text.push_str(&format!("{}\n", wrapped(&scope(comparison), "  ")));
    let best: Vec<String> = comparison
        .correlations
        .iter()
        .take(4)
        .map(|entry| format!("{} {:+.2}", entry.parameter, entry.with_loss))
        .collect();
    if !best.is_empty() {
        text.push_str(&format!(
            "rank correlation of roughness with the computed loss ({} windows; the model's own input)\n  {}\n",
            comparison.windows,
            best.join("   ")
        ));
    }
    text.push_str(&warnings(comparison));
    text
}

/// Efficiency and loss of each finish; of a single mesh also its lubrication.
pub(super) fn table(comparison: &Comparison) -> Table {
    let rows = || {
        let finishes = comparison.finishes.iter();
        finishes.map(|finish| (finish, cells(comparison, finish)))
    };
    let table = columns! { (finish, [loss, difference, change]) in rows();
        head name "finish" "" = &finish.name;
        number efficiency "efficiency" "%" = efficiency(finish);
        number loss "loss" "W" = loss;
        number difference "minus the first" "W" = difference;
        number change "change" "%" = change;
    };
    if comparison.pairs().next().is_none() {
        return table;
    }
    table.with(columns! { (finish, _) in rows();
        number mixed "mixed" "%" "{:.0}" = finish.mixed_share.map(|share| 100.0 * share);
        text regime "regime" "" = Cell::optional(finish.regime.map(|regime| regime.name()));
    })
}

/// Loss of every mesh of a gear train with every finish, mesh by mesh.
pub(super) fn meshes(comparison: &Comparison) -> Table {
    let count = comparison
        .finishes
        .first()
        .map_or(0, |first| first.meshes.len());
    let finishes = comparison.finishes.iter();
    let rows = (0..count).flat_map(|k| {
        finishes.clone().filter_map(move |finish| {
            let mesh = finish.meshes.get(k)?;
            let times = match mesh.count {
                1 => String::new(),
                count => format!("{count} × "),
            };
            let drawn = mesh.loss_median_w.zip(mesh.loss_quantiles_w);
            let first = comparison
                .is_later(finish)
                .then(|| comparison.finishes[0].meshes[k].loss_w);
            let cells = texts((mesh.loss_w, first), drawn, mesh.difference.as_ref());
            Some((format!("{times}{}, {}", mesh.mesh, finish.name), cells))
        })
    });
    columns! { (name, [loss, difference, change]) in rows;
        head name "mesh and finish" "" = name;
        number loss "loss" "W" = loss;
        number difference "minus the first" "W" = difference;
        number change "change" "%" = change;
    }
}

/// Median of the efficiency in percent, with the digits that its interval leaves; without an interval the efficiency of
/// the run.
fn efficiency(finish: &FinishResult) -> String {
    match finish.drawn_w() {
        Some((median, quantiles)) => {
            let percent = Digits::of_interval(quantiles).of_percent(finish.power_in_w);
            percent.rounded(100.0 * (1.0 - median / finish.power_in_w))
        }
        None => format!("{:.4}", 100.0 * finish.efficiency),
    }
}

/// Loss, difference and change of a finish, each with its quantiles.
pub(super) fn cells(comparison: &Comparison, finish: &FinishResult) -> [String; 3] {
    texts(
        (finish.loss_w, comparison.first_w(finish)),
        finish.drawn_w(),
        finish.difference.as_ref(),
    )
}

/// The same of a loss, and of the loss with the first finish; `None` of the first itself.
fn texts(
    (loss_w, first_w): (f64, Option<f64>),
    drawn: Option<(f64, [f64; 2])>,
    difference: Option<&PairedDifference>,
) -> [String; 3] {
    let loss = match drawn {
        Some((median, quantiles)) => interval(median, quantiles, false),
        None => Digits::of_decimals(1).rounded(loss_w),
    };
    let [watts, percent] = match (difference, first_w) {
        (Some(difference), _) => difference_with_interval(difference),
        (None, Some(first)) => {
            let watts = loss_w - first;
            [watts, 100.0 * watts / first].map(|value| signed(Digits::of_decimals(1), value))
        }
        (None, None) => ["reference", "reference"].map(str::to_owned),
    };
    [loss, watts, percent]
}

/// A difference in watts and in percent, each with its quantiles and its sign, without units.
#[must_use]
pub fn difference_with_interval(difference: &PairedDifference) -> [String; 2] {
    [
        interval(difference.median_w, difference.quantiles_w, true),
        interval(
            100.0 * difference.median_share,
            difference.share_quantiles.map(|share| 100.0 * share),
            true,
        ),
    ]
}

/// A median with its interval and the digits that this leaves, with signs if `is_signed`; a difference that is exactly 0 has
/// no interval.
fn interval(median: f64, [low, high]: [f64; 2], is_signed: bool) -> String {
    if [median, low, high] == [0.0; 3] {
        return "0".to_owned();
    }
    let digits = Digits::of_difference([low, high]);
    let text = |value: f64| match is_signed {
        true => signed(digits, value),
        false => digits.rounded(value),
    };
    format!("{} ({}..{})", text(median), text(low), text(high))
}

/// A rounded value with its sign.
fn signed(digits: Digits, value: f64) -> String {
    let sign = if digits.steps(value) > 0.0 { "+" } else { "" };
    format!("{sign}{}", digits.rounded(value))
}

impl Comparison {
    /// Loss of the first finish, from which the difference of `finish` is taken \[W\]; `None` for the first itself.
    pub(super) fn first_w(&self, finish: &FinishResult) -> Option<f64> {
        self.is_later(finish).then(|| self.finishes[0].loss_w)
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
    let sign = if difference.median_w < 0.0 { -1.0 } else { 1.0 };
    let turned = |[low, high]: [f64; 2]| match sign < 0.0 {
        true => [-high, -low],
        false => [low, high],
    };
    let share = interval(
        100.0 * sign * difference.median_share,
        turned(difference.share_quantiles.map(|share| 100.0 * share)),
        false,
    );
    let watts = interval(
        sign * difference.median_w,
        turned(difference.quantiles_w),
        false,
    );
    let less = if sign < 0.0 { "less" } else { "more" };
    let by = format!("{other} loses {share} % {less} than {first}, {watts} W");
    let count = difference.models.len();
    let range = difference.model_range_w().map_or(String::new(), |range| {
        let digits = Digits::of_interval(difference.quantiles_w);
        let [low, high] = turned(range).map(|loss| digits.rounded(loss));
        format!(" ({low}..{high} W)")
    });
    match &difference.verdict {
        Verdict::Equal => format!("{other} loses exactly as much as {first}"),
        Verdict::Holds if count == 0 => format!("{by}; the sign holds"),
        Verdict::Holds => format!("{by}; the sign holds under all {count} models{range}"),
        Verdict::Except(models) => format!(
            "{by}; the sign holds under all {count} models{range} except {}",
            models.join(", ")
        ),
        _ => {
            let digits = Digits::of_interval(difference.quantiles_w);
            let [low, high] = difference.quantiles_w;
            format!(
                "{other} against {first}: undecided, between {} and +{} W",
                digits.rounded(low),
                digits.rounded(high)
            )
        }
    }
}

/// Explanation of the intervals.
pub(super) fn note(comparison: &Comparison) -> String {
    let is_drawn = comparison
        .finishes
        .iter()
        .any(|finish| finish.drawn_w().is_some());
    match is_drawn.then(Predictive::count) {
        None => "without an uncertainty of the loss".to_owned(),
        Some(draws) => format!(
            "medians of {draws} draws, in brackets their 5 and 95 % quantiles; all finishes share the draws, but model error and sampling of the flanks are drawn for each"
        ),
    }
}

/// Losses of the finishes run in; empty without `model.run_in`.
pub(super) fn run_in(comparison: &Comparison) -> Vec<String> {
    let of = |finish: &FinishResult| {
        let after = finish.run_in_loss_w?;
        let digits = match finish.drawn_w() {
            Some((_, quantiles)) => Digits::of_interval(quantiles),
            None => Digits::of_decimals(1),
        };
        Some(format!(
            "{} run in: {} W in place of {} W, both with every constant at its median",
            finish.name,
            digits.rounded(after),
            digits.rounded(finish.loss_w)
        ))
    };
    let mut lines: Vec<String> = comparison.finishes.iter().filter_map(of).collect();
    if !lines.is_empty() {
        lines.insert(
            0,
            "the table and the verdict are of the flanks as measured".to_owned(),
        );
    }
    lines
}

/// Scope of the comparison, with the efficiency of the gearbox if it is included.
pub(super) fn scope(comparison: &Comparison) -> String {
    let first = comparison.finishes.first();
    let Some(first) = first.and_then(|finish| finish.gearbox.as_ref()) else {
        return "scope mesh: without bearings, seals, churning".to_owned();
    };
    let with = |finish: &FinishResult| {
        let gearbox = finish.gearbox.as_ref()?;
        let efficiency = match finish.drawn_w() {
            Some((median, quantiles)) => {
                let percent = Digits::of_interval(quantiles).of_percent(gearbox.power_in_w);
                let median = median + gearbox.parts_w;
                percent.rounded(100.0 * (1.0 - median / gearbox.power_in_w))
            }
            None => format!("{:.4}", 100.0 * gearbox.efficiency),
        };
        Some(format!("{} {efficiency} %", finish.name))
    };
    let efficiencies: Vec<String> = comparison.finishes.iter().filter_map(with).collect();
    let losses: Vec<f64> = first.parts.iter().map(|part| part.loss_w).collect();
    let parts = first.parts.iter().zip(stated_parts(&losses));
    let parts = parts.map(|(part, loss)| format!("{} {loss}", part.name));
    format!(
        "scope gearbox: the values above are of the {}; with {} from the input and without a band ({}), the efficiency of the gearbox is {}",
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

/// Distinct warnings, with their finishes unless they apply to all.
fn warnings(comparison: &Comparison) -> String {
    let mut finishes_of: Vec<(&str, Vec<&str>)> = Vec::new();
    for finish in &comparison.finishes {
        for warning in &finish.warnings {
            match finishes_of.iter_mut().find(|(text, _)| text == warning) {
                Some((_, names)) => names.push(&finish.name),
                None => finishes_of.push((warning, vec![&finish.name])),
            }
        }
    }
    let lines = finishes_of.iter().map(|(warning, names)| {
        let whose = match names.len() == comparison.finishes.len() {
            true => String::new(),
            false => format!(" ({})", names.join(", ")),
        };
        let line = format!("{warning}{whose}");
        format!("{}\n", wrapped(&one_line(&line), "     "))
    });
    lines.collect()
}

#[cfg(test)]
mod tests {
    use super::texts;

    #[test]
    fn a_later_finish_has_a_difference_with_and_without_draws() {
        let later = texts((414.1, Some(6736.4)), None, None);
        assert_eq!(later, ["414.1", "-6322.3", "-93.9"]);
        let first = texts((6736.4, None), None, None);
        assert_eq!(first, ["6736.4", "reference", "reference"]);
    }
}
