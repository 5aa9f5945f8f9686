//! `asperity profile convert`, `filter` and `generate`: a profile into a file.

use asperity_core::Code;
use asperity_profile_io::Warning;
use asperity_profile_io::read::{FilterState, Metadata, Positions, Trace};
use asperity_report::Report;
use asperity_report::profile_json::um;
use asperity_roughness::composite::resampled;
use asperity_roughness::generate::{Recipe, SelfAffine, Surface};
use asperity_roughness::preparation::profiles;
use serde_json::json;

use super::evaluated::{
    Note, achieved, made_points, opened, opened_trace, refusal, refused, save, save_trace,
    synthetic, to_digits, without_outliers,
};
use super::plan::PreparationPlan;
use super::{like_surface, like_trace};
use crate::args::{
    Common, ProfileConvertArgs, ProfileFilterArgs, ProfileGenerateArgs, ProfilePart,
};
use crate::failure::Failure;
use crate::output::{besides_file, print_report};

/// `asperity profile convert`
pub fn convert(args: &ProfileConvertArgs, common: &Common) -> Result<(), Failure> {
    let common = &besides_file(&args.output, common)?;
    let trace = opened_trace(&args.file, &args.reading, args.base_radius)?;
    let as_it_stands = args.outliers.is_none() && args.reading.uneven.is_none();
    if let Positions::Own { unevenness, .. } = &trace.positions
        && as_it_stands
        && trace.metadata.arc_from_base.is_none()
    {
        let off = unevenness.off;
        return convert_uneven(args, trace, off, common);
    }
    let uneven = args.reading.uneven.unwrap_or_default();
    let reading = trace.reading(uneven).map_err(|error| refused(&error))?;
    let (reading, outliers) = without_outliers(reading, args.outliers)?;
    let mut profile = reading.profile.clone();
    if let Some(dx) = args.resample {
        profile = resampled(&profile, dx)
            .map_err(|error| Failure::new(Code::E209, format!("--resample {dx:.6}: {error}")))?;
    }
    save(
        &args.output,
        &profile,
        &reading.metadata,
        reading.filter_state,
    )?;
    let (output, n) = (args.output.display().to_string(), profile.len());
    let replaced = outliers.as_ref().map(|record| {
        format!(
            "{} outliers replaced (longest run {}, farthest {:.3} um)",
            record.replaced,
            record.longest,
            um(record.farthest)
        )
    });
    let resampled = args
        .resample
        .map(|_| format!("resampled linearly from {}", reading.spacing));
    let json = || {
        json!({
            "reading": reading, "output": output, "n": n, "dx_um": um(profile.spacing()),
            "resampled_from_um": args.resample.map(|_| um(reading.spacing)), "outliers": outliers,
        })
    };
    let read = format!(
        "{} ({}, {} points)",
        reading.name, reading.format, reading.points
    );
    let report = || {
        Report::new(&format!("{read} -> {output}, {n} points"), "")
            .text(replaced)
            .text(resampled)
            .warning(notes(&reading.warnings))
    };
    print_report(common, json, report, None)
}

/// Writes an uneven trace with the x of every point, or resampled to even steps.
fn convert_uneven(
    args: &ProfileConvertArgs,
    mut trace: Trace,
    off: f64,
    common: &Common,
) -> Result<(), Failure> {
    let (mut n, mut dx) = (trace.heights.len(), None);
    match args.resample {
        None => {
            save_trace(&args.output, &trace)?;
            trace.warnings.push(Warning::PositionsKept { off });
        }
        Some(spacing) => {
            let even = trace.resampled(spacing).map_err(|error| refused(&error))?;
            save(
                &args.output,
                &even.profile,
                &trace.metadata,
                trace.filter_state,
            )?;
            (n, dx) = (even.profile.len(), Some(um(spacing)));
            trace.warnings.push(Warning::Resampled {
                off,
                spacing,
                rms: even.rms,
                most: even.most,
            });
        }
    }
    let output = args.output.display().to_string();
    let points = trace.heights.len();
    let head = format!(
        "{} ({}, {points} uneven points) -> {output}, {n} points",
        trace.name, trace.format
    );
    print_report(
        common,
        || json!({ "reading": trace, "output": output, "n": n, "dx_um": dx }),
        || Report::new(&head, "").warning(notes(&trace.warnings)),
        None,
    )
}

/// The warnings of the reader.
fn notes(warnings: &[Warning]) -> impl Iterator<Item = String> {
    let note = |warning: &Warning| format!("{} {}", warning.code(), Note::Read(warning));
    warnings.iter().map(note)
}

/// `asperity profile filter`
pub fn filter(args: &ProfileFilterArgs, common: &Common) -> Result<(), Failure> {
    let common = &besides_file(&args.output, common)?;
    let reading = opened(&args.file, &args.reading, args.preparing.base_radius)?;
    let (reading, outliers) = without_outliers(reading, args.preparing.outliers)?;
    let plan = PreparationPlan::for_reading(&args.preparing, &reading)?;
    let unfit = |error| refusal(&reading, &plan, &error);
    let without_involute = plan.without_involute(&reading.profile).map_err(unfit)?;
    let trace = without_involute.as_ref().unwrap_or(&reading.profile);
    let parts = profiles(trace, &plan.recipe, plan.filter).map_err(unfit)?;
    let profile = match args.part {
        ProfilePart::Roughness => &parts.roughness.profile,
        ProfilePart::Primary => &parts.primary,
        ProfilePart::Waviness => parts.waviness.as_ref().ok_or_else(|| {
            let text = format!(
                "{}: there is no waviness without lambda_c",
                args.file.display()
            );
            Failure::new(Code::E205, text)
        })?,
    };
    let (state, lambda_c) = match args.part {
        ProfilePart::Primary => (FilterState::Primary, None),
        ProfilePart::Roughness if plan.recipe.lambda_c.is_some() => {
            (FilterState::Roughness, plan.recipe.lambda_c)
        }
        ProfilePart::Roughness => (reading.filter_state, reading.metadata.lambda_c),
        ProfilePart::Waviness => (FilterState::Unknown, None),
    };
    let metadata = Metadata {
        lambda_c,
        lambda_s: plan.recipe.lambda_s.or(reading.metadata.lambda_s),
        ..reading.metadata.clone()
    };
    save(&args.output, &to_digits(profile)?, &metadata, state)?;
    let record = &parts.roughness.record;
    let output = args.output.display().to_string();
    let json = || {
        json!({
            "reading": reading, "outliers": outliers, "preparation": plan.recorded(record), "output": output,
            "n": profile.len(),
        })
    };
    let robust = record.robust.map_or(String::new(), |robust| {
        format!(
            ", {} iterations, {:.2} % ignored",
            robust.iterations,
            100.0 * robust.ignored
        )
    });
    let head = format!(
        "{} -> {output}: {} of {} points{robust}",
        reading.name,
        profile.len(),
        reading.points
    );
    let report = || Report::new(&head, "").warning(notes(&reading.warnings));
    print_report(common, json, report, None)
}

/// `asperity profile generate`
pub fn generate(args: &ProfileGenerateArgs, common: &Common) -> Result<(), Failure> {
    let common = &besides_file(&args.output, common)?;
    if !args.like.is_empty() {
        return match like_trace::generate(args, common) {
            // A file of several traces of which none is chosen is a surface.
            Err(failure) if failure.is_of_several() && args.reading.row.is_none() => {
                like_surface::generate(args, common)
            }
            done => done,
        };
    }
    let recipe = Recipe::from_surface(Surface::SelfAffine(SelfAffine {
        points: args.points,
        spacing: args.spacing,
        rq: args.rq,
        hurst: args.hurst,
        roll_off: args.roll_off,
        short_cut: args.short_cut,
        seed: args.seed,
    }));
    let made = recipe
        .generate()
        .map_err(|error| Failure::new(Code::E209, error.to_string()))?;
    save(
        &args.output,
        &to_digits(&made.profile)?,
        &synthetic(args.seed),
        FilterState::Primary,
    )?;
    let output = args.output.display().to_string();
    print_report(
        common,
        || json!({ "recipe": recipe, "achieved": made.achieved, "output": output }),
        || Report::new(&made_points(&output, &made), "").text([achieved(&made.achieved)]),
        None,
    )
}
