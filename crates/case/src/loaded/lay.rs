//! Lay of each flank from the surface that its traces were taken from.

use asperity_core::Code;
use asperity_flanks::flank_lay::{FlankLay, two_digits};
use asperity_flanks::surface_lay::lay_of_surface;
use asperity_flanks::trace::Flank;
use asperity_roughness::lay::RowLay;

use super::flank_sample::Listed;
use super::flank_trace::{Context, FlankKeys};
use crate::source::defaults::DefaultUsed;
use asperity_core::message::Warning;
use asperity_ehl_regime::Lay;

/// Lays of both flanks, with what `check` and `run` say about them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Lays {
    /// Distributions of pinion and wheel.
    pub of_flanks: [FlankLay; 2],
    /// Origin of the lay of each flank; empty if no flank was taken from a surface.
    pub origin: String,
}

impl Lays {
    /// Ground flanks, of which no surface was measured.
    pub(crate) const ASSUMED: Self = Self {
        of_flanks: [FlankLay::ASSUMED; 2],
        origin: String::new(),
    };

    /// Median lay of a flank whose surface shows it.
    pub(crate) fn measured(&self, body: usize) -> Option<Lay> {
        let lay = self.of_flanks[body];
        Lay::new(lay.at(0.0))
            .ok()
            .filter(|_| lay != FlankLay::ASSUMED)
    }

    /// The medians with their row among the defaults, instead of the default of a case that states none; `None` where no surface
    /// shows them.
    pub(crate) fn in_place_of_default(&self) -> Option<([Lay; 2], DefaultUsed)> {
        let medians = self.of_flanks.map(|lay| lay.at(0.0));
        let (false, [Ok(pinion), Ok(wheel)]) = (self.origin.is_empty(), medians.map(Lay::new))
        else {
            return None;
        };
        let row = DefaultUsed {
            key: "model.lay".into(),
            value: serde_json::to_string(&medians).unwrap_or_default(),
            source: Some(self.origin.clone().into()),
        };
        Some(([pinion, wheel], row))
    }
}

/// Median lay of the surface that a trace was taken from, if it shows it.
pub(crate) fn median_lay(
    listed: &Listed,
    flank: &Flank,
    keys: &FlankKeys,
    context: Context<'_>,
) -> Option<Lay> {
    let found = of_surface(listed, flank, keys, context)?.finding.ok()?;
    Lay::new(FlankLay::from_rows(&found)?.at(0.0)).ok()
}

/// Lays of pinion and wheel, each from the surface of its first trace.
pub(crate) fn lays(
    context: Context<'_>,
    lists: &[Vec<Listed>; 2],
    flanks: &[Vec<Flank>; 2],
    keys: &[FlankKeys; 2],
    warnings: &mut Vec<Warning>,
) -> Lays {
    let mut measured: Vec<Option<MeasuredLay>> = Vec::with_capacity(2);
    for (body, keys) in keys.iter().enumerate() {
        let (Some(listed), Some(flank)) = (lists[body].first(), flanks[body].first()) else {
            return Lays::ASSUMED;
        };
        let same = body == 1
            && lists[0]
                .first()
                .is_some_and(|first| is_of_same_surface(first, listed));
        let found = if same {
            measured[0].clone()
        } else {
            of_surface(listed, flank, keys, context)
        };
        measured.push(found);
    }
    if measured.iter().all(Option::is_none) {
        return Lays::ASSUMED;
    }
    let mut texts = Vec::new();
    let mut of_flanks = [FlankLay::ASSUMED; 2];
    for (body, found) in measured.iter().enumerate() {
        let name = ["pinion", "wheel"][body];
        let text = match found {
            None => "assumed, 0 to 1/6".to_owned(),
            Some(MeasuredLay { file, finding }) => match finding {
                Ok(lay) => match FlankLay::from_rows(lay) {
                    Some(own) => {
                        of_flanks[body] = own;
                        written(lay, file)
                    }
                    None => unknown(
                        file,
                        "its ridges are longer than half of it, which leaves the lay open",
                    ),
                },
                Err(reason) => unknown(file, reason),
            },
        };
        let shared = measured[0] == measured[1];
        let of = if shared { "flanks" } else { name };
        let warning = found.as_ref().and_then(|found| found.warning(of));
        let is_needed = context.inputs.lay.is_none() && (body == 0 || !shared);
        warnings.extend(warning.filter(|_| is_needed));
        texts.push(format!("{name} {text}"));
    }
    texts.dedup_by(|second, first| second.strip_prefix("wheel") == first.strip_prefix("pinion"));
    if texts.len() == 1 {
        texts[0] = texts[0].replacen("pinion", "both flanks", 1);
    }
    Lays {
        of_flanks,
        origin: texts.join(", "),
    }
}

/// Finding on the surface of a flank.
#[derive(Clone, PartialEq)]
struct MeasuredLay {
    file: String,
    finding: Result<RowLay, String>,
}

impl MeasuredLay {
    /// W444 if the lay is not known, or above the range of the law of the inlet.
    fn warning(&self, flank: &str) -> Option<Warning> {
        let file = &self.file;
        let text = match &self.finding {
            Err(reason) => format!(
                "{file} does not show the lay of the {flank}: {reason}. It is assumed to be 0 to 1/6"
            ),
            Ok(lay) if FlankLay::from_rows(lay).is_none() => format!(
                "{file} does not show the lay of the {flank}: the ridges are longer than half of the surface, so that it is between {:.2} and {:.2}. It is assumed to be 0 to 1/6",
                lay.range[0],
                lay.range[1].min(1.0)
            ),
            Ok(lay) if lay.range[0] > 1.0 => format!(
                "the ridges on {file} run along the traces of the {flank}, lay {:.1}; it is held at 1, the end of the law of the inlet. If the rows of the file run across the face, take columns",
                lay.gamma.min(99.0)
            ),
            Ok(_) => return None,
        };
        Some(Warning::new(Code::W444, text))
    }
}

/// Whether both traces are lines of one surface in one direction.
fn is_of_same_surface(first: &Listed, second: &Listed) -> bool {
    let (a, b) = (&first.input, &second.input);
    a.file == b.file
        && a.line.unwrap_or_default() == b.line.unwrap_or_default()
        && a.z_unit == b.z_unit
        && (a.dx, a.dy) == (b.dx, b.dy)
}

fn written(lay: &RowLay, file: &str) -> String {
    let [low, high] = lay.range.map(|end| two_digits(end.min(1.0)));
    match lay.is_bound {
        _ if lay.range[0] > 1.0 => format!("1, as the ridges on {file} run along the traces"),
        true => {
            format!("{low} to {high} measured on {file}, whose ridges are longer than half of it")
        }
        false => {
            let median = two_digits(lay.gamma.min(1.0));
            format!("{median} ({low} to {high}) measured on {file}")
        }
    }
}

fn unknown(file: &str, reason: &str) -> String {
    format!("assumed, 0 to 1/6 ({file}: {reason})")
}

/// The lay of the surface that a trace was taken from; `None` for a trace that was measured as a line.
fn of_surface(
    listed: &Listed,
    flank: &Flank,
    keys: &FlankKeys,
    context: Context<'_>,
) -> Option<MeasuredLay> {
    let input = &listed.input;
    let file = input.file.as_ref()?;
    let reading = flank.report.reading.as_ref()?;
    if !reading.format.may_hold_several() {
        return None;
    }
    let scan = context.scan(input, file, keys).ok()??;
    let line = input.line.unwrap_or_default();
    let (along, record) = (reading.profile.spacing(), flank.report.preparation.as_ref());
    let finding = lay_of_surface(&scan.surface, line, along, record)?;
    Some(MeasuredLay {
        file: scan.surface.name.clone(),
        finding,
    })
}
