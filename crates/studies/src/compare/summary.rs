//! Summary of a comparison for the terminal.

use asperity_report::{stated, stated_parts, wrapped};
use asperity_storage::one_line;

use asperity::result::loss_band::rounded;

use super::comparison::{Comparison, FinishResult};

/// Summary of a comparison for the terminal.
pub(super) fn summary(comparison: &Comparison) -> String {
    let mut text = format!("{}\n", one_line(&comparison.title));
    let width = comparison
        .finishes
        .iter()
        .map(|f| f.name.chars().count())
        .max()
        .unwrap_or(0)
        .max(8);
    text.push_str(&format!(
        "{:width$}  {:>10}  {:>18}  {:>20}  {:>22}\n",
        "finish", "efficiency", "loss W", "minus the first W", "change %"
    ));
    for finish in &comparison.finishes {
        let [loss, difference, change] = cells(finish);
        text.push_str(&format!(
            "{:width$}  {:>8} %  {loss:>18}  {difference:>20}  {change:>22}\n",
            one_line(&finish.name),
            efficiency(finish),
        ));
    }
    text.push_str(&format!("{}\n", wrapped(&note(comparison), "  ")));
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

/// Efficiency in percent, with the digits that its band justifies.
pub(super) fn efficiency(finish: &FinishResult) -> String {
    let [low, high] = finish.quantiles_w;
    let half = 50.0 * (high - low) / finish.power_in_w;
    rounded(100.0 * finish.efficiency, half)
}

/// Loss, difference and change of a finish, each with its quantiles.
pub(super) fn cells(finish: &FinishResult) -> [String; 3] {
    let banded = |value: f64, [low, high]: [f64; 2], sign: bool| {
        let half = 0.5 * (high - low);
        let text = |value: f64| match (sign, half == 0.0 && value == 0.0) {
            (_, true) => "0".to_owned(),
            (true, _) if value > 0.0 => format!("+{}", rounded(value, half)),
            _ => rounded(value, half),
        };
        format!("{} ({}..{})", text(value), text(low), text(high))
    };
    let loss = banded(finish.loss_w, finish.quantiles_w, false);
    match &finish.difference {
        None => [loss, "reference".to_owned(), "reference".to_owned()],
        Some(difference) => [
            loss,
            banded(difference.nominal_w, difference.quantiles_w, true),
            banded(
                100.0 * difference.nominal_share,
                difference.share_quantiles.map(|share| 100.0 * share),
                true,
            ),
        ],
    }
}

/// Explanation of the bands.
pub(super) fn note(comparison: &Comparison) -> String {
    let bands = comparison.finishes.iter().filter_map(|f| f.band.as_ref());
    let mut names: Vec<&str> = Vec::new();
    for parameter in bands.clone().flat_map(|band| &band.parameters) {
        if !names.contains(&parameter.name.as_str()) {
            names.push(&parameter.name);
        }
    }
    let draws = bands.map(|band| band.draws).max().unwrap_or(0);
    if names.is_empty() {
        return "in brackets 5 to 95 % by the sampling of the flanks".to_owned();
    }
    format!(
        "in brackets 5 to 95 % over {draws} draws of {}, the same for every finish, and the sampling of the flanks",
        names.join(", ")
    )
}

/// Scope of the comparison, with the efficiency of the gearbox if it is included.
pub(super) fn scope(comparison: &Comparison) -> String {
    let first = comparison.finishes.first();
    let Some(first) = first.and_then(|finish| finish.gearbox.as_ref()) else {
        return "scope mesh: without bearings, seals, churning".to_owned();
    };
    let with = |finish: &FinishResult| {
        let gearbox = finish.gearbox.as_ref()?;
        let half = 50.0 * (finish.quantiles_w[1] - finish.quantiles_w[0]) / gearbox.power_in_w;
        let efficiency = rounded(100.0 * gearbox.efficiency, half);
        Some(format!("{} {efficiency} %", finish.name))
    };
    let efficiencies: Vec<String> = comparison.finishes.iter().filter_map(with).collect();
    let losses: Vec<f64> = first.parts.iter().map(|part| part.loss_w).collect();
    let parts = first.parts.iter().zip(stated_parts(&losses));
    let parts = parts.map(|(part, loss)| format!("{} {loss}", part.name));
    format!(
        "scope gearbox: the values above are of the mesh; with {} from the input and without a band ({}), the efficiency of the gearbox is {}",
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
