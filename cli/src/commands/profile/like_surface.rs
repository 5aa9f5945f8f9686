//! `asperity profile generate --like` with surfaces: a surface of their kind.

use std::path::Path;

use asperity_core::quantity::Length;
use asperity_core::{Code, Fault};
use asperity_profile_io::read::Surface;
use asperity_profile_io::write::{WrittenFormat, write_surface};
use asperity_report::profile_json::um;
use asperity_roughness::areal::parameters;
use asperity_roughness::generate::{LONG_WAVES, LikeSurface, MadeSurface, Method};
use asperity_roughness::lay::bridged;
use serde_json::json;

use super::evaluated::{Note, opened_surface, synthetic};
use super::surface_facts::{areal_line, spacings};
use crate::args::{Common, ProfileGenerateArgs};
use crate::failure::Failure;
use crate::output::{self, print_json, print_text};

/// Writes a surface of the kind of those in `args.like`.
pub(super) fn generate(args: &ProfileGenerateArgs, common: &Common) -> Result<(), Failure> {
    let name = args.output.display().to_string();
    if WrittenFormat::of_name(&name) != Some(WrittenFormat::X3p) {
        let text = format!("{name}: cannot be written; a surface is written as X3P, name it .x3p");
        return Err(Failure::new(Code::E401, text));
    }
    let surfaces = args
        .like
        .iter()
        .map(|file| opened_surface(file, &args.reading));
    let surfaces: Vec<Surface> = surfaces.collect::<Result<_, _>>()?;
    let Some(first) = surfaces.first() else {
        return Ok(());
    };
    let spacings = spacings(first)
        .map_err(|reason| Failure::new(Code::E110, format!("{}: {reason}", first.name)))?;
    for other in &surfaces {
        let grid = |surface: &Surface| (surface.columns, surface.rows, surface.dx, surface.dy);
        if grid(other) != grid(first) {
            let text = format!(
                "{}: its rows, points or their distances differ from {}, to which it is fitted together",
                other.name, first.name
            );
            return Err(Failure::new(Code::E120, text));
        }
    }
    let heights = surfaces.iter().map(|surface| whole(surface, args));
    let heights: Vec<Vec<f64>> = heights.collect::<Result<_, _>>()?;
    let refused = |error| Failure::new(Code::E120, format!("{}: {error}", first.name));
    let like = LikeSurface::to(&heights, first.columns, spacings, args.method).map_err(refused)?;
    let warnings: Vec<_> = like
        .warnings
        .iter()
        .map(Note::Evaluated)
        .map(|note| json!({ "code": note.code(), "text": note.to_string() }))
        .collect();
    let made = like.generate(args.seed);
    let z = &made.heights;
    let bytes = write_surface(z, first.columns, spacings, &synthetic(args.seed))
        .map_err(|error| Fault::unwritten(&name, error))?;
    output::save(Path::new(&args.output), &bytes)?;
    let areal = parameters(z, first.columns, spacings).map_err(refused)?;
    if common.json {
        return print_json(&json!({
            "like": surfaces.iter().map(|surface| &surface.name).collect::<Vec<_>>(),
            "seed": args.seed,
            "method": made.method,
            "warnings": warnings,
            "pieces": pieces(&made, args, spacings),
            "columns": first.columns,
            "rows": first.rows,
            "dx_um": um(spacings[0]),
            "dy_um": um(spacings[1]),
            "achieved": areal,
            "output": name,
        }));
    }
    let mut text = format!(
        "{name}: {} rows of {} points, achieved {}\n{}\n",
        first.rows,
        first.columns,
        areal_line(&areal),
        source(&made, surfaces.len(), like.has_long_waves())
    );
    for note in like.warnings.iter().map(Note::Evaluated) {
        text += &format!("{} {note}\n", note.code());
    }
    print_text(common, &text)
}

/// Source of the surface, as a sentence.
fn source(made: &MadeSurface, surfaces: usize, has_long_waves: bool) -> String {
    let surfaces = match surfaces {
        1 => "one surface".to_owned(),
        several => format!("{several} surfaces"),
    };
    match made.method {
        Method::Pieces => {
            let long = if has_long_waves {
                "; longer waves are random, with their spectrum"
            } else {
                ""
            };
            format!(
                "{} pieces of {surfaces}: waves up to {LONG_WAVES:.1} and rare valleys are those of the surfaces given{long}",
                made.pieces.len()
            )
        }
        Method::Spectrum => format!("spectrum and heights of {surfaces}"),
    }
}

/// The pieces, with their files, first points and sizes along and across the rows.
fn pieces(
    made: &MadeSurface,
    args: &ProfileGenerateArgs,
    spacings: [Length; 2],
) -> serde_json::Value {
    let lengths = |points: [usize; 2]| [0, 1].map(|d| um(spacings[d]) * points[d] as f64);
    let piece = |piece: &asperity_roughness::generate::SurfacePiece| {
        json!({
            "file": args.like.get(piece.surface),
            "from_um": lengths(piece.first),
            "size_um": lengths(piece.size),
        })
    };
    made.pieces.iter().map(piece).collect()
}

/// Heights without gaps.
fn whole(surface: &Surface, args: &ProfileGenerateArgs) -> Result<Vec<f64>, Failure> {
    let missing = surface.z.len() - surface.measured();
    let fills = args.reading.gaps == Some(asperity_profile_io::read::Gaps::Interpolate);
    let refused = |rows: &str| {
        let text = format!("{}: {missing} heights are missing{rows}", surface.name);
        Failure::new(Code::E107, text)
    };
    match (missing, fills) {
        (0, _) => Ok(surface.z.clone()),
        (_, false) => Err(refused(". Pass --gaps interpolate")),
        (_, true) => {
            let rows = surface.z.chunks(surface.columns).map(bridged);
            let rows: Option<Vec<Vec<f64>>> = rows.collect();
            let rows = rows.ok_or_else(|| refused(", more than half of a row"))?;
            Ok(rows.concat())
        }
    }
}
