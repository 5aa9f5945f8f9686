//! Curves over an axis.

use std::fmt::Write as _;

use asperity_core::numerics;
use serde_json::{Value, json};

use super::axis::{Axis, Range, Scale};
use super::canvas::{Anchor, Canvas};
use super::dress::Dress;
use super::frame::{Frame, WIDTH, document, title_room};
use super::steps::{in_tenths, step};
use super::text_width::{NAME_ALONE, TICK, width};
use crate::thin::{BINS, thin};

/// Number of bins of the curves for the zoom of the script.
const ZOOM_BINS: usize = 1000;
/// Number of colours of curves.
pub(super) const COLOURS: usize = 6;

/// Line style of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Line {
    /// Solid line.
    Solid,
    /// Dashed line, for references.
    Dashed,
    /// Line with dots.
    Dots,
    /// Only dots.
    Scatter,
    /// Solid line in the colour of text, for a sum.
    Ink,
    /// Filled area.
    Area,
    /// Shaded band about a curve.
    Band,
    /// Shaded band in the colour of the curve with this index.
    BandOf(usize),
    /// Filled area in a colour of a scale about zero: 0 is its middle, 1 to 3 above, -1 to -3 below.
    Level(i8),
}

impl Line {
    fn is_filled(self) -> bool {
        matches!(
            self,
            Self::Area | Self::Band | Self::BandOf(_) | Self::Level(_)
        )
    }
}

/// Curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Line style.
    pub line: Line,
    /// Points in the units of the axes; a point that is not finite breaks the line. For an area, its outline.
    pub points: Vec<[f64; 2]>,
    /// Read-off values of an area, which differ from its outline; empty for other lines.
    pub readings: Vec<[f64; 2]>,
    /// Unit of the readings, which are then printed without a name; empty for that of the axis.
    pub unit: &'static str,
}

impl Series {
    /// Makes a curve through `x` and `y`.
    pub fn new(name: &str, line: Line, x: &[f64], y: &[f64]) -> Self {
        Self::through(name, line, x.iter().zip(y).map(|(x, y)| [*x, *y]))
    }

    /// Makes a curve through `points`.
    pub fn through(name: &str, line: Line, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        Self {
            name: name.to_owned(),
            line,
            points: points.into_iter().collect(),
            readings: Vec::new(),
            unit: "",
        }
    }

    /// Makes the area over `x` between `low` and `high`; its read-off value is their difference.
    pub fn area(name: &str, x: &[f64], low: &[f64], high: &[f64]) -> Self {
        let differences = low.iter().zip(high).map(|(low, high)| high - low);
        Self {
            readings: x
                .iter()
                .copied()
                .zip(differences)
                .map(|(x, y)| [x, y])
                .collect(),
            ..Self::between(name, Line::Area, x, low, high)
        }
    }

    /// Makes the band over `x` between `low` and `high`, without read-off values.
    pub fn band(name: &str, x: &[f64], low: &[f64], high: &[f64]) -> Self {
        Self::between(name, Line::Band, x, low, high)
    }

    /// Makes the band about the curve `index` of several, without read-off values.
    pub fn band_of(index: usize, name: &str, x: &[f64], low: &[f64], high: &[f64]) -> Self {
        Self::between(name, Line::BandOf(index), x, low, high)
    }

    fn between(name: &str, line: Line, x: &[f64], low: &[f64], high: &[f64]) -> Self {
        let forward = x.iter().zip(high);
        let back = x.iter().zip(low).rev();
        Self {
            name: name.to_owned(),
            line,
            points: forward.chain(back).map(|(x, y)| [*x, *y]).collect(),
            readings: Vec::new(),
            unit: "",
        }
    }
}

impl Series {
    /// The points within the limits of the axis `x` and their neighbours, thinned to `bins` bins. The outline of an area
    /// is not thinned.
    fn drawn(&self, x: &Axis, bins: usize) -> Vec<[f64; 2]> {
        if self.line.is_filled() {
            return self.points.clone();
        }
        let coordinate = |point: &[f64; 2]| match x.scale {
            Scale::Linear => point[0],
            Scale::Log => point[0].ln(),
        };
        let is_visible = |k: usize| {
            let point = self.points.get(k);
            point.is_some_and(|point| x.shows(point[0]))
        };
        let near = (0..self.points.len())
            .filter(|&k| is_visible(k) || is_visible(k + 1) || k > 0 && is_visible(k - 1));
        let near: Vec<[f64; 2]> = near.map(|k| self.points[k]).collect();
        thin(&near, bins, coordinate, |point| [point[1]])
    }
}

/// Named position on the horizontal axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Position on the axis.
    pub at: f64,
    /// Name.
    pub label: String,
}

/// Named value on the vertical axis, drawn as a dashed line.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// Position on the axis.
    pub at: f64,
    /// Name.
    pub label: String,
}

/// Chart of curves over an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// Identifier for links.
    pub id: String,
    /// Title of the drawing.
    pub title: String,
    /// Name of its data file.
    pub source: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// The curves.
    pub series: Vec<Series>,
    /// Marked positions on the horizontal axis.
    pub marks: Vec<Mark>,
    /// Marked values on the vertical axis.
    pub levels: Vec<Level>,
    /// Height of the box in units of the drawing.
    pub height: f64,
    /// Width that box and labels use of the drawing; narrower in a panel of a figure.
    pub width: f64,
}

impl Chart {
    /// CSS class of its drawing.
    pub(super) const KIND: &str = "curve-chart";

    /// Makes a chart without curves.
    pub fn new(id: &str, title: &str, source: &str, x: Axis, y: Axis) -> Self {
        /// Height of a box about twice as wide as high.
        const HEIGHT: f64 = 230.0;
        Self {
            id: id.to_owned(),
            title: title.to_owned(),
            source: source.to_owned(),
            x,
            y,
            series: Vec::new(),
            marks: Vec::new(),
            levels: Vec::new(),
            height: HEIGHT,
            width: WIDTH,
        }
    }

    /// Adds a curve.
    pub fn with(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// Adds a curve through `x` and `y`.
    pub fn curve(self, name: &str, line: Line, x: &[f64], y: &[f64]) -> Self {
        self.with(Series::new(name, line, x, y))
    }

    /// Adds marked positions on the horizontal axis.
    pub fn marked(mut self, marks: &[Mark]) -> Self {
        self.marks = marks.to_vec();
        self
    }

    /// Adds a marked value on the vertical axis.
    pub fn level(mut self, at: f64, label: &str) -> Self {
        self.levels.push(Level {
            at,
            label: label.to_owned(),
        });
        self
    }

    fn frame(&self, dress: Dress) -> Frame {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let marks = self.marks.iter().map(|mark| mark.at);
        let mut x = self.x.range(points().map(|p| p[0]).chain(marks));
        let reaches = |series: &Series| series.line != Line::Scatter;
        let is_free = self.x.scale == Scale::Linear && self.x.limits.is_none();
        if is_free && (!self.marks.is_empty() || self.series.iter().all(reaches)) {
            // Curves over the full path from A to E need no margin.
            x = tight(
                x,
                points()
                    .map(|p| p[0])
                    .chain(self.marks.iter().map(|mark| mark.at)),
            );
        }
        let levels = self.levels.iter().map(|level| level.at);
        let inside = points().filter(|p| self.x.shows(p[0]));
        let y = self.y.range(inside.map(|p| p[1]).chain(levels));
        let rows = match dress {
            Dress::Page => 0,
            Dress::Alone => 1 + self.legend_rows().len(),
        } + usize::from(!self.marks.is_empty());
        Frame::new(self.height, rows, WIDTH - self.width, &self.y, [x, y])
    }

    /// Height of the chart in a separate file.
    pub(super) fn height_alone(&self) -> f64 {
        self.frame(Dress::Alone).height + title_room(&self.title)
    }

    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        let frame = self.frame(dress);
        let mut canvas = Canvas::default();
        frame.axes(&mut canvas, &self.x);
        if dress == Dress::Alone {
            self.draw_legend(&mut canvas);
        }
        let clip = format!("clip-{}", self.id);
        // Dots on the frame are drawn whole.
        let radii = self.series.iter().filter_map(|series| radius(series.line));
        let dots = radii.fold(0.0, f64::max);
        canvas.raw(&format!(
            "<clipPath id=\"{clip}\"><rect x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\"/></clipPath>",
            frame.left - dots,
            frame.top - dots,
            frame.right - frame.left + 2.0 * dots,
            frame.bottom - frame.top + 2.0 * dots
        ));
        canvas.raw(&format!("<g class=\"curves\" clip-path=\"url(#{clip})\">"));
        for (index, series) in self.layers() {
            let few = series.drawn(&self.x, BINS);
            canvas.path(
                &class(index, series.line),
                &outline(&frame, series.line, &few),
            );
        }
        canvas.close();
        self.draw_marks(&mut canvas, &frame);
        document(
            dress,
            Self::KIND,
            &self.title,
            frame.height,
            &canvas.into_text(),
        )
    }

    /// The curves with their numbers in the order of drawing: filled ones lie below the lines.
    fn layers(&self) -> Vec<(usize, &Series)> {
        let mut layers: Vec<(usize, &Series)> = self.series.iter().enumerate().collect();
        layers.sort_by_key(|(_, series)| !series.line.is_filled());
        layers
    }

    fn draw_marks(&self, canvas: &mut Canvas, frame: &Frame) {
        canvas.open("marks");
        let mut free = f64::NEG_INFINITY;
        for mark in &self.marks {
            let at = frame.px(mark.at);
            canvas.line("mark", [at, frame.top], [at, frame.bottom]);
            // Letters that would overlap or leave the frame are moved.
            let end = frame.right - 0.5 * width(&mark.label, TICK);
            let x = at.min(end).max(free);
            canvas.label("letter", [x, frame.top - 5.0], Anchor::Middle, &mark.label);
            free = x + 4.0 + width(&mark.label, TICK);
        }
        for level in &self.levels {
            let at = frame.py(level.at);
            canvas.line("level", [frame.left, at], [frame.right, at]);
            let text = if at - frame.top < 18.0 {
                at + 14.0
            } else {
                at - 5.0
            };
            canvas.label(
                "letter",
                // The position shown first is at the left.
                [frame.right - 6.0, text],
                Anchor::End,
                &level.label,
            );
        }
        canvas.close();
    }

    /// Names of the curves with their CSS classes.
    pub fn legend(&self) -> Vec<(String, String)> {
        let named = self.series.iter().enumerate();
        named
            .map(|(index, series)| (series.name.clone(), class(index, series.line)))
            .collect()
    }

    /// The legend, broken into lines that fit.
    fn legend_rows(&self) -> Vec<Vec<(f64, String, String)>> {
        /// Width of the sample line with its gaps.
        const SAMPLE: f64 = 46.0;
        let mut rows: Vec<Vec<(f64, String, String)>> = Vec::new();
        let mut at = f64::INFINITY;
        // A single curve is named by the title, as in a page.
        let named = self.legend().into_iter();
        for (name, class) in named.filter(|_| self.series.len() > 1) {
            let width = SAMPLE + width(&name, NAME_ALONE);
            if at + width > WIDTH {
                rows.push(Vec::new());
                at = 10.0;
            }
            if let Some(row) = rows.last_mut() {
                row.push((at, name, class));
            }
            at += width;
        }
        rows
    }

    fn draw_legend(&self, canvas: &mut Canvas) {
        for (row, entries) in self.legend_rows().iter().enumerate() {
            let y = 40.0 + 18.0 * row as f64;
            for (x, name, class) in entries {
                let sample = if class.ends_with("scatter") {
                    format!(
                        "M{:.1} {:.1}a4 4 0 1 0 8 0a4 4 0 1 0 -8 0",
                        x + 8.0,
                        y - 4.0
                    )
                } else {
                    format!("M{x:.1} {:.1}h24", y - 4.0)
                };
                canvas.path(class, &sample);
                canvas.label("name", [x + 30.0, y], Anchor::Start, name);
            }
        }
    }

    /// Data for zoom and read-off by the script.
    pub fn data(&self) -> Value {
        let frame = self.frame(Dress::Page);
        let mut data = frame.data(&self.x, &self.y);
        let series: Vec<Value> = self
            .layers()
            .into_iter()
            .map(|(_, series)| {
                let flat = |points: &[[f64; 2]]| -> Vec<Value> {
                    points.iter().flatten().map(|v| short(*v)).collect()
                };
                let mut data = json!({"name": series.name, "points": flat(&series.drawn(&self.x, ZOOM_BINS)),
                    "joined": series.line != Line::Scatter,
                    "radius": radius(series.line).unwrap_or(0.0)});
                if series.line.is_filled() {
                    data["filled"] = json!(true);
                    data["told"] = json!(flat(&series.readings));
                    data["unit"] = json!(series.unit);
                }
                data
            })
            .collect();
        data["kind"] = json!("curves");
        data["series"] = json!(series);
        data["marks"] = json!(
            self.marks
                .iter()
                .map(|m| json!([m.at, m.label]))
                .collect::<Vec<_>>()
        );
        data["levels"] = json!(
            self.levels
                .iter()
                .map(|l| json!([l.at, l.label]))
                .collect::<Vec<_>>()
        );
        data
    }
}

/// Range of `values` without margin.
fn tight(range: Range, values: impl Iterator<Item = f64>) -> Range {
    let [low, high] = numerics::range(values.filter(|v| v.is_finite()));
    if low < high {
        Range { low, high, ..range }
    } else {
        range
    }
}

fn class(index: usize, line: Line) -> String {
    let kind = match line {
        Line::Solid => "solid",
        Line::Dashed => "dashed",
        Line::Dots => "dots",
        Line::Scatter => "scatter",
        Line::Ink => return "curve ink".to_owned(),
        Line::Area => return format!("area c{}", index % COLOURS),
        Line::Band => return "area spread".to_owned(),
        Line::BandOf(index) => return format!("area about c{}", index % COLOURS),
        Line::Level(0) => return "area l0".to_owned(),
        Line::Level(level) if level < 0 => return format!("area m{}", -level),
        Line::Level(level) => return format!("area l{level}"),
    };
    format!("curve c{} {kind}", index % COLOURS)
}

/// Radius of the circles at the points of a line.
fn radius(line: Line) -> Option<f64> {
    match line {
        Line::Dots => Some(2.0),
        Line::Scatter => Some(3.5),
        _ => None,
    }
}

/// SVG path of a curve, with a circle at each point of a line with dots.
fn outline(frame: &Frame, line: Line, points: &[[f64; 2]]) -> String {
    let radius = radius(line);
    let (mut d, mut dots) = (String::new(), String::new());
    // The previous point, in tenths of a unit of the drawing.
    let mut before: Option<[i64; 2]> = None;
    for &[x, y] in points {
        let (px, py) = (frame.px(x), frame.py(y));
        if !px.is_finite() || !py.is_finite() {
            before = None;
            continue;
        }
        let at = [px, py].map(in_tenths);
        if line != Line::Scatter {
            step(&mut d, before, at);
        }
        if let Some(r) = radius {
            let (left, wide) = (px - r, 2.0 * r);
            let _ = write!(
                dots,
                "M{left:.1} {py:.1}a{r} {r} 0 1 0 {wide} 0a{r} {r} 0 1 0 -{wide} 0"
            );
        }
        before = Some(at);
    }
    if line.is_filled() && !d.is_empty() {
        d.push('Z');
    }
    d + &dots
}

/// Value with five significant digits; null if it is not finite.
pub(super) fn short(value: f64) -> Value {
    let rounded: f64 = format!("{value:.4e}").parse().unwrap_or(f64::NAN);
    match rounded {
        // Without a point.
        whole if whole.fract() == 0.0 && whole.abs() < 1e9 => json!(whole as i64),
        other if other.is_finite() => json!(other),
        _ => Value::Null,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramp() -> Chart {
        let x = Axis::new("position", "mm");
        let y = Axis::new("load", "N/mm").from_zero();
        Chart::new("ramp", "A ramp & more", "ramp.csv", x, y)
            .curve("load", Line::Solid, &[0.0, 1.0, 2.0], &[1.0, f64::NAN, 3.0])
            .marked(&[Mark {
                at: 0.5,
                label: "C".to_owned(),
            }])
            .level(2.0, "limit")
    }

    #[test]
    fn a_chart_carries_its_units_and_escapes_its_text() {
        let svg = ramp().svg(Dress::Alone);
        assert!(svg.contains("position [mm]") && svg.contains("load [N/mm]"));
        assert!(svg.contains("A ramp &amp; more") && !svg.contains("NaN"));
    }

    #[test]
    fn the_steps_of_a_path_lead_to_the_points() {
        let [x, y] = [
            Axis::new("x", "").within(0.0, 1.0),
            Axis::new("y", "").within(0.0, 1.0),
        ];
        let points = [[0.0, 0.0], [0.31, 0.77], [0.32, 0.13], [1.0, 1.0]];
        let chart = Chart::new("steps", "Steps", "steps.csv", x, y);
        let frame = chart.frame(Dress::Page);
        let d = outline(&frame, Line::Solid, &points).replace('-', " -");
        let mut at = [0.0, 0.0];
        for (part, [x, y]) in d.split(['M', 'l']).skip(1).zip(points) {
            let steps: Vec<f64> = part
                .split_whitespace()
                .map(|step| step.parse().unwrap())
                .collect();
            at = [at[0] + steps[0], at[1] + steps[1]];
            assert!((at[0] - frame.px(x)).abs() < 0.051 && (at[1] - frame.py(y)).abs() < 0.051);
        }
    }

    #[test]
    fn a_missing_value_breaks_the_line() {
        let svg = ramp().svg(Dress::Page);
        let start = svg.find("class=\"curve").unwrap();
        let d = &svg[start..start + svg[start..].find("/>").unwrap()];
        assert_eq!(d.matches('M').count(), 2);
        assert!(ramp().data()["series"][0]["points"][3].is_null());
    }
}
