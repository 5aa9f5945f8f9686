//! A strip along the path of contact: which share of the load the film carries, and the regime.

use super::axis::{Axis, Range, Scale};
use super::canvas::{Anchor, Canvas};
use super::frame::{WIDTH, document};
use super::{Dress, Mark};

/// Shares along the path of contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// Name for links.
    pub id: String,
    /// What it shows.
    pub title: String,
    /// The table it was drawn from.
    pub source: String,
    /// The axis along the path.
    pub axis: Axis,
    /// Places of the positions.
    pub at: Vec<f64>,
    /// Share of the offsets in mixed lubrication at each, 0 to 1.
    pub mixed: Vec<f64>,
    /// Share of the load that the film carries at each, 0 to 1.
    pub film: Vec<f64>,
    /// The points A to E.
    pub marks: Vec<Mark>,
}

impl Strip {
    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        const LEFT: f64 = 110.0;
        const RIGHT: f64 = WIDTH - 18.0;
        const THICK: f64 = 30.0;
        const GAP: f64 = 12.0;
        let top = if dress == Dress::Alone { 54.0 } else { 24.0 };
        let places = self.at.iter().chain(self.marks.iter().map(|mark| &mark.at));
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
            (a.min(*v), b.max(*v))
        });
        let range = Range {
            low,
            high,
            scale: Scale::Linear,
        };
        let place = |value: f64| LEFT + range.share(value) * (RIGHT - LEFT);
        let bottom = top + 2.0 * THICK + GAP;
        let mut canvas = Canvas::default();
        for (row, (lower, upper, shares)) in [
            ("mixed", "full film", &self.mixed),
            ("load on film", "on asperities", &self.film),
        ]
        .into_iter()
        .enumerate()
        {
            let y = top + row as f64 * (THICK + GAP);
            canvas.rect("rest", [LEFT, y], [RIGHT - LEFT, THICK]);
            for (k, share) in shares.iter().enumerate() {
                let before = if k == 0 {
                    low
                } else {
                    0.5 * (self.at[k - 1] + self.at[k])
                };
                let after = if k + 1 == self.at.len() {
                    high
                } else {
                    0.5 * (self.at[k] + self.at[k + 1])
                };
                let (x, tall) = (place(before), THICK * share.clamp(0.0, 1.0));
                // A hair of overlap, so that no gap shows between neighbours.
                let class = if row == 0 { "mixed" } else { "film" };
                canvas.rect(class, [x, y + THICK - tall], [place(after) - x + 0.3, tall]);
            }
            canvas.label("letter", [LEFT - 8.0, y + 12.0], Anchor::End, upper);
            canvas.label("letter", [LEFT - 8.0, y + 26.0], Anchor::End, lower);
        }
        for mark in &self.marks {
            let at = place(mark.at);
            canvas.line("mark", [at, top], [at, bottom]);
            canvas.label("letter", [at, top - 6.0], Anchor::Middle, &mark.label);
        }
        for (value, label) in range.ticks(6) {
            canvas.label(
                "tick",
                [place(value), bottom + 17.0],
                Anchor::Middle,
                &label,
            );
        }
        let height = bottom + 46.0;
        canvas.label(
            "name",
            [0.5 * (LEFT + RIGHT), height - 8.0],
            Anchor::Middle,
            &self.axis.text(),
        );
        document(dress, &self.title, height, &canvas.into_text())
    }
}
