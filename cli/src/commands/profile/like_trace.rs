//! `asperity profile generate --like` with traces: a trace of their finish.

use std::path::{Path, PathBuf};

use asperity::flanks::statements::Statements;
use asperity_core::quantity::Length;
use asperity_core::{Code, Profile};
use asperity_profile_io::read::{FilterState, Metadata};
use asperity_report::Report;
use asperity_report::profile_json::um;
use asperity_roughness::RoughnessError;
use asperity_roughness::generate::{Like, MadeLike, Method, Recipe, State, Surface};
use serde_json::json;

use super::evaluated::{Note, achieved, made_points, opened, save, synthetic, to_digits};
use crate::args::{Common, ProfileGenerateArgs};
use crate::failure::Failure;
use crate::output::print_report;

/// Writes a trace like those that `args` name.
pub(super) fn generate(args: &ProfileGenerateArgs, common: &Common) -> Result<(), Failure> {
    let (mut warnings, mut stated) = (Vec::new(), Vec::new());
    let mut read = |file: &Path| -> Result<Profile, Failure> {
        let reading = opened(file, &args.reading, None)?;
        let notes = reading.record.warnings.iter().map(Note::Read);
        warnings.extend(notes.map(|note| (note.code(), note.to_string())));
        stated.push(Statements::from(&reading));
        Ok(reading.profile)
    };
    let mut all = |files: &[PathBuf]| -> Result<Vec<Profile>, Failure> {
        files.iter().map(|file| read(file)).collect()
    };
    let (traces, after) = (all(&args.like)?, all(&args.after)?);
    let refused = |error: RoughnessError| {
        Failure::new(Code::E120, format!("{}: {error}", args.like[0].display()))
    };
    let state = state(args)?;
    let like = match state {
        None => Like::to(&traces[0], &traces[1..], args.method).map_err(refused)?,
        Some(state) => Like::of_stages(&traces, &after, state)?,
    };
    let notes = like.warnings.iter().map(Note::Evaluated);
    warnings.extend(notes.map(|note| (note.code(), note.to_string())));
    let made = like.generate(args.seed).map_err(refused)?;
    let mut source = source(&made, args.like.len());
    if let Some(state) = state {
        source += &format!(" {state}");
    }
    if let Some(words) = like.teeth.words() {
        source += &format!(", {words}");
    }
    let metadata = synthetic(args.seed);
    let metadata = match made.method {
        Method::Pieces => Metadata {
            title: metadata.title.map(|title| format!("{title}, {source}")),
            ..metadata
        },
        // As its recipe makes it.
        Method::Spectrum => metadata,
    };
    let profile = to_digits(&made.generated.profile)?;
    let (metadata, filtered) = filtered_as(&stated, metadata);
    save(&args.output, &profile, &metadata, filtered)?;
    let output = args.output.display().to_string();
    let a = made.generated.achieved;
    let meaning = (made.method == Method::Pieces).then(|| {
        format!(
            "{source}: waves shorter than a piece and rare valleys are those of the traces given; longer waves have their power"
        )
    });
    let json = || {
        let warnings = warnings
            .iter()
            .map(|(code, text)| json!({ "code": code, "text": text }));
        let recipe = made
            .recipe
            .clone()
            .map(Surface::Fitted)
            .map(Recipe::from_surface);
        json!({
            "recipe": recipe, "method": made.method, "pieces": pieces(&made, args, traces[0].spacing().si()),
            "achieved": a, "output": output,
            "warnings": warnings.collect::<Vec<_>>(),
        })
    };
    let report = || {
        Report::new(&made_points(&output, &made.generated), "")
            .text([achieved(&a)])
            .text(meaning.clone())
            .warning(warnings.iter().map(|(code, text)| format!("{code} {text}")))
    };
    print_report(common, json, report, None)
}

/// Filters that the traces went through, and their cut-offs, where all files state the same: a trace made of them went through no other.
fn filtered_as(stated: &[Statements], metadata: Metadata) -> (Metadata, FilterState) {
    let common = |of: fn(&Statements) -> Option<Length>| {
        let mut all = stated.iter().map(of);
        let first = all.next().flatten();
        first.filter(|_| all.all(|other| other == first))
    };
    let metadata = Metadata {
        lambda_c: common(|stated| stated.cutoffs[0]),
        lambda_s: common(|stated| stated.cutoffs[1]),
        ..metadata
    };
    let state = if stated.iter().all(Statements::is_roughness) {
        FilterState::Roughness
    } else {
        FilterState::Primary
    };
    (metadata, state)
}

/// The state wanted, if there are traces after a test.
fn state(args: &ProfileGenerateArgs) -> Result<Option<State>, Failure> {
    if args.after.is_empty() {
        return Ok(None);
    }
    let needed = args.stages.len().max(1) * args.like.len();
    if args.after.len() != needed {
        let text = format!(
            "--after: each --like needs its trace after each stage, in the same order: {needed} traces, not {}",
            args.after.len()
        );
        return Err(Failure::new(Code::E205, text));
    }
    Ok(Some(State::stated(
        args.state,
        args.engagements,
        &args.stages,
    )?))
}

/// The method of a generated trace, and the number of traces given.
fn source(made: &MadeLike, traces: usize) -> String {
    let traces = match traces {
        1 => "one trace".to_owned(),
        several => format!("{several} traces"),
    };
    match made.method {
        Method::Pieces => format!("{} pieces of {traces}", made.pieces.len()),
        Method::Spectrum => format!("spectrum and heights of {traces}"),
    }
}

/// The pieces, with their files.
fn pieces(made: &MadeLike, args: &ProfileGenerateArgs, spacing: f64) -> serde_json::Value {
    let um = |points: usize| um(Length::from_si(points as f64 * spacing));
    let piece = |piece: &asperity_roughness::generate::Piece| {
        json!({
            "file": args.like.get(piece.trace), "from_um": um(piece.first), "length_um": um(piece.points),
        })
    };
    made.pieces.iter().map(piece).collect()
}
