//! Axes along the path of contact, with the points A to E, and along the flanks.

use asperity::result::RunResult;

use crate::chart::{Axis, Mark};

/// The table of the path.
pub(super) const SOURCE: &str = "path.csv";

/// The points A to E [mm from T₁].
#[must_use]
pub fn points(result: &RunResult) -> Vec<Mark> {
    let mut points = result.gears.path.named_points().map(|(label, at)| Mark {
        at: 1e3 * at.si(),
        label: label.to_owned(),
    });
    points.sort_by(|a, b| a.at.total_cmp(&b.at));
    points.to_vec()
}

/// The axis along the path.
#[must_use]
pub fn along() -> Axis {
    Axis::new("distance from T₁ along the line of action", "mm").shared()
}

/// The axis of a trace on flank `body` (0 pinion, 1 wheel), which runs as the contact does.
#[must_use]
pub fn on_flank(body: usize, is_mirrored: bool) -> Axis {
    let begin = if is_mirrored { "last" } else { "first" };
    let way = ["root to tip", "tip to root"][body.min(1)];
    Axis::new(&format!("from the {begin} point of the file, {way}"), "mm")
}
