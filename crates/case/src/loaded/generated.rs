//! Flanks that are generated like measured traces.

use std::cmp::Ordering;
use std::path::Path;
use std::sync::Arc;

use asperity_core::message::Warning;
use asperity_core::{Code, Fault, Profile};
use asperity_flanks::generated_record::{GeneratedRecord, MeasuredTrace};
use asperity_flanks::statements::Statements;
use asperity_flanks::trace::{TraceContent, TraceInputs, measured};
use asperity_flanks::trace_sites::TraceSite;
use asperity_roughness::generate::{Like, Method, State};

use super::flank_sample::{GeneratedSample, Listed, listed};
use super::flank_trace::{Context, FlankKeys, gear_of, placed, read_options};
use crate::input::case_input::FlankInput;
use crate::input::files::{Content, HeldTrace};
use crate::input::flank_place::stated_place;
use crate::input::trace_list::TraceList;
use crate::key_words::with_keys;
use crate::source::case_error::CaseError;
use crate::source::section::Section;

/// Seed that is not stated.
const SEED: u32 = 1;

/// The flanks wanted between the measured stages of a test.
struct WantedTrace {
    /// Traces after each stage, in the order of the stages.
    after: Vec<MeasuredProfile>,
    state: State,
}

/// A measured trace as it is read.
struct MeasuredProfile {
    profile: Profile,
    trace: MeasuredTrace,
    statements: Statements,
}

/// As many flanks as the list names traces, each of a tooth of its own.
pub(crate) fn generated(
    input: &FlankInput,
    list: &TraceList,
    keys: &FlankKeys,
    context: Context<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<Listed>, CaseError> {
    let section = Section::new(context.source, keys.table);
    let of_value = input.rq.or(input.ra).or(input.rz).is_some();
    if input.file.is_some() || input.traces.is_some() || input.rows.is_some() || of_value {
        let rule = "is given instead of file, traces, rows, rq, ra and rz; give one of them";
        return Err(section.conflict("like", rule));
    }
    let before = measured_traces(input, "like", list, keys, context)?;
    let wanted = wanted(input, before.len(), keys, context)?;
    let refused =
        |fault: &Fault| CaseError::not_generated(section.place("like"), section.key("like"), fault);
    let like = maker(&before, wanted.as_ref()).map_err(|fault| refused(&fault))?;
    for warning in &like.warnings {
        let message = format!("{}: {warning}", section.key("like"));
        let message = with_keys(&message, &warning.remedy(), keys.table);
        warnings.push(Warning::new(warning.code(), message));
    }
    let (seed, count) = (input.seed.unwrap_or(SEED), before.len());
    let of_what = match like.method() {
        Method::Pieces => "pieces of them",
        Method::Spectrum => "their spectrum and heights",
    };
    let teeth = like.teeth.words();
    let teeth = teeth.map_or_else(String::new, |words| format!(", {words}"));
    let text = format!(
        "{}: {count} flanks are generated from {count} traces ({of_what}{teeth}); none was measured on this pair of gears",
        section.key("like")
    );
    warnings.push(Warning::new(Code::W463, text));
    let record = GeneratedRecord {
        like: before
            .iter()
            .map(|measured| measured.trace.clone())
            .collect(),
        after: wanted
            .iter()
            .flat_map(|wanted| &wanted.after)
            .map(|measured| measured.trace.clone())
            .collect(),
        state: wanted.as_ref().and_then(|wanted| wanted.state.part()),
        engagements: wanted
            .as_ref()
            .and_then(|wanted| wanted.state.engagements()),
        method: like.method(),
        pieces: Vec::new(),
        seed,
        number: [0, count],
    };
    let first = before.into_iter().next();
    let statements = first.map(|measured| measured.statements.without_warnings());
    let statements = statements.unwrap_or_default();
    let flank = |k: usize| -> Result<Listed, CaseError> {
        let made = like.generate(seed_of(seed, keys.table, k));
        let made = made.map_err(|error| refused(&error.into()))?;
        Ok(Listed {
            input: FlankInput {
                mirrored: input.mirrored,
                ..FlankInput::default()
            },
            is_of_a_list: true,
            has_own_place: false,
            site: TraceSite {
                tooth: k,
                ..TraceSite::default()
            },
            scan: None,
            engagements: None,
            generated: Some(GeneratedSample {
                heights: Arc::new(HeldTrace {
                    profile: made.generated.profile,
                    statements: statements.clone(),
                }),
                record: GeneratedRecord {
                    pieces: made.pieces,
                    number: [k + 1, count],
                    ..record.clone()
                },
            }),
        })
    };
    (0..count).map(flank).collect()
}

/// The maker of flanks like traces before a test, or in a state of it.
fn maker(before: &[MeasuredProfile], wanted: Option<&WantedTrace>) -> Result<Like, Fault> {
    let profiles = |traces: &[MeasuredProfile]| -> Vec<Profile> {
        traces.iter().map(|trace| trace.profile.clone()).collect()
    };
    let before = profiles(before);
    match wanted {
        Some(wanted) => Like::of_stages(&before, &profiles(&wanted.after), wanted.state),
        None => Ok(Like::to(&before[0], &before[1..], None)?),
    }
}

/// The flanks wanted of a test at whose start the traces of `places` were measured, if there was one.
fn wanted(
    input: &FlankInput,
    places: usize,
    keys: &FlankKeys,
    context: Context<'_>,
) -> Result<Option<WantedTrace>, CaseError> {
    let section = Section::new(context.source, keys.table);
    let Some(list) = &input.after else {
        let rule = "needs after, the traces after the test";
        return match (input.state, input.engagements) {
            (Some(_), _) => Err(section.conflict("state", rule)),
            (_, Some(_)) => Err(section.conflict("engagements", rule)),
            _ => Ok(None),
        };
    };
    let mut after = measured_traces(input, "after", list, keys, context)?;
    let stated = |trace: &MeasuredProfile| trace.trace.engagements;
    after.sort_by(|a, b| stated(a).partial_cmp(&stated(b)).unwrap_or(Ordering::Equal));
    let by_stage: Vec<&[MeasuredProfile]> = after.chunk_by(|a, b| stated(a) == stated(b)).collect();
    if by_stage.iter().any(|stage| stage.len() != places) {
        let rule = "needs a trace for each of like and stage, in the same order; traces of several stages state their engagements";
        return Err(section.conflict("after", rule));
    }
    let stages: Vec<Option<f64>> = by_stage.iter().map(|stage| stated(&stage[0])).collect();
    let stages: Option<Vec<f64>> = stages.into_iter().collect();
    if input.state.is_some() && (input.engagements.is_some() || by_stage.len() > 1) {
        let rule = "is of a test with one stage; state engagements instead";
        return Err(section.conflict("state", rule));
    }
    let is_by_engagements = input.engagements.is_some() || by_stage.len() > 1;
    let (key, stages) = match (is_by_engagements, stages) {
        (false, _) => ("state", Vec::new()),
        (true, Some(stages)) => ("engagements", stages),
        (true, None) => {
            let rule = "states no engagements of its traces; state them as { file = \"run1_*.csv\", engagements = 1e4 }";
            return Err(section.conflict("after", rule));
        }
    };
    let state = State::stated(input.state, input.engagements, &stages);
    Ok(Some(WantedTrace {
        state: state.map_err(section.domain(key))?,
        after,
    }))
}

/// The traces that the list at a key names.
fn measured_traces(
    input: &FlankInput,
    key: &str,
    list: &TraceList,
    keys: &FlankKeys,
    context: Context<'_>,
) -> Result<Vec<MeasuredProfile>, CaseError> {
    let section = Section::new(context.source, keys.table);
    let traces = listed(input, key, list, section, context.files)?;
    let is_placed = |trace: &Listed| trace.input.at.is_some() || trace.input.from.is_some();
    let is_sited = |trace: &Listed| trace.site.number.is_some() || trace.site.y.is_some();
    let mut all = traces.iter();
    if all.any(|trace| is_placed(trace) || is_sited(trace)) {
        let rule = "makes flanks without a tooth or place; leave tooth, y, at and from out";
        return Err(section.conflict(key, rule));
    }
    let keys = FlankKeys {
        file: section.key(key),
        ..keys.clone()
    };
    let each = traces.iter();
    each.map(|trace| read(trace, &keys, context)).collect()
}

/// Seed of flank `k` of a table of a mesh: pinion and wheel differ, and so do drive and coast flanks.
fn seed_of(seed: u32, table: &str, k: usize) -> u64 {
    let is_coast = table.starts_with("surface.coast");
    let flank = 2 * u64::from(is_coast) + gear_of(table) as u64;
    (u64::from(seed) << 32) + (flank << 30) + k as u64
}

/// Reads a measured trace.
fn read(
    listed: &Listed,
    keys: &FlankKeys,
    context: Context<'_>,
) -> Result<MeasuredProfile, CaseError> {
    let input = &listed.input;
    let file = input.file.as_deref().unwrap_or(Path::new(""));
    let name = file.display().to_string();
    let (content, sum) = context
        .files
        .open(file, context.source, keys.file.clone())?;
    let conditions = context.files.conditions(file);
    let content = match &content {
        Content::Bytes(bytes) => TraceContent::Bytes(bytes.clone(), conditions),
        Content::Heights(held) => TraceContent::Heights(&held.profile, &held.statements),
    };
    let inputs = TraceInputs {
        name: &name,
        options: &read_options(input),
        is_line_stated: input.line.is_some(),
        outliers: context.inputs.surface.outliers,
        place: stated_place(None, None, None),
        filters: context.inputs.filters(),
        needed_of_scan: None,
        shortest_form: None,
    };
    let gears = &context.inputs.gears;
    let (profile, statements) = measured(content, inputs, gears, gear_of(keys.table))
        .map_err(|error| placed(error, &name, &name, keys, context))?;
    Ok(MeasuredProfile {
        profile,
        trace: MeasuredTrace {
            file: name,
            sha256: sum,
            engagements: listed.engagements,
        },
        statements,
    })
}
