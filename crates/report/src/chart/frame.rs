//! The frame of a chart: its box, grid, ticks, labels, and the data in it as pixels.

use super::axis::{Axis, Range};
use super::canvas::{Anchor, Canvas, escaped};
use super::dress::{Dress, STYLE};

/// Width of every chart in its own units; the page scales it.
pub(super) const WIDTH: f64 = 640.0;
/// Ticks aimed at.
pub(super) const TICKS_ACROSS: usize = 6;
pub(super) const TICKS_UP: usize = 5;
const LEFT: f64 = 66.0;
const BOTTOM: f64 = 46.0;
const RIGHT: f64 = 18.0;
const ROW: f64 = 18.0;

/// Box and ranges of a chart.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
    pub height: f64,
    pub x: Range,
    pub y: Range,
    pub downward: bool,
}

impl Frame {
    /// A frame of `height` with `rows` lines of text above it and `beside` units kept free at its right.
    pub fn new(height: f64, rows: usize, beside: f64, x: Range, y: Range, downward: bool) -> Self {
        let top = 10.0 + ROW * rows as f64;
        Self {
            left: LEFT,
            top,
            right: WIDTH - RIGHT - beside,
            bottom: top + height,
            height: top + height + BOTTOM,
            x,
            y,
            downward,
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
    pub fn axes(&self, canvas: &mut Canvas, x: &Axis, y: &Axis) {
        canvas.rect(
            "box",
            [self.left, self.top],
            [self.right - self.left, self.bottom - self.top],
        );
        canvas.open("ticks");
        for (value, label) in self.x.ticks(TICKS_ACROSS) {
            let at = self.px(value);
            canvas.line("grid", [at, self.top], [at, self.bottom]);
            canvas.label("tick", [at, self.bottom + 17.0], Anchor::Middle, &label);
        }
        for (value, label) in self.y.ticks(TICKS_UP) {
            let at = self.py(value);
            canvas.line("grid", [self.left, at], [self.right, at]);
            canvas.label("tick", [self.left - 6.0, at + 4.0], Anchor::End, &label);
        }
        canvas.close();
        let middle = 0.5 * (self.left + self.right);
        canvas.label(
            "name",
            [middle, self.height - 8.0],
            Anchor::Middle,
            &x.text(),
        );
        canvas.upright("name", [14.0, 0.5 * (self.top + self.bottom)], &y.text());
    }

    /// Data from which the script redraws the same axes.
    pub fn data(&self, x: &Axis, y: &Axis) -> serde_json::Value {
        serde_json::json!({
            "box": [self.left, self.top, self.right, self.bottom],
            "width": WIDTH,
            "x": {"scale": self.x.scale, "low": self.x.low, "high": self.x.high, "label": x.label, "unit": x.unit},
            "y": {"scale": self.y.scale, "low": self.y.low, "high": self.y.high, "label": y.label, "unit": y.unit,
                "zero": y.zero, "downward": self.downward},
        })
    }
}

/// Wraps the body of a drawing.
pub(super) fn document(dress: Dress, title: &str, height: f64, body: &str) -> String {
    let name = escaped(title);
    match dress {
        Dress::Page => format!(
            "<svg class=\"chart\" viewBox=\"0 0 {WIDTH} {height:.0}\" role=\"img\" aria-label=\"{name}\">{body}</svg>"
        ),
        Dress::Alone => format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" viewBox=\"0 0 {WIDTH} {height:.0}\" role=\"img\">\
             <title>{name}</title><style>{STYLE}</style><rect class=\"paper\" width=\"100%\" height=\"100%\"/>\
             <text class=\"title\" x=\"10\" y=\"20\">{name}</text>{body}</svg>\n"
        ),
    }
}
