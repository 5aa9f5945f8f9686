//! The ridges that cost most, in words.

use asperity::result::RunResult;
use asperity::result::loss_band::{Digits, rounded};
use asperity::result::ridges::{RidgeRow, Ridges};
use asperity_core::Estimate;

/// Explanation of the numbers.
pub const NOTE: &str = "A ridge is a part of a prepared trace above its mean line. Its saving uses the mean of the gradients of the \
    loss before, half-way and after the removal of all listed ridges. The saving by all of them together is from a second run. \
    The ridges are numbered by first_order_w of ridges.csv, the saving by the gradient before the removal. measured_first_order_w \
    is computed in the same way on the unfiltered trace, whose filtered mean line moves too. It is empty if the preparation is \
    not linear. These values are with the constants at their \
    medians; in brackets are the 5 and 95 % quantiles. Sets of the contacts, windows and relief are fixed in the gradient. \
    Running-in, which removes ridges too, is not included. These are answers of the model, not measurements. \
    docs/howto/what-matters.md describes the method.";

/// Least uncertainty of printed watts.
const LEAST_W: f64 = 0.5;

/// Watts with the digits that a scatter of a tenth over the windows leaves, and at most one decimal.
pub fn watts(value: f64) -> String {
    rounded(value, (0.1 * value.abs()).max(LEAST_W))
}

/// The saving of all listed ridges together, by a run, as a sentence.
pub fn verdict(ridges: &Ridges) -> String {
    format!("Removing {}.", saving(ridges))
}

/// The listed ridges and what removing them saves.
fn saving(ridges: &Ridges) -> String {
    let saved = ridges.loss_at_medians_w - ridges.pressed_at_medians_w;
    let sampled = ridges.sampling_quantiles_w.map(|[low, high]| [-high, -low]);
    let quantiles = ridges.saving_quantiles_w.or(sampled);
    format!(
        "the {} costliest ridges down to the mean line saves {}",
        ridges.rows.len(),
        with_interval(saved, quantiles, " W")
    )
}

/// Ridges in the report of a run, named in sentences, and marked on the traces by their cost only.
const LISTED: usize = 5;

/// Whether the saving of a ridge has an interval above zero, as printed.
fn is_certain(row: &RidgeRow) -> bool {
    let ends = row.low_w.zip(row.high_w);
    ends.is_some_and(|(low, high)| digits([low, high]).steps(low) > 0.0)
}

/// Digits of watts by their quantiles.
fn digits([low, high]: [f64; 2]) -> Digits {
    Digits::of_uncertainty((0.5 * (high - low)).max(LEAST_W))
}

/// The costliest ridges and those that [`certain`] names, with their numbers from 1.
pub fn listed(ridges: &Ridges) -> impl Iterator<Item = (usize, &RidgeRow)> {
    let is_named = ridges.rows.iter().filter(|row| is_certain(row)).count() <= LISTED;
    let rows = (1..).zip(&ridges.rows);
    rows.filter(move |(number, row)| *number <= LISTED || (is_named && is_certain(row)))
}

/// The ridges whose saving has an interval above zero, in words; `None` without intervals.
pub fn certain(ridges: &Ridges) -> Option<String> {
    if ridges.rows.iter().all(|row| row.low_w.is_none()) {
        return None;
    }
    /// Most ridges that are named with their places.
    const PLACED: usize = 3;
    let above = (1..).zip(&ridges.rows).filter(|(_, row)| is_certain(row));
    let above: Vec<(usize, &RidgeRow)> = above.collect();
    let place = |(number, row): &(usize, &RidgeRow)| {
        if above.len() <= PLACED {
            format!("{number} ({} at {:.3} mm)", row.flank, row.place_mm)
        } else {
            number.to_string()
        }
    };
    let above: Vec<String> = above.iter().map(place).collect();
    let of_all = format!("of the {} ridges", ridges.rows.len());
    Some(match &above[..] {
        [] => format!("None {of_all} has an interval above zero by itself."),
        [only] => format!("Only ridge {only} has an interval above zero by itself."),
        [first @ .., last] if above.len() <= LISTED => {
            format!(
                "Only ridges {} and {last} have intervals above zero by themselves.",
                first.join(", ")
            )
        }
        many => format!(
            "{} {of_all} have intervals above zero by themselves.",
            many.len()
        ),
    })
}

/// Saving by a ridge with its interval, according to the mean of the gradients.
pub fn saving_of(row: &RidgeRow) -> String {
    let quantiles = row.low_w.zip(row.high_w).map(|(low, high)| [low, high]);
    with_interval(row.mean_gradient_w, quantiles, "")
}

/// Watts with their quantiles and the digits that these leave.
fn with_interval(value: f64, quantiles: Option<[f64; 2]>, unit: &str) -> String {
    match quantiles {
        Some([low, high]) if low < high => {
            let estimate = Estimate { value, low, high };
            digits([low, high]).interval_with(unit, estimate)
        }
        _ => format!("{}{unit}", watts(value)),
    }
}

/// The content of the intervals, the parts of the loss that the numbers leave out, and their factor by the heat balance.
pub fn notes(ridges: &Ridges) -> Vec<String> {
    let mut notes = Vec::new();
    let (drawn, sampled) = (ridges.saving_quantiles_w, ridges.sampling_quantiles_w);
    let content = match (drawn.is_some(), sampled.is_some()) {
        (true, true) => Some("the constants, the model and the sampling of the flanks"),
        (true, false) => Some("the constants and the model, without the sampling of the flanks"),
        (false, true) => {
            Some("the sampling of the flanks only, with the constants at their medians")
        }
        (false, false) => None,
    };
    if let Some(content) = content {
        notes.push(format!("The quantiles are over {content}."));
    }
    if let Some(pairs) = ridges.first_of_pairs {
        notes.push(format!(
            "The case has {pairs} pairs of teeth. All these numbers, also the loss, are of the first trace of each flank only; \
             other teeth have other ridges."
        ));
    }
    if ridges.without_gearbox {
        notes.push(
            "Only the mesh: the losses of bearings, seals, churning and other parts of the gearbox are left out."
                .to_owned(),
        );
    }
    if ridges.unresolved_w > 0.0 {
        notes.push(format!(
            "{} W of sliding loss are where the traces do not resolve the contact; the gradient leaves them out.",
            watts(ridges.unresolved_w)
        ));
    }
    if ridges.heat_balance != 1.0 {
        notes.push(format!(
            "The bulk temperature follows from the loss: it multiplies every change by {:.2}.",
            ridges.heat_balance
        ));
    }
    notes
}

/// The line of a run: the saving, or why there is none; `None` if the ridges were not sought.
pub fn line(result: &RunResult) -> Option<String> {
    let found = result.ridges.as_ref();
    let found = found.map(|ridges| format!("removing {}", saving(ridges)));
    let none = || Some(format!("not computed: {}", result.no_ridges.as_ref()?));
    Some(format!("ridges: {}", found.or_else(none)?))
}
