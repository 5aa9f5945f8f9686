//! A plane field as filled contours, drawn from the lowest level to the highest.

use std::fmt::Write as _;

use asperity_core::numerics::range;
use serde_json::{Value, json};

use super::axis::{Axis, Range, Scale};
use super::canvas::{Anchor, Canvas};
use super::dress::Dress;
use super::frame::{Frame, RIGHT, WIDTH, document, upright_room};
use super::steps::{block, in_tenths, polygon, step};
use super::text_width::{DESCENT, NAME, TICK, name_lines, widest};

/// Number of bands of the colour scale.
const BANDS: usize = 10;

/// A field on a grid.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Contour {
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
    /// Quantity shown by the colours, with its unit.
    pub value: String,
    /// Positions of the columns, ascending.
    pub columns: Vec<f64>,
    /// Positions of the rows, ascending.
    pub rows: Vec<f64>,
    /// Values row by row; a cell with an undefined corner stays blank.
    pub values: Vec<f64>,
    /// Lower edges of the bands, ascending; round numbers from zero if empty. The first band includes all values
    /// below the second.
    pub levels: Option<Vec<f64>>,
    /// Whether each value is marked as doubtful: cells at such a node are hatched. Empty if none is.
    pub hatched: Vec<bool>,
    /// Positions of dots, in the units of the axes.
    pub dots: Vec<[f64; 2]>,
    /// Value of an isoline over the bands.
    pub isoline: Option<f64>,
    /// Height of the box in units of the drawing.
    pub height: f64,
    /// Whether each value is of a whole cell around its place, without a slope between cells. All cells are drawn equally large.
    pub is_of_cells: bool,
}

/// Distance from the box to the colour scale.
const SCALE_LEFT: f64 = 12.0;
/// Width of the colour scale.
const SCALE_THICK: f64 = 14.0;
/// Distance from the colour scale to its ticks.
const SCALE_TICKS: f64 = 4.0;

/// Labels of the lower edges of the bands, which share the number of their decimals if these are few. The last one says so
/// if its band holds values up to `highest`, more than another band's width above.
fn labels(levels: &[f64], highest: f64) -> Vec<String> {
    /// Most decimals of a label that ends with zeros.
    const FEW: usize = 3;
    let texts: Vec<String> = levels.iter().map(f64::to_string).collect();
    let decimals = |text: &String| text.split_once('.').map_or(0, |(_, after)| after.len());
    let most = texts.iter().map(decimals).max().unwrap_or(0).min(FEW);
    let pairs = levels.iter().zip(&texts);
    let labels = pairs.map(|(level, text)| format!("{level:.*}", most.max(decimals(text))));
    let mut labels: Vec<String> = labels.collect();
    if let ([.., before, last], Some(label)) = (levels, labels.last_mut())
        && highest - last > 2.0 * (last - before)
    {
        label.insert_str(0, "≥ ");
    }
    labels
}

impl Contour {
    /// CSS class of its drawing.
    pub(super) const KIND: &str = "contour-chart";

    fn frame(&self, dress: Dress) -> Frame {
        let of = |axis: &Axis, values: &[f64]| match (axis.limits, values.first(), values.last()) {
            (None, Some(&low), Some(&high)) if low < high => {
                let low = if axis.zero { low.min(0.0) } else { low };
                Range {
                    low,
                    high,
                    scale: Scale::Linear,
                }
            }
            _ => axis.range(values.iter().copied()),
        };
        let lines = usize::from(dress == Dress::Alone);
        let (x, y) = if self.is_of_cells {
            (
                of(&self.x, &edges(&self.columns)),
                of(&self.y, &edges(&self.rows)),
            )
        } else {
            (of(&self.x, &self.columns), of(&self.y, &self.rows))
        };
        let beside = self.scale_room(&self.levels());
        Frame::new(self.height, lines, beside, &self.y, [x, y])
    }

    /// Largest value, at least zero.
    fn highest(&self) -> f64 {
        let values = self.values.iter().copied();
        values.filter(|v| v.is_finite()).fold(0.0, f64::max)
    }

    /// Lower edges of the bands, at round numbers from zero.
    fn levels(&self) -> Vec<f64> {
        if let Some(levels) = self.levels.as_ref().filter(|levels| !levels.is_empty()) {
            return levels.clone();
        }
        let highest = self.highest();
        let range = Range {
            low: 0.0,
            high: highest,
            scale: Scale::Linear,
        };
        if highest <= 0.0 {
            return vec![0.0];
        }
        let ticks = range.ticks(BANDS);
        ticks
            .into_iter()
            .map(|(value, _)| value.abs())
            .filter(|value| *value < highest)
            .collect()
    }

    /// The chart as SVG.
    pub fn svg(&self, dress: Dress) -> String {
        let frame = self.frame(dress);
        let levels = self.levels();
        let mut canvas = Canvas::default();
        frame.axes(&mut canvas, &self.x);
        let clip = format!("clip-{}", self.id);
        let size = [frame.right - frame.left, frame.bottom - frame.top];
        canvas.raw(&format!(
            "<clipPath id=\"{clip}\"><rect x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\"/></clipPath>\
             <g clip-path=\"url(#{clip})\"><g class=\"field\">",
            frame.left, frame.top, size[0], size[1]
        ));
        if self.is_of_cells {
            // One unit to a cell: a page with two of these fields is a fourth as large.
            let counts = [self.columns.len(), self.rows.len()].map(|count| count.max(1) as f64);
            let [wide, high] = [size[0] / counts[0], size[1] / counts[1]];
            let (left, first) = (frame.left, frame.bottom - 0.5 * high);
            canvas.raw(&format!(
                "<g class=\"cells\" transform=\"translate({left:.2} {first:.2}) scale({wide:.4} -{high:.4})\">"
            ));
        }
        for (band, level) in levels.iter().enumerate() {
            // The first band includes all lower values.
            let from = if band == 0 { f64::NEG_INFINITY } else { *level };
            let outline = if self.is_of_cells {
                self.cells_above(from)
            } else {
                self.region_above(from, &frame)
            };
            canvas.path(&format!("band {}", colour(band, &levels)), &outline);
        }
        if self.is_of_cells {
            canvas.close();
        }
        if let Some(level) = self.isoline {
            canvas.path("isoline", &self.line_at(level, &frame));
        }
        if self.hatched.iter().any(|is_hatched| *is_hatched) {
            canvas.path("hatch", &self.hatching(&frame));
        }
        canvas.raw("</g></g>");
        if !self.dots.is_empty() {
            canvas.path("dots", &self.dotted(&frame));
        }
        self.draw_scale(&mut canvas, &frame, &levels);
        document(
            dress,
            Self::KIND,
            &self.title,
            frame.height,
            &canvas.into_text(),
        )
    }

    /// Name of the colour scale, broken into lines that fit.
    fn scale_name(&self) -> Vec<String> {
        name_lines(&self.value, self.height)
    }

    /// Width of the colour scale to the right of the box.
    fn scale_room(&self, levels: &[f64]) -> f64 {
        let labels = labels(levels, self.highest());
        let ticks = widest(labels.iter().map(String::as_str), TICK);
        let [name, _] = upright_room(&self.scale_name());
        SCALE_LEFT + SCALE_THICK + SCALE_TICKS + ticks + name - RIGHT
    }

    fn draw_scale(&self, canvas: &mut Canvas, frame: &Frame, levels: &[f64]) {
        let left = frame.right + SCALE_LEFT;
        let tall = (frame.bottom - frame.top) / levels.len() as f64;
        for (band, label) in labels(levels, self.highest()).iter().enumerate() {
            let y = frame.bottom - tall * (band + 1) as f64;
            canvas.rect(
                &format!("band {}", colour(band, levels)),
                [left, y],
                [SCALE_THICK, tall],
            );
            canvas.label(
                "tick",
                [left + SCALE_THICK + SCALE_TICKS, y + tall + 4.0],
                Anchor::Start,
                label,
            );
        }
        let at = [WIDTH - DESCENT * NAME, 0.5 * (frame.top + frame.bottom)];
        canvas.upright("name", at, &self.scale_name());
    }

    /// Lines of the thickness of a row through the cells at or above `level`, in units of cells; an undefined cell stays blank.
    fn cells_above(&self, level: f64) -> String {
        let mut d = String::new();
        for (j, row) in self.values.chunks(self.columns.len().max(1)).enumerate() {
            let mut from = 0;
            for run in row.chunk_by(|a, b| (*a >= level) == (*b >= level)) {
                if run[0] >= level {
                    let _ = write!(d, "M{from} {j}h{}", run.len());
                }
                from += run.len();
            }
        }
        d
    }

    /// Outline of the region where the field is at or above `level`, by cell; full cells are joined to runs. A cell with
    /// an undefined corner stays blank.
    fn region_above(&self, level: f64, frame: &Frame) -> String {
        let (nx, ny) = (self.columns.len(), self.rows.len());
        let px: Vec<f64> = self.columns.iter().map(|x| frame.px(*x)).collect();
        let py: Vec<f64> = self.rows.iter().map(|y| frame.py(*y)).collect();
        let at = |i: usize, j: usize| self.values[j * nx + i];
        let mut d = String::new();
        for j in 0..ny.saturating_sub(1) {
            let mut run: Option<usize> = None;
            for i in 0..nx.saturating_sub(1) {
                let corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                if corners.iter().all(|v| *v >= level) {
                    run.get_or_insert(i);
                    continue;
                }
                if let Some(from) = run.take() {
                    block(&mut d, [px[from], px[i]], [py[j], py[j + 1]]);
                }
                if !corners.iter().all(|v| v.is_finite()) {
                    continue;
                }
                let places = [
                    [px[i], py[j]],
                    [px[i + 1], py[j]],
                    [px[i + 1], py[j + 1]],
                    [px[i], py[j + 1]],
                ];
                part_above(&mut d, &places, &corners, level);
            }
            if let Some(from) = run {
                block(&mut d, [px[from], px[nx - 1]], [py[j], py[j + 1]]);
            }
        }
        d
    }

    /// Hatching of the cells at doubtful nodes, with common lines for all cells.
    fn hatching(&self, frame: &Frame) -> String {
        /// Distance of the lines in units of the drawing.
        const SPACING: f64 = 9.0;
        let (nx, ny) = (self.columns.len(), self.rows.len());
        let is_hatched = |i: usize, j: usize| self.hatched.get(j * nx + i) == Some(&true);
        let mut d = String::new();
        for j in 0..ny.saturating_sub(1) {
            for i in 0..nx.saturating_sub(1) {
                let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                let is_blank = corners
                    .iter()
                    .any(|&(i, j)| !self.values[j * nx + i].is_finite());
                if is_blank || !corners.iter().any(|&(i, j)| is_hatched(i, j)) {
                    continue;
                }
                let [x1, x2] = [frame.px(self.columns[i]), frame.px(self.columns[i + 1])];
                let [a, b] = [frame.py(self.rows[j]), frame.py(self.rows[j + 1])];
                let (y1, y2) = (a.min(b), a.max(b));
                // Lines x + y = k·SPACING.
                let mut k = ((x1 + y1) / SPACING).ceil();
                while k * SPACING < x2 + y2 {
                    let sum = k * SPACING;
                    let (from, to) = (x1.max(sum - y2), x2.min(sum - y1));
                    if to > from {
                        let _ = write!(d, "M{from:.1} {:.1}L{to:.1} {:.1}", sum - from, sum - to);
                    }
                    k += 1.0;
                }
            }
        }
        d
    }

    /// Small circles at the dots within the field, whole at its edges.
    fn dotted(&self, frame: &Frame) -> String {
        /// Radius of a single dot, which marks its point, and of one of many, which leave the field visible.
        const RADII: [f64; 2] = [7.0, 2.0];
        let radius = RADII[usize::from(self.dots.len() > 1)];
        let [columns, rows] = [&self.columns, &self.rows].map(|nodes| range(nodes.iter().copied()));
        let is_within = |value: f64, [low, high]: [f64; 2]| low <= value && value <= high;
        let mut d = String::new();
        for [x, y] in &self.dots {
            if !is_within(*x, columns) || !is_within(*y, rows) {
                continue;
            }
            let (x, y) = (frame.px(*x) - radius, frame.py(*y));
            let twice = 2.0 * radius;
            let _ = write!(
                d,
                "M{x:.1} {y:.1}a{radius} {radius} 0 1 0 {twice} 0a{radius} {radius} 0 1 0 -{twice} 0"
            );
        }
        d
    }

    /// Isoline of `level`, by cell.
    fn line_at(&self, level: f64, frame: &Frame) -> String {
        let (nx, ny) = (self.columns.len(), self.rows.len());
        let px: Vec<f64> = self.columns.iter().map(|x| frame.px(*x)).collect();
        let py: Vec<f64> = self.rows.iter().map(|y| frame.py(*y)).collect();
        let at = |i: usize, j: usize| self.values[j * nx + i];
        let mut d = String::new();
        for j in 0..ny.saturating_sub(1) {
            for i in 0..nx.saturating_sub(1) {
                let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                if !corners.iter().all(|&(i, j)| at(i, j).is_finite()) {
                    continue;
                }
                let mut crossings = Vec::with_capacity(4);
                for k in 0..4 {
                    let ([(i1, j1), (i2, j2)], [a, b]) = {
                        let ends = [corners[k], corners[(k + 1) % 4]];
                        (ends, ends.map(|(i, j)| at(i, j)))
                    };
                    if (a >= level) != (b >= level) {
                        let share = (level - a) / (b - a);
                        crossings.push([
                            px[i1] + share * (px[i2] - px[i1]),
                            py[j1] + share * (py[j2] - py[j1]),
                        ]);
                    }
                }
                for pair in crossings.chunks_exact(2) {
                    let [from, to] = [pair[0], pair[1]].map(|place: [f64; 2]| place.map(in_tenths));
                    step(&mut d, None, from);
                    step(&mut d, Some(from), to);
                }
            }
        }
        d
    }

    /// Data for zoom and read-off by the script.
    pub fn data(&self) -> Value {
        let mut data = self.frame(Dress::Page).data(&self.x, &self.y);
        data["kind"] = json!("contour");
        data["value"] = json!(self.value);
        data["columns"] = json!(self.columns);
        data["rows"] = json!(self.rows);
        data["values"] = Value::Array(counted(&digits(&self.values)));
        data
    }
}

/// Edges of the cells around some places: half-way between them, and as far beyond the first and the last.
fn edges(places: &[f64]) -> Vec<f64> {
    let ([first, second, ..], [.., before, last]) = (places, places) else {
        return places.iter().flat_map(|x| [x - 0.5, x + 0.5]).collect();
    };
    let inner = places.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    std::iter::once(1.5 * first - 0.5 * second)
        .chain(inner)
        .chain([1.5 * last - 0.5 * before])
        .collect()
}

/// Values with four digits, more than a band shows; null if undefined.
fn digits(values: &[f64]) -> Vec<Value> {
    let digits = |value: &f64| {
        let text = format!("{value:.3e}");
        let value = text.parse::<f64>().ok().filter(|value| value.is_finite());
        // A whole number without its ".0".
        value.map_or(Value::Null, |value| {
            if value.abs() < 1e6 && value.fract() == 0.0 {
                json!(value as i64)
            } else {
                json!(value)
            }
        })
    };
    values.iter().map(digits).collect()
}

/// More than two equal values that follow each other as `[value, number]`.
pub(super) fn counted(values: &[Value]) -> Vec<Value> {
    let runs = values.chunk_by(|a, b| a == b);
    let runs = runs.flat_map(|run| match run.len() {
        0..=2 => run.to_vec(),
        length => vec![json!([run[0], length])],
    });
    runs.collect()
}

/// Appends the part of a cell where the field, linear along its edges, is at or above `level`.
fn part_above(d: &mut String, places: &[[f64; 2]; 4], corners: &[f64; 4], level: f64) {
    let mut outline = Vec::with_capacity(8);
    for k in 0..4 {
        let next = (k + 1) % 4;
        let (a, b) = (corners[k], corners[next]);
        if a >= level {
            outline.push(places[k]);
        }
        if (a >= level) != (b >= level) {
            let share = (level - a) / (b - a);
            let between =
                |axis: usize| places[k][axis] + share * (places[next][axis] - places[k][axis]);
            outline.push([between(0), between(1)]);
        }
    }
    polygon(d, outline);
}

/// Whether the bands reach below zero, so that they have the colours of differences.
fn is_diverging(levels: &[f64]) -> bool {
    levels.first().is_some_and(|level| *level < 0.0)
}

/// Class with the colour of a band; few bands use the full range of colours. A band of differences about zero has neither of
/// their colours.
fn colour(band: usize, levels: &[f64]) -> String {
    const COLOURS: usize = 12;
    let number = match levels.len() {
        0 | 1 => 0,
        bands => band * (COLOURS - 1) / (bands - 1),
    };
    let above = levels.get(band + 1);
    match is_diverging(levels) {
        true if levels[band] < 0.0 && above.is_some_and(|above| *above > 0.0) => "even".to_owned(),
        true => format!("v{number}"),
        false => format!("b{number}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_cut_where_the_field_passes_the_level() {
        let mut d = String::new();
        let places = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
        part_above(&mut d, &places, &[0.0, 4.0, 4.0, 0.0], 1.0);
        assert_eq!(d, "M2.5 0l7.5 0l0 10l-7.5 0z");
    }

    #[test]
    fn bands_about_zero_have_the_colours_of_differences() {
        assert_eq!(colour(0, &[0.0, 1.0]), "b0");
        let about_zero = [-2.0, -1.0, 0.0, 1.0];
        let classes = [0, 1, 2, 3].map(|band| colour(band, &about_zero));
        assert_eq!(classes, ["v0", "v3", "v7", "v11"]);
        let classes = [0, 1, 2].map(|band| colour(band, &[-3.0, -1.0, 1.0]));
        assert_eq!(classes, ["v0", "even", "v11"]);
    }

    #[test]
    fn the_last_label_says_that_its_band_holds_far_higher_values() {
        let levels = [0.0, 100.0, 200.0];
        assert_eq!(labels(&levels, 390.0), ["0", "100", "200"]);
        assert_eq!(labels(&levels, 410.0), ["0", "100", "≥ 200"]);
    }

    #[test]
    fn a_cell_with_an_undefined_corner_stays_blank() {
        let [gap, none] = [f64::NAN, f64::NEG_INFINITY];
        let field = Contour {
            id: "field".to_owned(),
            title: "Field".to_owned(),
            source: "field.csv".to_owned(),
            x: Axis::new("x", ""),
            y: Axis::new("y", ""),
            value: "value".to_owned(),
            columns: vec![0.0, 1.0, 2.0, 3.0],
            rows: vec![0.0, 1.0],
            values: vec![gap, 95.0, 95.0, 99.0, 95.0, 95.0, 95.0, 97.0],
            levels: Some(vec![0.0, 90.0, 96.0]),
            hatched: vec![true; 8],
            dots: Vec::new(),
            isoline: Some(96.0),
            height: 100.0,
            is_of_cells: false,
        };
        let frame = field.frame(Dress::Page);
        assert!(!field.svg(Dress::Page).contains("NaN"));
        let begin = |x: f64| {
            let mut d = String::new();
            step(&mut d, None, [frame.px(x), 0.0].map(in_tenths));
            d.trim_end_matches('0').to_owned()
        };
        let [blank, left] = [0.0, 1.0].map(begin);
        for level in [none, 90.0] {
            let region = field.region_above(level, &frame);
            assert!(
                region.starts_with(&left) && !region.contains(&blank),
                "{region}"
            );
            assert_eq!(region.matches('M').count(), 1);
        }
        let strokes = field.hatching(&frame);
        let starts = strokes
            .split('M')
            .skip(1)
            .map(|stroke| stroke.split(' ').next());
        let first = starts
            .filter_map(|x| x?.parse::<f64>().ok())
            .fold(f64::INFINITY, f64::min);
        assert!(first >= frame.px(1.0) - 0.1, "{first}");
        let above = field.region_above(96.0, &frame);
        assert_eq!(
            (above.matches('M').count(), above.contains(&left)),
            (1, false)
        );
    }

    #[test]
    fn cells_are_drawn_whole_to_their_edges_and_undefined_ones_stay_blank() {
        assert_eq!(edges(&[1.0, 2.0, 4.0]), [0.5, 1.5, 3.0, 5.0]);
        assert_eq!(edges(&[3.0]), [2.5, 3.5]);
        let field = Contour {
            columns: vec![0.0, 1.0, 2.0],
            rows: vec![0.0, 1.0],
            values: vec![1.0, 5.0, f64::NAN, 5.0, 5.0, 5.0],
            levels: Some(vec![0.0, 4.0]),
            height: 100.0,
            is_of_cells: true,
            ..Contour::default()
        };
        assert_eq!(field.cells_above(4.0), "M1 0h1M0 1h3");
        assert_eq!(field.cells_above(f64::NEG_INFINITY), "M0 0h2M0 1h3");
        let drawing = field.svg(Dress::Page);
        let frame = field.frame(Dress::Page);
        let (wide, high) = (
            (frame.right - frame.left) / 3.0,
            (frame.bottom - frame.top) / 2.0,
        );
        let scale = format!("scale({wide:.4} -{high:.4})");
        assert!(drawing.contains(&scale) && (frame.px(0.5) - frame.px(-0.5) - wide).abs() < 1e-9);
    }

    #[test]
    fn equal_values_of_a_field_are_counted() {
        let values = [2.0, 2.0, 1.23456, 0.0, 0.0, 0.0, f64::NAN, f64::NAN];
        let runs = Value::Array(counted(&digits(&values))).to_string();
        assert_eq!(runs, "[2,2,1.235,[0,3],null,null]");
    }

    #[test]
    fn a_field_below_the_level_draws_nothing() {
        let mut d = String::new();
        part_above(&mut d, &[[0.0; 2]; 4], &[0.0; 4], 1.0);
        assert!(d.is_empty());
    }
}
