//! Relief derived from the traces, along the path of contact.

use asperity::result::RunResult;

use super::along::{along, points};
use crate::chart::{Axis, Chart, Drawing, Line};
use crate::tables::BODIES;

/// Missing material on each flank, relative to the mean over the active flank; `None` if no relief is derived from a
/// trace.
pub(super) fn along_the_path(result: &RunResult) -> Option<Drawing> {
    let path = &result.gears.path;
    let (start, end) = (1e3 * path.a.si(), 1e3 * path.e.si());
    let mut chart = Chart::new(
        "relief",
        "Relief from the traces: form that separates the teeth",
        "result.json",
        along(),
        Axis::new("material missing, zero in the mean", "µm"),
    )
    .marked(&points(result));
    let mut is_empty = true;
    for (body, flank) in result.flanks.iter().enumerate() {
        let Some(form) = &flank.form else { continue };
        is_empty = false;
        let distance = |roll: &f64| match (body, result.gears.internal) {
            (0, _) => *roll,
            (_, false) => 1e3 * path.t1t2.si() - roll,
            (_, true) => 1e3 * path.t1t2.si() + roll,
        };
        let distances = form.roll_length_mm.iter().map(distance);
        let (s, heights): (Vec<f64>, Vec<f64>) = (distances.zip(form.height_um.iter().copied()))
            .filter(|(s, _)| (start..=end).contains(s))
            .unzip();
        let mean = heights.iter().sum::<f64>() / heights.len().max(1) as f64;
        let missing: Vec<f64> = heights.iter().map(|height| mean - height).collect();
        chart = chart.curve(BODIES[body], Line::Solid, &s, &missing);
    }
    (!is_empty).then_some(Drawing::Curves(chart))
}
