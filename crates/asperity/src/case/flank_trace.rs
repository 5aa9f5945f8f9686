//! One flank of a case: its trace read and prepared, or its roughness values.

use std::path::Path;

use asperity_core::quantity::Length;
use asperity_core::remedy::Remedy;
use asperity_core::{DomainError, Profile};
use asperity_gear::Gear;
use asperity_profile_io::Warning as ReadWarning;
use asperity_profile_io::read::steepness::implausible;
use asperity_profile_io::read::{
    LengthUnit, ReadError, ReadOptions, Reading, read_with_conditions,
};
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::outliers::{OutlierRecord, Outliers, replace};
use asperity_roughness::preparation::{RoughnessFilter, prepare, profiles};
use asperity_roughness::{Parameters, Warning as RoughnessWarning};

use super::defaults::DefaultUsed;
use super::domain::domain;
use super::error::CaseError;
use super::files::{
    Content, FILE_OF_COAST_PINION, FILE_OF_COAST_WHEEL, FILE_OF_PINION, FILE_OF_WHEEL, Reader,
    TRACES_OF_COAST_PINION, TRACES_OF_COAST_WHEEL, TRACES_OF_PINION, TRACES_OF_WHEEL,
};
use super::flank_form::{self, FormError};
use super::flank_place::{PlaceError, ReadPlace, Told, read_place};
use super::flank_sample::{self, Listed};
use super::input::{FlankInput, Side};
use super::key_names::key_of;
use super::resolve::Case;
use super::source::Source;
use super::trace_filters::Filters;
use crate::flanks::placement::PlacedTrace;
use crate::flanks::surfaces::{FlankReport, Texture};
use crate::message::Warning;

/// Context shared by the reading of both flanks.
#[derive(Clone, Copy)]
pub(super) struct Given<'a> {
    pub case: &'a Case,
    pub source: &'a Source,
    pub files: &'a Reader<'a>,
}

/// A flank with the trace it came from, where there is one.
pub(super) struct Flank {
    pub texture: Texture,
    pub report: FlankReport,
    pub raw: Option<Profile>,
    /// Roughness values that follow from others.
    pub assumed: Vec<DefaultUsed>,
    /// Place on the flank, where it is known.
    pub placed: Option<PlacedTrace>,
}

/// Table, files and place of a flank in the case file.
#[derive(Clone, Copy)]
pub(super) struct Keys {
    pub table: &'static str,
    pub file: &'static str,
    pub traces: &'static str,
    pub at: &'static str,
}

/// The keys of pinion and wheel; the wheel may run on the trace of the pinion.
pub(super) fn keys_of(side: Side, wheel_has_its_own: bool) -> [Keys; 2] {
    let [pinion, wheel] = match side {
        Side::Drive => [
            Keys {
                table: "surface.pinion",
                file: FILE_OF_PINION,
                traces: TRACES_OF_PINION,
                at: "surface.pinion.at",
            },
            Keys {
                table: "surface.wheel",
                file: FILE_OF_WHEEL,
                traces: TRACES_OF_WHEEL,
                at: "surface.wheel.at",
            },
        ],
        Side::Coast => [
            Keys {
                table: "surface.coast.pinion",
                file: FILE_OF_COAST_PINION,
                traces: TRACES_OF_COAST_PINION,
                at: "surface.coast.pinion.at",
            },
            Keys {
                table: "surface.coast.wheel",
                file: FILE_OF_COAST_WHEEL,
                traces: TRACES_OF_COAST_WHEEL,
                at: "surface.coast.wheel.at",
            },
        ],
    };
    let file = if wheel_has_its_own {
        wheel.file
    } else {
        pinion.file
    };
    [pinion, Keys { file, ..wheel }]
}

/// The traces that the keys of a flank name; one without a list.
pub(super) fn traces_of(
    input: &FlankInput,
    keys: Keys,
    given: Given<'_>,
) -> Result<Vec<Listed>, CaseError> {
    let Some(list) = &input.traces else {
        return Ok(vec![Listed::alone(input)]);
    };
    if input.file.is_some() || input.rq.or(input.ra).or(input.rz).is_some() {
        return Err(CaseError::Conflict {
            place: given.source.place_of(keys.traces),
            key: keys.traces,
            rule: "stands in place of file and of rq, ra and rz; give one of them",
        });
    }
    flank_sample::listed(input, list, (keys.traces, given.source, given.files))
}

pub(super) fn flank(
    listed: &Listed,
    keys: Keys,
    given: Given<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<Flank, CaseError> {
    let (source, key, input) = (given.source, keys.table, &listed.input);
    let values_given = input.rq.or(input.ra).or(input.rz);
    match (&input.file, values_given) {
        (Some(_), Some(_)) if input.rq.is_some() => Err(CaseError::Conflict {
            place: source.place_of(key),
            key,
            rule: "give either file or rq, not both",
        }),
        (None, None) => Err(CaseError::Conflict {
            place: source.place_of_key(key),
            key,
            rule: "give file, the trace of the flank, or rq (ra or rz) when there is none",
        }),
        (None, Some(_)) if flank_form::is_wanted(given.case, gear_of(key)) => {
            let none = "a flank known by roughness values alone";
            let of = (given.case, gear_of(key));
            Err(flank_form::refused(
                FormError::NotPlaced,
                of,
                (none, keys.at),
                source,
            ))
        }
        (None, Some(_)) => values(input, key, source),
        (Some(file), _) => {
            let keys = Keys {
                file: if listed.is_of_a_list {
                    keys.traces
                } else {
                    keys.file
                },
                at: if listed.has_own_place {
                    keys.traces
                } else {
                    keys.at
                },
                ..keys
            };
            trace(input, file, keys, given, warnings)
        }
    }
}

fn values(input: &FlankInput, key: &'static str, source: &Source) -> Result<Flank, CaseError> {
    let checked = |name, length: Option<Length>| match length {
        None => Ok(None),
        Some(length) => DomainError::positive(name, length)
            .map(Some)
            .map_err(domain(source, key_of(key, name))),
    };
    /// Ra of a Gaussian surface is Rq·√(2/π).
    const GAUSSIAN_RA: f64 = 0.797_884_560_802_865_4;
    /// Rz of a Gaussian surface over five cut-offs is near six times its Rq.
    const GAUSSIAN_RZ: f64 = 6.0;
    let mut assumed = Vec::new();
    let mut follows = |name: &str, value: f64, source: &'static str| {
        assumed.push(DefaultUsed {
            key: format!("{key}.{name}").into(),
            value: format!("\"{:.4}\"", Length::from_si(value)),
            source: Some(source.into()),
        });
        value
    };
    let given = [
        checked("Rq", input.rq)?,
        checked("Ra", input.ra)?,
        checked("Rz", input.rz)?,
    ];
    let rq = match given {
        [Some(rq), ..] => rq,
        [None, Some(ra), _] => follows("rq", ra / GAUSSIAN_RA, "Ra/0.798, a Gaussian surface"),
        [None, None, rz] => {
            let rz = rz.unwrap_or_default();
            follows("rq", rz / GAUSSIAN_RZ, "Rz/6, a Gaussian surface")
        }
    };
    let ra =
        given[1].unwrap_or_else(|| follows("ra", GAUSSIAN_RA * rq, "0.798 Rq, a Gaussian surface"));
    let rz =
        given[2].unwrap_or_else(|| follows("rz", GAUSSIAN_RZ * rq, "6 Rq, a Gaussian surface"));
    let texture = Texture::Values {
        rq,
        ra,
        rz,
        rpk: checked("Rpk", input.rpk)?,
        asperity_radius: checked("asperity radius", input.asperity_radius)?.map(Length::from_si),
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
    keys: Keys,
    given: Given<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<Flank, CaseError> {
    let (of_flank, key) = (keys.table, keys.file);
    // As the case names it: that is what the user looks for.
    let name = file.display().to_string();
    let mut read = read_trace(input, file, (of_flank, key), given)?;
    let place = place_of(input, &mut read, keys, given)?;
    let mirrored = match &place {
        Some(place) => place.turned,
        None => input.mirrored.unwrap_or(false),
    };
    let raw = if mirrored {
        read.profile.mirrored()
    } else {
        read.profile.clone()
    };
    let refused = |source| CaseError::Preparation {
        file: name.clone(),
        source,
    };
    let mut filters = Filters::of(given.case, &name, read.reading.as_ref());
    if let Some(place) = place.filter(|place| place.reference.is_some()) {
        filters.keep_ends(given.case, of_flank, &place);
    }
    let gear = gear_of(of_flank);
    let of_form =
        |error| flank_form::refused(error, (given.case, gear), (&name, keys.at), given.source);
    let form_cutoff = filters.part_form(given.case, gear, read.reading.as_ref());
    let form_cutoff = form_cutoff.map_err(of_form)?;
    let preparation = &filters.preparation;
    let (mut prepared, waviness) = match form_cutoff {
        None => (prepare(&raw, preparation).map_err(refused)?, None),
        Some(_) => {
            let found = profiles(&raw, preparation, RoughnessFilter::Gaussian).map_err(refused)?;
            (found.roughness, found.waviness)
        }
    };
    if form_cutoff.is_some() {
        // It was left in to be parted from the roughness.
        prepared
            .warnings
            .retain(|warning| !matches!(warning, RoughnessWarning::FormNotRemoved { .. }));
    }
    // Without a cut-off the whole trace is one evaluation of five sections, and nothing is filtered twice.
    let lambda_c = preparation.lambda_c;
    let section = lambda_c.unwrap_or_else(|| prepared.profile.length() / 5.0);
    let parameters = Parameters::of(&prepared.profile, Mode::Iso4287, section).map_err(refused)?;
    let mut warn = |code, warning: &dyn std::fmt::Display, remedy: Remedy| {
        let end = if remedy.is_empty() { "" } else { ". " };
        warnings.push(Warning::new(
            code,
            format!("{name}: {warning}{end}{remedy}"),
        ));
    };
    for warning in read.reading.iter().flat_map(|reading| &reading.warnings) {
        if lambda_c.is_some() || *warning != ReadWarning::AlreadyFiltered {
            warn(warning.code(), warning, warning.remedy());
        }
    }
    let replaced = read.outliers.as_ref().and_then(OutlierRecord::warning);
    let prepared_warnings = prepared.warnings.iter().chain(&parameters.warnings);
    for warning in replaced.iter().chain(prepared_warnings) {
        warn(warning.code(), warning, warning.remedy());
    }
    warnings.extend(filters.overridden.into_iter().chain(filters.parted));
    let placed = place.and_then(|place| {
        Some(PlacedTrace {
            first_arc: place.first_arc(raw.len(), raw.spacing(), prepared.first_index)?,
            direction: given.case.gears.arc_direction(gear),
            base_radius: given.case.gears.base_radius[gear as usize].si().abs(),
        })
    });
    let form = match (form_cutoff, &waviness, &placed) {
        (None, ..) => None,
        (Some(cutoff), Some(waviness), Some(placed)) => Some(
            flank_form::measured(waviness, cutoff, placed, (given.case, gear)).map_err(of_form)?,
        ),
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

/// The gear that a flank's keys are of.
fn gear_of(key: &str) -> Gear {
    match key {
        "surface.wheel" | "surface.coast.wheel" => Gear::Wheel,
        _ => Gear::Pinion,
    }
}

/// Where a trace lies on its flank. Deviations over roll lengths count along the transverse base tangent and are
/// turned into heights normal to the flank.
fn place_of(
    input: &FlankInput,
    read: &mut ReadTrace,
    Keys { table: key, at, .. }: Keys,
    given: Given<'_>,
) -> Result<Option<ReadPlace>, CaseError> {
    let gears = &given.case.gears;
    let arc = read.reading.as_ref().and_then(|r| r.metadata.arc_from_base);
    if arc.is_some() {
        let normal = gears.base_helix.si().cos();
        let heights = read.profile.heights().iter().map(|z| z * normal).collect();
        read.profile =
            Profile::new(read.profile.spacing(), heights).map_err(domain(given.source, key))?;
    }
    let gear = gear_of(key);
    let told = Told {
        from: input.from,
        at: input.at,
        is_mirrored: input.mirrored.is_some(),
    };
    read_place(told, gears, gear, arc).map_err(|error| match error {
        PlaceError::Rule(rule) => CaseError::Conflict {
            place: given.source.place_of(at),
            key: at,
            rule,
        },
        PlaceError::Domain(error) => domain(given.source, at)(error),
    })
}

/// A trace as measured; how it was read and the SHA-256 of its file where it comes from one.
struct ReadTrace {
    profile: Profile,
    reading: Option<Reading>,
    sha256: Option<String>,
    /// Spikes replaced.
    outliers: Option<OutlierRecord>,
}

/// The trace in `file` as its keys say.
fn read_trace(
    input: &FlankInput,
    file: &Path,
    (of_flank, key): (&'static str, &'static str),
    given: Given<'_>,
) -> Result<ReadTrace, CaseError> {
    let source = given.source;
    let cleaned = |profile: &Profile| -> Result<Option<_>, CaseError> {
        let Some(deviations) = given.case.input.surface.outliers else {
            return Ok(None);
        };
        let found = replace(profile, Outliers::beyond(deviations));
        let found = found.map_err(|source| CaseError::Preparation {
            file: file.display().to_string(),
            source,
        })?;
        Ok(Some(found))
    };
    let (bytes, sum) = match given.files.open(file, source, key)? {
        (Content::Bytes(bytes), sum) => (bytes, sum),
        (Content::Heights(profile), _) => {
            let (profile, outliers) = match cleaned(&profile)? {
                Some((cleaned, record)) => (cleaned, Some(record)),
                None => (profile.as_ref().clone(), None),
            };
            if let Some(steepness) = implausible(&profile, LengthUnit::Metre) {
                let file = file.display().to_string();
                return Err(CaseError::Profile {
                    place: source.place_of(key),
                    source: Box::new(ReadError::ImplausibleHeights { file, steepness }),
                });
            }
            return Ok(ReadTrace {
                profile,
                reading: None,
                sha256: None,
                outliers,
            });
        }
    };
    // Roll lengths are of the gear, unless the case says otherwise.
    let gear = gear_of(of_flank) as usize;
    let options = ReadOptions {
        base_radius: input.base_radius.or(Some(Length::from_si(
            given.case.gears.base_radius[gear].si().abs(),
        ))),
        ..read_options(input)
    };
    let conditions = given.files.conditions(file);
    let name = file.display().to_string();
    let read = read_with_conditions(&name, &bytes, conditions.as_deref(), &options);
    let refused = |error| CaseError::Profile {
        place: source.place_of(key),
        source: Box::new(error),
    };
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
                place: source.place_of(key),
                key,
                rule,
            });
        }
    }
    Ok(ReadTrace {
        profile: reading.profile.clone(),
        sha256: Some(sum),
        reading: Some(reading),
        outliers,
    })
}

/// Options of the reader from the keys of a flank.
fn read_options(input: &FlankInput) -> ReadOptions {
    ReadOptions {
        x_unit: input.x_unit,
        z_unit: input.z_unit,
        dx: input.dx,
        columns: input.columns,
        decimal: input.decimal,
        separator: input.separator,
        encoding: input.encoding,
        gaps: input.gaps.unwrap_or_default(),
        row: input.row,
        line: input.line.unwrap_or_default(),
        abscissa: input.abscissa,
        uneven: input.uneven.unwrap_or_default(),
        ..ReadOptions::default()
    }
}
