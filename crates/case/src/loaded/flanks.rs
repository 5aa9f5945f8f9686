//! The two flanks of a case: traces read and prepared, or roughness values.

use std::sync::Arc;

use asperity_core::message::Warning;
use asperity_core::provenance::Provenance;
use asperity_core::quantity::Length;
use asperity_core::{Code, DomainError};
use asperity_flanks::meeting::{Meeting, Refined, longer_than_active, on_common_spacing};
use asperity_flanks::surfaces::{FlankReport, Surfaces};
use asperity_flanks::surrogates::Surrogates;
use asperity_flanks::trace::Flank;
use asperity_flanks::trace_pairs::SampledFlanks;
use asperity_flanks::trace_sites::{TraceSite, zones as zones_of};
use asperity_gear::MeasuredForm;

use super::flank_inputs::FlankInputs;
use super::flank_sample::Listed;
use super::flank_trace::{Context, FlankKeys, KnownTrace, flank};
use super::lay::{Lays, lays};
use super::named_traces::NamedTraces;
use super::scan_choice::{Taken, taken};
use super::scans::Scans;
use super::sheets::sheets_of;
use super::surrogates::surrogates_of;
use crate::input::files::{FileSums, Files, Reader};
use crate::source::case_error::CaseError;
use crate::source::defaults::DefaultUsed;
use crate::source::section::domain;
use crate::source::source_text::Source;

/// Both flanks with the records of their reading and preparation, and the warnings.
#[derive(Debug, Clone)]
pub(crate) struct Flanks {
    pub surfaces: Surfaces,
    /// Report on the first trace of each flank.
    pub reports: Arc<[FlankReport; 2]>,
    /// All traces, if a flank has several.
    pub sampled: Option<Arc<SampledFlanks>>,
    /// Form of each gear, the mean of its traces, if its relief is taken from them.
    pub forms: [Option<MeasuredForm>; 2],
    /// Lay of each flank.
    pub lays: Arc<Lays>,
    /// Places y/b between zones of the face with separate traces.
    pub zones: Vec<f64>,
    pub warnings: Vec<Warning>,
    /// Roughness values that follow from others.
    pub assumed: Vec<DefaultUsed>,
    /// Equations of the preparation.
    pub provenance: Provenance,
    /// Sums of the files read.
    pub sums: Arc<FileSums>,
}

/// Reads and prepares the flanks of a case.
pub(crate) fn flanks(
    inputs: &FlankInputs,
    source: &Source,
    files: &Files,
) -> Result<Flanks, CaseError> {
    let provenance = Provenance::new();
    let reader = Reader::new(files);
    let scans = Scans::default();
    let context = Context {
        inputs,
        source,
        files: &reader,
        scans: &scans,
    };
    let flanks = provenance.collect(|| both(context))?;
    Ok(Flanks {
        provenance,
        sums: reader.into_sums().into(),
        ..flanks
    })
}

fn both(context: Context<'_>) -> Result<Flanks, CaseError> {
    let inputs = context.inputs;
    let mut warnings = Vec::new();
    let mut named = NamedTraces::new(context, &mut warnings)?;
    let known_of = |named: &NamedTraces, body: usize, warnings: &mut Vec<Warning>| {
        let each = named.lists[body].iter();
        let each = each.map(|trace| flank(trace, &named.keys[body], context, warnings));
        each.collect::<Result<Vec<KnownTrace>, CaseError>>()
    };
    let Taken {
        known,
        is_scan,
        is_patch,
    } = taken(&mut named, context, known_of, &mut warnings)?;
    let of_teeth = named.lists.iter().zip(&named.keys).take(named.stated());
    warnings.extend(of_teeth.filter_map(|(list, keys)| of_one_tooth(list, keys)));
    let is_several = named.lists.iter().any(|list| list.len() > 1);
    let mut flanks: [Vec<Flank>; 2] = Default::default();
    let mut follow: [Vec<Vec<DefaultUsed>>; 2] = Default::default();
    for (body, known) in known.into_iter().enumerate() {
        (flanks[body], follow[body]) = known.into_iter().unzip();
    }
    let refined = on_common_spacing(inputs.largest_spacing, &mut flanks);
    let refined = refined.map_err(|(file, error)| CaseError::preparation(file, error))?;
    warnings.extend(refined.map(resampled));
    let first = [0, 1].map(|body: usize| (&named.lists[body][0].input, &named.keys[body]));
    let surrogates = surrogates_of(context, first, &flanks, &mut warnings)?;
    if let Some((surrogates, _)) = &surrogates {
        for (body, record) in surrogates.records.iter().enumerate() {
            if let (Some(flank), Some(_)) = (flanks[body].first_mut(), record) {
                flank.report.surrogates.clone_from(record);
                follow[body][0].clear();
            }
        }
    }
    let left_open = surrogates.as_ref().map(|(_, left_open)| left_open.clone());
    let mut assumed = left_open.unwrap_or_default();
    let lays = lays(context, &named.lists, &flanks, &named.keys, &mut warnings);
    assumed.extend(named.taken_by_lay(context, is_scan, is_patch, &lays));
    for default in follow.into_iter().take(named.stated()).flatten().flatten() {
        if !assumed.contains(&default) {
            assumed.push(default);
        }
    }
    let sheets = if is_patch {
        Some(sheets_of(
            context,
            &named.lists,
            &mut flanks,
            &named.keys,
            is_scan,
            &lays,
            &mut warnings,
        )?)
    } else {
        None
    };
    let first_file = |body: usize| {
        flanks[body]
            .first()
            .and_then(|flank| flank.report.file.as_ref())
    };
    if is_several || (first_file(0).is_some() && first_file(0) == first_file(1)) {
        // Once for the shared file.
        keep_first(&mut warnings);
    }
    let (surfaces, zones) = met(&named, context, &flanks, surrogates, &mut warnings)?;
    let surfaces = surfaces.with_sheets(sheets);
    let forms = flanks.each_ref().map(|flanks| {
        let forms = flanks.iter().filter_map(|flank| flank.report.form.as_ref());
        MeasuredForm::mean(&forms.map(|flank| flank.form.clone()).collect::<Vec<_>>())
    });
    let sampled = is_several.then(|| named.sampled(&flanks).into());
    let first_report = |flanks: Vec<Flank>| {
        let first = flanks.into_iter().next();
        first.map(|flank| flank.report).unwrap_or_default()
    };
    Ok(Flanks {
        surfaces,
        reports: Arc::new(flanks.map(first_report)),
        sampled,
        forms,
        lays: Arc::new(lays),
        zones,
        warnings,
        assumed,
        provenance: Provenance::new(),
        sums: Arc::default(),
    })
}

/// Leaves each warning once.
fn keep_first(warnings: &mut Vec<Warning>) {
    let mut seen = std::collections::BTreeSet::new();
    warnings.retain(|warning| seen.insert(warning.to_string()));
}

/// W447: traces of a list that are lines of one surface, which is of one tooth.
fn of_one_tooth(list: &[Listed], keys: &FlankKeys) -> Option<Warning> {
    let file = |trace: &Listed| trace.input.file.clone();
    let mut others = list.iter().enumerate().skip(1);
    let shared = others
        .find(|(k, trace)| {
            list[..*k]
                .iter()
                .any(|other| other.site.tooth != trace.site.tooth && file(other) == file(trace))
        })?
        .1;
    let rows = list
        .iter()
        .filter(|trace| file(trace) == file(shared))
        .count();
    let text = format!(
        "{}: {rows} lines of {} count as teeth of their own, and a surface is of one tooth: the scatter between teeth is not in the interval of the loss",
        keys.table,
        shared.input.file.as_ref()?.display()
    );
    Some(Warning::new(Code::W447, text))
}

/// The flanks in contact, and the places y/b between the zones of the face.
fn met(
    named: &NamedTraces,
    context: Context<'_>,
    flanks: &[Vec<Flank>; 2],
    surrogates: Option<(Surrogates, Vec<DefaultUsed>)>,
    warnings: &mut Vec<Warning>,
) -> Result<(Surfaces, Vec<f64>), CaseError> {
    let inputs = context.inputs;
    let is_placed = all_placed(flanks, warnings);
    if !is_placed {
        let tables = named.keys.each_ref().map(|keys| keys.table);
        warnings.extend(too_long(longer_than_active(&inputs.gears, flanks), tables));
    }
    let width = inputs.gears.face_width;
    let sites = named.sites.each_ref().map(Vec::as_slice);
    let zones = zones_of(sites, width);
    check_across(inputs, sites, &zones, &named.keys, context.source)?;
    if let Some((surrogates, _)) = surrogates {
        return Ok((surrogates.surfaces, zones));
    }
    let meeting = Meeting {
        noise_cutoff: inputs.preparation.lambda_s,
        flanks,
        is_placed,
        like: named.like(),
    };
    let is_several = flanks.iter().any(|flanks| flanks.len() > 1);
    let pairs = is_several.then(|| meeting.pairs(sites, named.teeth, &zones, width));
    let surfaces = pairs.and_then(Surfaces::of_pairs);
    Ok((surfaces.unwrap_or_else(|| meeting.surfaces([0, 0])), zones))
}

/// Whether the place of every trace is known; known places of only some traces raise a warning and are not used.
fn all_placed(flanks: &[Vec<Flank>; 2], warnings: &mut Vec<Warning>) -> bool {
    let placed = flanks
        .iter()
        .flatten()
        .filter(|flank| flank.placed.is_some());
    let is_missing = |body: usize| flanks[body].iter().any(|flank| flank.placed.is_none());
    let missing = match [is_missing(0), is_missing(1)] {
        [false, false] => return true,
        _ if placed.count() == 0 => return false,
        [true, false] => "the trace of the pinion",
        [false, true] => "the trace of the wheel",
        [true, true] => "some traces of pinion and wheel",
    };
    warnings.push(Warning::new(
        Code::W418,
        format!(
            "the place on the flank is not known of {missing}: windows do not follow from the mesh, all traces stand for any place of their flanks"
        ),
    ));
    false
}

/// W448: flanks with traces so long that little of them can lie on the active flank.
fn too_long(longer: [Option<[Length; 2]>; 2], tables: [&str; 2]) -> Option<Warning> {
    let each = longer.into_iter().zip(tables);
    let found = each.filter_map(|(longer, table)| {
        let [longest, active] = longer?;
        Some(format!("{longest:.3} in {table} on {active:.3}"))
    });
    let found: Vec<String> = found.collect();
    (!found.is_empty()).then(|| {
        let text = format!(
            "filtered traces are longer than the active flank: {}. The rest was not measured there, and windows are taken from it, too. State the part on the active flank as range or the place of the trace as at; keep the trace if it was measured along the tooth or on a specimen of the same finish",
            found.join(", and ")
        );
        Warning::new(Code::W448, text)
    })
}

/// W119: traces of different spacings.
fn resampled(refined: Refined) -> Warning {
    let common = refined.common;
    let text = match refined.before {
        Some([pinion, wheel]) => format!(
            "the flanks are spaced {pinion:.5} and {wheel:.5}; the coarser was resampled to {common:.5}"
        ),
        None => format!(
            "the traces have different spacings; the coarser ones were resampled to {common:.5}"
        ),
    };
    Warning::new(Code::W119, text)
}

/// Refuses traces outside of the face width or of teeth that the gear lacks, and zones of the face if a single position
/// represents the mesh.
fn check_across(
    inputs: &FlankInputs,
    sites: [&[TraceSite]; 2],
    zones: &[f64],
    keys: &[FlankKeys; 2],
    source: &Source,
) -> Result<(), CaseError> {
    let width = inputs.gears.face_width;
    for ((sites, keys), teeth) in sites.into_iter().zip(keys).zip(inputs.gears.teeth) {
        for y in sites.iter().filter_map(|trace| trace.y) {
            let rule = "must not exceed the face width";
            DomainError::require(y <= width, "y", y.si(), "m", rule)
                .map_err(domain(source, keys.traces()))?;
        }
        for tooth in sites.iter().filter_map(|trace| trace.number) {
            let rule = "must not exceed the number of teeth";
            DomainError::require(tooth <= teeth, "tooth", f64::from(tooth), "-", rule)
                .map_err(domain(source, keys.traces()))?;
        }
    }
    if inputs.has_one_position && !zones.is_empty() {
        Err(CaseError::Conflict {
            place: source.place_of(&keys[0].traces()),
            key: keys[0].traces(),
            rule: "y tells traces of one tooth apart across the face, and a single position represents the mesh",
        })
    } else {
        Ok(())
    }
}
