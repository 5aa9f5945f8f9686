//! The traces that the keys of both flanks name, and the teeth that are paired.

use std::collections::BTreeSet;

use asperity_core::Code;
use asperity_core::message::Warning;
use asperity_flanks::surfaces::LikeMeasured;
use asperity_flanks::trace::Flank;
use asperity_flanks::trace_pairs::{SampledFlanks, SampledTrace};
use asperity_flanks::trace_sites::{TraceSite, paired, teeth as teeth_of};

use super::flank_sample;
use super::flank_sample::Listed;
use super::flank_trace::{Context, FlankKeys, keys_of, traces_of};
use super::generated::generated;
use crate::input::case_input::FlankInput;
use crate::source::case_error::CaseError;
use crate::source::section::Section;
use crate::source::source_text::Source;

/// The traces that the keys of a flank name, or traces generated like them.
fn named(
    input: &FlankInput,
    keys: &FlankKeys,
    context: Context<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<Listed>, CaseError> {
    match &input.like {
        Some(list) => generated(input, list, keys, context, warnings),
        None => {
            let stated = [
                ("seed", input.seed.is_some()),
                ("after", input.after.is_some()),
                ("state", input.state.is_some()),
                ("engagements", input.engagements.is_some()),
            ];
            match stated.into_iter().find(|(_, is_stated)| *is_stated) {
                Some((key, _)) => {
                    let section = Section::new(context.source, keys.table);
                    Err(section.conflict(key, "needs like, the traces to generate others like"))
                }
                None => traces_of(input, keys, context),
            }
        }
    }
}

/// The traces that the keys of both flanks name.
pub(crate) struct NamedTraces {
    pub keys: [FlankKeys; 2],
    /// Whether the wheel has keys of its own.
    has_own_wheel: bool,
    pub lists: [Vec<Listed>; 2],
    pub sites: [Vec<TraceSite>; 2],
    /// Teeth that are named, and teeth that are paired.
    named: [usize; 2],
    pub teeth: [usize; 2],
}

impl NamedTraces {
    /// Lists the traces; of too many teeth those that are paired.
    pub(crate) fn new(
        context: Context<'_>,
        warnings: &mut Vec<Warning>,
    ) -> Result<Self, CaseError> {
        let Context { inputs, source, .. } = context;
        let (pinion_input, own_wheel) = inputs.surface.of_side(inputs.side);
        // Flanks face each other: a wheel without a trace has the trace of the pinion, mirrored.
        let wheel_input = own_wheel.cloned();
        let wheel_input = wheel_input.unwrap_or_else(|| pinion_input.for_wheel());
        let keys = keys_of(inputs.side, own_wheel.is_some());
        let is_list =
            pinion_input.traces.is_some() || pinion_input.rows.is_some_and(|rows| rows > 1);
        if is_list && own_wheel.is_none() {
            return Err(CaseError::Conflict {
                place: source.place_of(&keys[0].traces()),
                key: keys[1].table.into(),
                rule: "the pinion has several traces, and the wheel's flanks are others: give traces of the wheel, or one file",
            });
        }
        let lists = [
            named(pinion_input, &keys[0], context, warnings)?,
            named(&wheel_input, &keys[1], context, warnings)?,
        ];
        let mut found = Self {
            sites: Default::default(),
            has_own_wheel: own_wheel.is_some(),
            keys,
            lists,
            named: [0; 2],
            teeth: [0; 2],
        };
        found.pair(source, warnings)?;
        Ok(found)
    }

    /// Counts the teeth, and leaves those that are paired; whether these are fewer.
    pub(crate) fn pair(
        &mut self,
        source: &Source,
        warnings: &mut Vec<Warning>,
    ) -> Result<bool, CaseError> {
        let named = [0, 1].map(|body: usize| teeth_of(&sites_of(&self.lists[body])));
        let teeth = paired(named);
        let of_rows = self.lists.each_ref().map(|list| list[0].site.row.is_some());
        for body in [0, 1] {
            match of_rows[body] {
                // Fewer rows, still spread evenly.
                true if named[body] > teeth[body] => self.take_rows(body, teeth[body], source)?,
                _ => self.lists[body].retain(|trace| trace.site.tooth < teeth[body]),
            }
        }
        let is_fewer = teeth != named;
        if is_fewer {
            warnings.push(left_out(named, teeth, of_rows));
        }
        self.sites = self.lists.each_ref().map(|list| sites_of(list));
        (self.named, self.teeth) = (named, teeth);
        Ok(is_fewer)
    }

    /// Number of flanks with keys: a wheel without any has those of the pinion.
    pub(crate) fn stated(&self) -> usize {
        if self.has_own_wheel { 2 } else { 1 }
    }

    /// Names rows of the scan of a flank, as `rows` does, instead of those named before.
    pub(crate) fn take_rows(
        &mut self,
        body: usize,
        rows: usize,
        source: &Source,
    ) -> Result<(), CaseError> {
        let section = Section::new(source, self.keys[body].table);
        let whole = FlankInput {
            row: None,
            ..self.lists[body][0].input.clone()
        };
        let scan = self.lists[body][0].scan.clone();
        self.lists[body] = flank_sample::rows(&whole, rows, scan.as_ref(), section)?;
        Ok(())
    }

    /// Flanks that were generated like measured traces.
    pub(crate) fn like(&self) -> LikeMeasured {
        let sums = self.lists.each_ref().map(|list| {
            let made = list.first().and_then(|trace| trace.generated.as_ref())?;
            let like = made.record.like.iter().map(|trace| &trace.sha256);
            Some(like.collect::<BTreeSet<_>>())
        });
        LikeMeasured {
            flanks: sums.each_ref().map(Option::is_some),
            is_same: sums[0].is_some() && sums[0] == sums[1],
        }
    }

    /// All traces with their teeth.
    pub(crate) fn sampled(&self, flanks: &[Vec<Flank>; 2]) -> SampledFlanks {
        let of = |body: usize| {
            let traces = self.sites[body].iter().zip(&flanks[body]);
            let traces = traces.map(|(site, flank)| SampledTrace::new(*site, flank.report.clone()));
            traces.collect()
        };
        SampledFlanks::new([of(0), of(1)], self.named)
    }
}

/// W427: teeth that are in no pair.
fn left_out(named: [usize; 2], teeth: [usize; 2], of_rows: [bool; 2]) -> Warning {
    let which = |body: usize| {
        if of_rows[body] {
            format!("{} rows spread evenly", teeth[body])
        } else {
            format!("the first {}", teeth[body])
        }
    };
    Warning::new(
        Code::W427,
        format!(
            "{} traced teeth of the pinion and {} of the wheel make {} pairs: {} of the pinion and {} of the wheel are computed",
            named[0],
            named[1],
            named[0] * named[1],
            which(0),
            which(1)
        ),
    )
}

/// Teeth and places of the traces of a list.
fn sites_of(list: &[Listed]) -> Vec<TraceSite> {
    list.iter().map(|trace| trace.site).collect()
}
