//! One flank of a case: its trace read and prepared, or its roughness values.

use std::borrow::Cow;
use std::path::Path;

use asperity_core::quantity::Length;
use asperity_core::remedy::Remedy;
use asperity_core::{DomainError, Profile};
use asperity_gear::Gear;
use asperity_profile_io::Warning as ReadWarning;
use asperity_profile_io::read::steepness::implausible;
use asperity_profile_io::read::{
    LengthUnit, ReadFault, ReadOptions, Reading, TraceCut, TraceLine, read_surface_bytes,
    read_with_conditions,
};
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::outliers::{OutlierRecord, Outliers, replace};
use asperity_roughness::preparation::{Preparation, RoughnessFilter, prepare, profiles};
use asperity_roughness::{Parameters, Warning as RoughnessWarning};

use super::defaults::DefaultUsed;
use super::error::CaseError;
use super::files::{Content, Reader};
use super::flank_form::{self, FormError};
use super::flank_place::{PlaceError, PlaceKeys, ReadPlace, read_place};
use super::flank_sample::{self, Listed};
use super::input::{FlankInput, Side};
use super::resolve::Case;
use super::section::{Section, domain};
use super::source::Source;
use super::trace_filters::Filters;
use crate::flanks::placement::PlacedTrace;
use crate::flanks::surfaces::{FlankReport, Texture};
use crate::key_words::with_keys;
use asperity_core::message::Warning;

/// Case, text and files that both flanks are read with.
#[derive(Clone, Copy)]
pub(super) struct Context<'a> {
    pub case: &'a Case,
    pub source: &'a Source,
    pub files: &'a Reader<'a>,
}

/// A flank with its trace, if there is one.
pub(super) struct Flank {
    pub texture: Texture,
    pub report: FlankReport,
    pub raw: Option<Profile>,
    /// Roughness values that follow from others.
    pub assumed: Vec<DefaultUsed>,
    /// Place on the flank, if it is known.
    pub placed: Option<PlacedTrace>,
}

/// Table of a flank in the case file, and the keys at which file and place of a trace are stated.
#[derive(Clone)]
pub(super) struct Keys {
    pub table: &'static str,
    pub file: Cow<'static, str>,
    pub at: Cow<'static, str>,
}

impl Keys {
    /// The list of traces.
    pub(super) fn traces(&self) -> Cow<'static, str> {
        format!("{}.traces", self.table).into()
    }
}

/// The keys of pinion and wheel; the wheel may use the trace of the pinion.
pub(super) fn keys_of(side: Side, wheel_has_its_own: bool) -> [Keys; 2] {
    let tables = match side {
        Side::Drive => ["surface.pinion", "surface.wheel"],
        Side::Coast => ["surface.coast.pinion", "surface.coast.wheel"],
    };
    let files = match wheel_has_its_own {
        true => tables,
        false => [tables[0]; 2],
    };
    [0, 1].map(|body: usize| Keys {
        table: tables[body],
        file: format!("{}.file", files[body]).into(),
        at: format!("{}.at", tables[body]).into(),
    })
}

/// The traces that the keys of a flank name; a single one without a list.
pub(super) fn traces_of(
    input: &FlankInput,
    keys: &Keys,
    context: Context<'_>,
) -> Result<Vec<Listed>, CaseError> {
    let section = Section::of(context.source, keys.table);
    let Some(list) = &input.traces else {
        return match (input.rows, &input.file) {
            (None, _) => Ok(vec![Listed::alone(input)]),
            (Some(_), None) => Err(section.conflict("rows", "needs file, the surface")),
            (Some(rows), Some(file)) => {
                let has = surface_rows(input, file, keys, context)?;
                flank_sample::rows(input, rows, has, section)
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
        let rule = "stands in place of file and of rq, ra and rz; give one of them";
        return Err(section.conflict("traces", rule));
    }
    flank_sample::listed(input, list, section, context.files)
}

/// Reads and prepares a trace, or takes the roughness values of a flank without one.
pub(super) fn flank(
    listed: &Listed,
    keys: &Keys,
    context: Context<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<Flank, CaseError> {
    let section = Section::of(context.source, keys.table);
    let input = &listed.input;
    let value = input.rq.or(input.ra).or(input.rz);
    match (&input.file, value) {
        (Some(_), Some(_)) if input.rq.is_some() => {
            Err(section.conflict("", "give either file or rq, not both"))
        }
        (None, None) => {
            let rule = "give file, the trace of the flank, or rq (ra or rz) when there is none";
            Err(section.conflict_of_key("", rule))
        }
        (None, Some(_)) if flank_form::is_from_trace(context.case, gear_of(keys.table)) => {
            let none = "a flank known by roughness values alone";
            let of = (context.case, gear_of(keys.table));
            let error = FormError::NotPlaced;
            Err(flank_form::refused(
                error,
                of,
                (none, &keys.at),
                context.source,
            ))
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
            trace(input, file, &keys, context, warnings)
        }
    }
}

fn values(input: &FlankInput, section: Section<'_>) -> Result<Flank, CaseError> {
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
    Ok(Flank {
        texture,
        report: FlankReport::default(),
        raw: None,
        assumed,
        placed: None,
    })
}

fn trace(
    input: &FlankInput,
    file: &Path,
    keys: &Keys,
    context: Context<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<Flank, CaseError> {
    let case = context.case;
    let gear = gear_of(keys.table);
    // The name in the case, which errors repeat; warnings, which are listed on pages, shorten a full path.
    let name = file.display().to_string();
    let short = match file.file_name().filter(|_| file.is_absolute()) {
        Some(last) => last.to_string_lossy().into_owned(),
        None => name.clone(),
    };
    let mut read = read_trace(input, file, keys, context)?;
    let place = place_of(input, &mut read, keys, context)?;
    let mirrored = match &place {
        Some(place) => place.turned,
        None => input.mirrored.unwrap_or(false),
    };
    let raw = if mirrored {
        read.profile.mirrored()
    } else {
        read.profile.clone()
    };
    let refused = |source| CaseError::preparation(&name, source);
    let mut filters = Filters::of(case, &short, read.reading.as_ref());
    if let Some(place) = place.filter(|place| place.reference.is_some()) {
        filters.keep_ends(case, keys.table, &place);
    }
    let of_form =
        |error| flank_form::refused(error, (case, gear), (&name, &keys.at), context.source);
    let form_cutoff = filters.part_form(case, gear, read.reading.as_ref());
    let form_cutoff = form_cutoff.map_err(of_form)?;
    let preparation = &filters.preparation;
    let (mut prepared, waviness) = match form_cutoff {
        None => (prepare(&raw, preparation).map_err(refused)?, None),
        Some(_) => {
            let parted = profiles(&raw, preparation, RoughnessFilter::Gaussian).map_err(refused)?;
            (parted.roughness, parted.waviness)
        }
    };
    if form_cutoff.is_some() {
        // The form was left in, to be separated from the roughness.
        prepared
            .warnings
            .retain(|warning| !matches!(warning, RoughnessWarning::FormNotRemoved { .. }));
    }
    // Without a cut-off the whole trace is one evaluation of five sections, and nothing is filtered twice.
    let lambda_c = preparation.lambda_c;
    let section = lambda_c.unwrap_or_else(|| prepared.profile.length() / 5.0);
    let parameters = Parameters::of(&prepared.profile, Mode::Iso4287, section).map_err(refused)?;
    check_mean(
        (input, keys, context),
        (file, &short),
        preparation,
        (section, parameters.heights.rq),
    )?;
    // A wheel without a trace has the keys of the pinion.
    let table = keys
        .file
        .rsplit_once('.')
        .map_or(keys.table, |(table, _)| table);
    let mut warn = |code, warning: &dyn std::fmt::Display, remedy: Remedy| {
        let message = format!("{short}: {warning}");
        warnings.push(Warning::new(code, with_keys(&message, &remedy, table)));
    };
    for warning in read.reading.iter().flat_map(|reading| &reading.warnings) {
        if lambda_c.is_some() || *warning != ReadWarning::AlreadyFiltered {
            warn(warning.code(), warning, warning.remedy());
        }
    }
    let replaced = read.outliers.as_ref().and_then(OutlierRecord::warning);
    let prepared_warnings = prepared.warnings.iter().chain(&parameters.warnings);
    for warning in replaced.iter().chain(prepared_warnings) {
        let warning = warning.clone().on_trace(mirrored, raw.length(), read.start);
        warn(warning.code(), &warning, warning.remedy());
    }
    warnings.extend(filters.overridden.into_iter().chain(filters.parted));
    let placed = place.and_then(|place| {
        Some(PlacedTrace {
            first_arc: place.first_arc(raw.len(), raw.spacing(), prepared.first_index)?,
            direction: case.gears.arc_direction(gear),
            base_radius: case.gears.base_radius[gear as usize].si().abs(),
        })
    });
    let form = match (form_cutoff, &waviness, &placed) {
        (None, ..) => None,
        (Some(cutoff), Some(waviness), Some(placed)) => {
            Some(flank_form::measured(waviness, cutoff, placed, (case, gear)).map_err(of_form)?)
        }
        (Some(_), ..) => return Err(of_form(FormError::NotPlaced)),
    };
    let report = FlankReport {
        form,
        trace: Some(read.profile.clone()),
        file: Some(name),
        sha256: read.sha256,
        mirrored,
        outliers: read.outliers,
        preparation: Some(prepared.record),
        parameters: Some(parameters),
        reading: read.reading,
        surrogates: None,
        roll_lengths: placed.map(|placed| placed.roll_lengths(&prepared.profile)),
    };
    Ok(Flank {
        texture: Texture::Trace(prepared.profile),
        report,
        raw: Some(read.profile),
        assumed: filters.stated,
        placed,
    })
}

/// Rejects the mean of a surface whose Rq is far below the Rq of single lines.
fn check_mean(
    (input, keys, context): (&FlankInput, &Keys, Context<'_>),
    (file, name): (&Path, &str),
    preparation: &Preparation,
    (section, mean): (Length, Length),
) -> Result<(), CaseError> {
    /// Smallest Rq of a mean, as a share of the Rq of its lines.
    const LEAST: f64 = 0.9;
    /// Lines that are compared.
    const LINES: usize = 8;
    let single = match input.line {
        Some(TraceLine::Mean) => TraceLine::Row,
        Some(TraceLine::MeanColumn) => TraceLine::Column,
        _ => return Ok(()),
    };
    let of_line = |row: usize| {
        let line = FlankInput {
            line: Some(single),
            row: Some(row),
            ..input.clone()
        };
        // A line with missing points has no parameters, but the mean may.
        let line = read_trace(&line, file, keys, context).ok()?;
        let line = prepare(&line.profile, preparation).ok()?.profile;
        let parameters = Parameters::of(&line, Mode::Iso4287, section).ok()?;
        Some(parameters.heights.rq.si().powi(2))
    };
    let across = lines_across(input, file, keys, context, single)?;
    let rows = (0..LINES).map(|k| (2 * k + 1) * across / (2 * LINES) + 1);
    let squares: Vec<f64> = rows.filter_map(of_line).collect();
    let lines = (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt();
    match mean.si() < LEAST * lines {
        true => Err(CaseError::averaged_out(
            context.source.place_of(&keys.file),
            name,
            mean,
            Length::from_si(lines),
        )),
        false => Ok(()),
    }
}

/// The gear of a table of the flanks.
fn gear_of(key: &str) -> Gear {
    match key {
        "surface.wheel" | "surface.coast.wheel" => Gear::Wheel,
        _ => Gear::Pinion,
    }
}

/// Place of a trace on its flank. Deviations over roll lengths count along the transverse base tangent and are turned into
/// heights normal to the flank.
fn place_of(
    input: &FlankInput,
    read: &mut ReadTrace,
    keys: &Keys,
    context: Context<'_>,
) -> Result<Option<ReadPlace>, CaseError> {
    let (gears, source) = (&context.case.gears, context.source);
    let arc = read.reading.as_ref().and_then(|r| r.metadata.arc_from_base);
    if arc.is_some() {
        let normal = gears.base_helix.si().cos();
        let heights = read.profile.heights().iter().map(|z| z * normal).collect();
        read.profile =
            Profile::new(read.profile.spacing(), heights).map_err(domain(source, keys.table))?;
    }
    let stated = PlaceKeys {
        from: input.from,
        at: input.at,
        is_mirrored: input.mirrored.is_some(),
    };
    read_place(stated, gears, gear_of(keys.table), arc, read.start).map_err(|error| match error {
        PlaceError::Rule(rule) => CaseError::Conflict {
            place: source.place_of(&keys.at),
            key: keys.at.clone(),
            rule,
        },
        PlaceError::Domain(error) => domain(source, keys.at.clone())(error),
    })
}

/// A trace as measured, with the record of its reading and the SHA-256 of its file if it comes from one.
struct ReadTrace {
    profile: Profile,
    reading: Option<Reading>,
    sha256: Option<String>,
    /// Distance of its first point from the first point measured.
    start: Length,
    /// Spikes replaced.
    outliers: Option<OutlierRecord>,
}

/// The trace in `file`, read as its keys state.
fn read_trace(
    input: &FlankInput,
    file: &Path,
    keys: &Keys,
    context: Context<'_>,
) -> Result<ReadTrace, CaseError> {
    let source = context.source;
    let cleaned = |profile: &Profile| -> Result<Option<_>, CaseError> {
        let Some(deviations) = context.case.input.surface.outliers else {
            return Ok(None);
        };
        let cleaned = replace(profile, Outliers::beyond(deviations));
        let cleaned =
            cleaned.map_err(|source| CaseError::preparation(file.display().to_string(), source))?;
        Ok(Some(cleaned))
    };
    let name = file.display().to_string();
    let refused = |error| CaseError::profile(source.place_of(&keys.file), &error);
    let (bytes, sum) = match context.files.open(file, source, keys.file.clone())? {
        (Content::Bytes(bytes), sum) => (bytes, sum),
        (Content::Heights(profile), _) => {
            let cut = input
                .range
                .map(|range| TraceCut::of_profile(&name, &profile, range));
            let (profile, start) = match cut.transpose().map_err(refused)? {
                Some((part, cut)) => (part, cut.start),
                None => (profile.as_ref().clone(), Length::default()),
            };
            let profile = match input.invert {
                Some(true) => {
                    let heights = profile.heights().iter().map(|z| -z).collect();
                    Profile::new(profile.spacing(), heights).map_err(domain(source, keys.table))?
                }
                _ => profile,
            };
            let (profile, outliers) = match cleaned(&profile)? {
                Some((cleaned, record)) => (cleaned, Some(record)),
                None => (profile, None),
            };
            if let Some(mut steepness) = implausible(&profile, LengthUnit::Metre) {
                steepness.suspicion = steepness.suspicion.on_trace(start);
                let fault = ReadFault::implausible_heights(steepness);
                return Err(refused(fault.in_file(&name)));
            }
            return Ok(ReadTrace {
                profile,
                reading: None,
                start,
                sha256: None,
                outliers,
            });
        }
    };
    // Roll lengths are those of the gear, unless the case states a base radius.
    let gear = gear_of(keys.table) as usize;
    let options = ReadOptions {
        base_radius: input.base_radius.or(Some(Length::from_si(
            context.case.gears.base_radius[gear].si().abs(),
        ))),
        ..read_options(input)
    };
    let conditions = context.files.conditions(file);
    let read = read_with_conditions(&name, &bytes, conditions.as_deref(), &options);
    let reading = read.map_err(refused)?;
    let (reading, outliers) = match cleaned(&reading.profile)? {
        Some((cleaned, record)) => (reading.corrected(cleaned), Some(record)),
        None => (reading, None),
    };
    reading.check_heights().map_err(refused)?;
    if !reading.format.may_hold_several() {
        let rule = match input.line {
            Some(_) => Some("this file holds a single profile; leave line out"),
            None if input.row.unwrap_or(1) > 1 => {
                Some("this file holds a single profile; leave row out")
            }
            None => None,
        };
        if let Some(rule) = rule {
            return Err(CaseError::Conflict {
                place: source.place_of(&keys.file),
                key: keys.file.clone(),
                rule,
            });
        }
    }
    Ok(ReadTrace {
        profile: reading.profile.clone(),
        sha256: Some(sum),
        start: reading.cut.map_or(Length::default(), |cut| cut.start),
        reading: Some(reading),
        outliers,
    })
}

/// Number of rows of the surface in `file`.
fn surface_rows(
    input: &FlankInput,
    file: &Path,
    keys: &Keys,
    context: Context<'_>,
) -> Result<usize, CaseError> {
    lines_across(input, file, keys, context, TraceLine::Row)
}

/// Number of rows or columns of the surface in `file`.
fn lines_across(
    input: &FlankInput,
    file: &Path,
    keys: &Keys,
    context: Context<'_>,
    line: TraceLine,
) -> Result<usize, CaseError> {
    let source = context.source;
    let (content, _) = context.files.open(file, source, keys.file.clone())?;
    let Content::Bytes(bytes) = content else {
        return Ok(1);
    };
    let name = file.display().to_string();
    let surface = read_surface_bytes(&name, &bytes, &read_options(input));
    let refused = |error| CaseError::profile(source.place_of(&keys.file), &error);
    let surface = surface.map_err(refused)?;
    Ok(match line {
        TraceLine::Row | TraceLine::Mean => surface.rows,
        _ => surface.columns,
    })
}

/// Options of the reader from the keys of a flank.
pub(super) fn read_options(input: &FlankInput) -> ReadOptions {
    // The other keys name the trace, its place, or roughness values.
    let &FlankInput {
        x_unit,
        z_unit,
        dx,
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
