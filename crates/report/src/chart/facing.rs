//! Two flanks in contact at one of several positions: heights to one scale, the gap filled, and the pressures below.

use std::fmt::Write as _;

use asperity_core::numerics::range;
use serde_json::{Value, json};

use super::axis::{Axis, Range};
use super::canvas::{Anchor, Canvas};
use super::contour::counted;
use super::dress::Dress;
use super::frame::{
    RIGHT, TICK_BELOW, TICK_LEFT, TICKS_ACROSS, TICKS_UP, WIDTH, document, left_margin,
    upright_room,
};
use super::spread::spread;
use super::steps::in_tenths;
use super::xy::Mark;

/// The contact at one position.
#[derive(Debug, Clone, PartialEq)]
pub struct FacingFrame {
    /// Caption.
    pub text: String,
    /// Position on the path of contact, in the unit of the marks.
    pub at: f64,
    /// Positions across the contact in half-widths, ascending.
    pub x: Vec<f64>,
    /// Height of the lower flank \[µm\].
    pub lower: Vec<f64>,
    /// Height of the upper flank \[µm\].
    pub upper: Vec<f64>,
    /// Pressure of touching asperities \[MPa\].
    pub solid: Vec<f64>,
    /// Pressure in the film \[MPa\].
    pub fluid: Vec<f64>,
    /// Hertz pressure of smooth dry flanks \[MPa\].
    pub hertz: f64,
}

/// Two flanks in contact, one frame per position.
#[derive(Debug, Clone, PartialEq)]
pub struct Facing {
    /// Identifier for links.
    pub id: String,
    /// Title of the drawing.
    pub title: String,
    /// Name of its data file.
    pub source: String,
    /// The positions, along the path; not empty.
    pub frames: Vec<FacingFrame>,
    /// Index of the first frame shown.
    pub first: usize,
    /// The points of the path of contact.
    pub marks: Vec<Mark>,
    /// Half-widths shown to either side.
    pub reach: f64,
}

/// Vertical position of the path of contact; then top and bottom of both panels.
const BAR: f64 = 26.0;
const FLANKS: [f64; 2] = [48.0, 258.0];
const PRESSURES: [f64; 2] = [280.0, 404.0];
const HEIGHT: f64 = 454.0;
/// Height of the title in a separate file.
const TITLE: f64 = 22.0;

/// Lines of the picture: CSS class, part name for the script, name in the legend.
const FILM: [&str; 3] = ["oil", "film", "gap, filled with oil"];
const LOWER: [&str; 3] = ["curve c0 solid", "lower", "pinion"];
const UPPER: [&str; 3] = ["curve c1 solid", "upper", "wheel"];
const SOLID: [&str; 3] = ["curve c3 solid", "solid", "pressure of asperities"];
const FLUID: [&str; 3] = ["curve c2 solid", "fluid", "of the film"];
const HERTZ: [&str; 3] = [
    "curve hertz dashed",
    "hertz",
    "of smooth dry flanks (Hertz)",
];

/// Ranges of the axes and sides of the panels, common to all frames.
struct FacingScales {
    left: f64,
    right: f64,
    x: Range,
    height: Range,
    pressure: Range,
    path: Range,
}

impl FacingScales {
    fn px(&self, range: &Range, value: f64) -> f64 {
        self.left + range.share(value) * (self.right - self.left)
    }
}

/// Frame in tenths of a unit of the drawing: integers keep the page small.
struct FramePaths {
    x: Vec<i64>,
    lower: Vec<i64>,
    upper: Vec<i64>,
    solid: Vec<i64>,
    fluid: Vec<i64>,
    hertz: Vec<i64>,
    at: i64,
}

fn between([top, bottom]: [f64; 2], share: f64) -> f64 {
    bottom - share * (bottom - top)
}

/// Names of the vertical axes.
const NAMES: [&str; 2] = ["height [µm]", "pressure [MPa]"];
/// Approximate number of ticks of the pressure axis.
const PRESSURE_TICKS: usize = 3;

/// Number of points of the Hertz ellipse.
const ELLIPSE: usize = 48;

impl Facing {
    /// CSS class of its drawing.
    pub(super) const KIND: &str = "facing-chart";

    fn scales(&self) -> FacingScales {
        /// Half-widths within which the vertical range includes all heights.
        const SEEN: f64 = 1.25;
        let frames = || self.frames.iter();
        let seen = |frame: &FacingFrame| -> Vec<f64> {
            let within = (0..frame.x.len()).filter(|&k| frame.x[k].abs() <= SEEN);
            within
                .flat_map(|k| [frame.lower[k], frame.upper[k]])
                .collect()
        };
        let heights = Axis::new("height", "µm").range(frames().flat_map(seen));
        let pressures = frames().flat_map(|frame| {
            let hertz = std::iter::once(frame.hertz);
            hertz.chain(frame.solid.iter().chain(&frame.fluid).copied())
        });
        let pressure = Axis::new("pressure", "MPa").from_zero().range(pressures);
        let places = frames()
            .map(|frame| frame.at)
            .chain(self.marks.iter().map(|m| m.at));
        let [low, high] = range(places);
        let x = Axis::new("", "")
            .within(-self.reach, self.reach)
            .range(std::iter::empty());
        let ticks = [heights.ticks(TICKS_UP), pressure.ticks(PRESSURE_TICKS)].concat();
        let name = NAMES[0].to_owned();
        FacingScales {
            left: left_margin(&[name], ticks.iter().map(|(_, label)| label.as_str())),
            right: WIDTH - RIGHT,
            x,
            height: heights,
            pressure,
            path: Range { low, high, ..x },
        }
    }

    fn placed(&self, frame: &FacingFrame, scales: &FacingScales) -> FramePaths {
        let rows = |panel: [f64; 2], range: &Range, values: &[f64]| -> Vec<i64> {
            let row = |value: &f64| in_tenths(between(panel, range.share(*value)));
            values.iter().map(row).collect()
        };
        let ellipse = (0..=ELLIPSE).map(|k| {
            let x = 2.0 * k as f64 / ELLIPSE as f64 - 1.0;
            frame.hertz * (1.0 - x * x).max(0.0).sqrt()
        });
        let ellipse: Vec<f64> = ellipse.collect();
        FramePaths {
            x: frame
                .x
                .iter()
                .map(|x| in_tenths(scales.px(&scales.x, *x)))
                .collect(),
            lower: rows(FLANKS, &scales.height, &frame.lower),
            upper: rows(FLANKS, &scales.height, &frame.upper),
            solid: rows(PRESSURES, &scales.pressure, &frame.solid),
            fluid: rows(PRESSURES, &scales.pressure, &frame.fluid),
            hertz: rows(PRESSURES, &scales.pressure, &ellipse),
            at: in_tenths(scales.px(&scales.path, frame.at)),
        }
    }

    /// Exaggeration of heights relative to lengths, for each micrometre of the half-width.
    #[must_use]
    pub(crate) fn exaggeration(&self) -> f64 {
        let scales = self.scales();
        let up = (FLANKS[1] - FLANKS[0]) / (scales.height.high - scales.height.low);
        let across = (scales.right - scales.left) / (scales.x.high - scales.x.low);
        up / across
    }

    /// The picture as SVG, with its first frame.
    pub fn svg(&self, dress: Dress) -> String {
        let scales = self.scales();
        let down = if dress == Dress::Alone { TITLE } else { 0.0 };
        let mut canvas = Canvas::default();
        if dress == Dress::Alone {
            canvas.raw(&format!("<g transform=\"translate(0 {TITLE})\">"));
        }
        self.axes(&mut canvas, &scales);
        if let Some(frame) = self.frames.get(self.first) {
            self.draw(&mut canvas, &self.placed(frame, &scales));
        }
        if dress == Dress::Alone {
            canvas.close();
        }
        document(
            dress,
            Self::KIND,
            &self.title,
            HEIGHT + down,
            &canvas.into_text(),
        )
    }

    fn draw(&self, canvas: &mut Canvas, placed: &FramePaths) {
        let [top, bottom] = FLANKS.map(in_tenths);
        let lower = line(&placed.x, &placed.lower);
        let upper = line(&placed.x, &placed.upper);
        let ends = placed.x.first().zip(placed.x.last());
        let (first, last) = ends.map_or((0, 0), |(a, b)| (*a, *b));
        let back: String = (placed.x.iter().zip(&placed.upper).rev())
            .map(|(x, y)| format!("L{x} {y}"))
            .collect();
        let clip = |panel: &str| {
            format!(
                "<g clip-path=\"url(#clip-{}-{panel})\"><g class=\"curves tenths\" transform=\"scale(.1)\">",
                self.id
            )
        };
        canvas.raw(&clip("flanks"));
        for (part, class, d) in [
            (
                "below",
                "flesh c0",
                format!("{lower}L{last} {bottom}L{first} {bottom}Z"),
            ),
            (
                "above",
                "flesh c1",
                format!("{upper}L{last} {top}L{first} {top}Z"),
            ),
            (FILM[1], FILM[0], format!("{lower}{back}Z")),
            (LOWER[1], LOWER[0], lower.clone()),
            (UPPER[1], UPPER[0], upper.clone()),
        ] {
            canvas.raw(&format!(
                "<path class=\"{class}\" data-part=\"{part}\" d=\"{d}\"/>"
            ));
        }
        canvas.raw("</g></g>");
        canvas.raw(&clip("pressures"));
        let ellipse = line(&self.ellipse_places(), &placed.hertz);
        for ([class, part, _], d) in [
            (HERTZ, ellipse),
            (FLUID, line(&placed.x, &placed.fluid)),
            (SOLID, line(&placed.x, &placed.solid)),
        ] {
            canvas.raw(&format!(
                "<path class=\"{class}\" data-part=\"{part}\" d=\"{d}\"/>"
            ));
        }
        canvas.raw("</g></g>");
        canvas.raw(&format!(
            "<circle class=\"touch\" data-part=\"dot\" cx=\"{}\" cy=\"{BAR}\" r=\"5\"/>",
            placed.at as f64 / 10.0
        ));
    }

    fn ellipse_places(&self) -> Vec<i64> {
        let scales = self.scales();
        let place =
            |k: usize| in_tenths(scales.px(&scales.x, 2.0 * k as f64 / ELLIPSE as f64 - 1.0));
        (0..=ELLIPSE).map(place).collect()
    }

    fn axes(&self, canvas: &mut Canvas, scales: &FacingScales) {
        let (left, right) = (scales.left, scales.right);
        for (name, [top, bottom]) in [("flanks", FLANKS), ("pressures", PRESSURES)] {
            canvas.raw(&format!(
                "<clipPath id=\"clip-{}-{name}\"><rect x=\"{left:.1}\" y=\"{top}\" width=\"{:.1}\" height=\"{}\"/></clipPath>",
                self.id,
                right - left,
                bottom - top
            ));
            canvas.rect("box", [left, top], [right - left, bottom - top]);
        }
        let panels = [
            (FLANKS, &scales.height, TICKS_UP, NAMES[0]),
            (PRESSURES, &scales.pressure, PRESSURE_TICKS, NAMES[1]),
        ];
        for (panel, range, wanted, name) in panels {
            for (value, label) in range.ticks(wanted) {
                let y = between(panel, range.share(value));
                canvas.line("grid", [left, y], [right, y]);
                canvas.label("tick", [left - TICK_LEFT, y + 4.0], Anchor::End, &label);
            }
            let name = [name.to_owned()];
            let [_, base] = upright_room(&name);
            canvas.upright("name", [base, 0.5 * (panel[0] + panel[1])], &name);
        }
        for (value, label) in scales.x.ticks(TICKS_ACROSS) {
            let x = scales.px(&scales.x, value);
            for [top, bottom] in [FLANKS, PRESSURES] {
                let class = if value.abs() == 1.0 { "mark" } else { "grid" };
                canvas.line(class, [x, top], [x, bottom]);
            }
            canvas.label(
                "tick",
                [x, PRESSURES[1] + TICK_BELOW],
                Anchor::Middle,
                &label,
            );
        }
        let below = [0.5 * (left + right), HEIGHT - 8.0];
        let name = "distance from the middle of the contact, in half-widths";
        canvas.label("name", below, Anchor::Middle, name);
        self.bar(canvas, scales);
    }

    /// Draws the path of contact with its points above both panels.
    fn bar(&self, canvas: &mut Canvas, scales: &FacingScales) {
        /// Least distance between letters.
        const APART: f64 = 15.0;
        canvas.line("axis", [scales.left, BAR], [scales.right, BAR]);
        canvas.label(
            "letter",
            [scales.left - 8.0, BAR + 4.0],
            Anchor::End,
            "path",
        );
        let places: Vec<f64> = (self.marks.iter())
            .map(|mark| scales.px(&scales.path, mark.at))
            .collect();
        for ((mark, at), letter) in self.marks.iter().zip(&places).zip(spread(&places, APART)) {
            canvas.line("axis", [*at, BAR - 4.0], [*at, BAR + 4.0]);
            canvas.label("letter", [letter, BAR - 9.0], Anchor::Middle, &mark.label);
        }
    }

    /// Names of the lines with their CSS classes.
    pub fn legend() -> Vec<(String, String)> {
        let named = |[class, _, name]: [&str; 3]| (name.to_owned(), class.to_owned());
        [UPPER, LOWER, FILM, SOLID, FLUID, HERTZ]
            .map(named)
            .to_vec()
    }

    /// Frames for the script of the slider, in tenths of a unit of the drawing, as differences of successive values.
    pub fn frames(&self) -> Value {
        let scales = self.scales();
        let frames: Vec<Value> = self
            .frames
            .iter()
            .map(|frame| {
                let placed = self.placed(frame, &scales);
                json!({"text": frame.text, "s": frame.at, "at": placed.at, "x": steps(&placed.x), "lower": steps(&placed.lower),
                    "upper": steps(&placed.upper), "solid": steps(&placed.solid), "fluid": steps(&placed.fluid),
                    "hertz": placed.hertz})
            })
            .collect();
        json!({"ellipse": self.ellipse_places(), "top": in_tenths(FLANKS[0]), "bottom": in_tenths(FLANKS[1]), "frames": frames})
    }
}

/// Differences of successive values, equal ones counted, which keep the page small.
fn steps(values: &[i64]) -> Vec<Value> {
    let before = std::iter::once(&0).chain(values);
    let steps = values.iter().zip(before);
    let steps: Vec<Value> = steps.map(|(value, before)| json!(value - before)).collect();
    counted(&steps)
}

fn line(xs: &[i64], ys: &[i64]) -> String {
    let mut d = String::with_capacity(10 * xs.len());
    for (k, (x, y)) in xs.iter().zip(ys).enumerate() {
        let _ = write!(d, "{}{x} {y}", if k == 0 { 'M' } else { 'L' });
    }
    d
}
