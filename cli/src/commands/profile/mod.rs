//! `asperity profile`: looking at, converting, filtering, making and comparing profiles.

mod info;
mod plot;
mod report;
mod svg;
mod transform;

use std::io::Write as _;
use std::path::Path;

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::form::Form;
use asperity_roughness::height_parameters::{HeightParameters, Mode, in_sections};
use asperity_roughness::preparation::{Preparation, Profiles, RoughnessFilter, profiles};
use asperity_roughness::read::{Metadata, ReadOptions, Reading, read};
use asperity_roughness::write::{WrittenFormat, write};
use asperity_roughness::{Parameters, RoughnessError, Warning};

use crate::args::{Common, PreparingArgs, ProfileCommand, ReadingArgs};
use crate::failure::Failure;

/// λc where none is asked for: the usual cut-off of Ra 0.1 to 2 µm.
const CUTOFF: Length = Length::from_si(0.8e-3);
/// Sections of a trace that is not filtered.
const SECTIONS: usize = 5;

/// Runs one of the subcommands.
pub fn run(command: &ProfileCommand, common: &Common) -> Result<(), Failure> {
    match command {
        ProfileCommand::Info(args) => info::info(args, common),
        ProfileCommand::Compare(args) => info::compare(args, common),
        ProfileCommand::Plot(args) => plot::plot(args, common),
        ProfileCommand::Convert(args) => transform::convert(args, common),
        ProfileCommand::Filter(args) => transform::filter(args, common),
        ProfileCommand::Generate(args) => transform::generate(args, common),
    }
}

/// A profile, read, prepared and evaluated.
struct Evaluated {
    reading: Reading,
    parts: Profiles,
    iso4287: Parameters,
    iso21920: Parameters,
    primary: HeightParameters,
    waviness: Option<HeightParameters>,
    /// Section length.
    section: Length,
}

impl Evaluated {
    fn of(file: &Path, preparing: &PreparingArgs, reading: &ReadingArgs) -> Result<Self, Failure> {
        let reading = opened(file, reading)?;
        let refused = |error: RoughnessError| refusal(file, &error);
        let recipe = recipe(preparing);
        let parts = profiles(&reading.profile, &recipe, filter(preparing)).map_err(refused)?;
        let rough = &parts.roughness.profile;
        let mode = Mode::Iso4287;
        let evaluated = match (preparing.sections, recipe.lambda_c) {
            (Some(n), _) => Parameters::with_sections(rough, mode, n.into()),
            (None, Some(lambda_c)) => Parameters::of(rough, mode, lambda_c),
            (None, None) => Parameters::with_sections(rough, mode, SECTIONS),
        };
        let iso4287 = evaluated.map_err(refused)?;
        let iso21920 = iso4287.in_mode(rough, Mode::Iso21920).map_err(refused)?;
        let whole = |profile: &Profile| in_sections(profile, Mode::Iso4287, 1).map_err(refused);
        Ok(Self {
            primary: whole(&parts.primary)?,
            waviness: parts.waviness.as_ref().map(whole).transpose()?,
            section: iso4287.lambda_c,
            reading,
            parts,
            iso4287,
            iso21920,
        })
    }

    /// All warnings, each once.
    fn warnings(&self) -> Vec<&Warning> {
        let mut all: Vec<&Warning> = Vec::new();
        let lists = [
            &self.reading.warnings,
            &self.parts.roughness.warnings,
            &self.iso4287.warnings,
        ];
        for warning in lists.into_iter().flatten() {
            if !all.contains(&warning) {
                all.push(warning);
            }
        }
        all
    }
}

/// Reads a file as the options say.
fn opened(file: &Path, args: &ReadingArgs) -> Result<Reading, Failure> {
    let options = ReadOptions {
        x_unit: args.x_unit,
        z_unit: args.z_unit,
        dx: args.dx,
        columns: args.columns,
        decimal: args.decimal,
        separator: args.separator,
        encoding: args.encoding,
        gaps: args.gaps.unwrap_or_default(),
        row: args.row,
    };
    read(file, &options).map_err(|error| Failure::new(error.code(), error.to_string()))
}

fn refusal(file: &Path, error: &RoughnessError) -> Failure {
    Failure::new("E120", format!("{}: {error}", file.display()))
}

fn filter(args: &PreparingArgs) -> RoughnessFilter {
    if args.robust {
        RoughnessFilter::RobustGaussian
    } else {
        RoughnessFilter::Gaussian
    }
}

fn recipe(args: &PreparingArgs) -> Preparation {
    let usual = Preparation::default();
    if args.as_is || args.level {
        return Preparation {
            form: if args.as_is { Form::None } else { Form::Level },
            lambda_s: None,
            lambda_c: None,
            ..usual
        };
    }
    let kept = |given: Option<Length>, usual: Option<Length>| match given {
        None => usual,
        Some(length) => (length.si() > 0.0).then_some(length),
    };
    Preparation {
        form: args.form.unwrap_or(usual.form),
        lambda_s: kept(args.lambda_s, usual.lambda_s),
        lambda_c: kept(args.lambda_c, usual.lambda_c.or(Some(CUTOFF))),
        ends: args.ends.unwrap_or(usual.ends),
    }
}

/// Writes a profile in the format its name asks for; an interrupted run leaves nothing half-written.
fn save(output: &Path, profile: &Profile, metadata: &Metadata) -> Result<(), Failure> {
    let name = output.display().to_string();
    let format = WrittenFormat::of_name(&name).ok_or_else(|| {
        Failure::new(
            "E401",
            format!("{name}: cannot be written; name it .csv, .x3p or .smd"),
        )
    })?;
    let bytes = write(profile, metadata, format)
        .map_err(|error| Failure::new("E401", format!("{name}: cannot be written: {error}")))?;
    save_bytes(output, &bytes)
}

/// Writes `bytes` beside their place and renames.
fn save_bytes(output: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let failed = |error: &dyn std::fmt::Display| {
        let text = format!("{}: cannot be written: {error}", output.display());
        Failure::new("E401", text)
    };
    let folder = output
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    let mut file = tempfile::NamedTempFile::new_in(folder).map_err(|error| failed(&error))?;
    file.write_all(bytes).map_err(|error| failed(&error))?;
    file.persist(output).map_err(|error| failed(&error.error))?;
    Ok(())
}

fn um(length: Length) -> f64 {
    length.si() * 1e6
}
