//! Comparison of patches of scans with rows of them.

use asperity_core::cancel::checkpoint;

use super::difference::difference;
use super::mesh_run::MeshRun;
use crate::contacts::Contacts;
use crate::pipeline::{Kept, Options, less_of_scans, over_gap, settled};
use crate::result::{GapRow, MeshOutcome, PositionRow, ScanComparison, ScanLoss};
use asperity_case::case::{LoadedCase, OperatingCase};
use asperity_case::error::Error;
use asperity_uncertainty::Predictive;

/// Runs a case without pictures, with draws if they are requested.
type Runs<'a> = &'a dyn Fn(&LoadedCase, bool) -> Result<MeshRun, Error>;

/// Whether the result of a run has the comparison: patches are in contact, and its pictures are requested.
pub(super) fn is_due(loaded: &LoadedCase, kept: &Kept) -> bool {
    !matches!(kept, Kept::Nothing | Kept::NoPictures) && loaded.surfaces.sheets().is_some()
}

/// Adds to the `outcome` of a case with patches the comparison with rows of the scans. Of rows without a result, as of a scan that is
/// too short, it has the reason.
pub(super) fn compare_with_rows(
    outcome: &mut MeshOutcome,
    drawn: Option<&Predictive>,
    loaded: &OperatingCase,
    contacts: &Contacts,
    kept: &Kept,
    run: Runs<'_>,
) -> Result<(), Error> {
    if !is_due(loaded, kept) {
        return Ok(());
    }
    match comparison(outcome, drawn, (loaded, contacts), run) {
        Ok(Some(scans)) => outcome.result.scans = Some(scans),
        Ok(None) => {
            let why = "the load on the asperities does not follow from the contact";
            outcome.result.no_scans = Some(why.to_owned());
        }
        Err(error) => outcome.result.no_scans = Some(error.to_string()),
    }
    // A cancelled run is not one without a result.
    Ok(checkpoint()?)
}

fn comparison(
    outcome: &MeshOutcome,
    drawn: Option<&Predictive>,
    patches: (&OperatingCase, &Contacts),
    run: Runs<'_>,
) -> Result<Option<ScanComparison>, Error> {
    let loaded = patches.0;
    let Some(rows) = less_of_scans(loaded).filter(|scans| scans.are_patches) else {
        return Ok(None);
    };
    let rows = rows.case?;
    let MeshRun {
        outcome: of_rows,
        drawn: drawn_of_rows,
        contacts,
    } = run(&rows, drawn.is_some())?;
    let pressure = |row: &PositionRow| row.p_max_mpa.unwrap_or(row.hertz_pressure_mpa);
    let path = outcome.result.path.iter();
    let highest = path.max_by(|a, b| pressure(a).total_cmp(&pressure(b)));
    let Some(shown) = highest else {
        return Ok(None);
    };
    let Some(patch) = over_gap(patches.0, patches.1, shown.position, None)? else {
        return Ok(None);
    };
    let warm = settled(&rows, &Options::known(&contacts))?;
    let Some(lines) = over_gap(&warm, &contacts, shown.position, Some(&patch.gaps))? else {
        return Ok(None);
    };
    let shares = patch.shares.iter().zip(&lines.shares);
    let flows = patch.flows.iter().zip(&lines.flows);
    let all = patch.gaps.iter().zip(shares.zip(flows));
    let gaps = all.map(
        |(gap, ((share_patch, share_lines), (flow_patch, flow_lines)))| GapRow {
            gap_um: 1e6 * gap.si(),
            share_patch: *share_patch,
            share_lines: *share_lines,
            flow_patch: *flow_patch,
            flow_lines: *flow_lines,
        },
    );
    let [own, other] = [outcome, &of_rows].map(|of| of.result.uncertainty.as_ref());
    let both = drawn.zip(own).zip(drawn_of_rows.as_ref().zip(other));
    Ok(Some(ScanComparison {
        rows: rows.surfaces.several_teeth().unwrap_or([1, 1]),
        patches: ScanLoss::new(outcome, patch.contact),
        lines: ScanLoss::new(&of_rows, lines.contact),
        difference_w: both.map(|((drawn, own), (of_rows, other))| {
            let watts = difference((&rows, of_rows, other), (loaded.loaded(), drawn, own)).watts;
            [watts.value, watts.low, watts.high]
        }),
        position: shown.position,
        gaps: gaps.collect(),
    }))
}
