//! Rows of bars with names at the left and values at the right: bars from zero, and intervals about a middle.

use super::axis::{Axis, Range};
use super::canvas::{Anchor, Canvas, LINE};
use super::dress::Dress;
use super::frame::{RIGHT, TICK_BELOW, WIDTH, document, right_end};
use super::text_width::{NAME, TICK, name_lines, widest, width};
use super::xy::COLOURS;

/// Bar.
#[derive(Debug, Clone, PartialEq)]
pub struct Bar {
    /// Name.
    pub name: String,
    /// Length, to the left of zero if negative; `None` without a value.
    pub value: Option<f64>,
    /// Ends of the whisker.
    pub spread: Option<[f64; 2]>,
    /// Formatted value.
    pub text: String,
}

/// Chart of bars from zero. Neighbours of one name are a group: the name is printed once, and each bar has its own colour.
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

/// Interval of a tornado chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Interval {
    /// Name.
    pub name: String,
    /// Ends.
    pub ends: [f64; 2],
    /// Value within the ends that is marked; `None` if all have the common middle.
    pub middle: Option<f64>,
    /// Formatted ends.
    pub text: String,
}

/// Tornado chart: intervals about a common middle.
#[derive(Debug, Clone, PartialEq)]
pub struct Tornado {
    /// Identifier for links.
    pub id: String,
    /// Title of the drawing.
    pub title: String,
    /// Name of its data file.
    pub source: String,
    /// Axis along the intervals.
    pub axis: Axis,
    /// The common middle; `None` if each interval has another one.
    pub middle: Option<f64>,
    /// The intervals.
    pub intervals: Vec<Interval>,
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

/// Row of a chart: a bar between two values, a whisker, and a text at its right.
struct BarRow<'a> {
    name: &'a str,
    /// Number in its group.
    in_group: usize,
    bar: Option<[f64; 2]>,
    whisker: Option<[f64; 2]>,
    /// Value that is marked in the bar.
    mark: Option<f64>,
    text: &'a str,
}

impl BarRow<'_> {
    /// Largest value of the row.
    fn end(&self) -> Option<f64> {
        let values = self.bar.iter().chain(&self.whisker).flatten();
        values.copied().reduce(f64::max)
    }
}

impl BarChart {
    /// CSS class of its drawing.
    pub(super) const KIND: &str = "bar-chart";

    fn rows(&self) -> Vec<BarRow<'_>> {
        let row = |k: usize| {
            let Bar {
                name,
                value,
                spread,
                text,
            } = &self.bars[k];
            let before = self.bars[..k].iter().rev();
            let in_group = before.take_while(|other| other.name == *name).count();
            BarRow {
                name: if in_group == 0 { name } else { "" },
                in_group,
                bar: value.map(|value| [value.min(0.0), value.max(0.0)]),
                whisker: spread.filter(|_| value.is_some()),
                mark: None,
                text,
            }
        };
        (0..self.bars.len()).map(row).collect()
    }

    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        let axis = self.axis.clone().from_zero();
        drawn(
            dress,
            [Self::KIND, &self.title],
            &axis,
            Some(0.0),
            &self.rows(),
        )
    }
}

impl Tornado {
    /// CSS class of its drawing.
    pub(super) const KIND: &str = "tornado-chart";

    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        let row = |interval| {
            let Interval {
                name,
                ends,
                middle,
                text,
            }: &Interval = interval;
            BarRow {
                name,
                in_group: 0,
                bar: Some(*ends),
                whisker: None,
                mark: *middle,
                text,
            }
        };
        let rows: Vec<BarRow<'_>> = self.intervals.iter().map(row).collect();
        let kind = [Self::KIND, self.title.as_str()];
        drawn(dress, kind, &self.axis, self.middle, &rows)
    }
}

/// Range of all values of `rows` and the `middle`.
fn range(axis: &Axis, middle: Option<f64>, rows: &[BarRow<'_>]) -> Range {
    let values = rows
        .iter()
        .flat_map(|row| row.bar.iter().chain(&row.whisker));
    axis.range(values.flatten().copied().chain(middle))
}

fn drawn(
    dress: Dress,
    [kind, title]: [&str; 2],
    axis: &Axis,
    middle: Option<f64>,
    rows: &[BarRow<'_>],
) -> String {
    const THICK: f64 = 17.0;
    const APART: f64 = 9.0;
    const IN_GROUP: f64 = 2.0;
    let names: Vec<Vec<String>> = rows.iter().map(|row| lines(row.name)).collect();
    let left = room(names.iter());
    let is_followed = |k: usize| rows.get(k + 1).is_some_and(|next| next.in_group > 0);
    let high = |(k, lines): (usize, &Vec<String>)| {
        let apart = if is_followed(k) { IN_GROUP } else { APART };
        (LINE * lines.len() as f64).max(THICK + apart)
    };
    let top = if dress == Dress::Alone { 36.0 } else { 10.0 };
    let bottom = top + names.iter().enumerate().map(high).sum::<f64>() + 4.0;
    let height = bottom + 50.0;
    let range = range(axis, middle, rows);
    let right = right_of(rows, left, &range);
    let px = |value: f64| left + range.share(value) * (right - left);
    let mut canvas = Canvas::default();
    for (value, label) in ticks(&range, right - left) {
        canvas.line("grid", [px(value), top], [px(value), bottom]);
        canvas.label(
            "tick",
            [px(value), bottom + TICK_BELOW],
            Anchor::Middle,
            &label,
        );
    }
    let mut begin = top + 2.0;
    for (k, (row, lines)) in rows.iter().zip(&names).enumerate() {
        let high = high((k, lines));
        let at = begin + 0.5 * high;
        begin += high;
        let y = at - 0.5 * THICK;
        let above = 0.5 * LINE * (lines.len() - 1) as f64;
        for (number, line) in lines.iter().enumerate() {
            let base = at + 4.0 - above + LINE * number as f64;
            canvas.label("name", [left - GAP, base], Anchor::End, line);
        }
        if let Some([low, high]) = row.bar {
            let class = match row.in_group {
                0 => "bar".to_owned(),
                k => format!("bar c{}", k % COLOURS),
            };
            canvas.rect(&class, [px(low), y], [px(high) - px(low), THICK]);
        }
        if let Some(mark) = row.mark {
            canvas.line("axis", [px(mark), y - 3.0], [px(mark), y + THICK + 3.0]);
        }
        if let Some(ends) = row.whisker {
            whisker(&mut canvas, ends.map(px), [y + 4.0, y + THICK - 4.0]);
        }
        let end = row.end().map_or(left, px);
        canvas.label("name", [end + GAP, at + 4.0], Anchor::Start, row.text);
    }
    if let Some(middle) = middle {
        canvas.line("axis", [px(middle), top], [px(middle), bottom]);
    }
    let below = [0.5 * (left + right), height - 8.0];
    canvas.label("name", below, Anchor::Middle, &axis.text());
    document(dress, kind, title, height, &canvas.into_text())
}

/// The ticks of an axis of this length: as many as their labels leave room for.
fn ticks(range: &Range, length: f64) -> Vec<(f64, String)> {
    let fit = |ticks: &Vec<(f64, String)>| {
        let mut pairs = ticks.iter().zip(ticks.iter().skip(1));
        pairs.all(|(before, after)| {
            let apart = length * (range.share(after.0) - range.share(before.0));
            apart > GAP + 0.5 * (width(&before.1, TICK) + width(&after.1, TICK))
        })
    };
    let mut all = (1..=TICKS).rev().map(|count| range.ticks(count));
    all.find(fit).unwrap_or_default()
}

/// Right end of the axis, such that the text of every row and the label of every tick fit.
fn right_of(rows: &[BarRow<'_>], left: f64, range: &Range) -> f64 {
    const LEAST: f64 = 60.0;
    let room = |row: &BarRow<'_>| {
        let free = WIDTH - EDGE - left - GAP - width(row.text, NAME);
        Some(left + free / range.share(row.end()?).max(f64::EPSILON))
    };
    let ends = rows.iter().filter_map(room);
    let ticks = range.ticks(TICKS);
    let labels = ticks
        .iter()
        .map(|(at, label)| (range.share(*at), label.as_str()));
    let right = right_end(left, ends.fold(WIDTH - RIGHT, f64::min), WIDTH, labels);
    right.max(left + LEAST)
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
        let right = right_of(&chart.rows(), 110.0, &range);
        let end = 110.0 + 0.9 * (right - 110.0);
        assert!(end + GAP + width("9 W, outside its range", NAME) <= WIDTH);
        assert!(right > 110.0 + 60.0);
    }

    #[test]
    fn bars_of_one_name_are_a_group_with_one_name_and_a_colour_for_each() {
        let bar = |name: &str, value: f64| Bar {
            name: name.to_owned(),
            value: Some(value),
            spread: None,
            text: format!("{value} W"),
        };
        let chart = BarChart {
            id: "pairs".to_owned(),
            title: "Pairs".to_owned(),
            source: "pairs.csv".to_owned(),
            axis: Axis::new("loss", "W"),
            bars: vec![bar("film", 4.0), bar("film", 3.0), bar("rolling", 2.0)],
        };
        let svg = chart.svg(Dress::Page);
        assert_eq!(svg.matches(">film</text>").count(), 1);
        assert_eq!(svg.matches("class=\"bar\"").count(), 2);
        assert_eq!(svg.matches("class=\"bar c1\"").count(), 1);
    }

    #[test]
    fn a_negative_bar_ends_left_of_zero_and_intervals_need_no_zero() {
        let bar = |value: f64| Bar {
            name: format!("{value}"),
            value: Some(value),
            spread: None,
            text: format!("{value} W"),
        };
        let chart = BarChart {
            id: "signs".to_owned(),
            title: "Signs".to_owned(),
            source: "signs.csv".to_owned(),
            axis: Axis::new("difference", "W"),
            bars: vec![bar(-4.0), bar(8.0)],
        };
        let number = |text: &str| -> f64 { text.split('"').next().unwrap().parse().unwrap() };
        let bars = |svg: &str| -> Vec<[f64; 2]> {
            let rects = svg.split("class=\"bar\" x=\"").skip(1);
            let ends = rects.map(|rect| {
                let wide = number(rect.split("width=\"").nth(1).unwrap());
                [number(rect), number(rect) + wide]
            });
            ends.collect()
        };
        let [negative, positive] = bars(&chart.svg(Dress::Page))[..] else {
            panic!("two bars")
        };
        assert!((negative[1] - positive[0]).abs() < 0.11);
        assert!((positive[1] - positive[0]) / (negative[1] - negative[0]) > 1.98);
        let tornado = Tornado {
            id: "tornado".to_owned(),
            title: "Tornado".to_owned(),
            source: "result.json".to_owned(),
            axis: Axis::new("loss", "W"),
            middle: Some(660.0),
            intervals: vec![Interval {
                name: "all".to_owned(),
                ends: [520.0, 870.0],
                middle: Some(640.0),
                text: "520..870 W".to_owned(),
            }],
        };
        let svg = tornado.svg(Dress::Page);
        let [[low, high]] = bars(&svg)[..] else {
            panic!("one interval")
        };
        assert!(high - low > 200.0 && !svg.contains(">0</text>"), "{svg}");
        let mark = number(svg.split("class=\"axis\" x1=\"").nth(1).unwrap());
        assert!(low < mark && mark < high, "{low} {mark} {high}");
    }
}
