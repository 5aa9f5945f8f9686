//! The two flanks of a case: traces read and prepared, or roughness values.

use std::sync::Arc;

use asperity_core::provenance::Provenance;
use asperity_core::{Code, DomainError};
use asperity_gear::MeasuredForm;

use super::defaults::DefaultUsed;
use super::error::CaseError;
use super::files::{FileSums, Files, Reader};
use super::flank_pairs::{Meeting, all_placed, longer_than_active, on_common_spacing};
use super::flank_sample::{self, Listed};
use super::flank_trace::{Context, Flank, Keys, flank, keys_of, traces_of};
use super::input::FlankInput;
use super::lay::{Lays, lays};
use super::path_point::Positions;
use super::resolve::Case;
use super::section::domain;
use super::source::Source;
use super::surrogates::{Surrogates, surrogates};
use crate::flanks::surfaces::{FlankReport, Surfaces};
use crate::flanks::trace_pairs::{SampledFlanks, SampledTrace};
use asperity_core::message::Warning;

/// Both flanks with the records of their reading and preparation, and the warnings.
#[derive(Debug, Clone)]
pub(super) struct Flanks {
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

/// Reads and prepares the flanks that `case` names.
pub(super) fn flanks(case: &Case, source: &Source, files: &Files) -> Result<Flanks, CaseError> {
    let provenance = Provenance::new();
    let reader = Reader::of(files);
    let flanks = provenance.collect(|| both(case, source, &reader))?;
    Ok(Flanks {
        provenance,
        sums: reader.into_sums().into(),
        ..flanks
    })
}

fn both(case: &Case, source: &Source, files: &Reader<'_>) -> Result<Flanks, CaseError> {
    let context = Context {
        case,
        source,
        files,
    };
    let mut warnings = Vec::new();
    let (pinion_input, own_wheel, side) = case.input.surface.loaded(case.torque);
    // Flanks face each other: a wheel without a trace has the trace of the pinion, mirrored.
    let wheel_input = own_wheel.cloned();
    let wheel_input = wheel_input.unwrap_or_else(|| pinion_input.for_wheel());
    let keys = keys_of(side, own_wheel.is_some());
    let is_list = pinion_input.traces.is_some() || pinion_input.rows.is_some();
    if is_list && own_wheel.is_none() {
        return Err(CaseError::Conflict {
            place: source.place_of(&keys[0].traces()),
            key: keys[1].table.into(),
            rule: "the pinion has several traces, and the wheel's flanks are others: give traces of the wheel, or one file",
        });
    }
    let mut lists = [
        traces_of(pinion_input, &keys[0], context)?,
        traces_of(&wheel_input, &keys[1], context)?,
    ];
    let named = [0, 1].map(|body: usize| flank_sample::teeth(&lists[body]));
    let teeth = flank_sample::paired(named);
    let inputs = [pinion_input, &wheel_input];
    for (body, list) in lists.iter_mut().enumerate() {
        match inputs[body].rows {
            // Fewer rows, still spread evenly.
            Some(rows) if rows > teeth[body] => {
                let fewer = FlankInput {
                    rows: Some(teeth[body]),
                    ..inputs[body].clone()
                };
                *list = traces_of(&fewer, &keys[body], context)?;
            }
            _ => list.retain(|trace| trace.tooth < teeth[body]),
        }
    }
    if teeth != named {
        warnings.push(left_out(
            named,
            teeth,
            inputs.map(|input| input.rows.is_some()),
        ));
    }
    warnings.extend(lists.iter().zip(&keys).filter_map(of_one_tooth));
    let is_several = lists.iter().any(|list| list.len() > 1);
    let mut flanks: [Vec<Flank>; 2] = Default::default();
    for (body, list) in lists.iter().enumerate() {
        for trace in list {
            flanks[body].push(flank(trace, &keys[body], context, &mut warnings)?);
        }
    }
    on_common_spacing(case, &mut flanks, &mut warnings)?;
    let inputs = [0, 1].map(|body: usize| (&lists[body][0].input, &keys[body]));
    let surrogates = surrogates(context, inputs, &flanks, &mut warnings)?;
    let mut assumed: Vec<DefaultUsed> = Vec::new();
    if let Some(surrogates) = &surrogates {
        for (flanks, record) in flanks.iter_mut().zip(&surrogates.records) {
            if let (Some(flank), Some(_)) = (flanks.first_mut(), record) {
                flank.report.surrogates.clone_from(record);
                flank.assumed.clear();
            }
        }
        assumed.clone_from(&surrogates.assumed);
    }
    let stated = if own_wheel.is_some() { 2 } else { 1 };
    for default in flanks[..stated]
        .iter_mut()
        .flatten()
        .flat_map(|f| std::mem::take(&mut f.assumed))
    {
        if !assumed.contains(&default) {
            assumed.push(default);
        }
    }
    let first_file = |body: usize| {
        flanks[body]
            .first()
            .and_then(|flank| flank.report.file.as_ref())
    };
    if is_several || (first_file(0).is_some() && first_file(0) == first_file(1)) {
        // Once for the shared file.
        warnings.dedup();
        let mut seen = std::collections::BTreeSet::new();
        warnings.retain(|warning| seen.insert(warning.to_string()));
    }
    let lays = lays(context, &lists, &flanks, &keys, &mut warnings);
    let is_placed = all_placed(&flanks, &mut warnings);
    if !is_placed {
        let tables = keys.each_ref().map(|keys| keys.table);
        warnings.extend(longer_than_active(case, &flanks, tables));
    }
    let width = case.gears.face_width;
    let zones = flank_sample::zones([&lists[0], &lists[1]], width);
    check_across(case, &lists, &zones, &keys, source)?;
    let meeting = Meeting {
        case,
        flanks: &flanks,
        is_placed,
    };
    let surfaces = match (surrogates, is_several) {
        (Some(Surrogates { surfaces, .. }), _) => surfaces,
        (None, false) => meeting.surfaces([0, 0]),
        (None, true) => {
            let pairs = meeting.pairs(&lists, teeth, (&zones, width));
            Surfaces::of_pairs(pairs).unwrap_or_else(|| meeting.surfaces([0, 0]))
        }
    };
    let sampled = is_several.then(|| {
        let of = |body: usize| {
            let traces = lists[body].iter().zip(&flanks[body]);
            let traces = traces.map(|(listed, flank)| SampledTrace {
                tooth: listed.tooth,
                number: listed.number,
                y: listed.y,
                report: flank.report.clone(),
            });
            traces.collect()
        };
        Arc::new(SampledFlanks {
            traces: [of(0), of(1)],
            named,
        })
    });
    let forms = flanks.each_ref().map(|flanks| {
        let forms = flanks.iter().filter_map(|flank| flank.report.form.as_ref());
        MeasuredForm::mean(&forms.map(|flank| flank.form.clone()).collect::<Vec<_>>())
    });
    let reports = flanks.map(|flanks| {
        flanks
            .into_iter()
            .next()
            .map(|f| f.report)
            .unwrap_or_default()
    });
    Ok(Flanks {
        surfaces,
        reports: Arc::new(reports),
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

/// W447: traces of a list that are lines of one surface, which is of one tooth.
fn of_one_tooth((list, keys): (&Vec<Listed>, &Keys)) -> Option<Warning> {
    let file = |trace: &Listed| trace.input.file.clone();
    let mut others = list.iter().enumerate().skip(1);
    let shared = others
        .find(|(k, trace)| {
            list[..*k]
                .iter()
                .any(|other| other.tooth != trace.tooth && file(other) == file(trace))
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

/// W427: teeth that are in no pair.
fn left_out(named: [usize; 2], teeth: [usize; 2], of_rows: [bool; 2]) -> Warning {
    let which = |body: usize| match of_rows[body] {
        true => format!("{} rows spread evenly", teeth[body]),
        false => format!("the first {}", teeth[body]),
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

/// Refuses traces outside of the face width or of teeth that the gear lacks, and zones of the face if a single position
/// represents the mesh.
fn check_across(
    case: &Case,
    lists: &[Vec<Listed>; 2],
    zones: &[f64],
    keys: &[Keys; 2],
    source: &Source,
) -> Result<(), CaseError> {
    let width = case.gears.face_width;
    for ((list, keys), teeth) in lists.iter().zip(keys).zip(case.gears.teeth) {
        for y in list.iter().filter_map(|trace| trace.y) {
            let rule = "must not exceed the face width";
            DomainError::require(y <= width, "y", y.si(), "m", rule)
                .map_err(domain(source, keys.traces()))?;
        }
        for tooth in list.iter().filter_map(|trace| trace.number) {
            let rule = "must not exceed the number of teeth";
            DomainError::require(tooth <= teeth, "tooth", f64::from(tooth), "-", rule)
                .map_err(domain(source, keys.traces()))?;
        }
    }
    let is_single = case.formulation.positions() == Positions::Single;
    match is_single && !zones.is_empty() {
        false => Ok(()),
        true => Err(CaseError::Conflict {
            place: source.place_of(&keys[0].traces()),
            key: keys[0].traces(),
            rule: "y tells traces of one tooth apart across the face, and a single position represents the mesh",
        }),
    }
}
