//! Bars from zero, labelled with their values.

use super::axis::{Axis, Range};
use super::canvas::{Anchor, Canvas, LINE};
use super::dress::Dress;
use super::frame::{RIGHT, TICK_BELOW, WIDTH, document, right_end};
use super::text_width::{NAME, name_lines, widest, width};

/// Bar.
#[derive(Debug, Clone, PartialEq)]
pub struct Bar {
    /// Name.
    pub name: String,
    /// Length; `None` without a value.
    pub value: Option<f64>,
    /// Ends of the whisker.
    pub spread: Option<[f64; 2]>,
    /// Formatted value.
    pub text: String,
}

/// Chart of bars from zero.
#[derive(Debug, Clone, PartialEq)]
pub struct BarChart {
    /// Identifier for links.
    pub id: String,
    /// Title of the drawing.
    pub title: String,
    /// Name of its data file.
    pub source: String,
    /// Axis along the bars, from zero.
    pub axis: Axis,
    /// The bars.
    pub bars: Vec<Bar>,
}

/// Approximate number of ticks.
const TICKS: usize = 5;
/// Distance between names and bars, and between a bar and its text.
const GAP: f64 = 8.0;
/// Margin of the drawing.
const EDGE: f64 = 4.0;
/// Longest line of a name.
const MOST: f64 = 0.5 * WIDTH - GAP - EDGE;

/// A name in few lines of similar length that leave half of the width to the bars.
fn lines(name: &str) -> Vec<String> {
    /// Longest name that is not broken.
    const LONG: f64 = 240.0;
    /// Ratio of the lengths that are tried.
    const LONGER: f64 = 1.05;
    let whole = width(name, NAME);
    let number = (whole / LONG).ceil().max(1.0);
    let mut most = whole / number;
    loop {
        let lines = name_lines(name, most.min(MOST));
        if lines.len() as f64 <= number || most >= MOST {
            return lines;
        }
        most *= LONGER;
    }
}

/// Width of the names left of the bars.
fn room<'a>(names: impl Iterator<Item = &'a Vec<String>>) -> f64 {
    const LEAST: f64 = 110.0;
    let longest = widest(names.flatten().map(String::as_str), NAME);
    (EDGE + longest + GAP).max(LEAST)
}

impl BarChart {
    /// CSS class of its drawing.
    pub(super) const KIND: &str = "bar-chart";

    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        const THICK: f64 = 20.0;
        let names: Vec<Vec<String>> = self.bars.iter().map(|bar| lines(&bar.name)).collect();
        let left = room(names.iter());
        let most = names.iter().map(Vec::len).max().unwrap_or(1);
        let pitch = (LINE * most as f64).max(THICK + 16.0);
        let top = if dress == Dress::Alone { 36.0 } else { 10.0 };
        let bottom = top + pitch * self.bars.len() as f64 + 4.0;
        let height = bottom + 50.0;
        let ends = self.bars.iter().filter_map(|bar| {
            bar.value
                .map(|value| bar.spread.map_or(value, |[_, high]| value.max(high)))
        });
        let range = self.axis.clone().from_zero().range(ends);
        let right = self.right(left, &range);
        let px = |value: f64| left + range.share(value) * (right - left);
        let mut canvas = Canvas::default();
        for (value, label) in range.ticks(TICKS) {
            canvas.line("grid", [px(value), top], [px(value), bottom]);
            canvas.label(
                "tick",
                [px(value), bottom + TICK_BELOW],
                Anchor::Middle,
                &label,
            );
        }
        for (index, (bar, lines)) in self.bars.iter().zip(&names).enumerate() {
            let middle = top + 2.0 + pitch * (index as f64 + 0.5);
            let y = middle - 0.5 * THICK;
            let above = 0.5 * LINE * (lines.len() - 1) as f64;
            for (number, line) in lines.iter().enumerate() {
                let base = middle + 4.0 - above + LINE * number as f64;
                canvas.label("name", [left - GAP, base], Anchor::End, line);
            }
            let mut end = left;
            if let Some(value) = bar.value {
                end = px(value);
                canvas.rect("bar", [left, y], [(end - left).max(0.0), THICK]);
                if let Some([low, high]) = bar.spread {
                    let ends = [px(low.max(0.0)), px(high)];
                    whisker(&mut canvas, ends, [y + 4.0, y + THICK - 4.0]);
                    end = end.max(ends[1]);
                }
            }
            canvas.label("name", [end + GAP, middle + 4.0], Anchor::Start, &bar.text);
        }
        canvas.line("axis", [left, top], [left, bottom]);
        let middle = 0.5 * (left + right);
        canvas.label(
            "name",
            [middle, height - 8.0],
            Anchor::Middle,
            &self.axis.text(),
        );
        document(dress, Self::KIND, &self.title, height, &canvas.into_text())
    }

    /// Right end of the axis, such that the text of every bar and the label of every tick fit.
    fn right(&self, left: f64, range: &Range) -> f64 {
        const LEAST: f64 = 60.0;
        let room = |bar: &Bar| {
            let end = bar.spread.map_or(0.0, |[_, high]| high).max(bar.value?);
            let free = WIDTH - EDGE - left - GAP - width(&bar.text, NAME);
            Some(left + free / range.share(end).max(f64::EPSILON))
        };
        let ends = self.bars.iter().filter_map(room);
        let ticks = range.ticks(TICKS);
        let labels = ticks
            .iter()
            .map(|(at, label)| (range.share(*at), label.as_str()));
        let right = right_end(left, ends.fold(WIDTH - RIGHT, f64::min), WIDTH, labels);
        right.max(left + LEAST)
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
    fn long_names_stand_in_lines_that_leave_room_for_the_bars() {
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
        let long =
            lines("share of the load that is carried by the film, by asperities and by the layer");
        assert!(long.len() > 2 && widest(long.iter().map(String::as_str), NAME) <= MOST);
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
        let range = chart
            .axis
            .clone()
            .within(0.0, 10.0)
            .range(std::iter::empty());
        let right = chart.right(110.0, &range);
        let end = 110.0 + 0.9 * (right - 110.0);
        assert!(end + GAP + width("9 W, outside its range", NAME) <= WIDTH);
        assert!(right > 110.0 + 60.0);
    }
}
