//! Flanks that are generated like measured traces.

use std::path::Path;
use std::sync::Arc;

use asperity_core::message::Warning;
use asperity_core::{Code, Fault, Profile};
use asperity_flanks::generated_record::{GeneratedRecord, MeasuredTrace};
use asperity_flanks::statements::Statements;
use asperity_flanks::trace::{TraceContent, TraceInputs, measured};
use asperity_flanks::trace_sites::TraceSite;
use asperity_roughness::generate::{Like, Method};

use super::flank_sample::{Generated, Listed, listed};
use super::flank_trace::{Context, Keys, gear_of, placed, read_options};
use crate::input::case_input::FlankInput;
use crate::input::files::{Content, HeldTrace};
use crate::input::flank_place::stated_place;
use crate::input::trace_list::TraceList;
use crate::key_words::with_keys;
use crate::source::case_error::CaseError;
use crate::source::section::Section;

/// Seed that is not stated.
const SEED: u32 = 1;
/// State that is not stated: after the test.
const AFTER: f64 = 1.0;

/// A measured trace as it is read.
struct Measured {
    profile: Profile,
    trace: MeasuredTrace,
    statements: Statements,
}

/// As many flanks as the list names traces, each of a tooth of its own.
pub(crate) fn generated(
    input: &FlankInput,
    list: &TraceList,
    keys: &Keys,
    context: Context<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<Listed>, CaseError> {
    let section = Section::of(context.source, keys.table);
    let of_value = input.rq.or(input.ra).or(input.rz).is_some();
    if input.file.is_some() || input.traces.is_some() || input.rows.is_some() || of_value {
        let rule = "stands in place of file, traces, rows, rq, ra and rz; give one of them";
        return Err(section.conflict("like", rule));
    }
    let before = measured_traces(input, ("like", list), keys, context)?;
    let after = match &input.after {
        Some(list) => measured_traces(input, ("after", list), keys, context)?,
        None => Vec::new(),
    };
    let refused =
        |fault: &Fault| CaseError::not_generated(section.place("like"), section.key("like"), fault);
    let like = maker(input, &before, &after, section)?;
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
    let text = format!(
        "{}: {count} flanks are generated from {count} traces ({of_what}); none was measured on this pair of gears",
        section.key("like")
    );
    warnings.push(Warning::new(Code::W463, text));
    let record = GeneratedRecord {
        like: before
            .iter()
            .map(|measured| measured.trace.clone())
            .collect(),
        after: after
            .iter()
            .map(|measured| measured.trace.clone())
            .collect(),
        state: (!after.is_empty()).then(|| input.state.unwrap_or(AFTER)),
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
            generated: Some(Generated {
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

/// The maker of flanks like traces, or like pairs of traces before and after a test.
fn maker(
    input: &FlankInput,
    before: &[Measured],
    after: &[Measured],
    section: Section<'_>,
) -> Result<Like, CaseError> {
    let refused =
        |fault: Fault| CaseError::not_generated(section.place("like"), section.key("like"), &fault);
    let Some((first, others)) = before.split_first() else {
        return Err(section.conflict("like", "names no trace; give at least one"));
    };
    if input.after.is_none() {
        if input.state.is_some() {
            return Err(section.conflict("state", "needs after, the traces after the test"));
        }
        let others = others.iter().map(|trace| trace.profile.clone());
        let like = Like::to(&first.profile, &others.collect::<Vec<_>>(), None);
        return like.map_err(|error| refused(error.into()));
    }
    if after.len() != before.len() {
        let rule = "needs a trace for each of like, in the same order";
        return Err(section.conflict("after", rule));
    }
    let pairs = before.iter().zip(after);
    let pairs = pairs.map(|(before, after)| [before.profile.clone(), after.profile.clone()]);
    let pairs: Vec<[Profile; 2]> = pairs.collect();
    Like::of_pairs(&pairs[0], &pairs[1..], input.state.unwrap_or(AFTER)).map_err(refused)
}

/// The traces that the list at a key names.
fn measured_traces(
    input: &FlankInput,
    (key, list): (&str, &TraceList),
    keys: &Keys,
    context: Context<'_>,
) -> Result<Vec<Measured>, CaseError> {
    let section = Section::of(context.source, keys.table);
    let traces = listed(input, (key, list), section, context.files)?;
    let is_placed = |trace: &Listed| trace.input.at.is_some() || trace.input.from.is_some();
    let is_sited = |trace: &Listed| trace.site.number.is_some() || trace.site.y.is_some();
    let mut all = traces.iter();
    if all.any(|trace| is_placed(trace) || is_sited(trace)) {
        let rule = "makes flanks without a tooth or place; leave tooth, y, at and from out";
        return Err(section.conflict(key, rule));
    }
    let keys = Keys {
        file: section.key(key),
        ..keys.clone()
    };
    let each = traces.iter();
    each.map(|trace| read(&trace.input, &keys, context))
        .collect()
}

/// Seed of flank `k` of a table of a mesh: pinion and wheel differ, and so do drive and coast flanks.
fn seed_of(seed: u32, table: &str, k: usize) -> u64 {
    let is_coast = table.starts_with("surface.coast");
    let flank = 2 * u64::from(is_coast) + gear_of(table) as u64;
    (u64::from(seed) << 32) + (flank << 30) + k as u64
}

/// Reads a measured trace.
fn read(input: &FlankInput, keys: &Keys, context: Context<'_>) -> Result<Measured, CaseError> {
    let file = input.file.as_deref().unwrap_or(Path::new(""));
    let name = file.display().to_string();
    let (content, sum) = context
        .files
        .open(file, context.source, keys.file.clone())?;
    let conditions = context.files.conditions(file);
    let inputs = TraceInputs {
        name: &name,
        content: match &content {
            Content::Bytes(bytes) => TraceContent::Bytes(bytes, conditions.as_deref()),
            Content::Heights(held) => TraceContent::Heights(&held.profile, &held.statements),
        },
        options: &read_options(input),
        is_line_stated: input.line.is_some(),
        outliers: context.inputs.surface.outliers,
        place: stated_place(None, None, None),
        filters: context.inputs.filters(),
        shortest_form: None,
    };
    let gears = (&context.inputs.gears, gear_of(keys.table));
    let (profile, statements) =
        measured(inputs, gears).map_err(|error| placed(error, (&name, &name), keys, context))?;
    Ok(Measured {
        profile,
        trace: MeasuredTrace {
            file: name,
            sha256: sum,
        },
        statements,
    })
}
