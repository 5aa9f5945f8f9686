//! Use of the scans of a case, and the same case with less of them.

use asperity_case::case::{ContactName, LoadedCase};
use asperity_case::error::Error;

/// Use of the scans of a case, and the same case with less of them.
#[derive(Debug)]
#[non_exhaustive]
pub struct ScanUse {
    /// Their use, in words.
    pub taken: String,
    /// Their use in the other case.
    pub other: &'static str,
    /// Patches in place of which rows are taken, or rows in place of which only the middle one is.
    pub are_patches: bool,
    /// The other case.
    pub case: Result<LoadedCase, Error>,
}

/// The case with rows of its scans where patches are in contact, and with their middle rows where rows are taken; `None` without
/// scans of several rows.
#[must_use]
pub fn less_of_scans(loaded: &LoadedCase) -> Option<ScanUse> {
    if loaded.surfaces.sheets().is_some() {
        return Some(ScanUse {
            taken: "patches of the scans".to_owned(),
            other: "rows of the scans",
            are_patches: true,
            case: loaded.with(|input| input.surface.contact = Some(ContactName::Lines)),
        });
    }
    let sampled = loaded.sampled.as_ref()?;
    let middle = |body: usize| {
        let traces = &sampled.traces[body];
        let is_scan = traces.len() > 1 && traces.iter().all(|trace| trace.row.is_some());
        traces.get(traces.len() / 2)?.row.filter(|_| is_scan)
    };
    let rows = [0, 1].map(middle);
    if rows.iter().all(Option::is_none) {
        return None;
    }
    let case = loaded.with(|input| {
        let surface = &mut input.surface;
        let flanks = [Some(&mut surface.pinion), surface.wheel.as_mut()];
        for (flank, row) in flanks.into_iter().zip(rows) {
            if let (Some(flank), Some(row)) = (flank, row) {
                (flank.rows, flank.row) = (None, Some(row.number));
            }
        }
    });
    let [pinion, wheel] = sampled.traces.each_ref().map(Vec::len);
    Some(ScanUse {
        taken: format!("{pinion} × {wheel} rows of the scans"),
        other: "their middle rows alone",
        are_patches: false,
        case,
    })
}
