//! Bars from zero, with their values written beside them.

use super::axis::Axis;
use super::canvas::{Anchor, Canvas};
use super::dress::Dress;
use super::frame::{WIDTH, document};

/// A bar.
#[derive(Debug, Clone, PartialEq)]
pub struct Bar {
    /// Its name.
    pub name: String,
    /// Its length; none when there is no value.
    pub value: Option<f64>,
    /// Ends of its whisker.
    pub spread: Option<[f64; 2]>,
    /// The value as text.
    pub text: String,
}

/// Bars from zero.
#[derive(Debug, Clone, PartialEq)]
pub struct BarChart {
    /// Name for links.
    pub id: String,
    /// Title of the drawing.
    pub title: String,
    /// The table it was drawn from.
    pub source: String,
    /// The axis along the bars; always from zero.
    pub axis: Axis,
    /// The bars.
    pub bars: Vec<Bar>,
}

/// Room for names of this many letters left of the bars.
fn room(letters: usize) -> f64 {
    const LEAST: f64 = 150.0;
    const MOST: f64 = 0.5 * WIDTH;
    const LETTER: f64 = 7.0;
    (20.0 + LETTER * letters as f64).clamp(LEAST, MOST)
}

impl BarChart {
    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        const RIGHT: f64 = WIDTH - 130.0;
        const PITCH: f64 = 34.0;
        const THICK: f64 = 20.0;
        let names = self.bars.iter().map(|bar| bar.name.chars().count());
        let left = room(names.max().unwrap_or(0));
        let top = if dress == Dress::Alone { 36.0 } else { 10.0 };
        let bottom = top + PITCH * self.bars.len() as f64 + 4.0;
        let height = bottom + 46.0;
        let ends = self.bars.iter().filter_map(|bar| {
            bar.value
                .map(|value| bar.spread.map_or(value, |[_, high]| value.max(high)))
        });
        let range = self.axis.clone().from_zero().range(ends);
        let place = |value: f64| left + range.share(value) * (RIGHT - left);
        let mut canvas = Canvas::default();
        for (value, label) in range.ticks(5) {
            canvas.line("grid", [place(value), top], [place(value), bottom]);
            canvas.label(
                "tick",
                [place(value), bottom + 17.0],
                Anchor::Middle,
                &label,
            );
        }
        for (index, bar) in self.bars.iter().enumerate() {
            let y = top + 8.0 + PITCH * index as f64;
            let middle = y + 0.5 * THICK;
            canvas.label("name", [left - 8.0, middle + 4.0], Anchor::End, &bar.name);
            let mut end = left;
            if let Some(value) = bar.value {
                end = place(value);
                canvas.rect("bar", [left, y], [(end - left).max(0.0), THICK]);
                if let Some([low, high]) = bar.spread {
                    let ends = [place(low.max(0.0)), place(high)];
                    whisker(&mut canvas, ends, [y + 4.0, y + THICK - 4.0]);
                    end = end.max(ends[1]);
                }
            }
            canvas.label("name", [end + 7.0, middle + 4.0], Anchor::Start, &bar.text);
        }
        canvas.line("axis", [left, top], [left, bottom]);
        let middle = 0.5 * (left + RIGHT);
        canvas.label(
            "name",
            [middle, height - 8.0],
            Anchor::Middle,
            &self.axis.text(),
        );
        document(dress, &self.title, height, &canvas.into_text())
    }
}

/// A line with a stroke across each end.
fn whisker(canvas: &mut Canvas, ends: [f64; 2], [top, bottom]: [f64; 2]) {
    let middle = 0.5 * (top + bottom);
    canvas.line("whisker", [ends[0], middle], [ends[1], middle]);
    for x in ends {
        canvas.line("whisker", [x, top], [x, bottom]);
    }
}
