//! Parts of a whole as a pie chart, with a list of their values.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use super::canvas::{Anchor, Canvas};
use super::dress::Dress;
use super::frame::document;
use super::text_width::{NAME_ALONE, widest};

/// Part of the whole.
#[derive(Debug, Clone, PartialEq)]
pub struct Slice {
    /// Name.
    pub name: String,
    /// Size, zero or more.
    pub value: f64,
    /// Formatted value.
    pub text: String,
}

/// Parts of a whole.
#[derive(Debug, Clone, PartialEq)]
pub struct PieChart {
    /// Identifier for links.
    pub id: String,
    /// Title.
    pub title: String,
    /// Name of its data file.
    pub source: String,
    /// The parts, clockwise from the top; a very small part is a line.
    pub slices: Vec<Slice>,
}

const RADIUS: f64 = 100.0;
const CENTRE: f64 = 150.0;
const LIST: f64 = 300.0;
/// Distance from the edge of the list to its names.
const SAMPLE: f64 = 20.0;
/// Distance from the names to the values.
const GAP: f64 = 16.0;
const ROW: f64 = 30.0;
/// Number of colours.
const COLOURS: usize = 6;

impl PieChart {
    /// CSS class of its drawing.
    pub(super) const KIND: &str = "pie-chart";

    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        let top = if dress == Dress::Alone { 40.0 } else { 14.0 };
        let middle = top + RADIUS;
        let whole: f64 = self.slices.iter().map(|slice| slice.value.max(0.0)).sum();
        let names = widest(
            self.slices.iter().map(|slice| slice.name.as_str()),
            NAME_ALONE,
        );
        let mut canvas = Canvas::default();
        let mut begin = 0.0;
        for (index, slice) in self.slices.iter().enumerate() {
            let share = if whole > 0.0 {
                slice.value.max(0.0) / whole
            } else {
                0.0
            };
            let class = format!("slice c{}", index % COLOURS);
            canvas.path(&class, &sector([CENTRE, middle], begin, share));
            begin += share;
            let y = top + 20.0 + ROW * index as f64;
            canvas.rect(&class, [LIST, y - 10.0], [12.0, 12.0]);
            canvas.label("name", [LIST + SAMPLE, y], Anchor::Start, &slice.name);
            let value = [LIST + SAMPLE + names + GAP, y];
            canvas.label("tick", value, Anchor::Start, &slice.text);
        }
        let height = top + 2.0 * RADIUS + 20.0;
        document(dress, Self::KIND, &self.title, height, &canvas.into_text())
    }
}

/// Sector of the pie from the share `begin`; a full circle consists of two halves.
fn sector([x, y]: [f64; 2], begin: f64, share: f64) -> String {
    let at = |share: f64| {
        let (sin, cos) = (TAU * share).sin_cos();
        (x + RADIUS * sin, y - RADIUS * cos)
    };
    let half = begin + 0.5 * share;
    let mut path = format!("M{x:.1} {y:.1}");
    let (sx, sy) = at(begin);
    // Writing into a string cannot fail.
    let _ = write!(path, "L{sx:.1} {sy:.1}");
    for end in [half, begin + share] {
        let (ex, ey) = at(end);
        let _ = write!(path, "A{RADIUS:.0} {RADIUS:.0} 0 0 1 {ex:.1} {ey:.1}");
    }
    path.push('Z');
    path
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slice(name: &str, value: f64) -> Slice {
        Slice {
            name: name.to_owned(),
            value,
            text: format!("{value} W"),
        }
    }

    #[test]
    fn every_part_has_its_sector_and_its_line_in_the_list() {
        let pie = PieChart {
            id: "pie".to_owned(),
            title: "Parts".to_owned(),
            source: "parts.csv".to_owned(),
            slices: vec![slice("large", 3.0), slice("small", 1.0), slice("none", 0.0)],
        };
        let svg = pie.svg(Dress::Alone);
        assert_eq!(svg.matches("<path").count(), 3);
        assert!(
            ["large", "small", "none", "3 W"]
                .iter()
                .all(|text| svg.contains(text))
        );
        // Three quarters end at nine o'clock.
        assert!(sector([0.0, 0.0], 0.0, 0.75).ends_with("-100.0 0.0Z"));
        let nothing = PieChart {
            slices: vec![slice("none", 0.0)],
            ..pie
        };
        assert!(!nothing.svg(Dress::Page).contains("NaN"));
    }
}
