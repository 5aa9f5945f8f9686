//! Strip along the path of contact: share of the load on the film, and lubrication regime.

use asperity_core::numerics::range;

use super::axis::{Axis, Range, Scale};
use super::canvas::{Anchor, Canvas};
use super::dress::Dress;
use super::frame::{RIGHT, TICK_BELOW, TICKS_ACROSS, WIDTH, document, right_end};
use super::text_width::{TICK, widest};
use super::xy::Mark;

/// Shares along the path of contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// Identifier for links.
    pub id: String,
    /// Title of the drawing.
    pub title: String,
    /// Name of its data file.
    pub source: String,
    /// The axis along the path.
    pub axis: Axis,
    /// Distances of the positions.
    pub at: Vec<f64>,
    /// Share of the offsets in mixed lubrication at each, 0 to 1.
    pub mixed: Vec<f64>,
    /// Share of the load that the film carries at each, 0 to 1.
    pub film: Vec<f64>,
    /// The points A to E.
    pub marks: Vec<Mark>,
}

/// Names of the upper and the lower part of both rows.
const NAMES: [[&str; 2]; 2] = [["full film", "mixed"], ["on asperities", "load on film"]];
const THICK: f64 = 30.0;
const GAP: f64 = 12.0;
/// Distance from the names to the rows.
const GAP_LEFT: f64 = 8.0;

impl Strip {
    /// CSS class of its drawing.
    pub(super) const KIND: &str = "strip-chart";

    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        let left = widest(NAMES.as_flattened().iter().copied(), TICK) + GAP_LEFT + 3.0;
        let top = if dress == Dress::Alone { 54.0 } else { 24.0 };
        let range = self.range();
        let ticks = range.ticks(TICKS_ACROSS);
        let labels = ticks
            .iter()
            .map(|(at, label)| (range.share(*at), label.as_str()));
        let right = right_end(left, WIDTH - RIGHT, WIDTH, labels);
        let px = |value: f64| left + range.share(value) * (right - left);
        let bottom = top + 2.0 * THICK + GAP;
        let mut canvas = Canvas::default();
        for (k, (class, shares)) in [("mixed", &self.mixed), ("film", &self.film)]
            .iter()
            .enumerate()
        {
            let y = top + k as f64 * (THICK + GAP);
            canvas.rect("rest", [left, y], [right - left, THICK]);
            for ([from, to], share) in self.cells(&range).iter().zip(*shares) {
                // A small overlap, so that no gap appears between neighbours.
                const OVERLAP: f64 = 0.3;
                let (x, tall) = (px(*from), THICK * share.clamp(0.0, 1.0));
                let wide = px(*to) - x + OVERLAP;
                canvas.rect(class, [x, y + THICK - tall], [wide, tall]);
            }
            for (name, base) in NAMES[k].iter().zip([11.0, 27.0]) {
                canvas.label("letter", [left - GAP_LEFT, y + base], Anchor::End, name);
            }
        }
        for mark in &self.marks {
            let at = px(mark.at);
            canvas.line("mark", [at, top], [at, bottom]);
            canvas.label("letter", [at, top - 6.0], Anchor::Middle, &mark.label);
        }
        for (value, label) in &ticks {
            let at = [px(*value), bottom + TICK_BELOW];
            canvas.label("tick", at, Anchor::Middle, label);
        }
        let height = bottom + 50.0;
        let below = [0.5 * (left + right), height - 8.0];
        canvas.label("name", below, Anchor::Middle, &self.axis.text());
        let place = [left, right, range.low, range.high, top, bottom];
        let place = place.map(|value| format!("{value:.4}")).join(" ");
        canvas.raw(&format!(
            "<g class=\"overlay\" data-shared=\"{place}\"></g>"
        ));
        document(dress, Self::KIND, &self.title, height, &canvas.into_text())
    }

    fn range(&self) -> Range {
        let distances = self.at.iter().chain(self.marks.iter().map(|mark| &mark.at));
        let [low, high] = range(distances.copied());
        Range {
            low,
            high,
            scale: Scale::Linear,
        }
    }

    /// Ends of the cells of the positions, half way to the neighbouring positions.
    fn cells(&self, range: &Range) -> Vec<[f64; 2]> {
        let between = self.at.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        let ends = [range.low].into_iter().chain(between).chain([range.high]);
        let ends: Vec<f64> = ends.collect();
        ends.windows(2).map(|pair| [pair[0], pair[1]]).collect()
    }
}
