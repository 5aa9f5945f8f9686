//! Use of the scans of a case, and the same case with less of them.

use asperity_case::case::{ContactName, LoadedCase};
use asperity_case::error::Error;
use asperity_profile_io::read::Gaps;

/// Use of the scans of a case, and the same case with less of them.
#[derive(Debug)]
#[non_exhaustive]
pub struct ScanUse {
    /// Their use, in words.
    pub taken: String,
    /// Their use in the other case.
    pub other: &'static str,
    /// Patches instead of which rows are taken, or rows instead of which only the middle one is.
    pub are_patches: bool,
    /// The other case.
    pub case: Result<LoadedCase, Error>,
}

/// Most rows of each of two scans next to patches: the loss of more pairs takes longer than the loss of the patches.
const ROWS_BESIDE: usize = 4;

/// The case with rows of its scans instead of patches.
fn beside_patches(loaded: &LoadedCase) -> Result<LoadedCase, Error> {
    let rows = loaded.with(|input| input.surface.contact = Some(ContactName::Lines))?;
    if rows.surfaces.pairs() <= ROWS_BESIDE * ROWS_BESIDE {
        return Ok(rows);
    }
    rows.with(|input| {
        let (pinion, wheel) = input.surface.loaded_flanks_mut(loaded.case.torque);
        let wheel = wheel.get_or_insert_with(|| pinion.for_wheel());
        for flank in [pinion, wheel] {
            (flank.rows, flank.gaps) = (Some(ROWS_BESIDE), Some(Gaps::Interpolate));
        }
    })
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
            case: beside_patches(loaded),
        });
    }
    let sampled = loaded.sampled.as_ref()?;
    let are_rows = sampled
        .traces
        .each_ref()
        .map(|traces| traces.len() > 1 && traces.iter().all(|trace| trace.row.is_some()));
    if are_rows == [false; 2] {
        return None;
    }
    let case = loaded.with(|input| {
        let (pinion, wheel) = input.surface.loaded_flanks_mut(loaded.case.torque);
        for (flank, are_rows) in [Some(pinion), wheel.as_mut()].into_iter().zip(are_rows) {
            if let Some(flank) = flank.filter(|_| are_rows) {
                // The row in the middle can lack points that the rows taken do not.
                flank.gaps = Some(Gaps::Interpolate);
                (flank.rows, flank.row) = (Some(1), None);
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
