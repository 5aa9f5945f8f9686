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
use asperity_profile_io::read::Gaps;
use asperity_roughness::RoughnessError;
use asperity_roughness::preparation::LAMBDA_C;
use asperity_roughness::surface_preparation::{PreparedSurface, prepare_surface};
use asperity_roughness::surface_step::step;

use super::flank_sample::Listed;
use super::flank_trace::{Context, FlankKeys};
use super::lay::Lays;
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
    keys: &[FlankKeys; 2],
    is_scan: [bool; 2],
    lays: &Lays,
    warnings: &mut Vec<Warning>,
) -> Result<Arc<Sheets>, CaseError> {
    let section = Section::new(context.source, "surface");
    if !context.inputs.has_patches {
        let rule = "patch needs the solved contact and a flooded inlet, and has no running-in; leave formulation, model.load_share, model.inlet_layer and operation.running_in at their defaults, or set surface.contact = \"lines\"";
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
        if !is_scan[body] {
            let measured = lays.measured(body);
            let stated = context.inputs.lay.map(|lay| lay[body]);
            let lay = stated.or(measured).unwrap_or(Lay::ACROSS).gamma();
            let made = MadeSheet::new(body, lay);
            let of = match (stated, measured) {
                (Some(_), _) => ["stated", ""],
                (None, Some(_)) => [
                    "measured",
                    ". Leave row and line out, and the file is taken whole",
                ],
                (None, None) => ["assumed", ". State model.lay, or scan this flank as well"],
            };
            warnings.push(made_from_trace(body, &flank.report, made, of));
            flank.report.made_sheet = Some(made);
            return Ok(SheetSource::Trace(row.clone(), lay));
        }
        scans += 1;
        let whole = whole(body, listed, flank, &keys[body], context)?;
        warnings.extend(stepped(&whole, &flank.report));
        Ok(SheetSource::Scan(whole))
    };
    let both = [of_body(0)?, of_body(1)?];
    if scans == 0 {
        let rule = "patch needs a scan of at least one flank, a file with the heights of an area; the other flank may have a trace";
        return Err(section.conflict("contact", rule));
    }
    let lines = match scans {
        1 => "the trace and the middle row of the scan",
        _ => "the middle row of each scan",
    };
    let text = format!(
        "patches of whole surfaces are in contact; flanks, stress and roughness parameters are of {lines}. A scan is of one tooth: the scatter between teeth is not in the interval of the loss"
    );
    warnings.push(Warning::new(Code::W459, text));
    let refused = |error| match error {
        RoughnessError::Domain(error) => section.domain("contact")(error),
        other => CaseError::preparation("surface", other),
    };
    Ok(Arc::new(Sheets::new(both, along).map_err(refused)?))
}

/// W458: the surface of a flank that was made from its trace.
fn made_from_trace(
    body: usize,
    report: &FlankReport,
    made: MadeSheet,
    [origin, next]: [&str; 2],
) -> Warning {
    let file = report.file.as_deref().unwrap_or("the trace");
    let (gear, lay) = (
        ["pinion", "wheel"][body],
        (100.0 * made.lay).round() / 100.0,
    );
    let how = match made.seed {
        None => "ridges across the face, the trace at every place along the lead".to_owned(),
        Some(seed) => format!("random with its heights and its autocorrelation (seed {seed})"),
    };
    let text = format!(
        "{file}: the surface of the {gear} is generated from its trace with the {origin} lay {lay}: {how}{next}"
    );
    Warning::new(Code::W458, text)
}

/// W467: a step across a scan, with the longer side of it.
pub(crate) fn stepped(surface: &PreparedSurface, report: &FlankReport) -> Option<Warning> {
    let step = step(surface)?;
    let (file, height) = (report.file.as_deref().unwrap_or_default(), step.height);
    let spacing = surface.spacings[0];
    let text = if step.is_across_rows {
        let points = surface.record.points_before[0];
        let mut at = surface.record.dropped_each_end as f64 + step.place / spacing;
        if report.mirrored {
            at = points as f64 - at;
        }
        let cut = report
            .reading
            .as_ref()
            .and_then(|reading| reading.cut.as_ref());
        let start = cut.map_or(Length::default(), |cut| cut.start);
        // A side as long as a wave of the step from it.
        let away = LAMBDA_C.si() / 10.0;
        let mm = |at: f64| 1e3 * (start.si() + at);
        let [step, end] = [at, points as f64].map(|at| at * spacing.si());
        let (from, to) = if 2.0 * step > end {
            (mm(0.0), mm(step - away))
        } else {
            (mm(step + away), mm(end))
        };
        format!(
            "{file}: all rows of the scan rise or fall by {height:.3} at {:.2} mm, as where two fields are joined. The step counts as roughness. Set range to {from:.2} mm .. {to:.2} mm to use the longer side",
            mm(step)
        )
    } else {
        format!(
            "{file}: the rows of the scan rise or fall by {height:.3} at once, as where two fields are joined. The step counts as roughness"
        )
    };
    Some(Warning::new(Code::W467, text))
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

/// The scan of pinion or wheel, prepared as its trace was, seen as both flanks face each other.
///
/// A turn about the lead reverses the points of the rows and leaves their order; a mirror image reverses one of both. The wheel faces the
/// pinion: seen from the side of the pinion its points are reversed. Of a flank that is read from its other end the order changes once more.
pub(crate) fn whole(
    body: usize,
    listed: &Listed,
    flank: &Flank,
    keys: &FlankKeys,
    context: Context<'_>,
) -> Result<PreparedSurface, CaseError> {
    let section = Section::new(context.source, "surface");
    let input = &listed.input;
    let missing = || section.conflict("contact", "patch needs a scan of each flank as file");
    let (Some(reading), Some(record)) = (
        flank.report.reading.as_ref(),
        flank.report.preparation.as_ref(),
    ) else {
        return Err(missing());
    };
    let scan = listed.scan.as_ref().ok_or_else(missing)?;
    let (surface, name) = (&scan.surface, scan.surface.name.clone());
    if scan.missing(input.range) > 0.0 && input.gaps == Some(Gaps::Refuse) {
        let rule = "refuse: the scan has points without a height; leave gaps out, and lines between their neighbours are in their place";
        return Err(Section::new(context.source, keys.table).conflict("gaps", rule));
    }
    let (mut z, columns) = (Cow::Borrowed(&*surface.z), surface.columns);
    let rows = z.len().checked_div(columns).unwrap_or(0);
    let (Some(across), true) = (surface.dy, rows > 1) else {
        return Err(missing());
    };
    let along = reading.profile.spacing();
    // The range that is stated.
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
    if mirrored ^ (body == 1) {
        z = Cow::Owned(z.rchunks_exact(columns).flatten().copied().collect());
    }
    let refused = |error| CaseError::preparation(&name, error);
    let prepared = prepare_surface(&z, columns, [along, across], &record.recipe);
    prepared.map_err(refused)
}
