//! Summary of a sensitivity study for the terminal.

use asperity::message::Warning;
use asperity::result::loss_band::{Digits, rounded};
use asperity_core::Code;
use asperity_report::{Cell, Table, columns, wrapped};
use asperity_storage::one_line;

use super::study::{Effect, Sensitivity, SensitivityRow};

/// Explanation of the numbers.
pub(super) const NOTE: &str = "Each row is a run of the model with one thing changed, at the same windows of the traces; in brackets \
    5 to 95 % by the sampling of the flanks. Other cut-offs leave other lengths of the traces, hence other windows. These are answers of the model, not measurements: what it leaves out or \
    has wrong, they leave out or have wrong.";

/// Summary of the study for the terminal.
pub(super) fn summary(study: &Sensitivity) -> String {
    let mut text = format!(
        "{}\n{}, and how it changes\n",
        one_line(&study.title),
        headline(study)
    );
    text.push_str(&table(study).without(&["of"]).text(""));
    for line in refused(study) {
        text.push_str(&format!("{}\n", wrapped(&line, "  ")));
    }
    text.push_str(&format!("{}\n", wrapped(NOTE, "")));
    if let Some(note) = left_aside(study) {
        text.push_str(&format!("{}\n", wrapped(&note, "     ")));
    }
    text
}

/// The changes of the loss and of its parts; "-" where the model refuses the change.
pub(super) fn table(study: &Sensitivity) -> Table {
    let rows = study.rows.iter().map(|row| {
        let effect = row.effect.as_ref();
        let parts: [Option<String>; 4] = match effect {
            Some(effect) => parts(effect).map(Some),
            None => Default::default(),
        };
        (row, of_to(row), effect, parts)
    });
    columns! { (row, [what, to], effect, [film, lubricated, boundary, rolling]) in rows;
        text group "of" "" = &row.group;
        text what "change" "" = what;
        text to "to" "" = to;
        number loss "loss" "W" = Cell::optional(effect.map(difference));
        number share "loss" "%" = Cell::optional(effect.map(share));
        number film "film" "W" = Cell::optional(film);
        number lubricated "lubricated asperities" "W" = Cell::optional(lubricated);
        number boundary "boundary layer" "W" = Cell::optional(boundary);
        number rolling "rolling" "W" = Cell::optional(rolling);
    }
}

/// The changes that the model refuses, with the reasons.
pub(super) fn refused(study: &Sensitivity) -> Vec<String> {
    let line = |row: &SensitivityRow| {
        let refused = row.refused.as_ref()?;
        Some(format!(
            "{}: {} {}",
            named(row),
            refused.code,
            refused.message
        ))
    };
    study.rows.iter().filter_map(line).collect()
}

/// The change in words.
pub(super) fn named(row: &SensitivityRow) -> String {
    let [what, to] = of_to(row);
    format!("{what} → {to}")
}

/// The changed key and its new value.
fn of_to(row: &SensitivityRow) -> [String; 2] {
    [&row.what, &row.to].map(|text| text.replace(" um", " µm"))
}

/// W431, if the case states a gearbox.
pub(super) fn left_aside(study: &Sensitivity) -> Option<String> {
    (!study.left_aside.is_empty()).then(|| {
        let text = format!(
            "losses are of the mesh; other losses of the case are ignored: {}",
            study.left_aside.join(", ")
        );
        Warning::new(Code::W431, text).to_string()
    })
}

/// The loss that the changes are relative to, with three digits: at given windows and constants it has no interval.
pub(super) fn headline(study: &Sensitivity) -> String {
    let loss = rounded(study.loss_w, 0.01 * study.loss_w);
    format!("loss {loss} W at the medians of all constants")
}

/// The change \[W\] with its interval.
pub(super) fn difference(effect: &Effect) -> String {
    let digits = digits(effect);
    let text = |value: f64| signed(&digits.rounded(value));
    match effect.sampling_quantiles_w {
        Some([low, high]) if low < high => {
            format!(
                "{} ({}..{})",
                text(effect.difference_w),
                text(low),
                text(high)
            )
        }
        _ => change(effect),
    }
}

/// The change \[W\].
pub(super) fn change(effect: &Effect) -> String {
    signed(&digits(effect).rounded(effect.difference_w))
}

/// The change in percent.
pub(super) fn share(effect: &Effect) -> String {
    let whole = (effect.difference_w / effect.change).abs();
    let half = match whole.is_finite() {
        true => 100.0 * half_width(effect) / whole,
        false => 1.0,
    };
    signed(&rounded(100.0 * effect.change, half))
}

/// The parts of the change with the digits of the total, to which they add up.
fn parts(effect: &Effect) -> [String; 4] {
    let digits = digits(effect);
    let parts = effect.parts();
    let steps = digits.parts(digits.steps(effect.difference_w), &parts);
    std::array::from_fn(|k| signed(&digits.text(steps[k])))
}

fn digits(effect: &Effect) -> Digits {
    Digits::of_uncertainty(half_width(effect))
}

/// Uncertainty that determines the digits of a change \[W\]: its sampling error, or a fiftieth of the change.
fn half_width(effect: &Effect) -> f64 {
    const LEAST_W: f64 = 0.1;
    let least = 0.02 * effect.difference_w.abs();
    let sampling = effect
        .sampling_quantiles_w
        .map_or(0.0, |[low, high]| 0.5 * (high - low));
    sampling.max(least).max(LEAST_W)
}

fn signed(number: &str) -> String {
    let is_zero = number.chars().all(|c| "0.-".contains(c));
    match (is_zero, number.starts_with('-')) {
        (true, _) => "0".to_owned(),
        (false, true) => number.to_owned(),
        (false, false) => format!("+{number}"),
    }
}
