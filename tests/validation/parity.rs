//! Picture of the gates of measurement: computed over measured values, with standard errors and the ranges that pass.

use std::fmt::Write as _;

use asperity_tests::picture::{document, hold_picture};

use crate::gate::{Class, Gate, Verdict};
use crate::gates::gates;

/// Width of the drawing, whose letters can be read at 400 pixels, and the left and right end of its axis.
const WIDTH: f64 = 440.0;
const ENDS: [f64; 2] = [14.0, 392.0];
/// Values at the ends of the axis.
const RANGE: [f64; 2] = [0.2, 1.8];
/// Height of a gate with its name above its bars, of a heading, and of the widest bar; the top of the first.
const ROW: f64 = 28.0;
const HEADING: f64 = 24.0;
const THICK: f64 = 12.0;
const TOP: f64 = 88.0;
/// Standard errors on each side of a value that make its 90 % interval.
const NINETY_PERCENT: f64 = 1.645;

fn x(ratio: f64) -> f64 {
    let share = (ratio.clamp(RANGE[0], RANGE[1]) - RANGE[0]) / (RANGE[1] - RANGE[0]);
    ENDS[0] + share * (ENDS[1] - ENDS[0])
}

/// Colour of a verdict and its name in the legend.
const VERDICTS: [(Verdict, &str, &str); 4] = [
    (Verdict::Pass, "c2", "passes"),
    (Verdict::Undecided, "c4", "inconclusive"),
    (Verdict::Fail, "c1", "fails"),
    (Verdict::Printed, "c3", "no rule"),
];

fn colour(verdict: Verdict) -> &'static str {
    let mut all = VERDICTS.iter();
    all.find(|(of, ..)| *of == verdict).map_or("c3", |of| of.1)
}

fn bar(text: &mut String, class: &str, ends: [f64; 2], y: f64, height: f64) {
    let [left, right] = ends.map(x);
    let (wide, top) = ((right - left).max(2.0), y - 0.5 * height);
    let _ = write!(
        text,
        "<rect class=\"{class}\" x=\"{left:.1}\" y=\"{top:.1}\" width=\"{wide:.1}\" height=\"{height}\"/>"
    );
}

fn dot(text: &mut String, class: &str, at: f64, y: f64) {
    let left = at - 4.0;
    let _ = write!(
        text,
        "<path class=\"scatter {class}\" d=\"M{left:.1} {y}a4 4 0 1 0 8 0a4 4 0 1 0 -8 0\"/>"
    );
}

fn label(text: &mut String, class: &str, [at, y]: [f64; 2], anchor: &str, words: &str) {
    let words = words.replace('&', "&amp;").replace('<', "&lt;");
    let _ = write!(
        text,
        "<text class=\"{class}\" x=\"{at:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{words}</text>"
    );
}

/// A gate from `top` on; nothing if no value was measured.
fn row(text: &mut String, gate: &Gate, top: f64) {
    let y = top + 20.0;
    let ratio = |value: f64| gate.over_reference(value);
    let (Some(value), Some(measured)) = (ratio(gate.value.value), gate.reference) else {
        return;
    };
    let ends = |range: [f64; 2]| range.map(|end| ratio(end).unwrap_or(f64::NAN));
    if let Some(rule) = gate.rule {
        bar(text, "area about c0", ends(rule), y, THICK);
    }
    bar(text, "area c0", ends(measured), y, 5.0);
    let class = colour(gate.verdict());
    let spread = NINETY_PERCENT * gate.value.standard_error;
    let [low, high] = ends([gate.value.value - spread, gate.value.value + spread]).map(x);
    let _ = write!(
        text,
        "<path class=\"curve {class}\" d=\"M{low:.1} {y}L{high:.1} {y}\"/>"
    );
    dot(text, class, x(value), y);
    label(text, "letter", [ENDS[0], top + 9.0], "start", &gate.name);
    let number = format!("{value:.2}");
    label(text, "letter", [WIDTH - 10.0, y + 4.0], "end", &number);
}

/// A line of the drawing.
enum Shown<'a> {
    Heading(Class),
    Row(&'a Gate),
}

impl Shown<'_> {
    const fn height(&self) -> f64 {
        match self {
            Self::Heading(_) => HEADING,
            Self::Row(_) => ROW,
        }
    }
}

/// The drawing.
fn picture(gates: &[Gate]) -> String {
    let mut shown: Vec<Shown<'_>> = Vec::new();
    for class in Class::ALL {
        let of_class = |gate: &&Gate| gate.class == class && gate.reference.is_some();
        let mut rows = gates.iter().filter(of_class).peekable();
        if rows.peek().is_some() {
            shown.push(Shown::Heading(class));
            shown.extend(rows.map(Shown::Row));
        }
    }
    let bottom = TOP + shown.iter().map(Shown::height).sum::<f64>();
    let mut text = String::new();
    let title = "Computed over measured, at the defaults of the program";
    label(&mut text, "title", [10.0, 20.0], "start", title);
    let mut at = 14.0;
    for (_, class, name) in VERDICTS {
        dot(&mut text, class, at, 42.0);
        label(&mut text, "letter", [at + 8.0, 46.0], "start", name);
        at += 88.0;
    }
    at = 10.0;
    for (class, name, height) in [
        ("area c0", "measured range", 5.0),
        ("area about c0", "range that passes", THICK),
    ] {
        let top = 62.0 - 0.5 * height;
        let _ = write!(
            text,
            "<rect class=\"{class}\" x=\"{at:.1}\" y=\"{top}\" width=\"24\" height=\"{height}\"/>"
        );
        label(&mut text, "letter", [at + 30.0, 66.0], "start", name);
        at += 138.0;
    }
    label(
        &mut text,
        "letter",
        [at, 66.0],
        "start",
        "lines: 90 % by sampling",
    );
    for tick in [0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75] {
        let (class, at) = (if tick == 1.0 { "axis" } else { "grid" }, x(tick));
        let _ = write!(
            text,
            "<line class=\"{class}\" x1=\"{at:.1}\" y1=\"{:.1}\" x2=\"{at:.1}\" y2=\"{bottom:.1}\"/>",
            TOP - 8.0
        );
        label(
            &mut text,
            "tick",
            [at, bottom + 16.0],
            "middle",
            &tick.to_string(),
        );
    }
    let mut top = TOP;
    for shown in &shown {
        match shown {
            Shown::Row(gate) => row(&mut text, gate, top),
            Shown::Heading(class) => {
                let place = [10.0, top + 17.0];
                label(&mut text, "name", place, "start", class.text());
            }
        }
        top += shown.height();
    }
    let name = "computed over the middle, or over the stated limit, of the measured range";
    label(
        &mut text,
        "name",
        [0.5 * WIDTH, bottom + 36.0],
        "middle",
        name,
    );
    document("curve-chart", title, [WIDTH, bottom + 46.0], &text)
}

/// The measured gates by verdict in words, and those at an unknown temperature, which are one measurement.
pub fn count() -> String {
    let number = |class, verdict| {
        let of_class = gates().iter().filter(|gate| gate.class == class);
        of_class.filter(|gate| gate.verdict() == verdict).count()
    };
    let verdicts = [Verdict::Pass, Verdict::Undecided, Verdict::Fail];
    let [pass, undecided, fail] = verdicts.map(|verdict| number(Class::Measured, verdict));
    let words = ["agrees", "is inconclusive", "misses"];
    let at_temperatures = verdicts.map(|verdict| number(Class::UnknownTemperature, verdict));
    let temperatures: usize = at_temperatures.iter().sum();
    let of_unknown = words.iter().zip(at_temperatures);
    let of_unknown = of_unknown.filter(|(_, count)| *count > 0);
    let of_unknown = of_unknown
        .map(|(word, count)| format!("{word} at {count} of {temperatures} plausible temperatures"));
    format!(
        "Of {} measured results the model agrees with {pass} and misses {fail}; {undecided} are inconclusive within the sampling error of the flanks. \
         One more (T3), at an unknown temperature, {}.\n",
        pass + undecided + fail,
        of_unknown.collect::<Vec<_>>().join(", ")
    )
}

#[test]
fn the_picture_of_the_gates_is_drawn() {
    hold_picture("figures/gates.svg", &picture(gates()));
    // Values beyond the axis would be drawn at its end.
    for gate in gates() {
        let ratio = gate.over_reference(gate.value.value);
        let is_inside = ratio.is_none_or(|ratio| (RANGE[0]..=RANGE[1]).contains(&ratio));
        assert!(is_inside, "{}: {ratio:?}", gate.name);
    }
}
