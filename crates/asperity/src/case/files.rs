//! Files of a case: the case itself and the traces it names.

use std::path::Path;

use asperity_core::DomainError;
use asperity_core::Profile;
use asperity_core::provenance::Provenance;
use asperity_core::quantity::Length;
use asperity_profile_io::Warning as ReadWarning;
use asperity_profile_io::read::{Format, ReadOptions, Reading, read_bytes};
use asperity_roughness::Parameters;
use asperity_roughness::composite::resampled;
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::preparation::prepare;
use asperity_tribo_friction::XuCalibration;
use sha2::{Digest, Sha256};

use super::error::CaseError;
use super::input::{CaseInput, FlankInput, Formulation, schema};
use super::key_names::key_of;
use super::known_keys::first_unknown;
use super::plain_words::plain;
use super::resolve::{Case, domain, resolve};
use super::source::Source;
use crate::message::Warning;
use crate::surfaces::{FlankReport, Surfaces, Texture};

const FILE_OF_WHEEL: &str = "surface.wheel.file";

/// A case with its traces, ready to run.
#[derive(Debug, Clone)]
pub struct LoadedCase {
    /// The case.
    pub case: Case,
    /// The flanks.
    pub surfaces: Surfaces,
    /// How each flank was read and prepared.
    pub flanks: [FlankReport; 2],
    /// What about the files calls for attention.
    pub warnings: Vec<Warning>,
    /// Equations that the preparation of oil, gears and traces used.
    pub provenance: Provenance,
}

/// Reads the case file `path` and the traces it names; `formulation` wins over the file's.
///
/// # Errors
/// When a file cannot be read or says something that cannot be. The source, where it could be
/// read, goes with the error so that the place can be shown.
pub fn load(
    path: &Path,
    formulation: Option<Formulation>,
) -> Result<LoadedCase, (Box<CaseError>, Option<Box<Source>>)> {
    load_with(path, &|input| {
        if formulation.is_some() {
            input.formulation = formulation;
        }
    })
}

/// The same with the case changed by `change` before its defaults are filled in.
///
/// # Errors
/// As for [`load`].
pub fn load_with(
    path: &Path,
    change: &dyn Fn(&mut CaseInput),
) -> Result<LoadedCase, (Box<CaseError>, Option<Box<Source>>)> {
    let source = open(path).map_err(|error| (Box::new(error), None))?;
    let folder = path.parent().unwrap_or(Path::new("."));
    let provenance = Provenance::new();
    provenance
        .collect(|| from_source(&source, folder, change))
        .map(|loaded| LoadedCase {
            provenance,
            ..loaded
        })
        .map_err(|error| (Box::new(error), Some(Box::new(source.clone()))))
}

fn open(path: &Path) -> Result<Source, CaseError> {
    let file = path.display().to_string();
    if path.is_dir() {
        return Err(CaseError::Folder { file });
    }
    match std::fs::read(path) {
        Ok(bytes) => Source::from_bytes(&file, &bytes),
        Err(reason) => Err(CaseError::Open { file, reason }),
    }
}

fn from_source(
    source: &Source,
    folder: &Path,
    change: &dyn Fn(&mut CaseInput),
) -> Result<LoadedCase, CaseError> {
    let schema = schema();
    if let Some((key, nearest)) = first_unknown(&schema, source.key_paths()) {
        return Err(CaseError::UnknownKey {
            place: source.place_of_key(key),
            key: key.to_owned(),
            nearest,
        });
    }
    let mut input: CaseInput = source.read().map_err(|error| match error {
        CaseError::Value {
            place,
            key,
            message,
        } => CaseError::Value {
            message: plain(&schema, key.as_deref(), &message),
            place,
            key,
        },
        error => error,
    })?;
    change(&mut input);
    let mut case = resolve(input, source)?;
    if let Some(file) = &case.input.model.xu_coefficients {
        let calibration = xu_calibration(&folder.join(file), source)?;
        case.model.friction_settings.xu.coefficients = calibration.coefficients;
    }
    load_flanks(case, source, folder)
}

fn xu_calibration(path: &Path, source: &Source) -> Result<XuCalibration, CaseError> {
    let key = "model.xu_coefficients";
    let text = std::fs::read_to_string(path).map_err(|reason| CaseError::OpenNamed {
        file: path.display().to_string(),
        place: source.place_of(key),
        key,
        reason,
    })?;
    XuCalibration::from_json(&text).map_err(|error| CaseError::Value {
        place: source.place_of(key),
        key: Some(key.to_owned()),
        message: error.to_string(),
    })
}

fn load_flanks(case: Case, source: &Source, folder: &Path) -> Result<LoadedCase, CaseError> {
    let mut warnings = Vec::new();
    let pinion_input = &case.input.surface.pinion;
    // Flanks face each other: without a trace of its own the wheel is the pinion's, mirrored.
    let wheel_input = case.input.surface.wheel.clone().unwrap_or(FlankInput {
        mirrored: Some(!pinion_input.mirrored.unwrap_or(false)),
        ..pinion_input.clone()
    });
    let (first, pinion) = flank(
        pinion_input,
        "surface.pinion",
        &case,
        source,
        folder,
        &mut warnings,
    )?;
    let (second, wheel) = flank(
        &wheel_input,
        "surface.wheel",
        &case,
        source,
        folder,
        &mut warnings,
    )?;
    let same_trace = are_one_trace(&pinion, &wheel);
    if pinion.file.is_some() && pinion.file == wheel.file {
        // Said once, for the file they share.
        warnings.dedup();
        let mut seen = std::collections::BTreeSet::new();
        warnings.retain(|warning| seen.insert(warning.to_string()));
    }
    let textures = on_common_spacing([first, second], &mut warnings)?;
    let surfaces = Surfaces::new(textures, case.preparation.lambda_s, same_trace);
    Ok(LoadedCase {
        case,
        surfaces,
        flanks: [pinion, wheel],
        warnings,
        provenance: Provenance::new(),
    })
}

/// Whether both flanks run on one trace; rows of one surface are traces of their own.
fn are_one_trace(pinion: &FlankReport, wheel: &FlankReport) -> bool {
    match (&pinion.reading, &wheel.reading) {
        (Some(first), Some(second)) => first.profile == second.profile,
        _ => false,
    }
}

fn flank(
    input: &FlankInput,
    key: &'static str,
    case: &Case,
    source: &Source,
    folder: &Path,
    warnings: &mut Vec<Warning>,
) -> Result<(Texture, FlankReport), CaseError> {
    match (&input.file, input.rq) {
        (Some(_), Some(_)) => Err(CaseError::Conflict {
            place: source.place_of(key),
            key,
            rule: "give either file or rq, not both",
        }),
        (None, None) => Err(CaseError::Conflict {
            place: source.place_of_key(key),
            key,
            rule: "give file, the trace of the flank, or rq when there is none",
        }),
        (None, Some(rq)) => values(input, rq, key, source),
        (Some(file), None) => {
            // The wheel may run on the trace of the pinion.
            let named = match source.written(FILE_OF_WHEEL) {
                Some(_) if key == "surface.wheel" => FILE_OF_WHEEL,
                _ => "surface.pinion.file",
            };
            trace(input, file, (source, named), case, folder, warnings)
        }
    }
}

fn values(
    input: &FlankInput,
    rq: Length,
    key: &'static str,
    source: &Source,
) -> Result<(Texture, FlankReport), CaseError> {
    let checked = |name, length: Option<Length>| match length {
        None => Ok(None),
        Some(length) => DomainError::positive(name, length)
            .map(Some)
            .map_err(domain(source, key_of(key, name))),
    };
    let rq = checked("Rq", Some(rq))?.unwrap_or_default();
    /// Ra of a Gaussian surface is Rq·√(2/π).
    const GAUSSIAN_RA: f64 = 0.797_884_560_802_865_4;
    /// Rz of a Gaussian surface over five cut-offs is near six times its Rq.
    const GAUSSIAN_RZ: f64 = 6.0;
    let texture = Texture::Values {
        rq,
        ra: checked("Ra", input.ra)?.unwrap_or(GAUSSIAN_RA * rq),
        rz: checked("Rz", input.rz)?.unwrap_or(GAUSSIAN_RZ * rq),
        rpk: checked("Rpk", input.rpk)?,
        asperity_radius: checked("asperity radius", input.asperity_radius)?.map(Length::from_si),
    };
    Ok((texture, FlankReport::default()))
}

fn trace(
    input: &FlankInput,
    file: &Path,
    (source, key): (&Source, &'static str),
    case: &Case,
    folder: &Path,
    warnings: &mut Vec<Warning>,
) -> Result<(Texture, FlankReport), CaseError> {
    // As the case names it: that is what the user looks for.
    let name = file.display().to_string();
    let (reading, sha256) = read_trace(input, file, (source, key), folder)?;
    let mirrored = input.mirrored.unwrap_or(false);
    let raw = if mirrored {
        reading.profile.mirrored()
    } else {
        reading.profile.clone()
    };
    let refused = |source| CaseError::Preparation {
        file: name.clone(),
        source,
    };
    let prepared = prepare(&raw, &case.preparation).map_err(refused)?;
    // Without a cut-off the whole trace is one evaluation of five sections, and nothing is filtered twice.
    let lambda_c = case.preparation.lambda_c;
    let section = lambda_c.unwrap_or_else(|| prepared.profile.length() / 5.0);
    let parameters = Parameters::of(&prepared.profile, Mode::Iso4287, section).map_err(refused)?;
    for warning in &reading.warnings {
        if lambda_c.is_some() || *warning != ReadWarning::AlreadyFiltered {
            warnings.push(Warning::new(warning.code(), format!("{name}: {warning}")));
        }
    }
    for warning in prepared.warnings.iter().chain(&parameters.warnings) {
        warnings.push(Warning::new(warning.code(), format!("{name}: {warning}")));
    }
    let report = FlankReport {
        file: Some(name),
        sha256: Some(sha256),
        mirrored,
        preparation: Some(prepared.record),
        parameters: Some(parameters),
        reading: Some(reading),
    };
    Ok((Texture::Trace(prepared.profile), report))
}

/// The trace in `file` as its keys say, and the SHA-256 of the file.
fn read_trace(
    input: &FlankInput,
    file: &Path,
    (source, key): (&Source, &'static str),
    folder: &Path,
) -> Result<(Reading, String), CaseError> {
    let path = folder.join(file);
    let bytes = std::fs::read(&path).map_err(|reason| CaseError::OpenNamed {
        file: path.display().to_string(),
        place: source.place_of(key),
        key,
        reason,
    })?;
    let options = ReadOptions {
        x_unit: input.x_unit,
        z_unit: input.z_unit,
        dx: input.dx,
        columns: input.columns,
        decimal: input.decimal,
        separator: input.separator,
        encoding: input.encoding,
        gaps: input.gaps.unwrap_or_default(),
        row: input.row,
    };
    let reading = read_bytes(&file.display().to_string(), &bytes, &options).map_err(|error| {
        CaseError::Profile {
            place: source.place_of(key),
            source: Box::new(error),
        }
    })?;
    if input.row.unwrap_or(1) > 1 && !matches!(reading.format, Format::X3p | Format::SdfAscii) {
        return Err(CaseError::Conflict {
            place: source.place_of(key),
            key,
            rule: "this file holds a single profile; leave row out",
        });
    }
    Ok((reading, hex(&Sha256::digest(&bytes))))
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
