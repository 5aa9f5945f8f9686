//! Just enough SVG for four panels of lines.

use std::fmt::Write as _;

/// Size of a panel and its margins.
const WIDTH: f64 = 860.0;
const LEFT: f64 = 70.0;
const RIGHT: f64 = 20.0;
const TOP: f64 = 30.0;
const BOTTOM: f64 = 46.0;
/// Points drawn of a curve at most; beyond it the highest and lowest of each bin are.
const MOST: usize = 3000;

/// A curve or a single straight line.
pub struct Curve {
    pub points: Vec<(f64, f64)>,
    pub colour: &'static str,
    pub label: &'static str,
    pub dashed: bool,
}

/// A panel with linear or logarithmic axes.
pub struct Panel {
    pub title: String,
    pub x_label: &'static str,
    pub y_label: &'static str,
    pub logarithmic: bool,
    pub height: f64,
    pub curves: Vec<Curve>,
}

/// Panels below each other as one document.
pub fn document(title: &str, panels: &[Panel]) -> String {
    const HEAD: f64 = 40.0;
    let height: f64 = HEAD + panels.iter().map(|panel| panel.height).sum::<f64>();
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" \
         height=\"{height}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
         <text x=\"{LEFT}\" y=\"26\" font-size=\"15\" font-weight=\"bold\">{}</text>\n",
        escaped(title)
    );
    let mut top = HEAD;
    for panel in panels {
        panel.draw(&mut svg, top);
        top += panel.height;
    }
    svg + "</svg>\n"
}

impl Panel {
    fn draw(&self, svg: &mut String, top: f64) {
        let scaled = |v: f64| if self.logarithmic { v.log10() } else { v };
        let all = || self.curves.iter().flat_map(|curve| curve.points.iter());
        let (x0, x1) = range(all().map(|p| scaled(p.0)), 0.0);
        let (y0, y1) = range(all().map(|p| scaled(p.1)), 0.05);
        let (w, h) = (WIDTH - LEFT - RIGHT, self.height - TOP - BOTTOM);
        let x = |v: f64| LEFT + (scaled(v) - x0) / (x1 - x0) * w;
        let y = |v: f64| top + TOP + (y1 - scaled(v)) / (y1 - y0) * h;
        let _ = write!(
            svg,
            "<text x=\"{LEFT}\" y=\"{:.1}\" font-weight=\"bold\">{}</text>\n\
             <rect x=\"{LEFT}\" y=\"{:.1}\" width=\"{w:.1}\" height=\"{h:.1}\" fill=\"none\" stroke=\"#888\"/>\n",
            top + TOP - 10.0,
            escaped(&self.title),
            top + TOP
        );
        for (tick, label) in self.ticks(x0, x1) {
            let at = LEFT + (tick - x0) / (x1 - x0) * w;
            let (foot, low) = (top + TOP + h, top + TOP);
            let _ = writeln!(
                svg,
                "<path d=\"M{at:.1} {low:.1}V{foot:.1}\" stroke=\"#e4e4e4\"/>\
                 <text x=\"{at:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{label}</text>",
                foot + 16.0
            );
        }
        for (tick, label) in self.ticks(y0, y1) {
            let at = top + TOP + (y1 - tick) / (y1 - y0) * h;
            let _ = writeln!(
                svg,
                "<path d=\"M{LEFT} {at:.1}h{w:.1}\" stroke=\"#e4e4e4\"/>\
                 <text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
                LEFT - 6.0,
                at + 4.0
            );
        }
        let _ = write!(
            svg,
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>\n\
             <text transform=\"translate(16 {:.1}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
            LEFT + 0.5 * w,
            top + self.height - 12.0,
            escaped(self.x_label),
            top + TOP + 0.5 * h,
            escaped(self.y_label)
        );
        let mut legend = WIDTH - RIGHT;
        for curve in self.curves.iter().rev() {
            let dash = if curve.dashed {
                " stroke-dasharray=\"6 4\""
            } else {
                ""
            };
            let _ = write!(
                svg,
                "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"{dash} points=\"",
                curve.colour
            );
            for (px, py) in thinned(&curve.points) {
                let _ = write!(svg, "{:.1},{:.1} ", x(px), y(py));
            }
            svg.push_str("\"/>\n");
            if !curve.label.is_empty() {
                let _ = writeln!(
                    svg,
                    "<text x=\"{legend:.1}\" y=\"{:.1}\" text-anchor=\"end\" fill=\"{}\">{}</text>",
                    top + TOP - 10.0,
                    curve.colour,
                    escaped(curve.label)
                );
                legend -= 8.0 * curve.label.chars().count() as f64 + 14.0;
            }
        }
    }

    /// Places (in the scale of the axis) and labels of round values.
    fn ticks(&self, low: f64, high: f64) -> Vec<(f64, String)> {
        if self.logarithmic {
            let (first, last) = (low.ceil() as i32, high.floor() as i32);
            let step = ((last - first) / 6).max(1);
            return (first..=last)
                .step_by(step as usize)
                .map(|decade| (decade.into(), format!("1e{decade}")))
                .collect();
        }
        const TICKS: f64 = 7.0;
        let rough = (high - low) / TICKS;
        let power = 10f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|m| m * power);
        let step = step
            .into_iter()
            .find(|step| *step >= rough)
            .unwrap_or(power);
        let digits = (-(step.log10().floor())).max(0.0) as usize;
        let (first, last) = ((low / step).ceil() as i64, (high / step).floor() as i64);
        (first..=last)
            .map(|k| (k as f64 * step, format!("{:.digits$}", k as f64 * step)))
            .collect()
    }
}

/// Smallest and largest value with a margin; never empty.
fn range(values: impl Iterator<Item = f64>, margin: f64) -> (f64, f64) {
    let finite = values.filter(|v| v.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
        (l.min(v), h.max(v))
    });
    if low > high {
        return (0.0, 1.0);
    }
    let pad = if high > low {
        margin * (high - low)
    } else {
        0.5
    };
    (low - pad, high + pad)
}

/// The curve with no more points than can be seen: the lowest and highest of each bin, in order.
fn thinned(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    if points.len() <= MOST {
        return points.to_vec();
    }
    let size = points.len().div_ceil(MOST / 2);
    let ends = |bin: &[(f64, f64)]| {
        let (mut low, mut high) = (0, 0);
        for (at, point) in bin.iter().enumerate() {
            if point.1 < bin[low].1 {
                low = at;
            }
            if point.1 > bin[high].1 {
                high = at;
            }
        }
        [bin[low.min(high)], bin[low.max(high)]]
    };
    points.chunks(size).flat_map(ends).collect()
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
