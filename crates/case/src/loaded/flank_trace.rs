//! One flank of a case: the keys of its trace, and the places of what is wrong with it.

use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;

use asperity_core::message::Warning;
use asperity_core::quantity::Length;
use asperity_core::remedy::Remedy;
use asperity_core::{Code, DomainError, Profile};
use asperity_flanks::flank_form::FormError;
use asperity_flanks::read_place::PlaceError;
use asperity_flanks::surfaces::{FlankReport, Texture};
use asperity_flanks::trace::{
    Flank, PreparedTrace, TraceContent, TraceError, TraceInputs, prepared_trace,
};
use asperity_flanks::trace_filters::{Filters, StatedFilters};
use asperity_gear::Gear;
use asperity_profile_io::Warning as ReadWarning;
use asperity_profile_io::read::{Gaps, ReadOptions, TraceLine};

use super::flank_inputs::FlankInputs;
use super::flank_sample::{self, Listed};
use super::scans::{Scan, Scans};
use crate::input::case_input::{FlankInput, Side};
use crate::input::files::{Content, Reader};
use crate::input::flank_place::stated_place;
use crate::key_words::with_keys;
use crate::source::case_error::CaseError;
use crate::source::defaults::DefaultUsed;
use crate::source::section::{Section, domain};
use crate::source::source_text::Source;

/// Inputs of the flanks of a case, with the text and the files that both are read with.
#[derive(Clone, Copy)]
pub(crate) struct Context<'a> {
    pub inputs: &'a FlankInputs,
    pub source: &'a Source,
    pub files: &'a Reader<'a>,
    pub scans: &'a Scans,
}

impl Context<'_> {
    /// The scan in the file of a flank; `None` of heights in memory.
    pub(crate) fn scan(
        self,
        input: &FlankInput,
        file: &Path,
        keys: &FlankKeys,
    ) -> Result<Option<Scan>, CaseError> {
        // Keys that choose a line do not change the surface.
        let options = ReadOptions {
            row: None,
            line: TraceLine::Row,
            range: None,
            gaps: Gaps::default(),
            ..read_options(input)
        };
        let outliers = self.inputs.surface.outliers;
        let (files, source) = (self.files, self.source);
        self.scans
            .read(file, keys.file.clone(), options, outliers, files, source)
    }
}

/// A flank, and the values of it that follow from others.
pub(crate) type KnownTrace = (Flank, Vec<DefaultUsed>);

/// Table of a flank in the case file, and the keys at which file and place of a trace are stated.
#[derive(Clone)]
pub(crate) struct FlankKeys {
    pub table: &'static str,
    pub file: Cow<'static, str>,
    pub at: Cow<'static, str>,
}

impl FlankKeys {
    /// The list of traces.
    pub(crate) fn traces(&self) -> Cow<'static, str> {
        format!("{}.traces", self.table).into()
    }
}

/// The keys of pinion and wheel; the wheel may use the trace of the pinion.
pub(crate) fn keys_of(side: Side, wheel_has_its_own: bool) -> [FlankKeys; 2] {
    let tables = match side {
        Side::Drive => ["surface.pinion", "surface.wheel"],
        Side::Coast => ["surface.coast.pinion", "surface.coast.wheel"],
    };
    let files = if wheel_has_its_own {
        tables
    } else {
        [tables[0]; 2]
    };
    [0, 1].map(|body: usize| FlankKeys {
        table: tables[body],
        file: format!("{}.file", files[body]).into(),
        at: format!("{}.at", tables[body]).into(),
    })
}

/// The traces that the keys of a flank name; a single one without a list.
pub(crate) fn traces_of(
    input: &FlankInput,
    keys: &FlankKeys,
    context: Context<'_>,
) -> Result<Vec<Listed>, CaseError> {
    let section = Section::new(context.source, keys.table);
    let Some(list) = &input.traces else {
        return match (input.rows, &input.file) {
            (None, _) => Ok(vec![Listed::alone(input)]),
            (Some(_), None) => Err(section.conflict("rows", "needs file, the surface")),
            (Some(rows), Some(file)) => {
                let scan = context.scan(input, file, keys)?;
                flank_sample::rows(input, rows, scan.as_ref(), section)
            }
        };
    };
    if input.rows.is_some() {
        return Err(section.conflict(
            "rows",
            "takes rows of file; a list names a row of each file",
        ));
    }
    if input.file.is_some() || input.rq.or(input.ra).or(input.rz).is_some() {
        let rule = "is given instead of file and of rq, ra and rz; give one of them";
        return Err(section.conflict("traces", rule));
    }
    flank_sample::listed(input, "traces", list, section, context.files)
}

/// Reads and prepares a trace, or takes the roughness values of a flank without one.
pub(crate) fn flank(
    listed: &Listed,
    keys: &FlankKeys,
    context: Context<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<KnownTrace, CaseError> {
    let section = Section::new(context.source, keys.table);
    let input = &listed.input;
    let value = input.rq.or(input.ra).or(input.rz);
    if let Some(generated) = &listed.generated {
        let name = generated.record.to_string();
        return trace(listed, &name, &name, keys, context, warnings);
    }
    match (&input.file, value) {
        (Some(_), Some(_)) if input.rq.is_some() => {
            Err(section.conflict("", "give either file or rq, not both"))
        }
        (None, None) => {
            let rule = "give file, the trace of the flank, or rq (ra or rz) when there is none";
            Err(section.conflict_of_key("", rule))
        }
        (None, Some(_)) if context.inputs.has_form_of_trace(gear_of(keys.table)) => {
            let none = "a flank known by roughness values alone";
            Err(no_form(FormError::NotPlaced, none, keys, context))
        }
        (None, Some(_)) => values(input, section),
        (Some(file), _) => {
            let mut keys = keys.clone();
            if listed.is_of_a_list {
                keys.file = keys.traces();
            }
            if listed.has_own_place {
                keys.at = keys.traces();
            }
            // The name in the case, which errors repeat; warnings, which are listed on pages, shorten a full path.
            let name = file.display().to_string();
            let short = match file.file_name().filter(|_| file.is_absolute()) {
                Some(last) => last.to_string_lossy().into_owned(),
                None => name.clone(),
            };
            trace(listed, &name, &short, &keys, context, warnings)
        }
    }
}

fn values(input: &FlankInput, section: Section<'_>) -> Result<KnownTrace, CaseError> {
    let checked = |key: &str, name, length: Option<Length>| {
        let checked = length.map(|length| DomainError::positive(name, length));
        checked.transpose().map_err(section.domain(key))
    };
    /// Ra of a Gaussian surface is Rq·√(2/π).
    const GAUSSIAN_RA: f64 = 0.797_884_560_802_865_4;
    /// Rz of a Gaussian surface over five cut-offs is near six times its Rq.
    const GAUSSIAN_RZ: f64 = 6.0;
    let mut assumed = Vec::new();
    let mut follows = |name: &str, value: f64, source: &'static str| {
        assumed.push(DefaultUsed {
            key: section.key(name),
            value: format!("\"{:.4}\"", Length::from_si(value)),
            source: Some(source.into()),
        });
        value
    };
    let stated = [
        checked("rq", "Rq", input.rq)?,
        checked("ra", "Ra", input.ra)?,
        checked("rz", "Rz", input.rz)?,
    ];
    let rq = match stated {
        [Some(rq), ..] => rq,
        [None, Some(ra), _] => follows("rq", ra / GAUSSIAN_RA, "Ra/0.798, a Gaussian surface"),
        [None, None, rz] => {
            let rz = rz.unwrap_or_default();
            follows("rq", rz / GAUSSIAN_RZ, "Rz/6, a Gaussian surface")
        }
    };
    let ra = stated[1]
        .unwrap_or_else(|| follows("ra", GAUSSIAN_RA * rq, "0.798 Rq, a Gaussian surface"));
    let rz =
        stated[2].unwrap_or_else(|| follows("rz", GAUSSIAN_RZ * rq, "6 Rq, a Gaussian surface"));
    let texture = Texture::Values {
        rq,
        ra,
        rz,
        rpk: checked("rpk", "Rpk", input.rpk)?,
        asperity_radius: checked("asperity_radius", "asperity radius", input.asperity_radius)?
            .map(Length::from_si),
    };
    let flank = Flank {
        texture,
        report: FlankReport::default(),
        raw: None,
        placed: None,
    };
    Ok((flank, assumed))
}

fn trace(
    listed: &Listed,
    name: &str,
    short: &str,
    keys: &FlankKeys,
    context: Context<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<KnownTrace, CaseError> {
    let (inputs, input) = (context.inputs, &listed.input);
    let gear = gear_of(keys.table);
    let mut source = Opened::new(listed, keys, context)?;
    let of_trace = TraceInputs {
        name,
        options: &read_options(input),
        is_line_stated: input.line.is_some(),
        outliers: inputs.surface.outliers,
        place: stated_place(input.from, input.at, input.mirrored),
        filters: inputs.filters(),
        needed_of_scan: listed.scan.as_ref().map(|_| inputs.needed_length),
        shortest_form: if inputs.has_form_of_trace(gear) {
            let shortest = inputs.shortest_form.clone();
            shortest.map_err(|error| no_form(error, name, keys, context))?
        } else {
            None
        },
    };
    let prepared = prepared_trace(source.content(), of_trace, &inputs.gears, gear);
    let prepared = prepared.map_err(|error| placed(error, name, short, keys, context))?;
    let PreparedTrace {
        mut flank,
        filters,
        assumed_from,
        statements,
        warnings: doubts,
    } = prepared;
    flank.report.sha256 = source.sum;
    flank.report.generated = listed.generated.as_ref().map(|made| made.record.clone());
    // A wheel without a trace has the keys of the pinion.
    let table = keys
        .file
        .rsplit_once('.')
        .map_or(keys.table, |(table, _)| table);
    let mut warn = |code, warning: &dyn std::fmt::Display, remedy: Remedy| {
        let message = format!("{short}: {warning}");
        warnings.push(Warning::new(code, with_keys(&message, &remedy, table)));
    };
    for warning in &statements.warnings {
        if filters.preparation.lambda_c.is_some() || *warning != ReadWarning::AlreadyFiltered {
            warn(warning.code(), warning, warning.remedy());
        }
    }
    for warning in &doubts {
        warn(warning.code(), warning, warning.remedy());
    }
    warnings.extend(overridden(&filters, inputs.filters(), short));
    warnings.extend(parted(&filters, gear));
    let raw = flank.raw.as_ref();
    warnings.extend(
        raw.into_iter()
            .flat_map(|raw| of_scan(&filters, raw, short)),
    );
    Ok((flank, stated(&filters, assumed_from, short, keys)))
}

/// The heights of a trace, in a file or in memory.
struct Opened {
    /// A scan of which the trace is a row; else the content of its own.
    source: Result<Scan, Content>,
    conditions: Option<Arc<[u8]>>,
    /// Sum of a file.
    sum: Option<String>,
}

impl Opened {
    fn new(listed: &Listed, keys: &FlankKeys, context: Context<'_>) -> Result<Self, CaseError> {
        if let Some(generated) = &listed.generated {
            return Ok(Self {
                source: Err(Content::Heights(generated.heights.clone())),
                conditions: None,
                sum: None,
            });
        }
        if let Some(scan) = &listed.scan {
            return Ok(Self {
                source: Ok(scan.clone()),
                conditions: None,
                sum: Some(scan.sum.to_string()),
            });
        }
        let file = listed.input.file.as_deref().unwrap_or(Path::new(""));
        let (content, sum) = context
            .files
            .open(file, context.source, keys.file.clone())?;
        let is_file = matches!(content, Content::Bytes(_));
        let conditions = || context.files.conditions(file);
        Ok(Self {
            conditions: is_file.then(conditions).flatten(),
            sum: is_file.then_some(sum),
            source: Err(content),
        })
    }

    /// The content, without the bytes of a file after the first time.
    fn content(&mut self) -> TraceContent<'_> {
        match &mut self.source {
            Ok(scan) => TraceContent::Scan(&scan.surface),
            Err(Content::Bytes(bytes)) => {
                TraceContent::Bytes(std::mem::take(bytes), self.conditions.take())
            }
            Err(Content::Heights(held)) => TraceContent::Heights(&held.profile, &held.statements),
        }
    }
}

/// Values of the filters that a file states, or that follow from the place of its trace.
fn stated(filters: &Filters, assumed_from: bool, file: &str, keys: &FlankKeys) -> Vec<DefaultUsed> {
    let mut stated: Vec<DefaultUsed> = Vec::new();
    for (key, of_file) in CUTOFFS.into_iter().zip(filters.of_file) {
        stated.extend(of_file.map(|of_file| DefaultUsed {
            key: key.into(),
            value: format!("\"{of_file}\""),
            source: Some(format!("stated in {file}").into()),
        }));
    }
    if filters.keeps_ends {
        stated.push(DefaultUsed {
            key: "surface.ends".into(),
            value: "\"reg1\"".to_owned(),
            source: Some("a placed trace keeps its ends".into()),
        });
    }
    if filters.keeps_ends_of_scan {
        stated.push(DefaultUsed {
            key: "surface.ends".into(),
            value: "\"reg1\"".to_owned(),
            source: Some(format!("{file} is too short to drop its ends").into()),
        });
    }
    stated.extend(filters.of_spacing.map(|cutoff| DefaultUsed {
        key: CUTOFFS[1].into(),
        value: format!("\"{cutoff:.4}\""),
        source: Some(format!("five times the distance of the points of {file}").into()),
    }));
    if assumed_from {
        stated.push(DefaultUsed {
            key: format!("{}.from", keys.table).into(),
            value: "\"root\"".to_owned(),
            source: None,
        });
    }
    if filters.keeps_form {
        stated.push(DefaultUsed {
            key: "surface.form".into(),
            value: "\"none\"".to_owned(),
            source: Some("of a trace that the relief is taken from".into()),
        });
    }
    stated
}

/// Keys of λc and λs.
const CUTOFFS: [&str; 2] = ["surface.cutoff", "surface.noise_cutoff"];

/// W129: cut-offs that differ between the case and the file.
fn overridden(filters: &Filters, stated: StatedFilters, file: &str) -> Option<Warning> {
    let each = CUTOFFS.into_iter().zip(["λc", "λs"]);
    let cutoffs = filters.overridden.into_iter().zip(stated.cutoffs);
    let others = each
        .zip(cutoffs)
        .filter_map(|((key, name), (of_file, stated))| {
            Some(format!("{name} {}, the case {key} = {}", of_file?, stated?))
        });
    let others: Vec<String> = others.collect();
    (!others.is_empty()).then(|| {
        Warning::new(
            Code::W129,
            format!("{file}: the file states {}", others.join("; ")),
        )
    })
}

/// W465 and W466: filters of a scan that differ from the filters of a trace.
fn of_scan(filters: &Filters, row: &Profile, file: &str) -> Vec<Warning> {
    let mut warnings = Vec::new();
    if filters.keeps_ends_of_scan {
        let text = format!(
            "{file}: the scan is {:.3} long, too short to drop half a cut-off at both ends. Its ends remain, filtered by regression: heights there are less certain",
            row.length()
        );
        warnings.push(Warning::new(Code::W465, text));
    }
    if let Some(cutoff) = filters.of_spacing {
        let text = format!(
            "{file}: the points are {:.4} apart. The noise cut-off is {cutoff:.4}, and shorter waves of the flank are not in the loss",
            row.spacing()
        );
        warnings.push(Warning::new(Code::W466, text));
    }
    warnings
}

/// W434: a cut-off between form and roughness that is longer than stated.
fn parted(filters: &Filters, gear: Gear) -> Option<Warning> {
    let (shortest, stated) = filters.parted?;
    let stated = stated.map_or("no cut-off".to_owned(), |stated| format!("{stated}"));
    let text = format!(
        "form and roughness of the {gear} are parted at {:.2} mm, eight half-widths of the contact, instead of {stated}: shorter waves lie within a contact and count as roughness",
        shortest.si() * 1e3
    );
    Some(Warning::new(Code::W434, text))
}

/// An error of the trace `name` at the key that is to blame.
pub(crate) fn placed(
    error: TraceError,
    name: &str,
    short: &str,
    keys: &FlankKeys,
    context: Context<'_>,
) -> CaseError {
    let source = context.source;
    let conflict = |key: &Cow<'static, str>, rule| CaseError::Conflict {
        place: source.place_of(key),
        key: key.clone(),
        rule,
    };
    match error {
        TraceError::Read(error) => CaseError::profile(source.place_of(&keys.file), &error),
        TraceError::Preparation(error) => CaseError::preparation(name, error),
        TraceError::Heights(error) => domain(source, keys.table)(error),
        TraceError::Place(PlaceError::Rule(rule)) => conflict(&keys.at, rule),
        TraceError::Place(PlaceError::Domain(error)) => domain(source, keys.at.clone())(error),
        TraceError::Form(error) => no_form(error, name, keys, context),
        TraceError::OneProfile(rule) => conflict(&keys.file, rule),
        TraceError::AveragedOut { mean, lines } => {
            CaseError::averaged_out(source.place_of(&keys.file), short, mean, lines)
        }
    }
}

/// The error at the key of the relief of a gear, whose trace in `file` has no form.
fn no_form(error: FormError, file: &str, keys: &FlankKeys, context: Context<'_>) -> CaseError {
    let key = match gear_of(keys.table) {
        Gear::Pinion => "gears.pinion.relief",
        Gear::Wheel => "gears.wheel.relief",
    };
    let mm = |length: Length| format!("{:.3}", length.si() * 1e3);
    let message = match error {
        FormError::NotPlaced => format!(
            "the place of {file} on the flank is not known: give the roll length of a point of it, as {} = {{ roll_length = \"8.2 mm\" }}, or export it over roll lengths",
            keys.at
        ),
        FormError::Filtered => format!(
            "{file} holds a roughness profile, from which the form was removed: export the unfiltered deviations"
        ),
        FormError::Removed(form) => format!(
            "surface.form = \"{}\" removes the form that the relief needs: leave it out and give deviations from the involute",
            serde_json::to_value(form)
                .ok()
                .and_then(|name| Some(name.as_str()?.to_owned()))
                .unwrap_or_default()
        ),
        FormError::Short([from, to], [active_from, active_to]) => format!(
            "{file} reaches from roll length {} to {} mm, and the active flank from {} to {} mm: give a trace of all of it, or draw the relief",
            mm(from),
            mm(to),
            mm(active_from),
            mm(active_to)
        ),
        FormError::High(range, largest) => format!(
            "the form of {file} spans {:.1} um, and no relief of this module more than {:.0} um: the trace must be the deviation from the involute, levelled on the gear's axis",
            range.si() * 1e6,
            largest.si() * 1e6
        ),
        FormError::Unsolved(reason) => reason,
    };
    CaseError::value(context.source.place_of(key), Some(key), message)
}

/// The gear of a table of the flanks.
pub(crate) fn gear_of(key: &str) -> Gear {
    match key {
        "surface.wheel" | "surface.coast.wheel" => Gear::Wheel,
        _ => Gear::Pinion,
    }
}

/// Options of the reader from the keys of a flank.
pub(crate) fn read_options(input: &FlankInput) -> ReadOptions {
    // The other keys name the trace, its place, or roughness values.
    let &FlankInput {
        x_unit,
        z_unit,
        dx,
        dy,
        columns,
        decimal,
        separator,
        encoding,
        gaps,
        row,
        line,
        abscissa,
        base_radius,
        uneven,
        range,
        invert,
        file: _,
        traces: _,
        like: _,
        after: _,
        state: _,
        engagements: _,
        seed: _,
        mirrored: _,
        from: _,
        at: _,
        rows: _,
        finish: _,
        rq: _,
        ra: _,
        rz: _,
        rpk: _,
        asperity_radius: _,
    } = input;
    ReadOptions {
        x_unit,
        z_unit,
        dx,
        dy,
        columns,
        decimal,
        separator,
        encoding,
        gaps: gaps.unwrap_or_default(),
        row,
        line: line.unwrap_or_default(),
        abscissa,
        base_radius,
        uneven: uneven.unwrap_or_default(),
        range,
        invert,
    }
}
