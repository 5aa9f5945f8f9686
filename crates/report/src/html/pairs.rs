//! Several traces of a flank: loss of every pair of teeth, and contributions to the error of their mean.

use asperity::result::loss_band::{Digits, PairSampling, rounded};
use asperity::result::{FlankRecord, ToothTrace, TracePairs};
use asperity::roughness::Parameters;
use asperity_core::quantity::Length;
use maud::{Markup, html};

use crate::summary::{counted_of_wheel, one_of, sampled_as, two_digits};
use crate::tables::BODIES;
use crate::units::MICRO;
use crate::{Cell, Column, Kind, Table, columns};

pub(super) fn section(
    pairs: &TracePairs,
    sampling: &PairSampling,
    flanks: &[FlankRecord; 2],
) -> Markup {
    let watts = |power: f64| rounded(power, sampling.half_width_w);
    let [pinion, wheel] = sampling.traces;
    let names = sampled_as(pairs, flanks);
    let of_wheel = counted_of_wheel(sampling, names);
    let teeth = one_of(names[0]);
    let [s1, s2] = sampling.between_w;
    html! {
        h3 { "The " (names[0]) ", pair by pair" }
        p {
            (pinion) " " (names[0]) " of the pinion run on " (of_wheel) " of the wheel. The mean loss is "
            (watts(sampling.mean_w)) " W, its standard error "
            (two_digits(sampling.standard_error_w)) " W with " (format!("{:.1}", sampling.freedom)) " degrees of freedom" (sampling.bound()) "."
            " Between the " (teeth) " of the pinion the loss scatters by " (two_digits(s1)) " W (s₁), between those of the wheel by "
            (two_digits(s2)) " W (s₂), and from pair to pair by further " (two_digits(sampling.interaction_w)) " W (s₁₂)."
        }
        (losses(pairs, wheel))
    }
}

/// Loss of each traced tooth of the pinion on each of the wheel.
fn losses(pairs: &TracePairs, wheel: usize) -> Table {
    let pinions = (1..=pairs.losses_w.len()).map(|tooth| format!("pinion {tooth}"));
    let names = Column::new(Kind::Head, "loss", "W", pinions);
    let of_wheel = (0..wheel).map(|tooth| {
        let losses = pairs.losses_w.iter().map(|row| {
            Cell::number(row.get(tooth).copied(), |loss| {
                Digits::of_power(loss).rounded(loss)
            })
        });
        Column::new(Kind::Number, &format!("wheel {}", tooth + 1), "", losses)
    });
    Table::new(std::iter::once(names).chain(of_wheel))
}

/// The traces with their roughness parameters.
pub(super) fn traces(pairs: &TracePairs) -> Markup {
    let flanks = BODIES.iter().zip(&pairs.traces);
    let all = flanks.flat_map(|(body, traces)| traces.iter().map(move |trace| (body, trace)));
    let rows = all.map(|(body, trace)| Traced {
        tooth: match trace.tooth_number {
            Some(number) => format!("{body} {} (tooth {number})", trace.tooth),
            None => format!("{body} {}", trace.tooth),
        },
        trace,
        parameters: trace.record.parameters.as_ref(),
    });
    let um = |length: Length| length.si() * MICRO;
    html! {
        p { "The charts below are of the first trace of each flank." }
        (columns! { row in rows;
            head tooth "tooth" "";
            code trace "trace" "" = file(row.trace);
            number y_mm "y" "mm" "{:.2}" = row.trace.y_mm;
            number rq "Rq" "µm" "{:.3}" = row.parameters.map(|of| um(of.heights.rq));
            number rz "Rz" "µm" "{:.3}" = row.parameters.map(|of| um(of.heights.rz));
            number rpk "Rpk" "µm" "{:.3}" = row.parameters.map(|of| um(of.material.rpk));
        })
    }
}

/// A trace of a tooth.
struct Traced<'a> {
    tooth: String,
    trace: &'a ToothTrace,
    parameters: Option<&'a Parameters>,
}

fn file(trace: &ToothTrace) -> &str {
    trace.record.file.as_deref().unwrap_or("roughness values")
}
