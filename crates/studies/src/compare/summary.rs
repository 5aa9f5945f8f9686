//! The comparison for the terminal.

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
    text.push_str(&format!(
        "goes with the loss (rank correlation, {} windows)  {}\n",
        comparison.windows,
        best.join("   ")
    ));
    text
}
