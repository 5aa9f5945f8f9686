//! The two flanks of a case: traces read and prepared, or roughness values.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::Arc;

use asperity_core::provenance::Provenance;
use asperity_core::quantity::Length;
use asperity_core::{Code, DomainError};
use asperity_ehl_regime::Lay;
use asperity_gear::MeasuredForm;

use super::flank_inputs::FlankInputs;
use super::flank_sample;
use super::flank_sample::Listed;
use super::flank_trace::{Context, Keys, Known, flank, keys_of, traces_of};
use super::generated::generated;
use super::lay::{Lays, lays, median_lay};
use super::scans::Scans;
use super::sheets::{bridged, sheets_of, whole};
use super::surrogates::surrogates_of;
use crate::input::case_input::FlankInput;
use crate::input::contact_name::ContactName;
use crate::input::files::{FileSums, Files, Reader};
use crate::source::case_error::CaseError;
use crate::source::defaults::DefaultUsed;
use crate::source::section::{Section, domain};
use crate::source::source_text::Source;
use asperity_core::message::Warning;
use asperity_flanks::meeting::{
    Meeting, Refined, longer_than_active, on_common_spacing, spacing_of,
};
use asperity_flanks::scan::rows_needed;
use asperity_flanks::sheets::{LEAST_ROWS, rows_of_patches};
use asperity_flanks::surfaces::{FlankReport, LikeMeasured, Surfaces, Texture};
use asperity_flanks::surrogates::Surrogates;
use asperity_flanks::trace::Flank;
use asperity_flanks::trace_pairs::{SampledFlanks, SampledTrace};
use asperity_flanks::trace_sites::{TraceSite, paired, teeth as teeth_of, zones as zones_of};
use asperity_profile_io::read::Gaps;

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
    let reader = Reader::of(files);
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
    let mut named = NamedTraces::of(context, &mut warnings)?;
    let known_of = |named: &NamedTraces, body: usize, warnings: &mut Vec<Warning>| {
        let each = named.lists[body].iter();
        let each = each.map(|trace| flank(trace, &named.keys[body], context, warnings));
        each.collect::<Result<Vec<Known>, CaseError>>()
    };
    let Taken {
        known,
        is_scan,
        is_patch,
    } = taken(&mut named, context, known_of, &mut warnings)?;
    let of_teeth = named.lists.iter().zip(&named.keys).take(named.stated());
    warnings.extend(of_teeth.filter_map(of_one_tooth));
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
    let sheets = match is_patch {
        true => Some(sheets_of(
            context,
            &named.lists,
            &mut flanks,
            (&named.keys, is_scan, &lays),
            &mut warnings,
        )?),
        false => None,
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
    let (surfaces, zones) = named.met(context, &flanks, surrogates, &mut warnings)?;
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

/// The flanks with the rows of scans that are computed.
struct Taken {
    known: [Vec<Known>; 2],
    /// Whether the flank is a scan of which the case names no line.
    is_scan: [bool; 2],
    /// Whether patches are in contact.
    is_patch: bool,
}

/// Reads the flanks by `known_of`; of a scan without a line the rows, as traces or as a surface, follow from its lay.
fn taken(
    named: &mut NamedTraces,
    context: Context<'_>,
    known_of: impl Fn(&NamedTraces, usize, &mut Vec<Warning>) -> Result<Vec<Known>, CaseError>,
    warnings: &mut Vec<Warning>,
) -> Result<Taken, CaseError> {
    let mut known: [Vec<Known>; 2] = Default::default();
    let mut is_scan = [false; 2];
    let mut doubts: [Vec<Warning>; 2] = Default::default();
    for (body, known) in known.iter_mut().enumerate() {
        let found = known_of(named, body, &mut doubts[body]);
        if found
            .as_ref()
            .is_err_and(|error| error.code() == Code::E119)
        {
            is_scan[body] = named.take_middle_row(body, context)?;
        }
        *known = match is_scan[body] {
            false => found?,
            true => known_of(named, body, &mut doubts[body])?,
        };
    }
    let is_patch = takes_patch(context, named, &known, is_scan, warnings);
    let mut is_anew = [false; 2];
    for (body, known) in known.iter().enumerate() {
        if is_scan[body] && !is_patch {
            let rows = scan_of_lines((body, named), known, context)?;
            if rows > 1 {
                named.take_rows(body, rows, context.source)?;
                is_anew[body] = true;
            }
        }
    }
    if is_anew != [false; 2] && named.pair(context.source, warnings)? {
        is_anew = [true; 2];
    }
    for (body, known) in known.iter_mut().enumerate() {
        if is_anew[body] {
            // The traces known before need not be among these.
            doubts[body].clear();
            *known = known_of(named, body, &mut doubts[body])?;
        }
    }
    warnings.extend(doubts.into_iter().flatten());
    for (list, known) in named.lists.iter().zip(&known) {
        if let (Some(scan), Some((flank, _))) = (&list[0].scan, known.first()) {
            if list[0].input.gaps == Some(Gaps::Interpolate) {
                warnings.extend(bridged(&flank.report, scan.missing()));
            }
            warnings.extend(scan.spikes.clone());
        }
    }
    Ok(Taken {
        known,
        is_scan,
        is_patch,
    })
}

/// Leaves each warning once.
fn keep_first(warnings: &mut Vec<Warning>) {
    let mut seen = BTreeSet::new();
    warnings.retain(|warning| seen.insert(warning.to_string()));
}

/// The traces that the keys of a flank name, or traces generated like them.
fn named(
    input: &FlankInput,
    keys: &Keys,
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
                    let section = Section::of(context.source, keys.table);
                    Err(section.conflict(key, "needs like, the traces to generate others like"))
                }
                None => traces_of(input, keys, context),
            }
        }
    }
}

/// The traces that the keys of both flanks name.
struct NamedTraces {
    keys: [Keys; 2],
    /// Whether the wheel has keys of its own.
    has_own_wheel: bool,
    lists: [Vec<Listed>; 2],
    sites: [Vec<TraceSite>; 2],
    /// Teeth that are named, and teeth that are paired.
    named: [usize; 2],
    teeth: [usize; 2],
}

impl NamedTraces {
    /// Lists the traces; of too many teeth those that are paired.
    fn of(context: Context<'_>, warnings: &mut Vec<Warning>) -> Result<Self, CaseError> {
        let Context { inputs, source, .. } = context;
        let (pinion_input, own_wheel) = inputs.surface.of_side(inputs.side);
        // Flanks face each other: a wheel without a trace has the trace of the pinion, mirrored.
        let wheel_input = own_wheel.cloned();
        let wheel_input = wheel_input.unwrap_or_else(|| pinion_input.for_wheel());
        let keys = keys_of(inputs.side, own_wheel.is_some());
        let is_list = pinion_input.traces.is_some() || pinion_input.rows.is_some();
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
    fn pair(&mut self, source: &Source, warnings: &mut Vec<Warning>) -> Result<bool, CaseError> {
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

    /// Names the middle row of a flank whose file is a scan, and of which the case names no line; whether it is one.
    fn take_middle_row(&mut self, body: usize, context: Context<'_>) -> Result<bool, CaseError> {
        let keys = &self.keys[body];
        let [alone] = self.lists[body].as_mut_slice() else {
            return Ok(false);
        };
        let scan = match &alone.input.file {
            Some(file) if alone.is_without_line() => context.scan(&alone.input, file, keys)?,
            _ => None,
        };
        let Some(scan) = scan.filter(|scan| scan.apart().is_some()) else {
            return Ok(false);
        };
        alone.input.row = Some(scan.row_of_part(0, 1));
        // Optical instruments miss some points of nearly every scan.
        alone.input.gaps.get_or_insert(Gaps::Interpolate);
        alone.scan = Some(scan);
        Ok(true)
    }

    /// Number of flanks with keys: a wheel without any has those of the pinion.
    fn stated(&self) -> usize {
        if self.has_own_wheel { 2 } else { 1 }
    }

    /// Contact and rows of scans without a line, where the case leaves them to the lay.
    fn taken_by_lay(
        &self,
        context: Context<'_>,
        is_scan: [bool; 2],
        is_patch: bool,
        lays: &Lays,
    ) -> Vec<DefaultUsed> {
        let default = |key: Cow<'static, str>, value: String, source: &'static str| DefaultUsed {
            key,
            value,
            source: Some(source.into()),
        };
        if is_patch && context.inputs.surface.contact.is_none() {
            let source = match is_scan {
                [true, true] => "both flanks are scans, and the lay of one is above 1/6",
                _ => "a flank is a scan, and the lay of one flank is above 1/6",
            };
            return vec![default(
                "surface.contact".into(),
                "\"patch\"".to_owned(),
                source,
            )];
        }
        let scans = (0..self.stated()).filter(|body| is_scan[*body] && !is_patch);
        let rows = scans.map(|body| {
            let key = format!("{}.rows", self.keys[body].table).into();
            let source = match (0..2).any(|body| is_scan[body] && lays.measured(body).is_none()) {
                true => "at most 8, with the sampling error of the whole scan; a scan does not show its lay, assumed 0 to 1/6",
                false => "as many as have the sampling error of the whole scan, at most 8",
            };
            default(key, self.lists[body].len().to_string(), source)
        });
        rows.collect()
    }

    /// Names rows of the scan of a flank, as `rows` does, in place of those named before.
    fn take_rows(&mut self, body: usize, rows: usize, source: &Source) -> Result<(), CaseError> {
        let section = Section::of(source, self.keys[body].table);
        let whole = FlankInput {
            row: None,
            ..self.lists[body][0].input.clone()
        };
        let scan = self.lists[body][0].scan.clone();
        self.lists[body] = flank_sample::rows(&whole, rows, scan.as_ref(), section)?;
        Ok(())
    }

    /// The flanks in contact, and the places y/b between the zones of the face.
    fn met(
        &self,
        context: Context<'_>,
        flanks: &[Vec<Flank>; 2],
        surrogates: Option<(Surrogates, Vec<DefaultUsed>)>,
        warnings: &mut Vec<Warning>,
    ) -> Result<(Surfaces, Vec<f64>), CaseError> {
        let inputs = context.inputs;
        let is_placed = all_placed(flanks, warnings);
        if !is_placed {
            let tables = self.keys.each_ref().map(|keys| keys.table);
            warnings.extend(too_long(longer_than_active(&inputs.gears, flanks), tables));
        }
        let width = inputs.gears.face_width;
        let sites = self.sites.each_ref().map(Vec::as_slice);
        let zones = zones_of(sites, width);
        check_across(inputs, sites, &zones, &self.keys, context.source)?;
        if let Some((surrogates, _)) = surrogates {
            return Ok((surrogates.surfaces, zones));
        }
        let meeting = Meeting {
            noise_cutoff: inputs.preparation.lambda_s,
            flanks,
            is_placed,
            like: self.like(),
        };
        let is_several = flanks.iter().any(|flanks| flanks.len() > 1);
        let pairs = is_several.then(|| meeting.pairs(sites, self.teeth, (&zones, width)));
        let surfaces = pairs.and_then(Surfaces::of_pairs);
        Ok((surfaces.unwrap_or_else(|| meeting.surfaces([0, 0])), zones))
    }

    /// Flanks that were generated like measured traces.
    fn like(&self) -> LikeMeasured {
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
    fn sampled(&self, flanks: &[Vec<Flank>; 2]) -> SampledFlanks {
        let of = |body: usize| {
            let traces = self.sites[body].iter().zip(&flanks[body]);
            let traces = traces.map(|(site, flank)| SampledTrace::new(*site, flank.report.clone()));
            traces.collect()
        };
        SampledFlanks::new([of(0), of(1)], self.named)
    }
}

/// Whether patches are in contact: as stated, or where a flank is a scan, the other a scan or a trace, and the ridges of one run less
/// across the face than those with which the contact of lines is confirmed.
fn takes_patch(
    context: Context<'_>,
    named: &NamedTraces,
    known: &[Vec<Known>; 2],
    is_scan: [bool; 2],
    warnings: &mut Vec<Warning>,
) -> bool {
    if let Some(stated) = context.inputs.surface.contact {
        return stated == ContactName::Patch;
    }
    let is_traced = |known: &[Known]| match known {
        [(flank, _)] => matches!(flank.texture, Texture::Trace(_)),
        _ => false,
    };
    if is_scan == [false; 2]
        || !context.inputs.has_patches
        || !known.iter().all(|known| is_traced(known))
    {
        return false;
    }
    let lay_of = |body: usize| {
        let (listed, (flank, _)) = (named.lists[body].first()?, known[body].first()?);
        let measured = || median_lay(listed, flank, &named.keys[body], context);
        match (is_scan[body], context.inputs.lay) {
            (true, _) => measured(),
            (false, Some(lay)) => Some(lay[body]),
            (false, None) => Some(measured().unwrap_or(Lay::ACROSS)),
        }
    };
    let [Some(pinion), Some(wheel)] = [0, 1].map(lay_of) else {
        return false;
    };
    if pinion <= Lay::CONFIRMED && wheel <= Lay::CONFIRMED {
        return false;
    }
    let reports = known.iter().flatten().map(|(flank, _)| &flank.report);
    let along = spacing_of(context.inputs.largest_spacing, reports).unwrap_or_default();
    let narrow = named.lists.iter().flatten().find_map(|listed| {
        let scan = listed.scan.as_ref()?;
        let rows = rows_of_patches(scan.surface.rows, scan.apart()?, along);
        (rows < LEAST_ROWS).then_some((scan, rows))
    });
    if let Some((scan, rows)) = narrow {
        let text = format!(
            "{} has {rows} rows at the spacing of patches, which need {LEAST_ROWS}: its rows are taken as traces, though a lay above 1/6 asks for patches. Scan a wider part of the flank",
            scan.surface.name
        );
        warnings.push(Warning::new(Code::W464, text));
    }
    narrow.is_none()
}

/// Number of the rows of the scan of a flank, known by its middle row, that are computed as traces.
fn scan_of_lines(
    (body, named): (usize, &NamedTraces),
    known: &[Known],
    context: Context<'_>,
) -> Result<usize, CaseError> {
    let ([listed], [(flank, _)]) = (named.lists[body].as_slice(), known) else {
        return Ok(1);
    };
    let whole = whole(body, (listed, flank), &named.keys[body], context)?;
    Ok(rows_needed(&whole))
}

/// W447: traces of a list that are lines of one surface, which is of one tooth.
fn of_one_tooth((list, keys): (&Vec<Listed>, &Keys)) -> Option<Warning> {
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

/// Teeth and places of the traces of a list.
fn sites_of(list: &[Listed]) -> Vec<TraceSite> {
    list.iter().map(|trace| trace.site).collect()
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
    keys: &[Keys; 2],
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
    match inputs.has_one_position && !zones.is_empty() {
        false => Ok(()),
        true => Err(CaseError::Conflict {
            place: source.place_of(&keys[0].traces()),
            key: keys[0].traces(),
            rule: "y tells traces of one tooth apart across the face, and a single position represents the mesh",
        }),
    }
}
