//! Facts that were read from a file: format, units, points, range, and the origin of each.

use asperity_core::by_size;
use asperity_core::numerics::extremes;
use asperity_core::quantity::Length;
use asperity_profile_io::Warning;
use asperity_profile_io::read::{Axis, Trace};
use asperity_report::Report;
use asperity_report::profile_json::um;
use serde_json::{Value, json};

use crate::args::{ReadingArgs, name_of};
use crate::failure::Failure;

/// The facts about a trace.
pub(super) struct FileFacts {
    name: String,
    lines: [String; 3],
    json: Value,
}

impl FileFacts {
    /// The facts of a trace that was read with the options.
    pub(super) fn new(trace: &Trace, args: &ReadingArgs) -> Self {
        let encoding = trace.encoding.map_or(String::new(), |e| format!(", {e}"));
        let points = trace.heights.len();
        let (spacing, length) = (trace.spacing(), trace.length());
        let source = name_of(&trace.spacing_source);
        let (low, high) = extremes(&trace.heights);
        let is_assumed = |axis| {
            let is = |warning: &Warning| matches!(warning, Warning::UnitAssumed { axis: a, .. } if *a == axis);
            trace.warnings.iter().any(is)
        };
        let origin = |axis, stated: bool| match () {
            () if is_assumed(axis) => "assumed",
            () if stated => "as stated",
            () => "of the file",
        };
        let heights = origin(Axis::Height, args.z_unit.is_some());
        let positions = trace.x_unit.map_or(String::new(), |unit| {
            format!(
                ", x in {unit} ({})",
                origin(Axis::Trace, args.x_unit.is_some())
            )
        });
        let facts = &trace.metadata;
        let text = |length: Option<Length>| length.map(|l| l.to_string());
        let stated = [
            ("instrument", facts.instrument.clone()),
            ("date", facts.date.clone()),
            ("title", facts.title.clone()),
            ("nominal length", text(facts.nominal_length)),
            ("lambda_c", text(facts.lambda_c)),
            ("lambda_s", text(facts.lambda_s)),
            ("filter state", Some(name_of(&trace.filter_state))),
        ];
        let cut = trace.cut.map_or(String::new(), |cut| {
            format!(", cut to {} of {}", cut.range, rounded(cut.of))
        });
        let known = stated
            .into_iter()
            .filter_map(|(name, value)| Some(format!("{name} {}", value?)));
        Self {
            name: trace.name.clone(),
            lines: [
                format!(
                    "{}{encoding}, heights in {} ({heights}){positions}; {points} points, dx {} ({source}), length {}{cut}",
                    trace.format,
                    trace.z_unit,
                    rounded(spacing),
                    rounded(length)
                ),
                format!(
                    "heights from {} to {} um",
                    by_size(1e6 * low, 4),
                    by_size(1e6 * high, 4)
                ),
                format!("stated: {}", known.collect::<Vec<_>>().join(", ")),
            ],
            json: json!({
                "file": trace.name,
                "format": trace.format,
                "n": points,
                "dx_um": um(spacing),
                "length_um": um(length),
                "filter_state": trace.filter_state,
                "reading": trace,
            }),
        }
    }

    /// A report with the name and the facts.
    pub(super) fn report<'a>(&self) -> Report<'a> {
        let [read, heights, stated] = &self.lines;
        Report::new(&self.name, "")
            .verdict([read])
            .text([heights, stated])
    }

    /// The facts of a file without parameters, with the reason.
    pub(super) fn json(&self, failure: &Failure) -> Value {
        let mut report = self.json.clone();
        report["error"] = failure.json()["error"].clone();
        report
    }
}

/// A length with seven digits, without round-off.
pub(super) fn rounded(length: Length) -> Length {
    let text = format!("{:.6e}", length.si());
    Length::from_si(text.parse().unwrap_or(length.si()))
}
