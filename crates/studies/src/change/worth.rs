//! Words and tables of the worth of a change in a case.

use asperity::result::loss_band::Digits;
use asperity_core::{Estimate, capitalised};
use asperity_report::{Cell, Report, Table, columns};

use super::digits::height;
use super::in_case::{AFTER, BEFORE, ChangeInCase, FlankChange, RUN_IN, StateLoss};
use crate::compare::verdict;

/// Unit of a printed wear coefficient, in mm³/(N m).
const NANO: f64 = 1e-9;
const UNIT: &str = "1e-9 mm³/(N m)";

/// Difference of the losses before and after the test.
pub(super) fn loss_line(of: &ChangeInCase) -> String {
    match &of.difference {
        Some(difference) => {
            let names = ["the flanks before it", "the flanks after the test"];
            format!("{}.", capitalised(&verdict(names, difference)))
        }
        None => {
            let losses = [BEFORE, AFTER]
                .into_iter()
                .filter_map(|name| loss(of, name));
            let losses: Vec<String> = losses.collect();
            format!("The loss is {} the test.", losses.join(", "))
        }
    }
}

/// Sliding and wear coefficient of each flank.
pub(super) fn wear_lines(of: &ChangeInCase) -> impl Iterator<Item = String> {
    of.flanks.iter().map(wear)
}

fn loss(of: &ChangeInCase, name: &str) -> Option<String> {
    let found = of.loss(name)?.loss_w;
    Some(format!(
        "{} W {name}",
        Digits::of_power(found).rounded(found)
    ))
}

/// Sliding distance and wear coefficient of a flank.
fn wear(of: &FlankChange) -> String {
    let flank = of.flank.name();
    let place = if of.is_placed {
        " at this place,"
    } else {
        ", wherever it lies,"
    };
    let is_range = of.sliding_um.half_width() > 5e-7 * of.sliding_um.high;
    let digits_of = |sliding: Estimate| {
        if is_range {
            Digits::of_interval(sliding.ends())
        } else {
            Digits::of_power(sliding.high)
        }
    };
    let digits = digits_of(of.sliding_um);
    let sliding = if is_range {
        digits.interval_with(" µm", of.sliding_um)
    } else {
        format!("{} µm", digits.rounded(of.sliding_um.high))
    };
    let slid = format!(
        "The {flank} changed: in the mean over the trace{place} a point slides {sliding} per engagement"
    );
    let Some((count, metres)) = of.engagements.zip(of.sliding_m) else {
        return format!("{slid}.");
    };
    let in_all = of.sliding_um.map(|um| um * metres / of.sliding_um.value);
    let metres = digits_of(in_all).rounded(metres);
    let of_hardness = |k: f64| format!("K = k H is {k:.1e}");
    let coefficient = match (
        of.k_mm3_per_n_m,
        of.k_at_most_mm3_per_n_m,
        of.k_times_hardness,
    ) {
        (Some(k), _, Some(times)) => {
            let k = k.map(|k| k / NANO);
            let digits = Digits::of_interval(k.ends());
            format!(
                "is {} times {UNIT}, {}",
                digits.interval(k),
                of_hardness(times)
            )
        }
        (None, Some(most), Some(times)) => {
            let most = most / NANO;
            let text = Digits::of_power(most).rounded(most);
            format!(
                "is at most {text} times {UNIT}, {} at most",
                of_hardness(times)
            )
        }
        _ => {
            return format!(
                "{slid}, {metres} m in {count:e} engagements. It gained height, so that no wear coefficient follows."
            );
        }
    };
    format!(
        "{slid}, {metres} m in {count:e} engagements. Archard's wear coefficient k {coefficient}."
    )
}

/// Prediction of `operation.running_in` next to what was measured.
pub(super) fn run_in(of: &ChangeInCase) -> Option<String> {
    if let Some(why) = &of.no_run_in {
        return Some(format!(
            "There is no prediction by operation.running_in: {why}"
        ));
    }
    let [before, predicted, after] = [BEFORE, RUN_IN, AFTER].map(|name| of.loss(name));
    let losses = [before?, predicted?, after?];
    let [before, predicted, after] =
        losses.map(|loss| Digits::of_power(loss.loss_w).rounded(loss.loss_w));
    let both = match of.flanks.len() {
        1 => " It runs in both flanks, and one was measured.",
        _ => "",
    };
    let heights = of.flanks.iter().filter_map(|flank| {
        let predicted = flank.run_in_rq_um?;
        Some(format!(
            "Rq of the {} {:.3} µm, {:.3} µm were measured",
            flank.flank.name(),
            predicted,
            flank.after_rq_um
        ))
    });
    let heights: Vec<String> = heights.collect();
    Some(format!(
        "The flanks before the test lose {before} W, and run in by operation.running_in {predicted} W. The flanks measured after the test lose \
         {after} W. With the filters of the case, operation.running_in predicts {}.{both}",
        heights.join("; ")
    ))
}

/// Tables of the flanks and of the losses.
pub(super) fn sections<'a>(report: Report<'a>, of: &'a ChangeInCase) -> Report<'a> {
    report
        .section("In the case")
        .text([format!("{}: {}", of.case, of.conditions)])
        .on_page()
        .table(losses(of))
        .table(flanks(of))
        .table(roughness(of))
        .on_page()
}

/// A number with its interval, or that there is none.
fn interval(of: Option<Estimate>) -> Cell {
    match of {
        Some(of) => Cell::interval(of),
        None => Cell::estimate("-", None),
    }
}

fn losses(of: &ChangeInCase) -> Table {
    let shown = |loss: &StateLoss| match loss.drawn_w() {
        Some(drawn) => Cell::interval(drawn),
        None => Cell::number(loss.loss_w, |w| Digits::of_power(w).rounded(w)),
    };
    let table = columns! { loss in &of.states;
        head state "flanks" "" = loss.state;
        interval loss_w "loss" "W" = shown(loss);
        file loss_at_medians_w = Cell::optional(loss.loss_at_medians_w);
    };
    table.in_file("losses.csv")
}

fn flanks(of: &ChangeInCase) -> Table {
    let table = columns! { flank in &of.flanks;
        head flank "flank" "" = flank.flank.name();
        interval removed_nm "removed" "nm" = height(flank.removed_nm);
        interval sliding_um "sliding per engagement" "µm" = Cell::interval(flank.sliding_um);
        number engagements "engagements" "" "{:.3e}" = flank.engagements;
        interval k "k" "1e-9 mm³/(N m)" = interval(flank.k_mm3_per_n_m.map(|k| k.map(|k| k / NANO)));
        number k_at_most "k at most" "1e-9 mm³/(N m)" "{:.3}" = flank.k_at_most_mm3_per_n_m.map(|k| k / NANO);
        number k_times_hardness "k H" "" "{:.1e}" = flank.k_times_hardness;
        file before_rq_um = flank.before_rq_um;
        file after_rq_um = flank.after_rq_um;
        file run_in_rq_um = Cell::optional(flank.run_in_rq_um);
        file before_rpk_um = flank.before_rpk_um;
        file after_rpk_um = flank.after_rpk_um;
        file run_in_rpk_um = Cell::optional(flank.run_in_rpk_um);
    };
    let one_of_k = if of
        .flanks
        .iter()
        .any(|flank| flank.k_at_most_mm3_per_n_m.is_some())
    {
        "k"
    } else {
        "k at most"
    };
    // The sentences state the height removed and the engagements.
    let table = table.unshown_of(&["removed", "engagements", one_of_k]);
    table.in_file("flanks.csv")
}

/// Roughness of the flanks in the case.
fn roughness(of: &ChangeInCase) -> Table {
    let rows = of.flanks.iter().flat_map(|flank| {
        let rq = (
            "Rq",
            [flank.before_rq_um, flank.after_rq_um],
            flank.run_in_rq_um,
        );
        let rpk = (
            "Rpk",
            [flank.before_rpk_um, flank.after_rpk_um],
            flank.run_in_rpk_um,
        );
        [rq, rpk].map(|row| (flank.flank.name(), row))
    });
    let um = |value: &f64| format!("{value:.3}");
    columns! { (flank, (name, [before, after], run_in)) in rows;
        head flank "flank" "" = flank;
        text parameter "filters of the case" "" = name;
        number before "before" "µm" = Cell::number(before, |of| um(&of));
        number after "after" "µm" = Cell::number(after, |of| um(&of));
        number run_in "run in by the model" "µm" = Cell::number(run_in, |of| um(&of));
    }
}
