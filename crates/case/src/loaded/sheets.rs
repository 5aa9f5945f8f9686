//! Both flanks as whole surfaces, where patches of them are in contact.

use std::sync::Arc;

use asperity_core::quantity::Length;
use asperity_flanks::Sheets;
use asperity_flanks::trace::Flank;
use asperity_profile_io::read::{TraceLine, read_surface_bytes};
use asperity_roughness::surface_preparation::{PreparedSurface, prepare_surface};

use super::flank_sample::Listed;
use super::flank_trace::{Context, Keys, read_options};
use crate::input::files::Content;
use crate::source::case_error::CaseError;
use crate::source::section::Section;

/// Part of λs by which the points of a patch are apart: a wave of twice this length is left with a thousandth of its amplitude.
const SHARE_OF_NOISE_CUTOFF: f64 = 0.4;

/// The surfaces of both flanks with all of their rows.
///
/// # Errors
/// When a flank has no surface, several traces or a place, or its surface cannot be prepared.
pub(crate) fn sheets_of(
    context: Context<'_>,
    lists: &[Vec<Listed>; 2],
    flanks: &[Vec<Flank>; 2],
    keys: &[Keys; 2],
) -> Result<Arc<Sheets>, CaseError> {
    let section = Section::of(context.source, "surface");
    if !context.inputs.solves_contact {
        let rule = "patch needs the solved contact; leave model.load_share and formulation at their defaults";
        return Err(section.conflict("contact", rule));
    }
    let mut made: Vec<PreparedSurface> = Vec::with_capacity(2);
    for (body, keys) in keys.iter().enumerate() {
        let ([listed], [flank]) = (lists[body].as_slice(), flanks[body].as_slice()) else {
            let rule = "patch takes one scan of each flank, whole; leave traces and rows out";
            return Err(section.conflict("contact", rule));
        };
        made.push(whole(listed, flank, keys, context)?);
    }
    let finest = made
        .iter()
        .map(|surface| surface.spacings[0].si())
        .fold(0.0, f64::max);
    let noise = made
        .iter()
        .filter_map(|surface| surface.record.recipe.lambda_s)
        .map(|cutoff| SHARE_OF_NOISE_CUTOFF * cutoff.si());
    let along = noise.fold(f64::INFINITY, f64::min);
    let along = match along.is_finite() {
        true => Length::from_si(along.max(finest)),
        false => Length::from_si(finest),
    };
    let sheets = Sheets::of([&made[0], &made[1]], along);
    let sheets = sheets.map_err(section.domain("contact"))?;
    Ok(Arc::new(sheets))
}

/// The surface of a flank, prepared as its trace was, in the direction of the flank.
fn whole(
    listed: &Listed,
    flank: &Flank,
    keys: &Keys,
    context: Context<'_>,
) -> Result<PreparedSurface, CaseError> {
    let section = Section::of(context.source, "surface");
    let input = &listed.input;
    let missing = || section.conflict("contact", "patch needs a scan of each flank as file");
    let (Some(file), Some(reading), Some(record)) = (
        input.file.as_ref(),
        flank.report.reading.as_ref(),
        flank.report.preparation.as_ref(),
    ) else {
        return Err(missing());
    };
    let (content, _) = context
        .files
        .open(file, context.source, keys.file.clone())?;
    let Content::Bytes(bytes) = content else {
        return Err(missing());
    };
    let name = file.display().to_string();
    let surface = read_surface_bytes(&name, &bytes, &read_options(input));
    let place = || context.source.place_of(&keys.file);
    let surface = surface.map_err(|error| CaseError::profile(place(), &error))?;
    let is_column = input.line.unwrap_or_default() == TraceLine::Column;
    let (mut z, columns, across) = match is_column {
        true => (surface.by_columns(), surface.rows, surface.dx),
        false => (surface.z, surface.columns, surface.dy),
    };
    let rows = z.len().checked_div(columns).unwrap_or(0);
    let (Some(across), true) = (across, rows > 1) else {
        return Err(missing());
    };
    // The part of the rows that the trace has.
    let start = reading
        .cut
        .map_or(0.0, |cut| cut.start / reading.profile.spacing());
    let first = (start.round() as usize).min(columns);
    let last = (first + reading.profile.len()).min(columns);
    if (first, last) != (0, columns) {
        let rows = z.chunks_exact(columns.max(1));
        z = rows.flat_map(|row| &row[first..last]).copied().collect();
    }
    let columns = last - first;
    if flank.report.mirrored {
        z.chunks_exact_mut(columns.max(1))
            .for_each(<[f64]>::reverse);
    }
    let along = reading.profile.spacing();
    let prepared = prepare_surface(&z, columns, [along, across], &record.recipe);
    prepared.map_err(|error| CaseError::preparation(&name, error))
}
