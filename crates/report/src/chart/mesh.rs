//! Two gears in mesh, to scale: teeth, circles, path of contact with its points, traces on the flanks. The gears can be
//! turned.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::canvas::{Anchor, Canvas};
use super::dress::Dress;
use super::frame::{WIDTH, document};
use super::spread::spread;

/// Points in the plane of the drawing, y upwards, the pitch point at the origin \[mm\].
type MeshPoints = Vec<[f64; 2]>;

/// Gear of the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshBody {
    /// Its name.
    pub name: String,
    /// Position of the axis \[mm\].
    pub centre: [f64; 2],
    /// Radii of tip, pitch and base circle \[mm\].
    pub radii: [f64; 3],
    /// Closed outline of the teeth near the pitch point and the body behind them \[mm\].
    pub outline: MeshPoints,
    /// Angle, positive counterclockwise, by which the gear turns while the contact moves by a millimetre \[rad/mm\].
    pub turn: f64,
}

/// Trace on a flank.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshTrace {
    /// Index of the gear: 0 or 1.
    pub body: usize,
    /// Name in the legend.
    pub name: String,
    /// Line along the flank \[mm\].
    pub line: MeshPoints,
}

/// Named point of the line of action.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshPoint {
    /// Its name.
    pub label: String,
    /// Position \[mm\].
    pub at: [f64; 2],
}

/// Two gears in mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshPicture {
    /// Identifier for links.
    pub id: String,
    /// Title of the drawing.
    pub title: String,
    /// Name of its data file.
    pub source: String,
    /// Pinion and wheel.
    pub bodies: [MeshBody; 2],
    /// The points of the path of contact, in the order of contact.
    pub path: Vec<MeshPoint>,
    /// Feet of the perpendiculars from the axes on the line of action.
    pub feet: Vec<MeshPoint>,
    /// Unit vector along the line of action.
    pub along: [f64; 2],
    /// Distances of A, of the pitch point, and of E from T₁ along the line of action \[mm\].
    pub stations: [f64; 3],
    /// Distance between the contacts of neighbouring pairs of teeth \[mm\].
    pub base_pitch: f64,
    /// Traces with known positions.
    pub traces: Vec<MeshTrace>,
    /// Half of the visible width \[mm\].
    pub reach: f64,
}

/// Height of the picture relative to its width.
pub(crate) const ASPECT: f64 = 0.72;
const MARGIN: f64 = 4.0;

/// Mapping from the picture to the canvas.
struct View {
    top: f64,
    scale: f64,
    half: [f64; 2],
}

impl View {
    fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            MARGIN + self.half[0] + self.scale * x,
            self.top + self.half[1] - self.scale * y,
        ]
    }

    fn shows(&self, [x, y]: [f64; 2]) -> bool {
        /// Size of a label.
        const LABEL: f64 = 26.0;
        (self.scale * x).abs() < self.half[0] - LABEL
            && (self.scale * y).abs() < self.half[1] - LABEL
    }

    fn path(&self, points: &[[f64; 2]], end: &str) -> String {
        let mut d = String::new();
        for (k, point) in points.iter().enumerate() {
            let [x, y] = self.at(*point);
            let _ = write!(d, "{}{x:.1} {y:.1}", if k == 0 { 'M' } else { 'L' });
        }
        d + end
    }
}

impl MeshPicture {
    /// CSS class of its drawing.
    pub(super) const KIND: &str = "mesh-chart";

    /// The picture as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        let view = self.view(dress);
        let (top, wide) = (view.top, 2.0 * view.half[0]);
        let height = top + ASPECT * wide + MARGIN;
        let mut canvas = Canvas::default();
        let clip = format!("clip-{}", self.id);
        canvas.raw(&format!(
            "<clipPath id=\"{clip}\"><rect x=\"{MARGIN}\" y=\"{top:.1}\" width=\"{wide:.1}\" height=\"{:.1}\"/></clipPath>\
             <g class=\"curves\" clip-path=\"url(#{clip})\">",
            ASPECT * wide
        ));
        for (index, body) in self.bodies.iter().enumerate() {
            canvas.raw("<g data-gear=\"\">");
            canvas.path(&format!("body c{index}"), &view.path(&body.outline, "Z"));
            for trace in self.traces.iter().filter(|trace| trace.body == index) {
                canvas.path(&format!("trace c{index}"), &view.path(&trace.line, ""));
            }
            canvas.close();
        }
        for body in &self.bodies {
            for (radius, kind) in body.radii.iter().zip(CIRCLES) {
                circle(&mut canvas, &view, kind.1, body.centre, *radius);
            }
        }
        self.line_of_action(&mut canvas, &view);
        canvas.close();
        self.labels(&mut canvas, &view);
        document(dress, Self::KIND, &self.title, height, &canvas.into_text())
    }

    fn line_of_action(&self, canvas: &mut Canvas, view: &View) {
        let ends =
            |points: &[MeshPoint]| points.first().zip(points.last()).map(|(a, e)| [a.at, e.at]);
        if let Some(ends) = ends(&self.feet) {
            canvas.path("action", &view.path(&ends, ""));
        }
        if let Some(ends) = ends(&self.path) {
            canvas.path("contact-path", &view.path(&ends, ""));
        }
        let [a, pitch, e] = self.stations;
        for number in CONTACTS {
            let away = self.base_pitch * number;
            let [x, y] = view.at(self.along.map(|part| part * away));
            let visibility = if (a..=e).contains(&(pitch + away)) {
                "visible"
            } else {
                "hidden"
            };
            canvas.raw(&format!(
                "<circle class=\"touch\" visibility=\"{visibility}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.6\"/>"
            ));
        }
    }

    fn view(&self, dress: Dress) -> View {
        let wide = WIDTH - 2.0 * MARGIN;
        View {
            top: if dress == Dress::Alone { 30.0 } else { MARGIN },
            scale: 0.5 * wide / self.reach,
            half: [0.5 * wide, 0.5 * ASPECT * wide],
        }
    }

    /// Data from which the script of the page turns the gears and moves the contacts.
    pub fn motion(&self) -> Value {
        let view = self.view(Dress::Page);
        let [a, pitch, e] = self.stations;
        // On the canvas y points down, and a positive angle is clockwise.
        let turns = self.bodies.each_ref().map(|body| {
            let [x, y] = view.at(body.centre);
            [-body.turn.to_degrees(), x, y]
        });
        json!({
            "path": [a, e],
            "pitch": pitch,
            "turns": turns,
            "along": [view.scale * self.along[0], -view.scale * self.along[1]],
            "contacts": CONTACTS,
            "step": self.base_pitch,
            "place": view.at([0.0; 2]),
        })
    }

    /// Draws the letters of the points on one side of the path, the names of the feet on the other, and the names of the
    /// gears.
    fn labels(&self, canvas: &mut Canvas, view: &View) {
        /// Least distance between letters along the line.
        const APART: f64 = 19.0;
        /// Distance of the centre of a letter from the line.
        const BESIDE: f64 = 21.0;
        /// Distance from the centre of a letter to its base line.
        const BASE: f64 = 5.0;
        // On the canvas y points down.
        let along = [self.along[0], -self.along[1]];
        let across = [along[1], -along[0]];
        for (points, side) in [(&self.path, 1.0), (&self.feet, -1.0)] {
            let shown: Vec<&MeshPoint> = points.iter().filter(|p| view.shows(p.at)).collect();
            let place = |point: &&MeshPoint| {
                let [x, y] = view.at(point.at);
                x * along[0] + y * along[1]
            };
            let places: Vec<f64> = shown.iter().map(place).collect();
            for ((point, place), moved) in shown.iter().zip(&places).zip(spread(&places, APART)) {
                let [x, y] = view.at(point.at);
                let shift = moved - place;
                let at = |beside: f64| {
                    [0, 1].map(|k| [x, y][k] + shift * along[k] + side * beside * across[k])
                };
                canvas.line("tick-mark", [x, y], at(0.55 * BESIDE));
                let [lx, ly] = at(BESIDE);
                canvas.label("point", [lx, ly + BASE], Anchor::Middle, &point.label);
            }
        }
        let middle = MARGIN + view.half[0];
        let rows = [view.top + 2.0 * view.half[1] - 12.0, view.top + 20.0];
        for (body, y) in self.bodies.iter().zip(rows) {
            canvas.label("point", [middle, y], Anchor::Middle, &body.name);
        }
    }

    /// Names of the lines with their CSS classes.
    pub fn legend(&self) -> Vec<(String, String)> {
        let circles = CIRCLES
            .iter()
            .map(|(name, class)| ((*name).to_owned(), (*class).to_owned()));
        let path = ("path of contact".to_owned(), "contact-path".to_owned());
        let traces = self.traces.iter();
        let traces = traces.map(|trace| (trace.name.clone(), format!("trace c{}", trace.body)));
        std::iter::once(path).chain(circles).chain(traces).collect()
    }
}

/// Pairs of teeth in contact, counted from the pair in the middle.
const CONTACTS: [f64; 5] = [-2.0, -1.0, 0.0, 1.0, 2.0];

/// Names and classes of the circles, in the order of the radii of a body.
const CIRCLES: [(&str, &str); 3] = [
    ("tip circle", "circle tip"),
    ("pitch circle", "circle pitch"),
    ("base circle", "circle base"),
];

fn circle(canvas: &mut Canvas, view: &View, class: &str, centre: [f64; 2], radius: f64) {
    let [x, y] = view.at(centre);
    let r = view.scale * radius;
    canvas.raw(&format!(
        "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{r:.1}\"/>"
    ));
}
