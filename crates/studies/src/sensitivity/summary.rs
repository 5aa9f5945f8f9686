//! Summary of a sensitivity study for the terminal.

use asperity::message::Warning;
use asperity::result::loss_band::{Digits, rounded};
use asperity_core::Code;
use asperity_report::wrapped;
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
    let name = |row: &SensitivityRow| format!("{} -> {}", row.what, row.to);
    let width = study.rows.iter().map(|row| name(row).chars().count());
    let width = width.max().unwrap_or(0);
    text.push_str(&format!(
        "{:width$} {:>20} {:>8} {:>7} {:>10} {:>9} {:>8}\n",
        "", "W", "%", "film", "asperities", "boundary", "rolling"
    ));
    for row in &study.rows {
        let Some(effect) = &row.effect else {
            let code = row
                .refused
                .as_ref()
                .map_or("", |refused| refused.code.as_str());
            text.push_str(&format!(
                "{:width$} {:>20}\n",
                name(row),
                format!("- {code}")
            ));
            continue;
        };
        let [film, asperities, boundary, rolling] = parts(effect);
        text.push_str(&format!(
            "{:width$} {:>20} {:>8} {film:>7} {asperities:>10} {boundary:>9} {rolling:>8}\n",
            name(row),
            difference(effect),
            share(effect),
        ));
    }
    for row in &study.rows {
        if let Some(refused) = &row.refused {
            let line = format!("{}: {} {}", name(row), refused.code, refused.message);
            text.push_str(&format!("{}\n", wrapped(&line, "  ")));
        }
    }
    text.push_str(&format!("{}\n", wrapped(NOTE, "")));
    if let Some(note) = left_aside(study) {
        text.push_str(&format!("{}\n", wrapped(&note, "     ")));
    }
    text
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
pub(super) fn parts(effect: &Effect) -> [String; 4] {
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
