//! Reading, preparation and evaluation of a profile file, and writing of profiles.

use std::path::Path;

use asperity_core::number;
use asperity_core::numerics::extremes;
use asperity_core::quantity::Length;
use asperity_core::unique;
use asperity_core::{Code, Fault, Profile};
use asperity_profile_io::Warning as ReadWarning;
use asperity_profile_io::read::{
    FilterState, Metadata, ReadError, ReadOptions, Reading, Surface, Trace, read_surface,
    read_trace,
};
use asperity_profile_io::write::{WriteError, WrittenFormat, write_filtered, write_trace};
use asperity_report::profile_json::height;
use asperity_roughness::ambiguity::Sections;
use asperity_roughness::generate::{Achieved, Generated};
use asperity_roughness::height_parameters::{HeightParameters, Mode, in_sections};
use asperity_roughness::outliers::{OutlierRecord, Outliers, replace};
use asperity_roughness::preparation::{Profiles, profiles};
use asperity_roughness::robust_filter::ROBUST_FILTER;
use asperity_roughness::{Parameters, RoughnessError, Warning};

use super::plan::PreparationPlan;
use crate::args::{PreparingArgs, ReadingArgs};
use crate::failure::Failure;
use crate::output;
use crate::words;

/// Profile, read, prepared and evaluated.
pub(super) struct EvaluatedFile {
    pub(super) reading: Reading,
    pub(super) plan: PreparationPlan,
    /// Warning that outliers were replaced.
    pub(super) outliers_replaced: Option<Warning>,
    /// Input of the recipe of the plan, if it is not the profile read.
    pub(super) without_involute: Option<Profile>,
    /// Warning that the involute does not match the trace.
    pub(super) involute_left: Option<Warning>,
    pub(super) parts: Profiles,
    pub(super) iso4287: Parameters,
    pub(super) iso21920: Parameters,
    pub(super) primary: HeightParameters,
    pub(super) waviness: Option<HeightParameters>,
    /// Section length.
    pub(super) section: Length,
}

impl EvaluatedFile {
    pub(super) fn new(
        file: &Path,
        preparing: &PreparingArgs,
        reading: &ReadingArgs,
    ) -> Result<Self, Failure> {
        let trace = opened_trace(file, reading, preparing.base_radius)?;
        Self::of_trace(trace, preparing, reading)
    }

    /// Evaluates a trace that was read with the options.
    pub(super) fn of_trace(
        trace: Trace,
        preparing: &PreparingArgs,
        options: &ReadingArgs,
    ) -> Result<Self, Failure> {
        let (reading, outliers) = without_outliers(even(trace, options)?, preparing.outliers)?;
        let plan = PreparationPlan::for_reading(preparing, &reading)?;
        let refused = |error| refusal(&reading, &plan, &error);
        let without_involute = plan.without_involute(&reading.profile).map_err(refused)?;
        let involute_left = plan.involute_left(&reading.profile).map_err(refused)?;
        let trace = without_involute.as_ref().unwrap_or(&reading.profile);
        let parts = profiles(trace, &plan.recipe, plan.filter).map_err(refused)?;
        let rough = &parts.roughness.profile;
        let mode = Mode::Iso4287;
        let evaluated = match plan.sections {
            Sections::Number(n) => Parameters::with_sections(rough, mode, n),
            Sections::OfLength(length) => Parameters::from_profile(rough, mode, length),
        };
        let iso4287 = evaluated.map_err(refused)?;
        let iso21920 = iso4287.in_mode(rough, Mode::Iso21920).map_err(refused)?;
        let whole = |profile: &Profile| in_sections(profile, Mode::Iso4287, 1).map_err(refused);
        Ok(Self {
            primary: whole(&parts.primary)?,
            waviness: parts.waviness.as_ref().map(whole).transpose()?,
            section: iso4287.lambda_c,
            reading,
            outliers_replaced: outliers.as_ref().and_then(OutlierRecord::warning),
            plan,
            without_involute,
            involute_left,
            parts,
            iso4287,
            iso21920,
        })
    }

    /// Input profile of the recipe of the plan.
    pub(super) fn trace(&self) -> &Profile {
        let read = &self.reading.profile;
        self.without_involute.as_ref().unwrap_or(read)
    }

    /// Distinct warnings.
    pub(super) fn warnings(&self) -> Vec<Note<'_>> {
        let is_idle = |warning: &ReadWarning| {
            *warning == ReadWarning::AlreadyFiltered && self.plan.recipe.lambda_c.is_none()
        };
        let read = self.reading.warnings.iter().filter(|w| !is_idle(w));
        let evaluated = [&self.parts.roughness.warnings, &self.iso4287.warnings];
        let evaluated = evaluated.into_iter().flatten().chain(&self.involute_left);
        let evaluated = self.outliers_replaced.iter().chain(evaluated);
        unique(read.map(Note::Read).chain(evaluated.map(Note::Evaluated)))
    }
}

/// Warning of the reader or of the evaluation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Note<'a> {
    Read(&'a ReadWarning),
    Evaluated(&'a Warning),
}

impl Note<'_> {
    /// Code of the message.
    pub(super) fn code(self) -> Code {
        match self {
            Self::Read(warning) => warning.code(),
            Self::Evaluated(warning) => warning.code(),
        }
    }
}

/// The warning with its remedy.
impl std::fmt::Display for Note<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (text, remedy) = match self {
            Self::Read(warning) => (warning.to_string(), warning.remedy()),
            Self::Evaluated(warning) => (warning.to_string(), warning.remedy()),
        };
        f.write_str(&words::with_options(&text, &remedy))
    }
}

/// Reads a file with the options, on an even grid.
pub(super) fn opened(
    file: &Path,
    args: &ReadingArgs,
    base_radius: Option<Length>,
) -> Result<Reading, Failure> {
    even(opened_trace(file, args, base_radius)?, args)
}

/// The trace on an even grid.
fn even(trace: Trace, args: &ReadingArgs) -> Result<Reading, Failure> {
    let uneven = args.uneven.unwrap_or_default();
    trace.reading(uneven).map_err(|error| refused(&error))
}

/// Replaces points farther than `deviations` from the running median, and returns a record of them.
pub(super) fn without_outliers(
    reading: Reading,
    deviations: Option<f64>,
) -> Result<(Reading, Option<OutlierRecord>), Failure> {
    let Some(deviations) = deviations else {
        return Ok((reading, None));
    };
    let (cleaned, record) =
        replace(&reading.profile, Outliers::beyond(deviations)).map_err(|error| {
            Failure::new(
                Code::E209,
                format!("--outliers {}: {error}", number(deviations)),
            )
        })?;
    Ok((reading.corrected(cleaned), Some(record)))
}

/// The options of the reader.
fn read_options(args: &ReadingArgs, base_radius: Option<Length>) -> ReadOptions {
    ReadOptions {
        x_unit: args.x_unit,
        z_unit: args.z_unit,
        dx: args.dx,
        dy: args.dy,
        columns: args.columns,
        decimal: args.decimal,
        separator: args.separator,
        encoding: args.encoding,
        gaps: args.gaps.unwrap_or_default(),
        row: args.row,
        line: args.line.unwrap_or_default(),
        abscissa: args.abscissa,
        base_radius,
        uneven: args.uneven.unwrap_or_default(),
        range: args.range,
        invert: args.invert,
    }
}

/// Reads a surface with the options.
pub(super) fn opened_surface(file: &Path, args: &ReadingArgs) -> Result<Surface, Failure> {
    if args.range.is_some() {
        let text = "--range cuts a trace; choose one of the surface with --row or --line";
        return Err(Failure::new(Code::E205, text));
    }
    read_surface(file, &read_options(args, None)).map_err(|error| refused(&error))
}

/// Reads a file with the options, with possibly uneven points.
pub(super) fn opened_trace(
    file: &Path,
    args: &ReadingArgs,
    base_radius: Option<Length>,
) -> Result<Trace, Failure> {
    let options = read_options(args, base_radius);
    let trace = read_trace(file, &options).map_err(|error| refused(&error))?;
    let row = args.row.unwrap_or(1);
    let single = !trace.format.may_hold_several();
    if single && (row > 1 || args.line.is_some() || args.dy.is_some()) {
        let name = &trace.name;
        let reason = match args.line {
            Some(line) => format!("--line {line} has nothing to choose from"),
            None if row > 1 => format!("there is no row {row}"),
            None => "--dy has no rows to set apart".to_owned(),
        };
        let text = format!("{name}: the file holds a single profile; {reason}");
        return Err(Failure::new(Code::E119, text));
    }
    Ok(trace)
}

/// Error of the reader, with the options that help.
pub(super) fn refused(error: &ReadError) -> Failure {
    let message = words::with_options(&error.to_string(), &error.remedy());
    Failure::new(error.code(), message)
}

/// Error of the evaluation of a profile, with its remedy.
pub(super) fn refusal(
    reading: &Reading,
    plan: &PreparationPlan,
    error: &RoughnessError,
) -> Failure {
    let name = &reading.name;
    let advice = match error {
        RoughnessError::TooShort { .. } => plan.advice_for(reading),
        RoughnessError::TooFewPoints { .. } if matches!(plan.sections, Sections::Number(_)) => {
            ". Pass fewer --sections".to_owned()
        }
        RoughnessError::NotConverged {
            what: ROBUST_FILTER,
            ..
        }
        | RoughnessError::NoSupport { .. } => {
            ". It has no line below a feature that is wider than the cut-off and much deeper than the roughness: \
             pass --range for the part of the trace without it, or leave --robust out"
                .to_owned()
        }
        error if error.is_of_noise_cutoff() && plan.recipe.lambda_s < Some(reading.spacing) => format!(
            ". Its points are {} apart. Pass a longer --lambda-s, or --lambda-s none",
            reading.spacing
        ),
        _ => String::new(),
    };
    Failure::new(Code::E120, format!("{name}: {error}{advice}"))
}

/// Format by the file name; standard output has the text format.
fn of_name(name: &str) -> Option<WrittenFormat> {
    WrittenFormat::of_name(if name == "-" { "-.csv" } else { name })
}

/// Writes a profile in the format of its name with its filter state, completely or not at all.
pub(super) fn save(
    output: &Path,
    profile: &Profile,
    metadata: &Metadata,
    state: FilterState,
) -> Result<(), Failure> {
    save_as(output, |format| {
        write_filtered(profile, metadata, state, format)
    })
}

/// A computed profile to the digits that are written: a millionth of a micrometre, or of the range of finer heights.
pub(super) fn to_digits(profile: &Profile) -> Result<Profile, Failure> {
    const FINEST: f64 = 1e12;
    const DIGITS: f64 = 1e6;
    let (low, high) = extremes(profile.heights());
    let mut steps = FINEST;
    while steps * (high - low) < DIGITS && high > low && steps < 1e18 {
        steps *= 10.0;
    }
    let heights = profile.heights().iter();
    let heights = heights.map(|z| (z * steps).round() / (steps / 1e6) / 1e6);
    Profile::new(profile.spacing(), heights.collect())
        .map_err(|error| Failure::new(Code::E209, error.to_string()))
}

/// Writes a trace unchanged.
pub(super) fn save_trace(output: &Path, trace: &Trace) -> Result<(), Failure> {
    save_as(output, |format| write_trace(trace, format))
}

fn save_as(
    output: &Path,
    bytes: impl Fn(WrittenFormat) -> Result<Vec<u8>, WriteError>,
) -> Result<(), Failure> {
    let name = output.display().to_string();
    let format = of_name(&name).ok_or_else(|| {
        Failure::new(
            Code::E401,
            format!("{name}: cannot be written; name it .csv, .x3p or .smd"),
        )
    })?;
    let bytes = bytes(format).map_err(|error| Fault::unwritten(&name, error))?;
    output::save(output, &bytes)
}

/// The facts of a trace or surface generated with `seed`.
pub(super) fn synthetic(seed: u64) -> Metadata {
    Metadata {
        title: Some(format!("synthetic, seed {seed}")),
        instrument: Some("asperity profile generate".to_owned()),
        ..Metadata::default()
    }
}

/// The first line of the report on a generated profile.
pub(super) fn made_points(output: &str, made: &Generated) -> String {
    format!("{output}: {} points", made.profile.len())
}

/// The parameters of a generated profile.
pub(super) fn achieved(a: &Achieved) -> String {
    let number = |value: Option<f64>| value.map_or("none".to_owned(), |v| format!("{v:.3}"));
    format!(
        "achieved Ra {} Rq {} Rt {} um Rsk {} Rku {} Rdq {}",
        height(a.ra),
        height(a.rq),
        height(a.rt),
        number(a.rsk),
        number(a.rku),
        number(a.rdq)
    )
}
