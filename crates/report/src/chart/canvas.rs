//! Construction of SVG text.

use std::fmt::Write as _;

/// Text escaped for elements and attributes.
pub(crate) fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            other => safe.push(other),
        }
    }
    safe
}

/// Line spacing of horizontal text.
pub(super) const LINE: f64 = 18.0;
/// Line spacing of vertical text.
pub(super) const UPRIGHT_LINE: f64 = 23.5;

/// Drawing under construction. Writing into a string cannot fail.
#[derive(Debug, Default)]
pub(super) struct Canvas {
    text: String,
}

/// Anchor of a text.
#[derive(Debug, Clone, Copy)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl Canvas {
    /// Appends markup without escaping.
    pub fn raw(&mut self, markup: &str) {
        self.text.push_str(markup);
    }

    pub fn open(&mut self, class: &str) {
        let _ = write!(self.text, "<g class=\"{class}\">");
    }

    pub fn close(&mut self) {
        self.text.push_str("</g>");
    }

    pub fn line(&mut self, class: &str, from: [f64; 2], to: [f64; 2]) {
        let ([x1, y1], [x2, y2]) = (from, to);
        let _ = write!(
            self.text,
            "<line class=\"{class}\" x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\"/>"
        );
    }

    pub fn rect(&mut self, class: &str, corner: [f64; 2], size: [f64; 2]) {
        let ([x, y], [w, h]) = (corner, size);
        let _ = write!(
            self.text,
            "<rect class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\" width=\"{w:.1}\" height=\"{h:.1}\"/>"
        );
    }

    pub fn label(&mut self, class: &str, at: [f64; 2], anchor: Anchor, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let [x, y] = at;
        let _ = write!(
            self.text,
            "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{}</text>",
            escaped(text)
        );
    }

    /// Draws vertical text in lines, centred at `at`, with the base line of the last line there.
    pub(crate) fn upright(&mut self, class: &str, [x, y]: [f64; 2], lines: &[String]) {
        for (above, line) in lines.iter().rev().enumerate() {
            let x = x - UPRIGHT_LINE * above as f64;
            let _ = write!(
                self.text,
                "<text class=\"{class}\" transform=\"translate({x:.1} {y:.1}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
                escaped(line)
            );
        }
    }

    pub fn path(&mut self, class: &str, d: &str) {
        let _ = write!(self.text, "<path class=\"{class}\" d=\"{d}\"/>");
    }

    pub(crate) fn into_text(self) -> String {
        self.text
    }
}
