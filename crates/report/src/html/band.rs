//! The uncertainty of the loss: its components, constants and structures, and the losses of other models.

use asperity::result::loss_band::{DrawnConstant, EvidenceRow, SamplingPart, Uncertainty};
use asperity_core::Estimate;
use maud::{Markup, html};

use crate::chart::{Axis, Drawing, Interval, Tornado};
use crate::columns;
use crate::other_models::models;
use crate::printed::duration;

/// The measurements that narrow each component: the fold below the chart.
pub(super) fn remedies(uncertainty: &Uncertainty) -> Markup {
    let digits = uncertainty.digits();
    html! {
        details {
            summary { "All components, and what narrows them" }
            (columns! { part in &uncertainty.loss.parts;
                head name "component" "";
                number low "5 %" "W" = digits.rounded(part.quantiles_w[0]);
                number high "95 %" "W" = digits.rounded(part.quantiles_w[1]);
                text remedy "to narrow it" "";
            })
        }
    }
}

/// The measurements that would narrow the interval most, and the quickest one, with each `loss` rounded.
pub(crate) fn evidence(rows: &[EvidenceRow], loss: &dyn Fn(f64) -> String) -> Markup {
    const SHOWN: usize = 3;
    /// Largest width that is left by a measurement that is shown for its few hours.
    const WORTH: f64 = 0.95;
    let (first, others) = rows.split_at(SHOWN.min(rows.len()));
    let hours = |row: &&EvidenceRow| row.hours;
    let others = others.iter().filter(|row| row.width < WORTH);
    let quickest = others.min_by(|a, b| hours(a).total_cmp(&hours(b)));
    let quickest = quickest.filter(|row| first.iter().all(|one| one.hours > row.hours));
    html! { h3 { "What would narrow the interval most" } @if rows.is_empty() {
        p { "The command " code { "asperity evidence" } " lists the measurements that would narrow the interval, of a gear train as a whole." }
    } @else {
        (columns! { row in first.iter().chain(quickest);
            head measurement "measurement" "";
            number hours "duration" "" = duration(60.0 * row.hours);
            number width "remaining width" "" = row.width_percent();
            number loss "loss" "W" = row.interval().map(loss).join("..");
        })
        p.note { "Remaining width: expected interval of ln loss over the present one. Duration: measuring with preparation, without the making of parts. " code { "asperity evidence" } " has all measurements." }
    } }
}

/// The method of the draws, the constants, and other models.
pub(super) fn section(uncertainty: &Uncertainty) -> Markup {
    html! {
        p {
            "The median and the 5 to 95 % of the loss are over " (uncertainty.draws) " samples. The samples interpolate "
            (uncertainty.evaluations) " evaluations (error of ln loss " (format!("{:.4}", uncertainty.interpolation_error))
            "). Each component is sampled alone."
        }
        p { "Sampling of the flanks: " (sampling(&uncertainty.sampling)) "." }
        h3 { "Constants" }
        (columns! { constant in &uncertainty.constants;
            head name "constant" "" = format!("{}{}", constant.name, if constant.is_calibrated { " (calibrated)" } else { "" });
            number value "median" "" = &values(constant)[0];
            number low "from" "" = &values(constant)[1];
            number high "to" "" = &values(constant)[2];
        })
        @if !uncertainty.held.is_empty() {
            p { "Not varied, because the case states it: " (uncertainty.held.join(", ")) "." }
        }
        h3 { "Other models, and the evidence against them" }
        p { "Each other model has its constants at their medians; its loss is scaled as the run to the median of the samples. The samples use no model with evidence against it. The loss of such a model may still be inside the interval." }
        (models(uncertainty))
    }
}

/// The sampling of the flanks in words.
fn sampling(part: &SamplingPart) -> String {
    match part {
        SamplingPart::Windows(windows) => format!(
            "{:.1} of {} windows count as independent, standard error of ln loss {:.3}, of the mean over these traces {:.3}",
            windows.effective_windows,
            windows.offsets,
            windows.standard_error,
            windows.numerical_error,
        ),
        SamplingPart::Pairs(pairs) => {
            let bound = pairs.bound();
            let misplaced = pairs.misplaced_w.map_or(String::new(), |[down, up]| {
                format!("; with the traces shifted by two half-widths {down:+.1} and {up:+.1} W")
            });
            format!(
                "{} pairs of traced teeth{bound}, standard error {:.2} W{misplaced}",
                pairs.pairs(),
                pairs.standard_error_w
            )
        }
        SamplingPart::OnePair([down, up]) => {
            format!(
                "one pair of placed traces; each shifted by two half-widths {down:+.1} and {up:+.1} W"
            )
        }
        SamplingPart::None(why) => why.clone(),
        _ => "-".to_owned(),
    }
}

/// Value and range of a constant as text.
pub(super) fn values(constant: &DrawnConstant) -> [String; 3] {
    let (factor, unit, digits) = match constant.unit.as_str() {
        "m" => (1e9, " nm", 1),
        "Pa" => (1e-6, " MPa", 1),
        "1/Pa" => (1e9, " 1/GPa", 1),
        "K" => (1.0, " K", 1),
        _ => (1.0, "", 3),
    };
    let Estimate { value, low, high } = constant.drawn();
    [value, low, high].map(|value| format!("{:.digits$}{unit}", factor * value))
}

/// Components in the picture; the table below it has all.
const LARGEST: usize = 6;

/// The interval of the loss and of its largest components, about the median.
pub(super) fn tornado(uncertainty: &Uncertainty) -> Drawing {
    let digits = uncertainty.digits();
    let interval = |name: &str, ends: [f64; 2]| Interval {
        name: name.to_owned(),
        ends,
        middle: None,
        text: ends.map(|loss| digits.rounded(loss)).join("..") + " W",
    };
    let all = interval("all together", uncertainty.loss.drawn().ends());
    let parts = uncertainty.loss.parts.iter().take(LARGEST);
    let parts = parts.filter(|part| digits.steps(part.half_range_w()) > 0.0);
    let parts = parts.map(|part| interval(&part.name, part.quantiles_w));
    Drawing::Tornado(Tornado {
        id: "band".to_owned(),
        title: "Interval of the loss, 5 to 95 %, and of its largest components".to_owned(),
        source: "result.json".to_owned(),
        axis: Axis::new("loss", "W"),
        middle: Some(uncertainty.loss.drawn().value),
        intervals: std::iter::once(all).chain(parts).collect(),
    })
}
