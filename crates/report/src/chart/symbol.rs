//! Symbol of surface texture as it is drawn on a drawing.

use super::canvas::{Anchor, Canvas};
use super::dress::Dress;
use super::frame::document;
use super::text_width::{NAME, width};

/// Symbol of a surface of which material must be removed, with one requirement below its line and a note below that: the form
/// of ISO 21920-1:2021.
///
/// The requirement is one line, its parts separated by spaces: kind of tolerance (U: upper limit), parameter, limit in µm,
/// acceptance rule, then type and nesting index in mm of the profile S-filter and of the profile L-filter (G: Gaussian). ISO 1302:2002,
/// which it replaces, has the same symbol and writes the transmission band before the parameter. Neither covers a requirement
/// on several traces, so the mean is a note.
///
/// Source of the sequence: ISO 21920-1:2021 in Westermann Verlag (Austria), ISBN 978-3-7100-2443-6, section 12.3.2 (elements a to u); of
/// the legs' heights and angle the same, and of the letter of the filter ISO 1101:2017.
#[derive(Debug, Clone, PartialEq)]
pub struct TextureSymbol {
    /// Identifier for links.
    pub id: String,
    /// Title of the drawing.
    pub title: String,
    /// Name of its data file.
    pub source: String,
    /// The requirement, as "U Rq 0.094 G 0.0025 G 0.25".
    pub requirement: String,
    /// Note below the requirement.
    pub note: String,
}

/// Height of the shorter leg and of the longer one above the vertex.
const LEGS: [f64; 2] = [24.0, 54.0];
/// Horizontal part of a leg of 60° over its height.
const SLOPE: f64 = 0.577_350_269;

impl TextureSymbol {
    /// CSS class of its drawing.
    pub(super) const KIND: &str = "symbol-chart";

    /// The drawing as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        let top = if dress == Dress::Alone { 40.0 } else { 12.0 };
        let [short, long] = LEGS;
        let [x, y] = [30.0, top + long];
        let bend = [x + SLOPE * long, top];
        let [left, right] = [x - SLOPE * short, x + SLOPE * short];
        let mut canvas = Canvas::default();
        canvas.line("stroke", [left, y - short], [x, y]);
        canvas.line("stroke", [x, y], bend);
        canvas.line("stroke", [left, y - short], [right, y - short]);
        let longest = width(&self.requirement, NAME).max(width(&self.note, NAME));
        let text = bend[0] + 8.0;
        canvas.line("stroke", bend, [text + longest + 8.0, top]);
        for (text_line, line) in [&self.requirement, &self.note].into_iter().enumerate() {
            let base = top + 20.0 + 20.0 * text_line as f64;
            canvas.label("name", [text, base], Anchor::Start, line);
        }
        document(dress, Self::KIND, &self.title, y + 8.0, &canvas.into_text())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_requirement_is_below_the_line_right_of_legs_at_60_degrees() {
        let symbol = TextureSymbol {
            id: "symbol".to_owned(),
            title: "Call-out".to_owned(),
            source: "limits.csv".to_owned(),
            requirement: "U Rq 0.094 G 0.0025 G 0.25".to_owned(),
            note: "mean of 17 traces".to_owned(),
        };
        let svg = symbol.svg(Dress::Page);
        assert!(svg.contains(">U Rq 0.094 G 0.0025 G 0.25</text>"), "{svg}");
        let number = |line: &str, key: &str| -> f64 {
            let (_, rest) = line.split_once(&format!("{key}=\"")).unwrap();
            rest.split('"').next().unwrap().parse().unwrap()
        };
        let legs: Vec<f64> = svg
            .split("<line ")
            .skip(1)
            .take(2)
            .map(|line| {
                let across = number(line, "x2") - number(line, "x1");
                let up = number(line, "y2") - number(line, "y1");
                (up / across).atan().to_degrees().abs()
            })
            .collect();
        assert!(
            legs.iter().all(|angle| (angle - 60.0).abs() < 0.3),
            "{legs:?}"
        );
    }
}
