//! Axes: range, ticks and labels.

use asperity_core::numerics::range;
use serde::Serialize;

/// Scale of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scale {
    /// Equal steps.
    #[default]
    Linear,
    /// Equal ratios; only positive values are shown.
    Log,
}

/// Axis without its range.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Axis {
    /// Quantity along the axis.
    pub label: String,
    /// Its unit; empty for a pure number.
    pub unit: String,
    /// Scale.
    pub scale: Scale,
    /// Whether the range includes zero.
    pub zero: bool,
    /// Whether values increase downwards, for depths.
    pub downward: bool,
    /// Fixed range instead of the range of the data.
    pub limits: Option<[f64; 2]>,
    /// Whether all charts of a page over this axis share a cursor.
    pub is_shared: bool,
}

impl Axis {
    /// Linear axis.
    pub fn new(label: &str, unit: &str) -> Self {
        Self {
            label: label.to_owned(),
            unit: unit.to_owned(),
            ..Self::default()
        }
    }

    /// Includes zero in the range.
    pub fn from_zero(mut self) -> Self {
        self.zero = true;
        self
    }

    /// Makes the axis logarithmic.
    pub fn log(mut self) -> Self {
        self.scale = Scale::Log;
        self
    }

    /// Makes values increase downwards.
    pub fn downward(mut self) -> Self {
        self.downward = true;
        self
    }

    /// Sets a fixed range.
    pub fn within(mut self, low: f64, high: f64) -> Self {
        self.limits = Some([low, high]);
        self
    }

    /// Shares a cursor among all charts of a page over this axis.
    pub fn shared(mut self) -> Self {
        self.is_shared = true;
        self
    }

    /// Whether `value` is within the limits of the axis.
    pub(super) fn shows(&self, value: f64) -> bool {
        self.limits
            .is_none_or(|[low, high]| (low..=high).contains(&value))
    }

    /// Label with unit.
    pub fn text(&self) -> String {
        if self.unit.is_empty() {
            self.label.clone()
        } else {
            format!("{} [{}]", self.label, self.unit)
        }
    }

    /// Range of all `values`, with a margin unless zero is the edge.
    pub(super) fn range(&self, values: impl Iterator<Item = f64>) -> Range {
        /// Margin of the data, relative to the range.
        const MARGIN: f64 = 0.04;
        if let Some([low, high]) = self.limits {
            return Range {
                low,
                high,
                scale: self.scale,
            };
        }
        let shown = values.filter(|v| v.is_finite() && (self.scale == Scale::Linear || *v > 0.0));
        let [mut low, mut high] = range(shown);
        if low > high {
            (low, high) = (if self.scale == Scale::Log { 0.1 } else { 0.0 }, 1.0);
        }
        if self.scale == Scale::Log {
            let (a, b) = (low.log10().floor(), high.log10().ceil());
            let high = if b > a { b } else { a + 1.0 };
            return Range {
                low: 10f64.powf(a),
                high: 10f64.powf(high),
                scale: Scale::Log,
            };
        }
        if self.zero {
            (low, high) = (low.min(0.0), high.max(0.0));
        }
        // Values that differ by round-off are one.
        if high - low <= EDGE * low.abs().max(high.abs()) {
            let half = if low == 0.0 { 1.0 } else { 0.5 * low.abs() };
            (low, high) = if self.zero {
                (low.min(0.0), low + half)
            } else {
                (low - half, high + half)
            };
        }
        let air = MARGIN * (high - low);
        // Zero within round-off is an edge too.
        let is_edge = |end: f64| self.zero && end.abs() < EDGE * air;
        low = if is_edge(low) { 0.0 } else { low - air };
        high = if is_edge(high) { 0.0 } else { high + air };
        Range {
            low,
            high,
            scale: Scale::Linear,
        }
    }
}

/// Visible range of an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range {
    pub low: f64,
    pub high: f64,
    pub scale: Scale,
}

impl Range {
    /// Position of `value` on the axis, 0 at the low end and 1 at the high end.
    pub fn share(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => (value - self.low) / (self.high - self.low),
            Scale::Log => (value / self.low).ln() / (self.high / self.low).ln(),
        }
    }

    /// About `count` ticks at round numbers, with their labels.
    pub fn ticks(&self, count: usize) -> Vec<(f64, String)> {
        match self.scale {
            Scale::Linear => round_ticks([self.low, self.high], count),
            Scale::Log => log_ticks(self.low, self.high, count),
        }
    }
}

/// Rounding of a tick at the edge of the range.
const EDGE: f64 = 1e-9;

/// About `count` round numbers from `low` to `high`, with their labels.
pub(crate) fn round_ticks([low, high]: [f64; 2], count: usize) -> Vec<(f64, String)> {
    let raw = (high - low) / count.max(1) as f64;
    let power = 10f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|factor| factor * power)
        .find(|step| *step >= raw * (1.0 - EDGE))
        .unwrap_or(10.0 * power);
    let first = (low / step - EDGE).ceil();
    let last = (high / step + EDGE).floor();
    let decimals = (-step.log10().floor()).max(0.0) as usize;
    let large = low.abs().max(high.abs());
    let mut ticks = Vec::new();
    let mut k = first;
    while k <= last {
        let value = k * step;
        let label = if !(1e-4..1e6).contains(&large) {
            format!("{value:.1e}")
        } else {
            minus(&format!(
                "{:.decimals$}",
                if k == 0.0 { 0.0 } else { value }
            ))
        };
        ticks.push((value, label));
        k += 1.0;
    }
    ticks
}

/// Powers of ten that are written out where all of an axis are among them.
const PLAIN: std::ops::RangeInclusive<i32> = -3..=4;

fn log_ticks(low: f64, high: f64, count: usize) -> Vec<(f64, String)> {
    let (a, b) = (
        (low.log10() - EDGE).ceil() as i32,
        (high.log10() + EDGE).floor() as i32,
    );
    let stride = ((b - a + 1) as usize).div_ceil(count.max(1)).max(1);
    let is_plain = PLAIN.contains(&a) && PLAIN.contains(&b);
    let label = |power: i32| {
        if is_plain {
            format!(
                "{:.*}",
                power.min(0).unsigned_abs() as usize,
                10f64.powi(power)
            )
        } else {
            power_of_ten(power)
        }
    };
    (a..=b)
        .step_by(stride)
        .map(|power| (10f64.powi(power), label(power)))
        .collect()
}

/// A power of ten with raised digits, such as 10⁻³.
fn power_of_ten(power: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = power.unsigned_abs().to_string();
    let raised = digits
        .bytes()
        .map(|digit| RAISED[usize::from(digit - b'0')]);
    let sign = if power < 0 { "⁻" } else { "" };
    format!("10{sign}{}", raised.collect::<String>())
}

/// Text with minus signs instead of hyphens.
fn minus(text: &str) -> String {
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_stand_at_round_numbers_inside_the_range() {
        let range = Range {
            low: -0.07,
            high: 1.03,
            scale: Scale::Linear,
        };
        let labels: Vec<String> = range.ticks(6).into_iter().map(|(_, label)| label).collect();
        assert_eq!(labels, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
    }

    #[test]
    fn log_axes_show_whole_decades() {
        let range = Axis::new("error", "").log().range([3e-3, 0.7].into_iter());
        assert_eq!((range.low, range.high), (1e-3, 1.0));
        let labels: Vec<String> = range.ticks(6).into_iter().map(|(_, label)| label).collect();
        assert_eq!(labels, ["0.001", "0.01", "0.1", "1"]);
        let labels = |ends: [f64; 2]| -> Vec<String> {
            let range = Axis::new("error", "").log().range(ends.into_iter());
            range.ticks(6).into_iter().map(|(_, label)| label).collect()
        };
        assert_eq!(labels([2.0, 700.0]), ["1", "10", "100", "1000"]);
        assert_eq!(labels([1e-4, 0.7])[..2], ["10⁻⁴", "10⁻³"]);
        assert!((range.share(1e-2) - 1.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn an_axis_from_zero_keeps_zero_at_its_edge() {
        let range = Axis::new("loss", "W")
            .from_zero()
            .range([3.0, 5.0].into_iter());
        assert_eq!(range.low, 0.0);
        assert!(range.high > 5.0);
    }

    #[test]
    fn a_range_without_extent_is_still_drawn() {
        for value in [0.0, 143.8, -2.0] {
            let range = Axis::new("load", "N").range([value].into_iter());
            assert!(range.low < value && value < range.high);
            assert!(!range.ticks(5).is_empty());
        }
        let of_round_off = Axis::new("temperature", "°C").range([90.0, 90.0 + 1e-13].into_iter());
        assert!(of_round_off.high - of_round_off.low > 1.0);
    }
}
