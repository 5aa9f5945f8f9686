//! Formatted loss of a mesh and its parts: the printed parts add up to the printed loss.

use asperity::result::gearbox::GearboxReport;
use asperity::result::loss_band::{Digits, Uncertainty, with_interval};
use asperity::result::{RunResult, Summary};

/// Loss and its parts as text with units.
pub(crate) struct PrintedLoss {
    pub loss: String,
    /// Film, lubricated asperities, boundary layer and rolling; deformation where it matters.
    pub parts: Vec<PrintedPart>,
    /// Lubricated asperities and boundary layer together.
    pub asperities: String,
    /// Boundary layer, with its interval if it is drawn.
    pub boundary: String,
    /// Share of lubricated asperities and boundary layer together, the sum of their printed shares.
    pub asperity_share: Option<String>,
}

/// Part of a loss.
pub(crate) struct PrintedPart {
    pub name: &'static str,
    /// Key in `result.json`.
    pub key: &'static str,
    /// The part \[W\].
    pub watts: f64,
    pub text: String,
    /// Share of the loss as printed.
    pub share: String,
}

impl PrintedLoss {
    /// The loss and its parts with the digits that the interval leaves; three or four digits without uncertainty.
    pub(crate) fn new(s: &Summary, uncertainty: Option<&Uncertainty>) -> Self {
        let powers = Powers {
            digits: uncertainty.map_or_else(|| Digits::of_power(s.loss_w), Uncertainty::digits),
            is_banded: uncertainty.is_some(),
            is_in_kilowatts: uncertainty.is_none() && s.loss_w >= KILOWATTS_FROM,
        };
        let loss = powers.digits.steps(s.loss_w);
        let [pinion, wheel] = s.deformation_w;
        let of_mesh = [s.sliding_w, s.rolling_w, pinion, wheel];
        let steps = powers.digits.parts(loss, &of_mesh);
        let of_sliding = [s.film_w, s.lubricated_asperity_w, s.boundary_w];
        let in_sliding = powers.digits.parts(steps[0], &of_sliding);
        let all = of_sliding.into_iter().chain(of_mesh.into_iter().skip(1));
        let all: Vec<f64> = all.collect();
        let places = [&in_sliding, &steps[1..]].concat();
        let shares = powers.digits.shares(&places, &all);
        let numbers = all.into_iter().zip(places).zip(shares.iter());
        let parts = PARTS.iter().zip(numbers).enumerate();
        let matters = |number: usize, watts: f64| number < ALWAYS || watts > NAMED * s.loss_w;
        let boundary = powers.text(s.boundary_w, in_sliding[2]);
        let of_asperities = s.lubricated_asperity_w + s.boundary_w;
        let interval = uncertainty.and_then(|uncertainty| uncertainty.boundary_w);
        Self {
            loss: powers.text(s.loss_w, loss),
            asperities: powers.text(of_asperities, in_sliding[1] + in_sliding[2]),
            asperity_share: sum_of(&shares[1..3]),
            boundary: match (interval, boundary.strip_suffix(" W")) {
                (Some(ends), Some(number))
                    if powers.digits.rounded(ends[0]) != powers.digits.rounded(ends[1]) =>
                {
                    format!("{number} ({}) W", powers.digits.range(ends))
                }
                _ => boundary,
            },
            parts: parts
                .filter(|(number, (_, ((watts, _), _)))| matters(*number, *watts))
                .map(|(_, ((name, key), ((watts, place), share)))| PrintedPart {
                    name,
                    key,
                    watts,
                    text: powers.text(watts, place),
                    share: format!("{share} %"),
                })
                .collect(),
        }
    }
}

/// The sum of shares as text, without those that are only bounded; `None` if all are.
fn sum_of(shares: &[String]) -> Option<String> {
    let decimals = shares.iter().filter_map(|share| share.split_once('.'));
    let decimals = decimals.map(|(_, digits)| digits.len()).max().unwrap_or(0);
    let known = shares.iter().filter_map(|share| share.parse::<f64>().ok());
    let sum = known.reduce(|a, b| a + b)?;
    Some(format!("{sum:.decimals$} %"))
}

/// Parts of the loss of a mesh: name, watts and text, which add up to the printed loss.
pub fn parts_of(result: &RunResult) -> impl Iterator<Item = (&'static str, f64, String)> {
    let uncertainty = result.uncertainty.as_ref();
    let printed = PrintedLoss::new(&result.summary, uncertainty);
    let parts = printed.parts.into_iter();
    parts.map(|part| (part.name, part.watts, part.text))
}

/// Names of the two parts of the friction of asperities.
pub(crate) const LUBRICATED: &str = "lubricated asperities";
pub(crate) const BOUNDARY: &str = "boundary layer";
/// Names of the parts and their keys in `result.json`.
const PARTS: [(&str, &str); 6] = [
    ("film", "summary.film_w"),
    (LUBRICATED, "summary.lubricated_asperity_w"),
    (BOUNDARY, "summary.boundary_w"),
    ("rolling", "summary.rolling_w"),
    ("deformation of the pinion", "summary.deformation_w"),
    ("deformation of the wheel", "summary.deformation_w"),
];
/// Number of parts that every loss has.
const ALWAYS: usize = 4;
/// Share of the loss from which the other parts are named.
const NAMED: f64 = 1e-3;

/// Units of a loss and of an efficiency.
const UNITS: [&str; 2] = [" W", " %"];

/// Loss and efficiency of the mesh, with their intervals if the run has an uncertainty.
pub(crate) fn of_mesh(result: &RunResult) -> [String; 2] {
    let s = &result.summary;
    match &result.uncertainty {
        Some(uncertainty) => with_interval(uncertainty.loss.drawn(), s.power_in_w, UNITS),
        None => [
            PrintedLoss::new(s, None).loss,
            format!("{:.4} %", 100.0 * s.efficiency),
        ],
    }
}

/// Loss and efficiency of the gearbox with the intervals that the mesh leaves.
pub(crate) fn gearbox_with_interval(gearbox: &GearboxReport, of_mesh: &Uncertainty) -> [String; 2] {
    let drawn_w = gearbox.drawn_w(of_mesh.loss.drawn());
    with_interval(drawn_w, gearbox.power_in_w, UNITS)
}

/// Power from which losses are printed in kW \[W\].
const KILOWATTS_FROM: f64 = 10_000.0;

/// A power with three or four significant digits.
pub(crate) fn watts(power: f64) -> String {
    if power > 0.0 && power < 0.1 {
        return format!("{power:.1e} W");
    }
    let powers = Powers {
        digits: Digits::of_power(power),
        is_banded: false,
        is_in_kilowatts: power >= KILOWATTS_FROM,
    };
    powers.text(power, powers.digits.steps(power))
}

/// Powers printed with the same last place.
struct Powers {
    digits: Digits,
    /// Whether the digits follow from a band.
    is_banded: bool,
    is_in_kilowatts: bool,
}

impl Powers {
    fn text(&self, power: f64, steps: f64) -> String {
        match (steps == 0.0, power > 0.0) {
            (true, true) if self.is_banded => format!("< {} W", self.digits.last_place()),
            (true, true) => format!("{power:.1e} W"),
            (true, false) => "0 W".to_owned(),
            _ if self.is_in_kilowatts => {
                // Steps of 10 W.
                format!("{} kW", Digits::of_decimals(2).text(steps))
            }
            _ => format!("{} W", self.digits.text(steps)),
        }
    }
}

/// A duration: below two hours in minutes, unless it is an hour.
///
/// ```
/// use asperity_report::duration;
/// assert_eq!([18.6, 60.0, 85.0, 372.0].map(duration), ["19 min", "1 h", "85 min", "6.2 h"]);
/// ```
pub fn duration(minutes: f64) -> String {
    if minutes < 120.0 && minutes.round() != 60.0 {
        format!("{minutes:.0} min")
    } else {
        format!("{} h", (minutes / 6.0).round() / 10.0)
    }
}

/// An input power with three digits.
pub fn stated(power: f64) -> String {
    let digits = stated_digits(power);
    format!("{} W", digits.text(digits.steps(power)))
}

/// Input powers with the last place of their sum, to which the printed powers add up.
///
/// ```
/// use asperity_report::stated_parts;
/// assert_eq!(stated_parts(&[36.912, 6.2149]), ["36.9 W", "6.2 W"]);
/// assert_eq!(stated_parts(&[10.04, 10.03, 0.06]), ["10.0 W", "10.0 W", "0.1 W"]);
/// ```
pub fn stated_parts(powers: &[f64]) -> Vec<String> {
    let total: f64 = powers.iter().sum();
    let digits = stated_digits(total);
    let steps = digits.parts(digits.steps(total), powers);
    let texts = steps.into_iter().map(|steps| digits.text(steps));
    texts.map(|text| format!("{text} W")).collect()
}

fn stated_digits(power: f64) -> Digits {
    Digits::of_decimals(match power.abs() {
        0.0 => 0,
        size => (2 - size.log10().floor() as i32).clamp(0, 6),
    })
}
