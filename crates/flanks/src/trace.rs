//! One trace of a flank: read, turned along the flank, placed, filtered, with its roughness parameters.

use std::sync::Arc;

use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use asperity_gear::{Gear, GearPair};
use asperity_profile_io::read::steepness::implausible;
use asperity_profile_io::read::{
    LengthUnit, ReadError, ReadFault, ReadOptions, Reading, Surface, TraceCut, TraceLine,
    read_surface_bytes, read_with_conditions,
};
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::outliers::{OutlierRecord, Outliers, replace};
use asperity_roughness::preparation::{Preparation, RoughnessFilter, prepare, profiles};
use asperity_roughness::{Parameters, RoughnessError, Warning};

use crate::flank_form::{self, FormError};
use crate::placement::PlacedTrace;
use crate::read_place::{PlaceError, ReadPlace, StatedPlace, read_place};
use crate::statements::Statements;
use crate::surfaces::{FlankReport, Texture};
use crate::trace_filters::{Filters, StatedFilters};

/// Source of a trace.
#[derive(Debug, Clone)]
pub enum TraceContent<'a> {
    /// Heights in memory, and what is stated of them.
    Heights(&'a Profile, &'a Statements),
    /// The bytes of a file, which are dropped when its heights are read, and the bytes of its measuring conditions.
    Bytes(Arc<[u8]>, Option<Arc<[u8]>>),
    /// A scan that was read, of which the options name a row.
    Scan(&'a Surface),
}

/// Everything that the preparation of a trace follows from, except its content and the gears.
#[derive(Debug, Clone, Copy)]
pub struct TraceInputs<'a> {
    /// Name of the file, for messages.
    pub name: &'a str,
    /// Options of its reader.
    pub options: &'a ReadOptions,
    /// Whether the line of a surface is stated, which a file with a single profile refuses.
    pub is_line_stated: bool,
    /// Robust standard deviations beyond which spikes are replaced.
    pub outliers: Option<f64>,
    /// Statements about its place.
    pub place: StatedPlace,
    /// Filters.
    pub filters: StatedFilters,
    /// Length that the contacts need, if the trace is a row of a scan.
    pub needed_of_scan: Option<Length>,
    /// Shortest wave of the form, if the relief of the gear is taken from the trace.
    pub shortest_form: Option<Length>,
}

/// A flank with its trace, if there is one.
#[derive(Debug, Clone, PartialEq)]
pub struct Flank {
    /// The prepared trace, or roughness values.
    pub texture: Texture,
    /// Reading and preparation.
    pub report: FlankReport,
    /// The trace as read.
    pub raw: Option<Profile>,
    /// Place on the flank, if it is known.
    pub placed: Option<PlacedTrace>,
}

/// A prepared trace, with what its preparation found.
#[derive(Debug, Clone)]
pub struct PreparedTrace {
    /// The flank.
    pub flank: Flank,
    /// Filters that were used.
    pub filters: Filters,
    /// Whether the end at which the trace begins is assumed.
    pub assumed_from: bool,
    /// Statements about its heights.
    pub statements: Statements,
    /// Doubts about its preparation.
    pub warnings: Vec<Warning>,
}

/// Reasons for which a trace cannot be used.
#[derive(Debug)]
pub enum TraceError {
    /// The file cannot be read.
    Read(ReadError),
    /// Filters or parameters refuse the trace.
    Preparation(RoughnessError),
    /// Heights are out of their domain.
    Heights(DomainError),
    /// Statements about its place that contradict each other, or the gears.
    Place(PlaceError),
    /// The flank has no form.
    Form(FormError),
    /// A key that selects one of several profiles in a file with a single one.
    OneProfile(&'static str),
    /// The mean of a surface whose Rq is far below the Rq of single lines.
    AveragedOut {
        /// Rq of the mean.
        mean: Length,
        /// Rq of the lines.
        lines: Length,
    },
}

impl From<RoughnessError> for TraceError {
    fn from(error: RoughnessError) -> Self {
        Self::Preparation(error)
    }
}

impl From<ReadError> for TraceError {
    fn from(error: ReadError) -> Self {
        Self::Read(error)
    }
}

/// A trace as measured, with the record of its reading.
struct ReadTrace {
    profile: Profile,
    reading: Option<Reading>,
    statements: Statements,
    /// Distance of its first point from the first point measured.
    start: Length,
    /// Spikes replaced.
    outliers: Option<OutlierRecord>,
}

/// A trace of a flank of `gear` as measured, normal to the flank, with what is stated of it.
///
/// # Errors
/// When the trace cannot be read or placed.
pub fn measured(
    content: TraceContent<'_>,
    inputs: TraceInputs<'_>,
    gears: &GearPair,
    gear: Gear,
) -> Result<(Profile, Statements), TraceError> {
    let mut read = read_trace(&content, inputs, inputs.options, own_radius(gears, gear))?;
    place_of(inputs, &mut read, gears, gear)?;
    Ok((read.profile, read.statements))
}

/// Base radius of `gear`, also of a ring.
fn own_radius(gears: &GearPair, gear: Gear) -> Length {
    Length::from_si(gears.base_radius[gear as usize].si().abs())
}

/// Reads and prepares a trace of a flank of `gear`.
///
/// # Errors
/// When the trace cannot be read, placed, or prepared, and for the mean of a surface whose Rq is far below the Rq of single lines.
pub fn prepared_trace(
    content: TraceContent<'_>,
    inputs: TraceInputs<'_>,
    gears: &GearPair,
    gear: Gear,
) -> Result<PreparedTrace, TraceError> {
    let own_radius = own_radius(gears, gear);
    let mut read = read_trace(&content, inputs, inputs.options, own_radius)?;
    // Only the lines of a mean are read again.
    let lines = single_line(inputs.options).map(|line| (content, line));
    let place = place_of(inputs, &mut read, gears, gear)?;
    let mirrored = match &place {
        Some(place) => place.turned,
        None => inputs.place.mirrored.unwrap_or(false),
    };
    let raw = if mirrored {
        read.profile.mirrored()
    } else {
        read.profile.clone()
    };
    let mut filters = Filters::new(inputs.filters, &read.statements);
    if place.is_some_and(|place| place.reference.is_some()) {
        filters.keep_ends(inputs.filters);
    }
    if let Some(needed) = inputs.needed_of_scan {
        filters.fit_scan(inputs.filters, &raw, needed);
    }
    let form_cutoff = inputs
        .shortest_form
        .map(|shortest| filters.part_form(inputs.filters, shortest, &read.statements));
    let form_cutoff = form_cutoff.transpose().map_err(TraceError::Form)?;
    let preparation = &filters.preparation;
    let (mut prepared, waviness) = match form_cutoff {
        None => (prepare(&raw, preparation)?, None),
        Some(_) => {
            let parted = profiles(&raw, preparation, RoughnessFilter::Gaussian)?;
            (parted.roughness, parted.waviness)
        }
    };
    if form_cutoff.is_some() {
        // The form was left in, to be separated from the roughness.
        let is_other = |warning: &Warning| !matches!(warning, Warning::FormNotRemoved { .. });
        prepared.warnings.retain(is_other);
    }
    // Without a cut-off the whole trace is one evaluation of five sections, and nothing is filtered twice.
    let of_length = || prepared.profile.length() / 5.0;
    let section = preparation.lambda_c.unwrap_or_else(of_length);
    let parameters = Parameters::from_profile(&prepared.profile, Mode::Iso4287, section)?;
    if let Some(lines) = lines {
        let evaluated = (preparation, section, parameters.heights.rq);
        check_mean(lines, inputs, own_radius, evaluated)?;
    }
    let replaced = read.outliers.as_ref().and_then(OutlierRecord::warning);
    let of_preparation = prepared.warnings.iter().chain(&parameters.warnings);
    let warnings = replaced.iter().chain(of_preparation).cloned();
    let warnings = warnings.map(|warning| warning.on_trace(mirrored, raw.length(), read.start));
    let warnings = warnings.collect();
    let placed = place.and_then(|place| {
        Some(PlacedTrace {
            first_arc: place.first_arc(raw.len(), raw.spacing(), prepared.first_index)?,
            direction: gears.arc_direction(gear),
            base_radius: own_radius.si(),
        })
    });
    let form = match (form_cutoff, &waviness, &placed) {
        (None, ..) => None,
        (Some(cutoff), Some(waviness), Some(placed)) => {
            let form = flank_form::measured(waviness, cutoff, placed, gears, gear);
            Some(form.map_err(TraceError::Form)?)
        }
        (Some(_), ..) => return Err(TraceError::Form(FormError::NotPlaced)),
    };
    let report = FlankReport {
        form,
        trace: Some(read.profile.clone()),
        file: Some(inputs.name.to_owned()),
        sha256: None,
        mirrored,
        outliers: read.outliers,
        preparation: Some(prepared.record),
        parameters: Some(parameters),
        reading: read.reading,
        surrogates: None,
        generated: None,
        made_sheet: None,
        roll_lengths: placed.map(|placed| placed.roll_lengths(&prepared.profile)),
    };
    Ok(PreparedTrace {
        flank: Flank {
            texture: Texture::Trace(prepared.profile),
            report,
            raw: Some(read.profile),
            placed,
        },
        filters,
        assumed_from: place.is_some_and(|place| place.reference.is_some() && place.assumed_from),
        statements: read.statements,
        warnings,
    })
}

/// Lines of the surface of which a mean is read.
fn single_line(options: &ReadOptions) -> Option<TraceLine> {
    match options.line {
        TraceLine::Mean => Some(TraceLine::Row),
        TraceLine::MeanColumn => Some(TraceLine::Column),
        _ => None,
    }
}

/// Refuses the mean of a surface whose Rq is far below the Rq of single lines.
fn check_mean(
    (content, single): (TraceContent<'_>, TraceLine),
    inputs: TraceInputs<'_>,
    own_radius: Length,
    (preparation, section, mean): (&Preparation, Length, Length),
) -> Result<(), TraceError> {
    /// Smallest Rq of a mean, as a share of the Rq of its lines.
    const LEAST: f64 = 0.9;
    /// Lines that are compared.
    const LINES: usize = 8;
    let of_line = |row: usize| {
        let options = ReadOptions {
            line: single,
            row: Some(row),
            ..inputs.options.clone()
        };
        // A line with missing points has no parameters, but the mean may.
        let line = read_trace(&content, inputs, &options, own_radius).ok()?;
        let line = prepare(&line.profile, preparation).ok()?.profile;
        let parameters = Parameters::from_profile(&line, Mode::Iso4287, section).ok()?;
        Some(parameters.heights.rq.si().powi(2))
    };
    let across = match &content {
        TraceContent::Heights(..) | TraceContent::Scan(_) => 1,
        TraceContent::Bytes(bytes, _) => {
            let surface = read_surface_bytes(inputs.name, bytes, inputs.options)?;
            lines_across(&surface, single)
        }
    };
    let rows = (0..LINES).map(|k| (2 * k + 1) * across / (2 * LINES) + 1);
    let squares: Vec<f64> = rows.filter_map(of_line).collect();
    let lines = (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt();
    if mean.si() < LEAST * lines {
        Err(TraceError::AveragedOut {
            mean,
            lines: Length::from_si(lines),
        })
    } else {
        Ok(())
    }
}

/// Number of rows or columns of a surface.
fn lines_across(surface: &Surface, line: TraceLine) -> usize {
    match line {
        TraceLine::Row | TraceLine::Mean => surface.rows,
        _ => surface.columns,
    }
}

/// Place of a trace on its flank. Deviations over roll lengths count along the transverse base tangent and are turned into
/// heights normal to the flank.
fn place_of(
    inputs: TraceInputs<'_>,
    read: &mut ReadTrace,
    gears: &GearPair,
    gear: Gear,
) -> Result<Option<ReadPlace>, TraceError> {
    let arc = read.reading.as_ref().and_then(|r| r.metadata.arc_from_base);
    if arc.is_some() {
        let normal = gears.base_helix.si().cos();
        let heights = read.profile.heights().iter().map(|z| z * normal).collect();
        let along_normal = Profile::new(read.profile.spacing(), heights);
        read.profile = along_normal.map_err(TraceError::Heights)?;
    }
    read_place(inputs.place, gears, gear, arc, read.start).map_err(TraceError::Place)
}

/// The trace in a file, or in memory, read with `options`.
fn read_trace(
    content: &TraceContent<'_>,
    inputs: TraceInputs<'_>,
    options: &ReadOptions,
    own_radius: Length,
) -> Result<ReadTrace, TraceError> {
    let name = inputs.name;
    let cleaned = |profile: &Profile| {
        let replaced = |deviations| replace(profile, Outliers::beyond(deviations));
        // Spikes of a scan were replaced before.
        let is_row = matches!(content, TraceContent::Scan(_));
        let outliers = inputs.outliers.filter(|_| !is_row);
        outliers.map(replaced).transpose()
    };
    // Roll lengths are those of the gear, unless a base radius is stated.
    let with_radius = ReadOptions {
        base_radius: options.base_radius.or(Some(own_radius)),
        ..options.clone()
    };
    let reading = match content {
        TraceContent::Bytes(bytes, conditions) => {
            read_with_conditions(name, bytes, conditions.as_deref(), &with_radius)?
        }
        TraceContent::Scan(surface) => surface.reading(&with_radius)?,
        TraceContent::Heights(profile, statements) => {
            let cut = options
                .range
                .map(|range| TraceCut::of_profile(name, profile, range));
            let (profile, start) = match cut.transpose()? {
                Some((part, cut)) => (part, cut.start),
                None => ((*profile).clone(), Length::default()),
            };
            let profile = match options.invert {
                Some(true) => {
                    let heights = profile.heights().iter().map(|z| -z).collect();
                    Profile::new(profile.spacing(), heights).map_err(TraceError::Heights)?
                }
                _ => profile,
            };
            let (profile, outliers) = match cleaned(&profile)? {
                Some((cleaned, record)) => (cleaned, Some(record)),
                None => (profile, None),
            };
            if let Some(mut steepness) = implausible(&profile, LengthUnit::Metre) {
                steepness.suspicion = steepness.suspicion.on_trace(start);
                return Err(ReadFault::implausible_heights(steepness)
                    .in_file(name)
                    .into());
            }
            return Ok(ReadTrace {
                profile,
                reading: None,
                statements: (*statements).clone(),
                start,
                outliers,
            });
        }
    };
    let (reading, outliers) = match cleaned(&reading.profile)? {
        Some((cleaned, record)) => (reading.corrected(cleaned), Some(record)),
        None => (reading, None),
    };
    reading.check_heights()?;
    if !reading.format.may_hold_several() {
        if inputs.is_line_stated {
            let rule = "this file holds a single profile; leave line out";
            return Err(TraceError::OneProfile(rule));
        }
        if options.row.unwrap_or(1) > 1 {
            let rule = "this file holds a single profile; leave row out";
            return Err(TraceError::OneProfile(rule));
        }
    }
    Ok(ReadTrace {
        profile: reading.profile.clone(),
        start: reading.cut.map_or(Length::default(), |cut| cut.start),
        statements: Statements::from(&reading),
        reading: Some(reading),
        outliers,
    })
}
