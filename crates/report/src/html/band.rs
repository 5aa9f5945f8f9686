//! The band of the loss: its contributions, and the losses of alternative models.

use asperity::result::loss_band::{BandParameter, LossBand, SamplingPart, rounded};
use maud::{Markup, html};

use crate::chart::{Axis, Bar, BarChart, Drawing};

pub(super) fn section(band: &LossBand) -> Markup {
    html! {
        h3 { "Contributions to the band" }
        p {
            "5 to 95 % of the loss over " (band.draws) " draws of the parameters below, each with the sampling of the flanks; the nominal \
            loss is computed with the defaults, which are not the centre of the draws. Trust: " (band.trust.text()) "."
        }
        div.scroll { table {
            thead { tr { th { "parameter" } th.number { "default" } th.number { "from" } th.number { "to" } th.number { "change of the loss" } } }
            tbody {
                @for parameter in &band.parameters {
                    @let [value, low, high] = values(parameter);
                    tr {
                        th scope="row" { (parameter.name) @if parameter.is_calibrated { " (calibrated)" } }
                        td.number { (value) } td.number { (low) } td.number { (high) }
                        td.number { (format!("{:+.0} W", parameter.effect_w)) }
                    }
                }
                tr {
                    th scope="row" { "sampling of the flanks" }
                    @match &band.sampling {
                        SamplingPart::Windows(sampling) => {
                            td colspan="3" {
                                (format!("{:.1} of {} windows count as independent", sampling.effective_windows, sampling.offsets))
                            }
                            td.number { (format!("±{} W (95 %)", rounded(sampling.half_width_w, sampling.half_width_w))) }
                        }
                        SamplingPart::Pairs(sampling) => {
                            td colspan="3" {
                                (sampling.pairs()) " pairs of traced teeth"
                                @if let Some(gear) = sampling.not_sampled() { ", " (gear) " not sampled: lower bound" }
                                @if let Some([down, up]) = sampling.misplaced_w {
                                    (format!("; with the traces shifted by two half-widths {down:+.1} and {up:+.1} W"))
                                }
                            }
                            td.number { (format!("±{} W (95 %)", rounded(sampling.half_width_w, sampling.half_width_w))) }
                        }
                        SamplingPart::OnePair([down, up]) => {
                            td colspan="3" { "one pair of placed traces; each shifted by two half-widths" }
                            td.number { (format!("{down:+.1} and {up:+.1} W")) }
                        }
                        SamplingPart::None(why) => { td colspan="3" { (why) } td.number { "-" } }
                        _ => { td colspan="4" { "-" } }
                    }
                }
            }
        } }
        @if !band.held.is_empty() {
            p { "Not varied, because the case states it: " (band.held.join(", ")) "." }
        }
    }
}

/// Value and range of a parameter as text.
fn values(parameter: &BandParameter) -> [String; 3] {
    let (factor, unit) = match parameter.unit.as_str() {
        "m" => (1e9, " nm"),
        "Pa" => (1e-6, " MPa"),
        _ => (1.0, ""),
    };
    let digits = if factor == 1.0 { 3 } else { 1 };
    [parameter.value, parameter.low, parameter.high]
        .map(|value| format!("{:.digits$}{unit}", factor * value))
}

/// The nominal loss with its band, and the alternative models.
pub(super) fn loss_chart(band: &LossBand) -> Drawing {
    let whole = |power: f64| rounded(power, band.half_width_w());
    let [low, high] = band.quantiles_w;
    let nominal = Bar {
        name: "this result".to_owned(),
        value: Some(band.nominal_w),
        spread: Some(band.quantiles_w),
        text: format!(
            "{} W ({}..{})",
            whole(band.nominal_w),
            whole(low),
            whole(high)
        ),
    };
    let others = band.alternatives.iter().map(|row| Bar {
        name: row.name.clone(),
        value: row.loss_w,
        spread: None,
        text: match row.loss_w {
            Some(loss) => format!("{} W", whole(loss)),
            None => "no solution".to_owned(),
        },
    });
    Drawing::Bars(BarChart {
        id: "band".to_owned(),
        title: "Loss with its band, and alternative models".to_owned(),
        source: "result.json".to_owned(),
        axis: Axis::new("loss", "W"),
        bars: std::iter::once(nominal).chain(others).collect(),
    })
}
