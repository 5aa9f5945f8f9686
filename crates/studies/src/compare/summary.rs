//! The comparison for the terminal.

use asperity_report::wrapped;

use super::comparison::{CONFIDENCE, Comparison};

/// The comparison for the terminal.
pub fn summary(comparison: &Comparison) -> String {
    let mut text = format!("{}\n", comparison.title);
    let width = comparison
        .finishes
        .iter()
        .map(|f| f.name.chars().count())
        .max()
        .unwrap_or(0)
        .max(8);
    text.push_str(&format!(
        "{:width$}  {:>10}  {:>20}  {:>24}\n",
        "finish", "efficiency", "loss W", "difference W"
    ));
    for finish in &comparison.finishes {
        let difference = match &finish.difference_w {
            None => "reference".to_owned(),
            Some(interval) => format!("{:+.1}{}", interval.mean, interval.spread()),
        };
        text.push_str(&format!(
            "{:width$}  {:>8.4} %  {:>20}  {difference:>24}\n",
            finish.name,
            100.0 * finish.efficiency,
            format!("{:.1}{}", finish.loss_w.mean, finish.loss_w.spread()),
        ));
    }
    let offsets = comparison
        .finishes
        .first()
        .map_or(0, |finish| finish.offsets.len());
    text.push_str(&format!(
        "± is a {:.0} % interval of Student's t over {offsets} offsets, differences offset by offset\n",
        100.0 * CONFIDENCE
    ));
    let best: Vec<String> = comparison
        .correlations
        .iter()
        .take(4)
        .map(|found| format!("{} {:+.2}", found.parameter, found.with_loss))
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

/// Every warning once, with the finishes it is about unless it is about all.
fn warnings(comparison: &Comparison) -> String {
    let mut found: Vec<(&str, Vec<&str>)> = Vec::new();
    for finish in &comparison.finishes {
        for warning in &finish.warnings {
            match found.iter_mut().find(|(text, _)| text == warning) {
                Some((_, names)) => names.push(&finish.name),
                None => found.push((warning, vec![&finish.name])),
            }
        }
    }
    let told = found.iter().map(|(warning, names)| {
        let whose = match names.len() == comparison.finishes.len() {
            true => String::new(),
            false => format!(" ({})", names.join(", ")),
        };
        format!("{}\n", wrapped(&format!("{warning}{whose}"), "     "))
    });
    told.collect()
}
