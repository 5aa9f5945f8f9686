//! Flanks that are generated like measured traces.

use std::path::Path;
use std::sync::Arc;

use asperity_core::message::Warning;
use asperity_core::{Code, Profile};
use asperity_flanks::generated_record::{GeneratedRecord, MeasuredTrace};
use asperity_flanks::trace::{TraceContent, TraceInputs, measured};
use asperity_flanks::trace_sites::TraceSite;
use asperity_gear::Gear;
use asperity_profile_io::read::Reading;
use asperity_roughness::generate::{Like, Method};

use super::flank_sample::{Generated, Listed, listed};
use super::flank_trace::{Context, Keys, gear_of, placed, read_options};
use crate::input::case_input::FlankInput;
use crate::input::files::Content;
use crate::input::flank_place::stated_place;
use crate::input::trace_list::TraceList;
use crate::key_words::with_keys;
use crate::source::case_error::CaseError;
use crate::source::section::Section;

/// Seed that is not stated.
const SEED: u32 = 1;

/// As many flanks as `list` names traces, each of a tooth of its own.
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
    let traces = listed(input, ("like", list), section, context.files)?;
    let is_placed = |trace: &Listed| trace.input.at.is_some() || trace.input.from.is_some();
    let is_sited = |trace: &Listed| trace.site.number.is_some() || trace.site.y.is_some();
    if traces
        .iter()
        .any(|trace| is_placed(trace) || is_sited(trace))
    {
        let rule = "makes flanks without a tooth or place; leave tooth, y, at and from out";
        return Err(section.conflict("like", rule));
    }
    let keys = Keys {
        file: section.key("like"),
        ..keys.clone()
    };
    let mut profiles = Vec::with_capacity(traces.len());
    let mut sources = Vec::with_capacity(traces.len());
    let mut reading = None;
    for trace in &traces {
        let (profile, sum, of_file) = read(&trace.input, &keys, context)?;
        let file = trace
            .input
            .file
            .iter()
            .map(|file| file.display().to_string());
        sources.push(MeasuredTrace {
            file: file.collect(),
            sha256: sum,
        });
        profiles.push(profile);
        reading = reading.or(of_file.map(Arc::new));
    }
    let name = sources.first().map_or("", |source| &source.file);
    let refused = |error| CaseError::preparation(name, error);
    let (first, others) = profiles
        .split_first()
        .ok_or_else(|| section.conflict("like", "names no trace; give at least one"))?;
    let like = Like::to(first, others, None).map_err(refused)?;
    for warning in &like.warnings {
        let message = format!("{}: {warning}", section.key("like"));
        let message = with_keys(&message, &warning.remedy(), keys.table);
        warnings.push(Warning::new(warning.code(), message));
    }
    let seed = input.seed.unwrap_or(SEED);
    let count = traces.len();
    let of_what = match like.method() {
        Method::Pieces => "pieces of them",
        Method::Spectrum => "their spectrum and heights",
    };
    let text = format!(
        "{}: {count} flanks are generated from {count} traces ({of_what}); none was measured on this pair of gears",
        section.key("like")
    );
    warnings.push(Warning::new(Code::W463, text));
    let flank = |k: usize| -> Result<Listed, CaseError> {
        let made = like
            .generate(seed_of(seed, gear_of(keys.table), k))
            .map_err(refused)?;
        let method = (made.method, made.pieces);
        Ok(Listed {
            input: FlankInput {
                like: None,
                mirrored: input.mirrored,
                ..FlankInput::default()
            },
            is_of_a_list: true,
            has_own_place: false,
            site: TraceSite {
                tooth: k,
                ..TraceSite::default()
            },
            generated: Some(Generated {
                heights: Arc::new(made.generated.profile),
                reading: reading.clone(),
                record: GeneratedRecord::new(sources.clone(), method, seed, [k + 1, count]),
            }),
        })
    };
    (0..count).map(flank).collect()
}

/// Seed of flank `k` of a gear: no two are equal.
fn seed_of(seed: u32, gear: Gear, k: usize) -> u64 {
    (u64::from(seed) << 32) + ((gear as u64) << 31) + k as u64
}

/// A measured trace as it is read, its sum, and what its file states.
fn read(
    input: &FlankInput,
    keys: &Keys,
    context: Context<'_>,
) -> Result<(Profile, String, Option<Reading>), CaseError> {
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
            Content::Heights(profile) => TraceContent::Heights(profile),
        },
        options: &read_options(input),
        is_line_stated: input.line.is_some(),
        outliers: context.inputs.surface.outliers,
        place: stated_place(None, None, None),
        filters: context.inputs.filters(),
        shortest_form: None,
    };
    let gears = (&context.inputs.gears, gear_of(keys.table));
    let (profile, reading) =
        measured(inputs, gears).map_err(|error| placed(error, (&name, &name), keys, context))?;
    Ok((profile, sum, reading))
}
