//! Both flanks as whole surfaces, where patches of them are in contact.

use std::sync::Arc;

use asperity_core::Code;
use asperity_core::message::Warning;
use asperity_core::quantity::Length;
use asperity_flanks::Sheets;
use asperity_flanks::surfaces::{FlankReport, Texture};
use asperity_flanks::trace::Flank;
use asperity_profile_io::read::{TraceLine, read_surface_bytes};
use asperity_roughness::surface_preparation::{PreparedSurface, prepare_surface};

use super::flank_sample::Listed;
use super::flank_trace::{Context, Keys, read_options};
use crate::input::files::Content;
use crate::source::case_error::CaseError;
use crate::source::section::Section;

/// The surfaces of both flanks with all of their rows.
///
/// # Errors
/// When a flank has no scan or several traces, its scan cannot be prepared, or the case has what only traces have.
pub(crate) fn sheets_of(
    context: Context<'_>,
    lists: &[Vec<Listed>; 2],
    flanks: &[Vec<Flank>; 2],
    keys: &[Keys; 2],
    warnings: &mut Vec<Warning>,
) -> Result<Arc<Sheets>, CaseError> {
    let section = Section::of(context.source, "surface");
    if !context.inputs.has_patches {
        let rule = "patch needs the solved contact and the gap law `inlet`, and has no running-in; leave formulation, model.load_share, model.gap_law and model.run_in at their defaults";
        return Err(section.conflict("contact", rule));
    }
    if context.inputs.surface.outliers.is_some() {
        let rule = "replaces spikes of traces; leave it out with contact = \"patch\"";
        return Err(section.conflict("outliers", rule));
    }
    let mut along = Length::default();
    let mut of_body = |body: usize| {
        let ([listed], [flank]) = (lists[body].as_slice(), flanks[body].as_slice()) else {
            let rule = "patch takes one scan of each flank, whole; leave traces and rows out";
            return Err(section.conflict("contact", rule));
        };
        if let Texture::Trace(row) = &flank.texture {
            // Its rows have the common spacing of traces.
            along = row.spacing();
        }
        let surface = whole(body, (listed, flank), &keys[body], context)?;
        if surface.record.bridged > 0.0 {
            warnings.push(bridged(&flank.report, surface.record.bridged));
        }
        Ok(surface)
    };
    let both = [of_body(0)?, of_body(1)?];
    let text = "patches of both scans are in contact; fields and pictures of one contact, and roughness parameters, are of the middle row of each scan";
    warnings.push(Warning::new(Code::W459, text));
    let sheets = Sheets::of(both, along);
    let sheets = sheets.map_err(section.domain("contact"))?;
    Ok(Arc::new(sheets))
}

/// W460: points of a scan without a height.
fn bridged(report: &FlankReport, share: f64) -> Warning {
    let file = report.file.as_deref().unwrap_or_default();
    let percent = 100.0 * share;
    let text = format!(
        "{file}: {percent:.1} % of the points of the scan have no height; lines between their neighbours are in their place"
    );
    Warning::new(Code::W460, text)
}

/// The scan of pinion or wheel, prepared as its trace was, seen as both flanks face each other.
///
/// A turn about the lead reverses the points of the rows and leaves their order; a mirror image reverses one of both. The wheel faces the
/// pinion: seen from the side of the pinion its points are reversed. Of a flank that is read from its other end, and of columns that are
/// read as rows, the order changes once more.
fn whole(
    body: usize,
    (listed, flank): (&Listed, &Flank),
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
    let line = input.line.unwrap_or_default();
    if matches!(line, TraceLine::Mean | TraceLine::MeanColumn) {
        let rule = "patch takes all rows of a scan; leave line = \"mean\" out";
        return Err(section.conflict("contact", rule));
    }
    let is_column = line == TraceLine::Column;
    let (mut z, columns, across) = match is_column {
        true => (surface.by_columns(), surface.rows, surface.dx),
        false => (surface.z, surface.columns, surface.dy),
    };
    let rows = z.len().checked_div(columns).unwrap_or(0);
    let (Some(across), true) = (across, rows > 1) else {
        return Err(missing());
    };
    let along = reading.profile.spacing();
    // The range that is stated; a trace may also lack points at its ends.
    let (first, last) = match &reading.cut {
        None => (0, columns),
        Some(cut) => {
            let first = ((cut.start / along).round() as usize).min(columns);
            (first, (first + reading.profile.len()).min(columns))
        }
    };
    if (first, last) != (0, columns) {
        let rows = z.chunks_exact(columns.max(1));
        z = rows.flat_map(|row| &row[first..last]).copied().collect();
    }
    let columns = (last - first).max(1);
    let mirrored = flank.report.mirrored;
    if mirrored {
        z.chunks_exact_mut(columns).for_each(<[f64]>::reverse);
    }
    if mirrored ^ is_column ^ (body == 1) {
        z = z.rchunks_exact(columns).flatten().copied().collect();
    }
    let prepared = prepare_surface(&z, columns, [along, across], &record.recipe);
    prepared.map_err(|error| CaseError::preparation(&name, error))
}
