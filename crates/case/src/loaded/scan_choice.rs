//! Whether scans of flanks are taken by their rows, and by how many, or as patches.

use std::borrow::Cow;

use asperity_core::Code;
use asperity_core::message::Warning;
use asperity_ehl_regime::Lay;
use asperity_flanks::meeting::spacing_of;
use asperity_flanks::scan::rows_needed;
use asperity_flanks::sheets::{LEAST_ROWS, rows_of_patches};
use asperity_flanks::surfaces::Texture;
use asperity_profile_io::read::Gaps;

use super::flank_trace::{Context, KnownTrace};
use super::lay::{Lays, median_lay};
use super::named_traces::NamedTraces;
use super::sheets::{bridged, stepped, whole};
use crate::input::contact_name::ContactName;
use crate::source::case_error::CaseError;
use crate::source::defaults::DefaultUsed;

/// The flanks with the rows of scans that are computed.
pub(crate) struct Taken {
    pub known: [Vec<KnownTrace>; 2],
    /// Whether the flank is a scan of which the case names no line.
    pub is_scan: [bool; 2],
    /// Whether patches are in contact.
    pub is_patch: bool,
}

/// Reads the flanks by `known_of`; of a scan without a line the rows, as traces or as a surface, follow from its lay.
pub(crate) fn taken(
    named: &mut NamedTraces,
    context: Context<'_>,
    known_of: impl Fn(&NamedTraces, usize, &mut Vec<Warning>) -> Result<Vec<KnownTrace>, CaseError>,
    warnings: &mut Vec<Warning>,
) -> Result<Taken, CaseError> {
    let mut known: [Vec<KnownTrace>; 2] = Default::default();
    let mut is_scan = [false; 2];
    let mut doubts: [Vec<Warning>; 2] = Default::default();
    for (body, known) in known.iter_mut().enumerate() {
        let found = known_of(named, body, &mut doubts[body]);
        if found
            .as_ref()
            .is_err_and(|error| error.code() == Code::E119)
        {
            is_scan[body] = named.take_middle_row(body, context)?;
        }
        *known = if is_scan[body] {
            known_of(named, body, &mut doubts[body])?
        } else {
            found?
        };
    }
    let is_patch = takes_patch(context, named, &known, is_scan, warnings);
    let mut is_anew = [false; 2];
    for (body, known) in known.iter().enumerate() {
        if is_scan[body] && !is_patch {
            let rows = scan_of_lines(body, named, known, context, warnings)?;
            if rows > 1 {
                named.take_rows(body, rows, context.source)?;
                is_anew[body] = true;
            }
        }
    }
    if is_anew != [false; 2] && named.pair(context.source, warnings)? {
        is_anew = [true; 2];
    }
    for (body, known) in known.iter_mut().enumerate() {
        if is_anew[body] {
            // The traces known before need not be among these.
            doubts[body].clear();
            *known = known_of(named, body, &mut doubts[body])?;
        }
    }
    warnings.extend(doubts.into_iter().flatten());
    for (list, known) in named.lists.iter().zip(&known) {
        if let (Some(scan), Some((flank, _))) = (&list[0].scan, known.first()) {
            if list[0].input.gaps == Some(Gaps::Interpolate) {
                warnings.extend(bridged(&flank.report, scan.missing(list[0].input.range)));
            }
            warnings.extend(scan.spikes.clone());
        }
    }
    Ok(Taken {
        known,
        is_scan,
        is_patch,
    })
}

impl NamedTraces {
    /// Names the middle row of a flank whose file is a scan, and of which the case names no line; whether it is one.
    fn take_middle_row(&mut self, body: usize, context: Context<'_>) -> Result<bool, CaseError> {
        let keys = &self.keys[body];
        let [alone] = self.lists[body].as_mut_slice() else {
            return Ok(false);
        };
        let scan = match &alone.input.file {
            Some(file) if alone.is_without_line() => context.scan(&alone.input, file, keys)?,
            _ => None,
        };
        let Some(scan) = scan.filter(|scan| scan.apart().is_some()) else {
            return Ok(false);
        };
        alone.input.row = Some(scan.row_of_part(0, 1, alone.input.range));
        // Optical instruments miss some points of nearly every scan.
        alone.input.gaps.get_or_insert(Gaps::Interpolate);
        alone.scan = Some(scan);
        Ok(true)
    }

    /// Contact and rows of scans without a line, where the case leaves them to the lay.
    pub(crate) fn taken_by_lay(
        &self,
        context: Context<'_>,
        is_scan: [bool; 2],
        is_patch: bool,
        lays: &Lays,
    ) -> Vec<DefaultUsed> {
        let default = |key: Cow<'static, str>, value: String, source: &'static str| DefaultUsed {
            key,
            value,
            source: Some(source.into()),
        };
        if is_patch && context.inputs.surface.contact.is_none() {
            let source = match is_scan {
                [true, true] => "both flanks are scans, and the lay of one is above 1/6",
                _ => "a flank is a scan, and the lay of one flank is above 1/6",
            };
            return vec![default(
                "surface.contact".into(),
                "\"patch\"".to_owned(),
                source,
            )];
        }
        let scans = (0..self.stated()).filter(|body| is_scan[*body] && !is_patch);
        let rows = scans.map(|body| {
            let key = format!("{}.rows", self.keys[body].table).into();
            let is_open = |body| is_scan[body] && lays.measured(body).is_none();
            let source = if context.inputs.lay.is_none() && (0..2).any(is_open) { "at most 8, with the sampling error of the whole scan; a scan does not show its lay, assumed 0 to 1/6" } else { "as many as have the sampling error of the whole scan, at most 8" };
            default(key, self.lists[body].len().to_string(), source)
        });
        rows.collect()
    }
}

/// Whether patches are in contact: as stated, or where a flank is a scan, the other a scan or a trace, and the ridges of one run less
/// across the face than those with which the contact of lines is confirmed.
fn takes_patch(
    context: Context<'_>,
    named: &NamedTraces,
    known: &[Vec<KnownTrace>; 2],
    is_scan: [bool; 2],
    warnings: &mut Vec<Warning>,
) -> bool {
    if let Some(stated) = context.inputs.surface.contact {
        return stated == ContactName::Patch;
    }
    let is_traced = |known: &[KnownTrace]| match known {
        [(flank, _)] => matches!(flank.texture, Texture::Trace(_)),
        _ => false,
    };
    if is_scan == [false; 2]
        || !context.inputs.has_patches
        || !known.iter().all(|known| is_traced(known))
    {
        return false;
    }
    let lay_of = |body: usize| {
        let (listed, (flank, _)) = (named.lists[body].first()?, known[body].first()?);
        let stated = context.inputs.lay.map(|lay| lay[body]);
        let known = stated.or_else(|| median_lay(listed, flank, &named.keys[body], context));
        known.or_else(|| (!is_scan[body]).then_some(Lay::ACROSS))
    };
    let [Some(pinion), Some(wheel)] = [0, 1].map(lay_of) else {
        return false;
    };
    if pinion <= Lay::CONFIRMED && wheel <= Lay::CONFIRMED {
        return false;
    }
    let reports = known.iter().flatten().map(|(flank, _)| &flank.report);
    let along = spacing_of(context.inputs.largest_spacing, reports).unwrap_or_default();
    let narrow = named.lists.iter().flatten().find_map(|listed| {
        let scan = listed.scan.as_ref()?;
        let rows = rows_of_patches(scan.surface.rows, scan.apart()?, along).ok()?;
        (rows < LEAST_ROWS).then_some((scan, rows))
    });
    if let Some((scan, rows)) = narrow {
        let text = format!(
            "{} has {rows} rows at the spacing of patches, which need {LEAST_ROWS}: its rows are taken as traces, though a lay above 1/6 needs patches. Scan a wider part of the flank",
            scan.surface.name
        );
        warnings.push(Warning::new(Code::W464, text));
    }
    narrow.is_none()
}

/// Number of the rows of the scan of a flank, known by its middle row, that are computed as traces.
fn scan_of_lines(
    body: usize,
    named: &NamedTraces,
    known: &[KnownTrace],
    context: Context<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<usize, CaseError> {
    let ([listed], [(flank, _)]) = (named.lists[body].as_slice(), known) else {
        return Ok(1);
    };
    let whole = whole(body, listed, flank, &named.keys[body], context)?;
    warnings.extend(stepped(&whole, &flank.report));
    Ok(rows_needed(&whole))
}
