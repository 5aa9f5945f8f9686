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

/// Width of a letter as narrow pages draw it, where letters are largest against the drawing.
const LETTER: f64 = 9.4;

fn width_of(text: &str) -> f64 {
    LETTER * text.chars().count() as f64
}

/// A name in one line, or in two where it is long: before its brackets, else of about equal length.
fn lines(name: &str) -> Vec<&str> {
    const LONG: usize = 22;
    let blanks = name.match_indices(' ').map(|(at, _)| at);
    let nearest = blanks.min_by_key(|at| name.len().abs_diff(2 * at));
    match name.find(" (").or(nearest) {
        Some(at) if name.chars().count() > LONG => vec![&name[..at], &name[at + 1..]],
        _ => vec![name],
    }
}

/// Room for the names left of the bars.
fn room<'a>(names: impl Iterator<Item = &'a str>) -> f64 {
    const LEAST: f64 = 110.0;
    const MOST: f64 = 0.5 * WIDTH;
    let longest = names.flat_map(lines).map(width_of).fold(0.0, f64::max);
    (20.0 + longest).clamp(LEAST, MOST)
}

impl BarChart {
    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        const PITCH: f64 = 36.0;
        const THICK: f64 = 20.0;
        /// Half the distance of the lines of a name.
        const HALF_LINE: f64 = 8.0;
        let left = room(self.bars.iter().map(|bar| bar.name.as_str()));
        let top = if dress == Dress::Alone { 36.0 } else { 10.0 };
        let bottom = top + PITCH * self.bars.len() as f64 + 4.0;
        let height = bottom + 46.0;
        let ends = self.bars.iter().filter_map(|bar| {
            bar.value
                .map(|value| bar.spread.map_or(value, |[_, high]| value.max(high)))
        });
        let range = self.axis.clone().from_zero().range(ends);
        let right = self.right(left, |value| range.share(value));
        let place = |value: f64| left + range.share(value) * (right - left);
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
            let lines = lines(&bar.name);
            let above = HALF_LINE * (lines.len() - 1) as f64;
            for (number, line) in lines.iter().enumerate() {
                let base = middle + 4.0 - above + 2.0 * HALF_LINE * number as f64;
                canvas.label("name", [left - 8.0, base], Anchor::End, line);
            }
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
        let middle = 0.5 * (left + right);
        canvas.label(
            "name",
            [middle, height - 8.0],
            Anchor::Middle,
            &self.axis.text(),
        );
        document(dress, &self.title, height, &canvas.into_text())
    }

    /// Right end of the axis, so that the text beside every bar fits.
    fn right(&self, left: f64, share: impl Fn(f64) -> f64) -> f64 {
        const EDGE: f64 = WIDTH - 10.0;
        const BESIDE: f64 = 7.0;
        const LEAST: f64 = 60.0;
        let room = |bar: &Bar| {
            let end = bar.spread.map_or(0.0, |[_, high]| high).max(bar.value?);
            let free = EDGE - left - BESIDE - width_of(&bar.text);
            Some(left + free / share(end).max(f64::EPSILON))
        };
        let least = self
            .bars
            .iter()
            .filter_map(room)
            .fold(EDGE - 20.0, f64::min);
        least.max(left + LEAST)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_names_stand_in_two_lines() {
        assert_eq!(lines("rolling"), ["rolling"]);
        assert_eq!(
            lines("benedict-kelley (with asperities)"),
            ["benedict-kelley", "(with asperities)"]
        );
        assert_eq!(
            lines("load share by Lambda*, dry asperities"),
            ["load share by Lambda*,", "dry asperities"]
        );
        assert_eq!(
            lines("a-name-without-any-blank-in-it"),
            ["a-name-without-any-blank-in-it"]
        );
    }

    #[test]
    fn the_longest_text_beside_a_bar_fits() {
        let bar = |value: f64, text: &str| Bar {
            name: "law".to_owned(),
            value: Some(value),
            spread: None,
            text: text.to_owned(),
        };
        let chart = BarChart {
            id: "bars".to_owned(),
            title: "Bars".to_owned(),
            source: "bars.csv".to_owned(),
            axis: Axis::new("loss", "W"),
            bars: vec![bar(1.0, "1 W"), bar(9.0, "9 W, outside its range")],
        };
        let right = chart.right(110.0, |value| value / 10.0);
        assert!(110.0 + 0.9 * (right - 110.0) + 7.0 + width_of("9 W, outside its range") <= WIDTH);
        assert!(right > 110.0 + 60.0);
    }
}
