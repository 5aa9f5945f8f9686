//! The comparison of patches of scans with their rows, in the report of a study.

use asperity::result::ScanComparison;

use crate::Report;
use crate::scans::{NOTE, drawings, gaps, losses, verdict};

/// Adds the comparison to a report.
pub fn with_scans<'a>(report: Report<'a>, scans: &'a ScanComparison) -> Report<'a> {
    report
        .heading("Patches of the scans against their rows")
        .text([verdict(scans)])
        .table(losses(scans))
        .figures(|| drawings(scans))
        .table(gaps(scans))
        .in_folder()
        .method([NOTE])
}
