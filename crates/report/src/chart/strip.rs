//! A strip along the path of contact: which share of the load the film carries, and the regime.

use super::axis::{Axis, Range, Scale};
use super::canvas::{Anchor, Canvas};
use super::dress::Dress;
use super::frame::{WIDTH, document};
use super::xy::Mark;

/// Shares along the path of contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// Name for links.
    pub id: String,
    /// Title of the drawing.
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

const LEFT: f64 = 110.0;
const RIGHT: f64 = WIDTH - 18.0;
const THICK: f64 = 30.0;
const GAP: f64 = 12.0;

fn place(range: &Range, value: f64) -> f64 {
    LEFT + range.share(value) * (RIGHT - LEFT)
}

impl Strip {
    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        let top = if dress == Dress::Alone { 54.0 } else { 24.0 };
        let range = self.range();
        let bottom = top + 2.0 * THICK + GAP;
        let mut canvas = Canvas::default();
        self.row(&mut canvas, &range, top, "mixed", &self.mixed);
        self.row(&mut canvas, &range, top + THICK + GAP, "film", &self.film);
        for (y, upper, lower) in [
            (top, "full film", "mixed"),
            (top + THICK + GAP, "on asperities", "load on film"),
        ] {
            canvas.label("letter", [LEFT - 8.0, y + 12.0], Anchor::End, upper);
            canvas.label("letter", [LEFT - 8.0, y + 26.0], Anchor::End, lower);
        }
        for mark in &self.marks {
            let at = place(&range, mark.at);
            canvas.line("mark", [at, top], [at, bottom]);
            canvas.label("letter", [at, top - 6.0], Anchor::Middle, &mark.label);
        }
        for (value, label) in range.ticks(6) {
            let at = [place(&range, value), bottom + 17.0];
            canvas.label("tick", at, Anchor::Middle, &label);
        }
        let height = bottom + 46.0;
        let below = [0.5 * (LEFT + RIGHT), height - 8.0];
        canvas.label("name", below, Anchor::Middle, &self.axis.text());
        document(dress, &self.title, height, &canvas.into_text())
    }

    fn range(&self) -> Range {
        let places = self.at.iter().chain(self.marks.iter().map(|mark| &mark.at));
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
            (a.min(*v), b.max(*v))
        });
        Range {
            low,
            high,
            scale: Scale::Linear,
        }
    }

    /// Shares from half way to the position before to half way to the next.
    fn row(&self, canvas: &mut Canvas, range: &Range, y: f64, class: &str, shares: &[f64]) {
        // A hair of overlap, so that no gap shows between neighbours.
        const OVERLAP: f64 = 0.3;
        canvas.rect("rest", [LEFT, y], [RIGHT - LEFT, THICK]);
        let between = |k: usize| 0.5 * (self.at[k - 1] + self.at[k]);
        for (k, share) in shares.iter().enumerate() {
            let before = if k == 0 { range.low } else { between(k) };
            let after = if k + 1 == self.at.len() {
                range.high
            } else {
                between(k + 1)
            };
            let (x, tall) = (place(range, before), THICK * share.clamp(0.0, 1.0));
            let wide = place(range, after) - x + OVERLAP;
            canvas.rect(class, [x, y + THICK - tall], [wide, tall]);
        }
    }
}
