//! Summary of a sensitivity study for the terminal.

use asperity::result::loss_band::rounded;
use asperity_report::wrapped;
use asperity_storage::one_line;

use super::study::{Effect, Sensitivity, SensitivityRow};

/// Explanation of the numbers.
pub(super) const NOTE: &str = "Each row is a run of the model with one thing changed, at the same windows of the traces; in brackets \
    5 to 95 % by the sampling of the flanks. These are answers of the model, not measurements: what it leaves out or \
    has wrong, they leave out or have wrong.";

/// Summary of the study for the terminal.
pub(super) fn summary(study: &Sensitivity) -> String {
    let mut text = format!(
        "{}\nloss {:.0} W, and how it changes\n",
        one_line(&study.title),
        study.loss_w
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
            let code = row.refused.as_ref().map_or("", |refused| &refused.code);
            text.push_str(&format!(
                "{:width$} {:>20}\n",
                name(row),
                format!("- {code}")
            ));
            continue;
        };
        let parts = [
            effect.film_w,
            effect.lubricated_asperity_w,
            effect.boundary_w,
            effect.rolling_w,
        ];
        let [film, asperities, boundary, rolling] = parts.map(|part| part_text(part, effect));
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
        format!(
            "W431 losses are of the mesh; other losses of the case are ignored: {}",
            study.left_aside.join(", ")
        )
    })
}

/// The loss \[W\], with the two digits that the band of a loss usually justifies.
pub(super) fn headline(study: &Sensitivity) -> String {
    rounded(study.loss_w, study.loss_w)
}

/// The change \[W\] with its interval.
pub(super) fn difference(effect: &Effect) -> String {
    let half = digits(effect);
    let value = signed(&rounded(effect.difference_w, half));
    match effect.sampling_quantiles_w {
        Some([low, high]) if low < high => {
            let [low, high] = [low, high].map(|end| signed(&rounded(end, half)));
            format!("{value} ({low}..{high})")
        }
        _ => value,
    }
}

/// The change in percent.
pub(super) fn share(effect: &Effect) -> String {
    let whole = (effect.difference_w / effect.change).abs();
    let half = match whole.is_finite() {
        true => 100.0 * digits(effect) / whole,
        false => 1.0,
    };
    signed(&rounded(100.0 * effect.change, half))
}

/// A part of the change with the digits of the total.
pub(super) fn part_text(part: f64, effect: &Effect) -> String {
    signed(&rounded(part, digits(effect)))
}

/// Uncertainty that determines the digits of a change: its sampling error, or a fiftieth of the change.
fn digits(effect: &Effect) -> f64 {
    let least = 0.02 * effect.difference_w.abs();
    let sampling = effect
        .sampling_quantiles_w
        .map_or(0.0, |[low, high]| 0.5 * (high - low));
    let half = sampling.max(least);
    half.max(0.1)
}

fn signed(number: &str) -> String {
    let is_zero = number.chars().all(|c| "0.-".contains(c));
    match (is_zero, number.starts_with('-')) {
        (true, _) => "0".to_owned(),
        (false, true) => number.to_owned(),
        (false, false) => format!("+{number}"),
    }
}
