//! Losses by other models and by published friction laws.

use asperity::result::loss_band::Uncertainty;
use asperity::result::{PublishedLawRow, PublishedOutcome, RunResult};
use asperity_core::numerics;

use crate::printed::watts;
use crate::{Table, columns};

/// The loss by models that records or measurements contradict, and over the boundary share that is drawn.
pub(crate) fn models(uncertainty: &Uncertainty) -> Table {
    let digits = uncertainty.digits();
    columns! { row in uncertainty.models();
        head name "model" "";
        number loss "loss" "W" = row.loss_w.map_or("no solution".to_owned(), |loss| digits.rounded(loss));
        text standing "against it" "" = row.standing();
    }
}

/// The losses by other models that are outside of the interval, in words; `None` if there are none.
pub(crate) fn outside(uncertainty: &Uncertainty) -> Option<String> {
    let drawn = uncertainty.loss.drawn();
    let losses = uncertainty.other_models.iter();
    let losses = losses.filter_map(|row| row.loss_w);
    let outside: Vec<f64> = losses.filter(|loss| !drawn.contains(*loss)).collect();
    let (below, above): (Vec<f64>, Vec<f64>) =
        outside.iter().copied().partition(|loss| *loss < drawn.low);
    // An end that is printed as the end of the interval is not named.
    let side = |losses: &[f64], words: [&str; 2], farthest: f64, end: f64| {
        let [farthest, end] = [farthest, end].map(|loss| uncertainty.digits().rounded(loss));
        let count = losses.len();
        (count > 0).then(|| {
            if farthest == end {
                format!("{count} just {}", words[0])
            } else {
                format!("{count} {}, {} to {farthest} W", words[0], words[1])
            }
        })
    };
    let [lowest, highest] = numerics::range(outside.iter().copied());
    let sides = [
        side(&below, ["below", "down"], lowest, drawn.low),
        side(&above, ["above", "up"], highest, drawn.high),
    ];
    let sides: Vec<String> = sides.into_iter().flatten().collect();
    let beside = match uncertainty.structures.len() {
        0 => String::new(),
        count => format!(" in addition to the {count} sampled ones"),
    };
    (!sides.is_empty()).then(|| {
        format!(
            "{} of {} other models{} give a loss outside of this interval: {}.",
            outside.len(),
            uncertainty.other_models.len(),
            beside,
            sides.join(", and ")
        )
    })
}

/// The loss by published laws, each instead of film and asperity friction.
pub(crate) fn published_laws(result: &RunResult) -> Table {
    columns! { entry in &result.published_laws;
        head law "law" "";
        number loss "loss" "" = loss(entry);
        text asperities "asperities" "" = if entry.includes_asperities { "included" } else { "film only" };
        text range "range" "" = range(entry);
    }
}

fn loss(entry: &PublishedLawRow) -> String {
    match &entry.outcome {
        PublishedOutcome::Applied { loss_w, .. } => watts(*loss_w),
        _ => "-".to_owned(),
    }
}

/// Whether the law applies here, and why not.
fn range(entry: &PublishedLawRow) -> String {
    match (&entry.outcome, entry.inside_its_range) {
        (PublishedOutcome::Refused(why), _) => why.clone(),
        (_, true) => "inside".to_owned(),
        (_, false) => format!("outside: {}", entry.outside.join("; ")),
    }
}
