//! A value of a fitted correlation together with every input that left the fitted range.

use serde::Serialize;

/// The value of a correlation, and its inputs outside the data it was fitted to.
///
/// Nothing is clamped silently: outside its range a correlation still returns its value, and lists the inputs
/// concerned here.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Checked<T> {
    /// The value.
    pub value: T,
    /// Inputs outside the fitted range; empty if there are none.
    pub outside: Vec<OutOfRange>,
}

impl<T> Checked<T> {
    /// A value with all inputs inside the fitted range.
    pub fn inside(value: T) -> Self {
        Self {
            value,
            outside: Vec::new(),
        }
    }

    /// Transforms the value and keeps the notes.
    pub fn map<U>(self, transform: impl FnOnce(T) -> U) -> Checked<U> {
        Checked {
            value: transform(self.value),
            outside: self.outside,
        }
    }
}

/// Treatment of an input outside the range of a correlation; it decides the code of the warning.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Treatment {
    /// The correlation is evaluated beyond its data.
    #[default]
    Extrapolated,
    /// The input, or what follows from it, is held at the end of the range.
    Held,
    /// A property of a sintered steel is extrapolated from its density.
    SinteredSteel,
}

/// One input outside the range a correlation was fitted to.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OutOfRange {
    /// Name of the input.
    pub name: &'static str,
    /// Value of the input, in `unit`.
    pub value: f64,
    /// Lower end of the fitted range.
    pub low: f64,
    /// Upper end of the fitted range.
    pub high: f64,
    /// Unit of the three numbers; `-` when they have none.
    pub unit: &'static str,
    /// The correlation, by its name.
    pub correlation: &'static str,
    /// Treatment of the input.
    #[serde(skip)]
    pub treatment: Treatment,
}

impl std::fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            name,
            value,
            low,
            high,
            unit: _,
            correlation,
            treatment: _,
        } = self;
        // Three digits, or more if they are needed to differ from the limits.
        let magnitude = value.abs().log10().floor().clamp(-9.0, 9.0) as i32;
        let at = |digits: i32| format!("{value:.*}", usize::try_from(digits).unwrap_or(0));
        let differs = |text: &String| {
            let printed: Result<f64, _> = text.parse();
            printed.is_ok_and(|printed| printed < *low || printed > *high)
        };
        let value = (2 - magnitude..12).map(at).find(differs);
        let value = value.unwrap_or_else(|| self.value.to_string());
        let range = self.limits(f64::to_string);
        let unit = self.unit_after_a_number();
        write!(
            f,
            "{name} {value}{unit} is {range}, the range of {correlation}"
        )
    }
}

impl OutOfRange {
    /// On which side of which limits the input lies, such as `outside 15 to 350 mm2/s` or, where the range has no upper
    /// end, `below 150 N/mm`; `number` writes a limit.
    ///
    /// ```
    /// use asperity_core::FittedRange;
    /// let load = FittedRange::new("load", 150.0, f64::INFINITY, "N/mm", "Schlenk");
    /// let mut outside = Vec::new();
    /// load.check(48.8, &mut outside);
    /// assert_eq!(outside[0].to_string(), "load 48.8 N/mm is below 150 N/mm, the range of Schlenk");
    /// ```
    pub fn limits(&self, number: impl Fn(&f64) -> String) -> String {
        let unit = self.unit_after_a_number();
        let low = number(&self.low);
        if self.high.is_infinite() {
            return format!("below {low}{unit}");
        }
        format!("outside {low} to {}{unit}", number(&self.high))
    }

    /// The unit with a space before it; empty if there is none.
    pub fn unit_after_a_number(&self) -> String {
        match self.unit {
            "-" => String::new(),
            unit => format!(" {unit}"),
        }
    }
}

/// The range of one input that a correlation was fitted to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedRange {
    /// Name of the input.
    pub name: &'static str,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Unit of both ends; `-` when they have none.
    pub unit: &'static str,
    /// The correlation, by its name.
    pub correlation: &'static str,
}

impl FittedRange {
    /// Makes the range `low` to `high` of the input `name` of `correlation`.
    pub const fn new(
        name: &'static str,
        low: f64,
        high: f64,
        unit: &'static str,
        correlation: &'static str,
    ) -> Self {
        Self {
            name,
            low,
            high,
            unit,
            correlation,
        }
    }

    /// Adds a note to `outside` if `value` is not within the range (NaN never is); the correlation is extrapolated.
    ///
    /// ```
    /// use asperity_core::FittedRange;
    /// let range = FittedRange::new("SRR", -0.7, 0.7, "-", "Xu");
    /// let mut outside = Vec::new();
    /// range.check(0.5, &mut outside);
    /// range.check(0.9, &mut outside);
    /// assert_eq!(outside.len(), 1);
    /// ```
    pub fn check(&self, value: f64, outside: &mut Vec<OutOfRange>) {
        self.check_as(Treatment::Extrapolated, value, outside);
    }

    /// Adds a note to `outside` if `value` is not within the range and is treated otherwise than by extrapolation.
    ///
    /// ```
    /// use asperity_core::{FittedRange, Treatment};
    /// let range = FittedRange::new("S", 0.0, 0.6, "um", "Xu");
    /// let mut outside = Vec::new();
    /// range.check_as(Treatment::Held, 0.9, &mut outside);
    /// assert_eq!(outside[0].treatment, Treatment::Held);
    /// ```
    pub fn check_as(&self, treatment: Treatment, value: f64, outside: &mut Vec<OutOfRange>) {
        if !(self.low..=self.high).contains(&value) {
            outside.push(OutOfRange {
                name: self.name,
                value,
                low: self.low,
                high: self.high,
                unit: self.unit,
                correlation: self.correlation,
                treatment,
            });
        }
    }
}
