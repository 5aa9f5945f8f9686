//! Both flanks as whole surfaces, where patches of them are in contact.

use std::borrow::Cow;
use std::sync::Arc;

use asperity_core::Code;
use asperity_core::message::Warning;
use asperity_core::quantity::Length;
use asperity_ehl_regime::Lay;
use asperity_flanks::Sheets;
use asperity_flanks::sheets::{MadeSheet, SheetSource};
use asperity_flanks::surfaces::{FlankReport, Texture};
use asperity_flanks::trace::Flank;
use asperity_profile_io::read::{Gaps, TraceLine};
use asperity_roughness::RoughnessError;
use asperity_roughness::surface_preparation::{PreparedSurface, prepare_surface};

use super::flank_sample::Listed;
use super::flank_trace::{Context, Keys};
use crate::source::case_error::CaseError;
use crate::source::section::Section;

/// The surfaces of both flanks with all of their rows.
///
/// # Errors
/// When no flank has a scan, a flank has no or several traces, a scan cannot be prepared, or the case has what only traces have.
pub(crate) fn sheets_of(
    context: Context<'_>,
    lists: &[Vec<Listed>; 2],
    flanks: &mut [Vec<Flank>; 2],
    keys: &[Keys; 2],
    warnings: &mut Vec<Warning>,
) -> Result<Arc<Sheets>, CaseError> {
    let section = Section::of(context.source, "surface");
    if !context.inputs.has_patches {
        let rule = "patch needs the solved contact and the gap law `inlet`, and has no running-in; leave formulation, model.load_share, model.gap_law and model.run_in at their defaults";
        return Err(section.conflict("contact", rule));
    }
    let mut along = Length::default();
    let mut scans = 0;
    let mut of_body = |body: usize| {
        let ([listed], [flank]) = (lists[body].as_slice(), flanks[body].as_mut_slice()) else {
            let rule = "patch takes one scan of each flank, whole, or a scan and a trace; leave traces and rows out";
            return Err(section.conflict("contact", rule));
        };
        let Texture::Trace(row) = &flank.texture else {
            let rule = "patch takes one scan of each flank, whole, or a scan and a trace; leave rq, ra and rz out";
            return Err(section.conflict("contact", rule));
        };
        // Its rows have the common spacing of traces.
        along = row.spacing();
        if !is_of_scan(listed, &keys[body], context) {
            let lay = lay_of_trace(context, body);
            let made = MadeSheet::of(body, lay.gamma());
            warnings.push(made_from_trace(body, (&flank.report, made), context));
            flank.report.made_sheet = Some(made);
            return Ok(SheetSource::Trace(row.clone(), lay.gamma()));
        }
        scans += 1;
        let whole = whole(body, (listed, flank), &keys[body], context)?;
        warnings.extend(bridged(&flank.report, whole.bridged));
        Ok(SheetSource::Scan(whole.prepared))
    };
    let both = [of_body(0)?, of_body(1)?];
    if scans == 0 {
        let rule = "patch needs a scan of at least one flank, a file with the heights of an area; the other flank may have a trace";
        return Err(section.conflict("contact", rule));
    }
    let text = "patches of whole surfaces are in contact; flanks, stress and roughness parameters are of the middle row of each scan";
    warnings.push(Warning::new(Code::W459, text));
    let refused = |error| match error {
        RoughnessError::Domain(error) => section.domain("contact")(error),
        other => CaseError::preparation("surface", other),
    };
    Ok(Arc::new(Sheets::of(both, along).map_err(refused)?))
}

/// Lay of a flank with a trace: as stated, or ridges across the face.
pub(crate) fn lay_of_trace(context: Context<'_>, body: usize) -> Lay {
    context.inputs.lay.map_or(Lay::ACROSS, |lay| lay[body])
}

/// Whether the file of a flank is a surface.
fn is_of_scan(listed: &Listed, keys: &Keys, context: Context<'_>) -> bool {
    if listed.scan.is_some() || listed.generated.is_some() {
        return listed.scan.is_some();
    }
    let file = listed.input.file.as_ref();
    let scan = file.and_then(|file| context.scan(&listed.input, file, keys).ok()?);
    scan.is_some_and(|scan| scan.surface.rows > 1 && scan.surface.columns > 1)
}

/// W458: the surface of a flank that was made from its trace.
fn made_from_trace(
    body: usize,
    (report, made): (&FlankReport, MadeSheet),
    context: Context<'_>,
) -> Warning {
    let file = report.file.as_deref().unwrap_or("the trace");
    let (gear, lay) = (["pinion", "wheel"][body], made.lay);
    let how = match made.seed {
        None => "the trace at every place along the lead".to_owned(),
        Some(seed) => format!("drawn with its heights and its autocorrelation (seed {seed})"),
    };
    let of = match context.inputs.lay {
        Some(_) => format!("the stated lay {lay}"),
        None => "ridges across the face, which is assumed".to_owned(),
    };
    let next = match context.inputs.lay {
        Some(_) => "",
        None => ". State model.lay, or scan this flank as well",
    };
    let text =
        format!("{file}: the surface of the {gear} is made from its trace with {of}: {how}{next}");
    Warning::new(Code::W458, text)
}

/// W460: points of a scan without a height.
pub(crate) fn bridged(report: &FlankReport, share: f64) -> Option<Warning> {
    let file = report.file.as_deref().unwrap_or_default();
    let percent = 100.0 * share;
    let text = format!(
        "{file}: {percent:.1} % of the points of the scan have no height; lines between their neighbours are in their place"
    );
    (share > 0.0).then(|| Warning::new(Code::W460, text))
}

/// A scan, prepared.
pub(crate) struct Whole {
    pub prepared: PreparedSurface,
    /// Share of its points without a height.
    pub bridged: f64,
}

/// The scan of pinion or wheel, prepared as its trace was, seen as both flanks face each other.
///
/// A turn about the lead reverses the points of the rows and leaves their order; a mirror image reverses one of both. The wheel faces the
/// pinion: seen from the side of the pinion its points are reversed. Of a flank that is read from its other end, and of columns that are
/// read as rows, the order changes once more.
pub(crate) fn whole(
    body: usize,
    (listed, flank): (&Listed, &Flank),
    keys: &Keys,
    context: Context<'_>,
) -> Result<Whole, CaseError> {
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
    let scan = match &listed.scan {
        Some(scan) => scan.clone(),
        None => context.scan(input, file, keys)?.ok_or_else(missing)?,
    };
    let (surface, name) = (&scan.surface, scan.surface.name.clone());
    let bridged = scan.missing();
    if bridged > 0.0 && input.gaps == Some(Gaps::Refuse) {
        let rule = "refuse: the scan has points without a height; leave gaps out, and lines between their neighbours are in their place";
        return Err(Section::of(context.source, keys.table).conflict("gaps", rule));
    }
    let line = input.line.unwrap_or_default();
    if matches!(line, TraceLine::Mean | TraceLine::MeanColumn) {
        let rule = "patch takes all rows of a scan; leave line = \"mean\" out";
        return Err(section.conflict("contact", rule));
    }
    let is_column = line == TraceLine::Column;
    let (mut z, columns, across) = match is_column {
        true => (Cow::Owned(surface.by_columns()), surface.rows, surface.dx),
        false => (Cow::Borrowed(&*surface.z), surface.columns, surface.dy),
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
        let part = rows.flat_map(|row| &row[first..last]);
        z = Cow::Owned(part.copied().collect());
    }
    let columns = (last - first).max(1);
    let mirrored = flank.report.mirrored;
    if mirrored {
        let rows = z.to_mut().chunks_exact_mut(columns);
        rows.for_each(<[f64]>::reverse);
    }
    if mirrored ^ is_column ^ (body == 1) {
        z = Cow::Owned(z.rchunks_exact(columns).flatten().copied().collect());
    }
    let refused = |error| CaseError::preparation(&name, error);
    let prepared = prepare_surface(&z, columns, [along, across], &record.recipe);
    Ok(Whole {
        prepared: prepared.map_err(refused)?,
        bridged,
    })
}
