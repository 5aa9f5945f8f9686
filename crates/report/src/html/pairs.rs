//! Several traces of a flank: loss of every pair of teeth, and contributions to the error of their mean.

use asperity::result::loss_band::{PairSampling, rounded};
use asperity::result::{ToothTrace, TracePairs};
use maud::{Markup, html};

use crate::summary::two_digits;

pub(super) fn section(pairs: &TracePairs, sampling: &PairSampling) -> Markup {
    let watts = |power: f64| rounded(power, sampling.half_width_w);
    let [pinion, wheel] = sampling.traces;
    let [s1, s2] = sampling.between_w;
    html! {
        h3 { "The traced teeth, pair by pair" }
        p {
            (pinion) " traced teeth of the pinion on " (wheel) " of the wheel: the mean loss is " (watts(sampling.mean_w)) " W, standard error "
            (two_digits(sampling.standard_error_w)) " W with " (format!("{:.1}", sampling.freedom)) " degrees of freedom" (sampling.bound()) "."
            " Between the teeth of the pinion the loss scatters by " (two_digits(s1)) " W (s₁), between those of the wheel by "
            (two_digits(s2)) " W (s₂), and from pair to pair by further " (two_digits(sampling.interaction_w)) " W (s₁₂)."
        }
        div.scroll { table {
            thead { tr {
                th { "loss, W" }
                @for tooth in 1..=wheel { th.number { "wheel " (tooth) } }
            } }
            tbody { @for (k, row) in pairs.losses_w.iter().enumerate() { tr {
                th scope="row" { "pinion " (k + 1) }
                @for loss in row { td.number { (format!("{loss:.2}")) } }
            } } }
        } }
    }
}

/// The traces with their roughness parameters.
pub(super) fn traces(pairs: &TracePairs) -> Markup {
    let flanks = ["pinion", "wheel"].into_iter().zip(&pairs.traces);
    let um = |value: f64| format!("{:.3}", 1e6 * value);
    html! {
        p { "The charts below are of the first trace of each flank." }
        div.scroll { table {
            thead { tr {
                th { "tooth" } th { "trace" } th.number { "y, mm" } th.number { "Rq, µm" } th.number { "Rz, µm" } th.number { "Rpk, µm" }
            } }
            tbody { @for (name, traces) in flanks { @for trace in traces { tr {
                th scope="row" { (name) " " (trace.tooth) @if let Some(number) = trace.tooth_number { " (tooth " (number) ")" } }
                td { code { (file(trace)) } }
                td.number { @match trace.y_mm { Some(y) => (format!("{y:.2}")), None => "-" } }
                @match &trace.record.parameters {
                    Some(parameters) => {
                        td.number { (um(parameters.heights.rq.si())) } td.number { (um(parameters.heights.rz.si())) }
                        td.number { (um(parameters.material.rpk.si())) }
                    }
                    None => { td.number { "-" } td.number { "-" } td.number { "-" } }
                }
            } } } }
        } }
    }
}

fn file(trace: &ToothTrace) -> &str {
    trace.record.file.as_deref().unwrap_or("roughness values")
}
