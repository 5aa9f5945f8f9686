//! Load-sharing laws compared with the transient solution, the reference.

use asperity::lubrication::ShareComparison;
use asperity_core::by_size;
use asperity_report::{Cell, Report, columns};

/// `report` with the table of the laws.
pub fn shown<'a>(report: Report<'a>, comparison: &ShareComparison) -> Report<'a> {
    let laws = comparison.laws.iter();
    let laws = laws.map(|law| {
        (
            law.law,
            law.solid_share,
            law.minus_reference,
            law.mean_gap_um,
            law.friction,
        )
    });
    let reference = (
        "reference",
        Some(comparison.reference_share),
        None,
        Some(comparison.reference_mean_film_um),
        comparison.reference_friction,
    );
    let table = columns! { (law, share, off, gap, friction) in std::iter::once(reference).chain(laws);
        head law "law" "" = law;
        number share "solid share" "" "{:.4}" = share;
        number off "off by" "" "{:+.4}" = off;
        number gap "mean gap" "µm" = Cell::number(gap, |um| by_size(um, 4));
        number friction "friction" "" "{:.5}" = friction;
    };
    let heading = format!(
        "laws over {} windows of the same traces; reference, the transient solution: mean of the loads below 20 and 50 nm, \
         friction with heat",
        comparison.windows,
    );
    report.heading(heading).table(table)
}
