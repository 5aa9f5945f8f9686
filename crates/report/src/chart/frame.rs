//! Frame of a chart: box, grid, ticks, labels, and the mapping from data to units of the drawing.

use super::axis::{Axis, Range};
use super::canvas::{Anchor, Canvas, LINE, UPRIGHT_LINE, escaped};
use super::dress::{Dress, STYLE};
use super::text_width::{ASCENT, DESCENT, NAME, TICK, name_lines, title_lines, widest, width};

/// Width of every chart in units of the drawing; the page scales it.
pub(super) const WIDTH: f64 = 640.0;
/// Approximate number of ticks of the horizontal axis.
pub(super) const TICKS_ACROSS: usize = 6;
/// Approximate number of ticks of the vertical axis.
pub(super) const TICKS_UP: usize = 5;
/// Least margin to the left of the box.
const LEFT: f64 = 66.0;
/// Least margin to the right of the box.
pub(super) const RIGHT: f64 = 18.0;
/// Margin below the box.
const BOTTOM: f64 = 50.0;
/// Margin above the box, for half the height of a tick label.
const TOP: f64 = 15.0;
/// Margin of the drawing.
const EDGE: f64 = 3.0;
const ROW: f64 = 18.0;
/// Distance from the box to the tick labels at its left.
pub(super) const TICK_LEFT: f64 = 6.0;
/// Distance from the box down to the base line of its tick labels.
pub(super) const TICK_BELOW: f64 = 20.0;
/// Distance from the middle of a letter to its base line.
const TICK_BASE: f64 = 4.0;

/// Box and ranges of a chart.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Frame {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
    pub height: f64,
    pub x: Range,
    pub y: Range,
    pub downward: bool,
    /// Name of the vertical axis, broken into lines that fit.
    name: Vec<String>,
}

/// Width of a vertical name in `lines` at the edge of a drawing, and the base line of the line next to the box.
pub(super) fn upright_room(lines: &[String]) -> [f64; 2] {
    let base = EDGE + ASCENT * NAME + UPRIGHT_LINE * (lines.len() - 1) as f64;
    [base + DESCENT * NAME, base]
}

/// Left margin for a vertical name in `lines` and the `ticks` next to it.
pub(super) fn left_margin<'a>(lines: &[String], ticks: impl IntoIterator<Item = &'a str>) -> f64 {
    let [name, _] = upright_room(lines);
    (name + widest(ticks, TICK) + TICK_LEFT).max(LEFT)
}

/// Right end of an axis from `left`, at most `most`, such that its tick labels end before `limit`.
pub(super) fn right_end<'a>(
    left: f64,
    most: f64,
    limit: f64,
    ticks: impl Iterator<Item = (f64, &'a str)>,
) -> f64 {
    let room = ticks
        .filter(|(share, _)| *share > 0.0)
        .map(|(share, label)| {
            let free = limit - EDGE - 0.5 * width(label, TICK) - left;
            left + free / share
        });
    room.fold(most, f64::min)
}

impl Frame {
    /// Makes a frame of `height` with `rows` lines of text above it and a margin of `beside` units at its right, with the
    /// vertical axis `y` and the ranges of both axes.
    pub fn new(
        height: f64,
        rows: usize,
        beside: f64,
        y: &Axis,
        [x_range, y_range]: [Range; 2],
    ) -> Self {
        let top = TOP + ROW * rows as f64;
        let name = name_lines(&y.text(), top + height);
        let up = y_range.ticks(TICKS_UP);
        let left = left_margin(&name, up.iter().map(|(_, label)| label.as_str()));
        let across = x_range.ticks(TICKS_ACROSS);
        let labels = across
            .iter()
            .map(|(value, label)| (x_range.share(*value), label.as_str()));
        let right = right_end(left, WIDTH - RIGHT - beside, WIDTH, labels);
        Self {
            left,
            top,
            right,
            bottom: top + height,
            height: top + height + BOTTOM,
            x: x_range,
            y: y_range,
            downward: y.downward,
            name,
        }
    }

    pub fn px(&self, value: f64) -> f64 {
        self.left + self.x.share(value) * (self.right - self.left)
    }

    pub fn py(&self, value: f64) -> f64 {
        let share = self.y.share(value);
        let up = if self.downward { 1.0 - share } else { share };
        self.bottom - up * (self.bottom - self.top)
    }

    /// Grid, ticks and labels.
    pub fn axes(&self, canvas: &mut Canvas, x: &Axis) {
        canvas.rect(
            "box",
            [self.left, self.top],
            [self.right - self.left, self.bottom - self.top],
        );
        canvas.open("ticks");
        for (value, label) in self.x.ticks(TICKS_ACROSS) {
            let at = self.px(value);
            canvas.line("grid", [at, self.top], [at, self.bottom]);
            let below = [at, self.bottom + TICK_BELOW];
            canvas.label("tick", below, Anchor::Middle, &label);
        }
        for (value, label) in self.y.ticks(TICKS_UP) {
            let at = self.py(value);
            canvas.line("grid", [self.left, at], [self.right, at]);
            let beside = [self.left - TICK_LEFT, at + TICK_BASE];
            canvas.label("tick", beside, Anchor::End, &label);
        }
        canvas.close();
        let middle = 0.5 * (self.left + self.right);
        canvas.label(
            "name",
            [middle, self.height - 8.0],
            Anchor::Middle,
            &x.text(),
        );
        let [_, base] = upright_room(&self.name);
        canvas.upright("name", [base, 0.5 * self.bottom], &self.name);
    }

    /// Data from which the script redraws the same axes.
    pub fn data(&self, x: &Axis, y: &Axis) -> serde_json::Value {
        serde_json::json!({
            "box": [self.left, self.top, self.right, self.bottom],
            "width": WIDTH,
            "ticks": [TICK_LEFT, TICK_BASE, TICK_BELOW],
            "x": {"scale": self.x.scale, "low": self.x.low, "high": self.x.high, "label": x.label, "unit": x.unit,
                "shared": x.is_shared},
            "y": {"scale": self.y.scale, "low": self.y.low, "high": self.y.high, "label": y.label, "unit": y.unit,
                "zero": y.zero, "downward": self.downward},
        })
    }
}

/// Wraps the body of a drawing of `kind` for a page or for a separate file.
pub(super) fn document(dress: Dress, kind: &str, title: &str, height: f64, body: &str) -> String {
    let name = escaped(title);
    match dress {
        Dress::Page => format!(
            "<svg class=\"chart {kind}\" viewBox=\"0 0 {WIDTH} {height:.0}\" role=\"img\" aria-label=\"{name}\">{body}</svg>"
        ),
        Dress::Alone => alone(kind, title, height, body),
    }
}

/// Margin to the left of a title.
const TITLE_LEFT: f64 = 10.0;

/// Lines of a title, and the height of the lines after the first.
fn heading(title: &str) -> (Vec<String>, f64) {
    let lines = title_lines(title, WIDTH - 2.0 * TITLE_LEFT);
    let room = LINE * (lines.len() - 1) as f64;
    (lines, room)
}

/// Height of the lines of a title after the first, in a separate file.
pub(super) fn title_room(title: &str) -> f64 {
    heading(title).1
}

/// A drawing as a separate file. `body` is `height` units high and has space for one line of the title.
pub(super) fn alone(kind: &str, title: &str, height: f64, body: &str) -> String {
    const BASE: f64 = 20.0;
    let name = escaped(title);
    let (lines, down) = heading(title);
    let mut head = Canvas::default();
    for (k, line) in lines.iter().enumerate() {
        let at = [TITLE_LEFT, BASE + LINE * k as f64];
        head.label("title", at, Anchor::Start, line);
    }
    let head = head.into_text();
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart {kind}\" viewBox=\"0 0 {WIDTH} {:.0}\" role=\"img\">\
         <title>{name}</title><style>{STYLE}</style><rect class=\"paper\" width=\"100%\" height=\"100%\"/>\
         {head}<g transform=\"translate(0 {down})\">{body}</g></svg>\n",
        height + down
    )
}
