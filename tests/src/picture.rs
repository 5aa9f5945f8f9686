//! Pictures of the documents: figures taken from the pages that the program writes, and the check that the committed files
//! are up to date.

use std::fmt::Write as _;
use std::path::Path;

use asperity_report::chart::{Chart, Dress, STYLE};
use serde_json::Value;

/// Width of every chart in units of the drawing.
const WIDTH: f64 = 640.0;
/// Height of a line of text.
const ROW: f64 = 20.0;

/// Writes `made` to `file` of the documents if `ASPERITY_WRITE` is set; otherwise checks the committed drawing.
///
/// # Panics
/// If the committed drawing differs from `made`.
#[track_caller]
pub fn hold_picture(file: &str, made: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../docs")
        .join(file);
    if std::env::var_os("ASPERITY_WRITE").is_some() {
        std::fs::write(&path, made).unwrap();
    }
    let shown = std::fs::read_to_string(&path).unwrap_or_default();
    let difference = difference(&shown, made);
    assert!(
        difference.is_none(),
        "docs/{file} is not up to date (just pictures): {}",
        difference.unwrap_or_default()
    );
}

/// The first difference of two drawings; `None` if they have the same elements and texts, numbers within 2 units, and
/// paths with the same extent and mean within 2 units: digits of a result differ between processors.
pub fn difference(shown: &str, made: &str) -> Option<String> {
    let [shown, made] = [shown, made].map(|text| text.split_inclusive(['<', '>', '"']));
    let [shown, made]: [Vec<&str>; 2] = [shown.collect(), made.collect()];
    for (before, now) in shown.iter().zip(&made) {
        if !is_near(before, now) {
            let short = |text: &str| text.chars().take(120).collect::<String>();
            return Some(format!("{:?}, now {:?}", short(before), short(now)));
        }
    }
    (shown.len() != made.len()).then(|| format!("{} parts, now {}", shown.len(), made.len()))
}

/// Largest difference of two positions [units of the drawing].
const NEAR: f64 = 2.0;

fn is_near(before: &str, now: &str) -> bool {
    if before == now {
        return true;
    }
    // Text between tags is exact.
    if now.ends_with('<') {
        return false;
    }
    if now.starts_with('M') {
        let [before, now] = [before, now].map(extent);
        return before.iter().zip(now).all(|(a, b)| (a - b).abs() < NEAR);
    }
    let [(before, a), (now, b)] = [before, now].map(numbers);
    let is_close = |(a, b): (&f64, &f64)| (a - b).abs() < NEAR;
    before == now && a.len() == b.len() && a.iter().zip(&b).all(is_close)
}

/// A text without its numbers, and these.
fn numbers(text: &str) -> (String, Vec<f64>) {
    let (mut rest, mut numbers, mut number) = (String::new(), Vec::new(), String::new());
    for c in text.chars().chain([' ']) {
        // A sign or a second point begins the next number.
        let begins = c == '-' || (c == '.' && number.contains('.'));
        if begins || !(c.is_ascii_digit() || c == '.') {
            numbers.extend(number.parse::<f64>().ok());
            number.clear();
        }
        match c {
            '-' | '.' | '0'..='9' => number.push(c),
            c if c.is_whitespace() => {}
            c => rest.push(c),
        }
    }
    (rest, numbers)
}

/// Lowest, highest and mean coordinates of the points of a path of M, L, l, H, a and Z.
fn extent(path: &str) -> [f64; 6] {
    let mut at = [0.0; 2];
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut commands = path
        .char_indices()
        .filter(|(_, c)| c.is_alphabetic())
        .peekable();
    while let Some((start, command)) = commands.next() {
        let end = commands.peek().map_or(path.len(), |(end, _)| *end);
        let (_, values) = numbers(&path[start + 1..end]);
        let step = if command == 'a' { 7 } else { 2 };
        for values in values.chunks_exact(step) {
            let [x, y] = [values[step - 2], values[step - 1]];
            at = if command.is_lowercase() {
                [at[0] + x, at[1] + y]
            } else {
                [x, y]
            };
            points.push(at);
        }
    }
    let of = |k: usize| {
        let values = points.iter().map(|point| point[k]);
        let low = values.clone().fold(f64::INFINITY, f64::min);
        let high = values.clone().fold(f64::NEG_INFINITY, f64::max);
        [low, high, values.sum::<f64>() / points.len() as f64]
    };
    let [x, y] = [of(0), of(1)];
    [x[0], x[1], x[2], y[0], y[1], y[2]]
}

/// A figure of a page.
pub struct Figure<'a> {
    title: &'a str,
    /// Samples with their names.
    legend: Vec<(&'a str, &'a str)>,
    /// Class, height and content of the drawing.
    kind: &'a str,
    height: f64,
    body: &'a str,
    data: Value,
}

fn between<'a>(text: &'a str, from: &str, to: &str) -> Option<&'a str> {
    let start = text.find(from)? + from.len();
    let length = text[start..].find(to)?;
    Some(&text[start..start + length])
}

impl<'a> Figure<'a> {
    /// The figure `id` of a page.
    ///
    /// # Panics
    /// If the page has no such figure with a drawing.
    pub fn new(page: &'a str, id: &str) -> Self {
        let begin = format!(" id=\"{id}\"><figcaption>");
        let figure = between(page, &begin, "</figure>").unwrap_or_else(|| panic!("{id}"));
        let title = figure.split('<').next().unwrap_or_default();
        let entries = figure.split("<li>").skip(1);
        let entry = |item: &'a str| {
            let sample = &item[..item.find("</svg>")? + 6];
            Some((sample, item[sample.len()..].split('<').next()?))
        };
        let legend = entries.filter_map(entry).collect();
        let drawing = between(figure, "<svg class=\"chart ", "</svg><").unwrap();
        let kind = drawing.split('"').next().unwrap_or_default();
        let size = between(drawing, "viewBox=\"0 0 640 ", "\"").unwrap();
        let data = between(figure, "<script type=\"application/json\">", "</script>");
        Self {
            title,
            legend,
            kind,
            height: size.parse().unwrap(),
            body: drawing.split_once('>').unwrap().1,
            data: data.map_or(Value::Null, |data| serde_json::from_str(data).unwrap()),
        }
    }

    /// Title and legend, and their height.
    fn head(&self) -> (String, f64) {
        const LETTER: f64 = 6.7;
        const SAMPLE: f64 = 34.0;
        let (mut text, mut x, mut y) = (String::new(), 10.0, 20.0);
        let _ = write!(
            text,
            "<text class=\"title\" x=\"{x}\" y=\"{y}\">{}</text>",
            self.title
        );
        for (k, (sample, name)) in self.legend.iter().enumerate() {
            let wide = SAMPLE + LETTER * name.chars().count() as f64 + 16.0;
            if k == 0 || x + wide > WIDTH {
                (x, y) = (10.0, y + ROW);
            }
            let place = format!(
                "<svg x=\"{x:.0}\" y=\"{:.0}\" width=\"28\" height=\"12\" ",
                y - 10.0
            );
            let _ = write!(
                text,
                "{}<text x=\"{:.0}\" y=\"{y}\">{name}</text>",
                sample.replacen("<svg ", &place, 1),
                x + SAMPLE
            );
            x += wide;
        }
        (text, y + 8.0)
    }

    /// The figure as a separate drawing with its title and legend.
    pub fn alone(&self) -> String {
        let (head, down) = self.head();
        let body = format!(
            "{head}<g transform=\"translate(0 {down})\">{}</g>",
            self.body
        );
        document(self.kind, self.title, [WIDTH, self.height + down], &body)
    }
}

/// Title and legend of a panel, and their height.
fn head_of_panel(chart: &Chart) -> (String, f64) {
    const LETTER: f64 = 8.6;
    const SAMPLE: f64 = 30.0;
    let (mut text, mut x, mut y) = (String::new(), LEFT, 20.0);
    let _ = write!(
        text,
        "<text class=\"title\" x=\"{x}\" y=\"{y}\">{}</text>",
        chart.title
    );
    // A single curve is named by the title.
    let legend = chart.legend().into_iter();
    for (k, (name, class)) in legend.filter(|_| chart.series.len() > 1).enumerate() {
        let wide = SAMPLE + LETTER * name.chars().count() as f64;
        if k == 0 || x + wide > chart.width {
            (x, y) = (LEFT, y + ROW);
        }
        let sample = match class.split(' ').next() {
            Some("area") => "v-10h22v10z",
            _ if class.ends_with("scatter") => "m7 -5a4 4 0 1 0 8 0a4 4 0 1 0 -8 0",
            _ => "m0 -5h22",
        };
        let _ = write!(
            text,
            "<path class=\"{class}\" d=\"M{x:.1} {y}{sample}\"/><text class=\"tick\" x=\"{:.1}\" y=\"{y}\">{name}</text>",
            x + SAMPLE - 4.0
        );
        x += wide + LEFT;
    }
    (text, y + 4.0)
}

/// Left margin of the head of a panel.
const LEFT: f64 = 8.0;

/// Charts of one width as panels in two columns. Letters are as large as the margins of a chart allow, so that they are
/// readable if the drawing is 400 pixels wide.
pub fn panels(title: &str, charts: &[Chart]) -> String {
    const GAP: f64 = 14.0;
    const LETTERS: &str =
        "svg.chart,svg.chart .title{font-size:17px}svg.chart :is(.tick,.letter){font-size:15.5px}";
    let wide = charts[0].width;
    let (mut body, mut top) = (format!("<style>{LETTERS}</style>"), 0.0);
    for row in charts.chunks(2) {
        let drawn = row.iter().map(|chart| {
            let svg = chart.svg(Dress::Page);
            let height = between(&svg, "viewBox=\"0 0 640 ", "\"").unwrap();
            let height: f64 = height.parse().unwrap();
            (head_of_panel(chart), svg, height)
        });
        let drawn: Vec<((String, f64), String, f64)> = drawn.collect();
        let heights = drawn.iter().map(|((_, head), _, height)| head + height);
        let bottom = top + heights.fold(0.0, f64::max);
        for (k, ((head, _), svg, height)) in drawn.iter().enumerate() {
            let x = k as f64 * (wide + GAP);
            let place = format!(
                "<svg x=\"{x}\" y=\"{}\" width=\"{WIDTH}\" height=\"{height}\" ",
                bottom - height
            );
            let _ = write!(
                body,
                "<g class=\"curve-chart\" transform=\"translate({x} {top})\">{head}</g>{}",
                svg.replacen("<svg ", &place, 1)
            );
        }
        top = bottom + GAP;
    }
    document("panels", title, [2.0 * wide + GAP, top], &body)
}

/// A drawing of `kind` and size as a separate file.
pub fn document(kind: &str, title: &str, [width, height]: [f64; 2], body: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart {kind}\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" role=\"img\">\
         <title>{title}</title><style>{STYLE}</style><rect class=\"paper\" width=\"100%\" height=\"100%\"/>{body}</svg>\n"
    )
}

/// Animated drawing of a report: the gears turn while a contact moves from A to E, and the flanks in this contact are
/// shown at every computed position.
pub fn animated(page: &str) -> String {
    /// Duration of a turn of the drawing [s].
    const SECONDS: f64 = 9.0;
    /// Units of the drawing between the two parts.
    const APART: f64 = 8.0;
    /// Height of the visible part of the gears.
    const CROPPED: f64 = 300.0;
    let [mesh, facing] = ["mesh", "facing"].map(|id| Figure::new(page, id));
    let number = |value: &Value| value.as_f64().unwrap();
    // Equal values are counted: `[value, number]`.
    let list = |value: &Value| -> Vec<f64> {
        let values = value.as_array().unwrap().iter();
        let runs = values.flat_map(|value| match value.as_array() {
            Some(run) => vec![number(&run[0]); number(&run[1]) as usize],
            None => vec![number(value)],
        });
        runs.collect()
    };
    let motion = &mesh.data;
    let [path, along, place] = ["path", "along", "place"].map(|name| list(&motion[name]));
    let [pitch, step] = ["pitch", "step"].map(|name| number(&motion[name]));
    // The picture repeats after a whole number of pitches, so that the gears come round without a jump.
    let (a, e) = (path[0], path[1]);
    let pitches = ((e - a) / step).ceil();
    let end = a + pitches * step;
    let percent = |s: f64| 100.0 * (s - a) / (end - a);

    let mut style = String::from(STYLE);
    let moving = format!("{SECONDS}s linear infinite");
    let mut body = String::new();
    let mut gears = mesh.body.split("<g data-gear=\"\">");
    body.push_str(gears.next().unwrap());
    for (k, (gear, turn)) in gears.zip(motion["turns"].as_array().unwrap()).enumerate() {
        let turn = list(turn);
        let [from, to] = [a, end].map(|s| turn[0] * (s - pitch));
        let _ = write!(
            style,
            ".g{k}{{transform-origin:{:.2}px {:.2}px;animation:g{k} {moving}}}\
             @keyframes g{k}{{from{{transform:rotate({from:.4}deg)}}to{{transform:rotate({to:.4}deg)}}}}",
            turn[1], turn[2]
        );
        let _ = write!(body, "<g class=\"g{k}\">{gear}");
    }
    // The contacts move along the path; each is seen between A and E.
    let (first, last) = (
        body.find("<circle class=\"touch\"").unwrap(),
        body.rfind("<circle class=\"touch\"").unwrap(),
    );
    let after = last + body[last..].find("/>").unwrap() + 2;
    let mut contacts = String::new();
    for (k, number) in list(&motion["contacts"]).iter().enumerate() {
        let [from, to] = [a, end].map(|s| s + number * step);
        let at = |s: f64| [0, 1].map(|k| place[k] + along[k] * (s - pitch));
        let ([x, y], [to_x, to_y]) = (at(from), at(to));
        let seen = [a.max(from), e.min(to)].map(|s| 100.0 * (s - from) / (to - from));
        if seen[0] >= seen[1] {
            continue;
        }
        let _ = write!(
            contacts,
            "<circle class=\"touch k{k}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/>"
        );
        let [begin, stop] = seen;
        let _ = write!(
            style,
            ".k{k}{{animation:k{k} {moving},s{k} {SECONDS}s step-end infinite}}\
             @keyframes k{k}{{to{{transform:translate({:.1}px,{:.1}px)}}}}\
             @keyframes s{k}{{0%{{visibility:hidden}}{begin:.2}%{{visibility:visible}}{:.2}%{{visibility:hidden}}}}",
            to_x - x,
            to_y - y,
            stop
        );
    }
    body.replace_range(first..after, &contacts);

    // The flanks: one group for each position, shown until the contact is half way to the next.
    let frames = facing.data["frames"].as_array().unwrap();
    let places: Vec<f64> = frames.iter().map(|frame| number(&frame["s"])).collect();
    let [top, bottom] = ["top", "bottom"].map(|name| number(&facing.data[name]));
    let ellipse = list(&facing.data["ellipse"]);
    let dot = between(facing.body, "data-part=\"dot\"", "/>").unwrap();
    let height_of_dot = between(dot, "cy=\"", "\"").unwrap();
    let groups = ["facing-flanks", "facing-pressures"].map(|clip| {
        format!(
            "<g clip-path=\"url(#clip-{clip})\"><g class=\"curves tenths\" transform=\"scale(.1)\">"
        )
    });
    let mut shown = String::new();
    for (k, frame) in frames.iter().enumerate() {
        let x = list(&frame["x"]);
        let of = |name: &str| steps(&x, &list(&frame[name]), 'M');
        let ends = [x[0], x.iter().sum()];
        let closed = |y: f64| format!("L{} {y}L{} {y}Z", ends[1], ends[0]);
        // Back along the upper flank.
        let upper = list(&frame["upper"]);
        let back = |steps: &[f64]| -> Vec<f64> {
            let last = steps.iter().sum();
            [last]
                .into_iter()
                .chain(steps[1..].iter().rev().map(|step| -step))
                .collect()
        };
        let film = of("lower") + &steps(&back(&x), &back(&upper), 'L') + "Z";
        let hertz: String = (ellipse.iter().zip(list(&frame["hertz"])).enumerate())
            .map(|(k, (x, y))| format!("{}{x} {y}", if k == 0 { 'M' } else { 'L' }))
            .collect();
        let _ = write!(
            shown,
            "<g class=\"f f{k}\">{}<path class=\"oil\" d=\"{film}\"/><path class=\"flesh c0\" d=\"{}{}\"/>\
             <path class=\"flesh c1\" d=\"{}{}\"/></g></g>{}<path class=\"curve hertz dashed\" d=\"{hertz}\"/>\
             <path class=\"curve c2 solid\" d=\"{}\"/><path class=\"curve c3 solid\" d=\"{}\"/></g></g>\
             <circle class=\"touch\" cx=\"{}\" cy=\"{height_of_dot}\" r=\"5\"/></g>",
            groups[0],
            of("lower"),
            closed(bottom),
            of("upper"),
            closed(top),
            groups[1],
            of("fluid"),
            of("solid"),
            0.1 * number(&frame["at"]),
        );
        let middle = |one: usize, other: usize| 0.5 * (places[one] + places[other]);
        let begin = if k == 0 {
            0.0
        } else {
            percent(middle(k - 1, k))
        };
        // The last one stays until the picture repeats.
        let stop = places
            .get(k + 1)
            .map_or(100.0, |_| percent(middle(k, k + 1)));
        let _ = write!(
            style,
            ".f{k}{{animation:f{k} {SECONDS}s step-end infinite}}\
             @keyframes f{k}{{0%{{visibility:hidden}}{begin:.2}%{{visibility:visible}}{stop:.2}%{{visibility:hidden}}}}"
        );
    }
    // Readers who prefer reduced motion see the first position, and the gears at the pitch point.
    let still = (0..frames.len()).find(|k| places[*k] >= pitch).unwrap_or(0);
    let _ = write!(
        style,
        ".f{{visibility:hidden}}.f .flesh{{stroke:var(--own);stroke-width:13}}\
         @media (prefers-reduced-motion:reduce){{.f,.gears *{{animation:none}}.f{still}{{visibility:visible}}\
         .gears .touch{{visibility:hidden}}}}"
    );
    // The middle of the drawing of the gears, with their names at its corners.
    let (mut gears, mut names) = (String::new(), String::new());
    for part in body.split_inclusive("</text>") {
        if part.contains(" teeth</text>") {
            let name = part.rsplit('>').nth(1).unwrap().trim_end_matches("</text");
            let y = if names.is_empty() {
                CROPPED - 10.0
            } else {
                18.0
            };
            let _ = write!(
                names,
                "<text class=\"point\" x=\"12\" y=\"{y}\">{name}</text>"
            );
        } else {
            gears.push_str(part)
        }
    }
    let frame = &facing.body[..facing.body.find("<g clip-path").unwrap()];
    let (head, under) = facing.head();
    let top = 0.5 * (mesh.height - CROPPED);
    let down = CROPPED + APART;
    let height = down + under + facing.height;
    let title = "A pair of gears in mesh, and its rough flanks under load";
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" role=\"img\">\
         <title>{title}</title><style>{style}</style><rect class=\"paper\" width=\"100%\" height=\"100%\"/>\
         <svg width=\"{WIDTH}\" height=\"{CROPPED}\" viewBox=\"0 {top} {WIDTH} {CROPPED}\"><g class=\"gears {0}\">{gears}</g></svg>\
         <g class=\"{0}\">{names}</g><g class=\"{1}\" transform=\"translate(0 {down})\">{head}\
         <g transform=\"translate(0 {under})\">{frame}{shown}</g></g></svg>\n",
        mesh.kind, facing.kind
    )
}

/// A path from steps along both axes, of which the first lead from the origin.
fn steps(x: &[f64], y: &[f64], begin: char) -> String {
    let mut d = String::new();
    for (k, (x, y)) in x.iter().zip(y).enumerate() {
        let space = |value: f64| if value < 0.0 { "" } else { " " };
        let _ = match k {
            0 => write!(d, "{begin}{x} {y}l"),
            1 => write!(d, "{x}{}{y}", space(*y)),
            _ => write!(d, "{}{x}{}{y}", space(*x), space(*y)),
        };
    }
    d
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawings_differ_by_texts_elements_numbers_and_the_extent_of_paths() {
        let of = |x: &str, d: &str, text: &str| {
            format!("<g><line x1=\"{x}\"/><path d=\"{d}\"/><text>{text}</text></g>")
        };
        let shown = of("10.0", "M10 10l5-3.2.4 4", "680 W");
        assert_eq!(difference(&shown, &shown), None);
        // Digits, and steps of a path that lead to the same places.
        assert_eq!(
            difference(&shown, &of("11.2", "M10 10l5-3.1.4 4", "680 W")),
            None
        );
        for changed in [
            of("14.0", "M10 10l5-3.2.4 4", "680 W"),
            of("10.0", "M10 10l5-7.2.4 4", "680 W"),
            of("10.0", "M10 10l5-3.2.4 4", "690 W"),
            of("10.0", "M10 10l5-3.2.4 4", "680 W") + "<g/>",
            String::new(),
        ] {
            assert!(difference(&shown, &changed).is_some(), "{changed}");
        }
    }

    #[test]
    fn the_extent_of_a_path_follows_its_steps() {
        assert_eq!(
            extent("M1 2l3-1.5.5 2L0 0Z\""),
            [0.0, 4.5, 2.375, 0.0, 2.5, 1.25]
        );
        // Half circles about a point: M, then two arcs.
        let [left, right, ..] = extent("M8 6a2 2 0 1 0 4 0a2 2 0 1 0 -4 0");
        assert_eq!([left, right], [8.0, 12.0]);
    }
}
