//! The two flanks of a case: traces read and prepared, or roughness values.

use std::path::Path;

use asperity_core::provenance::Provenance;
use asperity_core::quantity::Length;
use asperity_core::remedy::Remedy;
use asperity_core::{DomainError, Profile};
use asperity_gear::Gear;
use asperity_profile_io::Warning as ReadWarning;
use asperity_profile_io::read::steepness::implausible;
use asperity_profile_io::read::{
    FilterState, LengthUnit, ReadError, ReadOptions, Reading, read_with_conditions,
};
use asperity_roughness::Parameters;
use asperity_roughness::composite::resampled;
use asperity_roughness::gaussian_filter::Ends;
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::preparation::{Preparation, prepare};
use sha2::{Digest, Sha256};

use super::defaults::DefaultUsed;
use super::domain::domain;
use super::error::CaseError;
use super::files::{
    Content, FILE_OF_COAST_PINION, FILE_OF_COAST_WHEEL, FILE_OF_PINION, FILE_OF_WHEEL, Files,
};
use super::flank_place::{PlaceError, ReadPlace, Told, read_place};
use super::input::{FlankInput, Side};
use super::key_names::key_of;
use super::resolve::Case;
use super::source::Source;
use crate::message::Warning;
use crate::placement::{PlacedTrace, Placement};
use crate::surfaces::{FlankReport, Surfaces, Texture};

/// Both flanks, how each was read and prepared, and the warnings on the way.
#[derive(Debug, Clone)]
pub(super) struct Flanks {
    pub surfaces: Surfaces,
    pub reports: [FlankReport; 2],
    pub warnings: Vec<Warning>,
    /// Roughness values that follow from others.
    pub assumed: Vec<DefaultUsed>,
    /// Equations of the preparation.
    pub provenance: Provenance,
}

/// Context shared by the reading of both flanks.
#[derive(Clone, Copy)]
struct Given<'a> {
    case: &'a Case,
    source: &'a Source,
    files: &'a Files,
}

/// A flank with the trace it came from, where there is one.
struct Flank {
    texture: Texture,
    report: FlankReport,
    raw: Option<Profile>,
    /// Roughness values that follow from others.
    assumed: Vec<DefaultUsed>,
    /// Place on the flank, where it is known.
    placed: Option<PlacedTrace>,
}

/// Reads and prepares the flanks that `case` names.
pub(super) fn flanks(case: &Case, source: &Source, files: &Files) -> Result<Flanks, CaseError> {
    let provenance = Provenance::new();
    let flanks = provenance.collect(|| both(case, source, files))?;
    Ok(Flanks {
        provenance,
        ..flanks
    })
}

fn both(case: &Case, source: &Source, files: &Files) -> Result<Flanks, CaseError> {
    let given = Given {
        case,
        source,
        files,
    };
    let mut warnings = Vec::new();
    let (pinion_input, own_wheel, side) = case.input.surface.loaded(case.torque);
    // Flanks face each other: without a trace of its own the wheel is the pinion's, mirrored.
    let wheel_input = own_wheel.cloned();
    let wheel_input = wheel_input.unwrap_or_else(|| pinion_input.for_wheel());
    let [of_pinion, of_wheel] = keys_of(side, own_wheel.is_some());
    let pinion = flank(pinion_input, of_pinion, given, &mut warnings)?;
    let wheel = flank(&wheel_input, of_wheel, given, &mut warnings)?;
    // Rows of one surface are traces of their own.
    let same_trace = pinion.raw.is_some() && pinion.raw == wheel.raw;
    let mut assumed = pinion.assumed;
    if own_wheel.is_some() {
        let told = |default: &DefaultUsed| !assumed.contains(default);
        let more: Vec<DefaultUsed> = wheel.assumed.into_iter().filter(told).collect();
        assumed.extend(more);
    }
    // Two files may have been filtered differently; the summits are looked for at the longer waves.
    let noise_cutoff = [&pinion.report, &wheel.report]
        .into_iter()
        .map(|report| match &report.preparation {
            Some(record) => record.recipe.lambda_s,
            None => case.preparation.lambda_s,
        })
        .max_by(|a, b| {
            a.unwrap_or_default()
                .si()
                .total_cmp(&b.unwrap_or_default().si())
        })
        .flatten();
    let reports = [pinion.report, wheel.report];
    if reports[0].file.is_some() && reports[0].file == reports[1].file {
        // Said once, for the file they share.
        warnings.dedup();
        let mut seen = std::collections::BTreeSet::new();
        warnings.retain(|warning| seen.insert(warning.to_string()));
    }
    let textures = on_common_spacing([pinion.texture, wheel.texture], &mut warnings)?;
    let placement = placement([pinion.placed, wheel.placed], &mut warnings);
    let rz = [0, 1].map(|body: usize| {
        let parameters = reports[body].parameters.as_ref();
        parameters.map(|found| found.heights.rz)
    });
    let surfaces = Surfaces::new(textures, noise_cutoff, same_trace).with_rz(rz);
    Ok(Flanks {
        surfaces: surfaces.placed(placement),
        reports,
        warnings,
        assumed,
        provenance: Provenance::new(),
    })
}

/// Table and file of a flank in the case file.
#[derive(Clone, Copy)]
struct Keys {
    table: &'static str,
    file: &'static str,
}

/// The keys of pinion and wheel; the wheel may run on the trace of the pinion.
fn keys_of(side: Side, wheel_has_its_own: bool) -> [Keys; 2] {
    let (tables, [pinion, wheel]) = match side {
        Side::Drive => (
            ["surface.pinion", "surface.wheel"],
            [FILE_OF_PINION, FILE_OF_WHEEL],
        ),
        Side::Coast => (
            ["surface.coast.pinion", "surface.coast.wheel"],
            [FILE_OF_COAST_PINION, FILE_OF_COAST_WHEEL],
        ),
    };
    let wheel = if wheel_has_its_own { wheel } else { pinion };
    [
        Keys {
            table: tables[0],
            file: pinion,
        },
        Keys {
            table: tables[1],
            file: wheel,
        },
    ]
}

fn flank(
    input: &FlankInput,
    Keys {
        table: key,
        file: named,
    }: Keys,
    given: Given<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<Flank, CaseError> {
    let source = given.source;
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
        (None, Some(_)) => values(input, key, source),
        (Some(file), _) => trace(input, file, [key, named], given, warnings),
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
    [of_flank, key]: [&'static str; 2],
    given: Given<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<Flank, CaseError> {
    // As the case names it: that is what the user looks for.
    let name = file.display().to_string();
    let mut read = read_trace(input, file, key, given)?;
    let place = place_of(input, &mut read, of_flank, given)?;
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
    let preparation = &filters.preparation;
    let prepared = prepare(&raw, preparation).map_err(refused)?;
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
    for warning in prepared.warnings.iter().chain(&parameters.warnings) {
        warn(warning.code(), warning, warning.remedy());
    }
    warnings.extend(filters.overridden);
    let gear = gear_of(of_flank);
    let placed = place.and_then(|place| {
        Some(PlacedTrace {
            first_arc: place.first_arc(raw.len(), raw.spacing(), prepared.first_index)?,
            direction: given.case.gears.arc_direction(gear),
            base_radius: given.case.gears.base_radius[gear as usize].si().abs(),
        })
    });
    let report = FlankReport {
        trace: Some(read.profile.clone()),
        file: Some(name),
        sha256: read.sha256,
        mirrored,
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
    key: &'static str,
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
    let at = match key {
        "surface.wheel" => "surface.wheel.at",
        "surface.coast.pinion" => "surface.coast.pinion.at",
        "surface.coast.wheel" => "surface.coast.wheel.at",
        _ => "surface.pinion.at",
    };
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

/// Places of both traces; one alone is told and not used.
fn placement(placed: [Option<PlacedTrace>; 2], warnings: &mut Vec<Warning>) -> Option<Placement> {
    match placed {
        [Some(pinion), Some(wheel)] => Some(Placement {
            traces: [pinion, wheel],
            misplaced: 0.0,
        }),
        [None, None] => None,
        [pinion, _] => {
            let other = if pinion.is_some() { "wheel" } else { "pinion" };
            warnings.push(Warning::new(
                "W418",
                format!(
                    "the place on the flank is not known of the trace of the {other}: windows do not follow from the mesh, both traces stand for any place of their flanks"
                ),
            ));
            None
        }
    }
}

/// Filters of one trace: those of the case, else those its file states, else the defaults.
struct Filters {
    preparation: Preparation,
    /// Cut-offs that the file states and the case leaves open.
    stated: Vec<DefaultUsed>,
    /// The warning that the case asks for other cut-offs than the file states.
    overridden: Option<Warning>,
}

impl Filters {
    /// Filters that lose nothing at the ends of a placed trace, unless the case says how they are treated.
    fn keep_ends(&mut self, case: &Case, key: &'static str, place: &ReadPlace) {
        if case.input.surface.ends.is_none() {
            self.preparation.ends = Ends::Reg1;
            self.stated.push(DefaultUsed {
                key: "surface.ends".into(),
                value: "\"reg1\"".to_owned(),
                source: Some("a placed trace keeps its ends".into()),
            });
        }
        if place.assumed_from {
            self.stated.push(DefaultUsed {
                key: format!("{key}.from").into(),
                value: "\"root\"".to_owned(),
                source: None,
            });
        }
    }

    fn of(case: &Case, file: &str, reading: Option<&Reading>) -> Self {
        /// Cut-offs that differ by less are the same as printed.
        const SAME: f64 = 1e-6;
        let asked = &case.input.surface;
        let mut filters = Self {
            preparation: case.preparation,
            stated: Vec::new(),
            overridden: None,
        };
        // What was filtered before has been filtered with them.
        let unfiltered = reading.filter(|r| r.filter_state != FilterState::Roughness);
        let Some(facts) = unfiltered.map(|reading| &reading.metadata) else {
            return filters;
        };
        let mut others = Vec::new();
        let preparation = &mut filters.preparation;
        for (key, name, given, of_file, used) in [
            (
                "surface.cutoff",
                "λc",
                asked.cutoff,
                facts.lambda_c,
                &mut preparation.lambda_c,
            ),
            (
                "surface.noise_cutoff",
                "λs",
                asked.noise_cutoff,
                facts.lambda_s,
                &mut preparation.lambda_s,
            ),
        ] {
            let Some(of_file) = of_file else {
                continue;
            };
            match given {
                None => {
                    *used = Some(of_file);
                    filters.stated.push(DefaultUsed {
                        key: key.into(),
                        value: format!("\"{of_file}\""),
                        source: Some(format!("stated in {file}").into()),
                    });
                }
                Some(given) if (given / of_file - 1.0).abs() > SAME => {
                    others.push(format!("{name} {of_file}, the case {key} = {given}"));
                }
                Some(_) => {}
            }
        }
        if !others.is_empty() {
            filters.overridden = Some(Warning::new(
                "W129",
                format!("{file}: the file states {}", others.join("; ")),
            ));
        }
        filters
    }
}

/// A trace as measured; how it was read and the SHA-256 of its file where it comes from one.
struct ReadTrace {
    profile: Profile,
    reading: Option<Reading>,
    sha256: Option<String>,
}

/// The trace in `file` as its keys say.
fn read_trace(
    input: &FlankInput,
    file: &Path,
    key: &'static str,
    given: Given<'_>,
) -> Result<ReadTrace, CaseError> {
    let source = given.source;
    let bytes = match given.files.open(file, source, key)? {
        Content::Bytes(bytes) => bytes,
        Content::Heights(profile) => {
            if let Some(steepness) = implausible(&profile, LengthUnit::Metre) {
                let file = file.display().to_string();
                return Err(CaseError::Profile {
                    place: source.place_of(key),
                    source: Box::new(ReadError::ImplausibleHeights { file, steepness }),
                });
            }
            return Ok(ReadTrace {
                profile: profile.as_ref().clone(),
                reading: None,
                sha256: None,
            });
        }
    };
    let options = read_options(input);
    let conditions = given.files.conditions(file);
    let name = file.display().to_string();
    let read = read_with_conditions(&name, &bytes, conditions.as_deref(), &options);
    let plausible = read.and_then(|reading| reading.check_heights().map(|()| reading));
    let reading = plausible.map_err(|error| CaseError::Profile {
        place: source.place_of(key),
        source: Box::new(error),
    })?;
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
        sha256: Some(hex(&Sha256::digest(&bytes))),
        reading: Some(reading),
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
        base_radius: input.base_radius,
        uneven: input.uneven.unwrap_or_default(),
    }
}

/// Brings two traces to the finer spacing of both.
fn on_common_spacing(
    textures: [Texture; 2],
    warnings: &mut Vec<Warning>,
) -> Result<[Texture; 2], CaseError> {
    /// Spacings that differ by less shift a window of 10⁴ points by less than a point.
    const SAME: f64 = 1e-5;
    let [Texture::Trace(first), Texture::Trace(second)] = &textures else {
        return Ok(textures);
    };
    let (a, b) = (first.spacing(), second.spacing());
    if (a / b - 1.0).abs() <= SAME {
        return Ok(textures);
    }
    let finer = if a < b { a } else { b };
    let bring = |profile: &Profile| -> Result<Profile, CaseError> {
        resampled(profile, finer).map_err(|source| CaseError::Preparation {
            file: "surface".to_owned(),
            source: source.into(),
        })
    };
    warnings.push(Warning::new(
        "W119",
        format!("the flanks are spaced {a} and {b}; the coarser was resampled linearly to {finer}"),
    ));
    Ok([
        Texture::Trace(bring(first)?),
        Texture::Trace(bring(second)?),
    ])
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
