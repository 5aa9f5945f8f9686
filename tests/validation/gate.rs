//! Gates of measurement: a value with its standard error, judged by a rule.

use std::fmt::Write as _;

/// A value with its standard error, 0 where nothing was sampled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    pub value: f64,
    pub standard_error: f64,
}

impl Estimate {
    pub const fn exact(value: f64) -> Self {
        Self {
            value,
            standard_error: 0.0,
        }
    }

    /// `self`/`other` − 1 of quantities with independent errors.
    pub fn change_to(self, other: Self) -> Self {
        let ratio = self.value / other.value;
        let relative = |of: Self| of.standard_error / of.value;
        Self {
            value: ratio - 1.0,
            standard_error: (ratio * relative(self).hypot(relative(other))).abs(),
        }
    }

    pub fn times(self, factor: f64) -> Self {
        Self {
            value: self.value * factor,
            standard_error: self.standard_error * factor.abs(),
        }
    }
}

/// Standard errors on each side of the end of a rule within which the gate is undecided: the 95 % quantile of a normal
/// distribution, so that a gate fails or passes at a one-sided level of 5 %.
const UNDECIDED: f64 = 1.65;

/// What a gate came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    Pass,
    Fail,
    Undecided,
    /// No rule: the value is printed only.
    Printed,
}

impl Verdict {
    const fn text(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Fail => "**FAIL**",
            Self::Undecided => "inconclusive",
            Self::Printed => "-",
        }
    }
}

/// The verdict on an estimate: undecided if an end of `rule`, (least, largest), lies within 1.65 standard errors of the
/// value. Ends may be infinite.
pub fn judge(found: Estimate, rule: Option<[f64; 2]>) -> Verdict {
    let Some([least, largest]) = rule else {
        return Verdict::Printed;
    };
    let is_near = |end: f64| (found.value - end).abs() < UNDECIDED * found.standard_error;
    match (least..=largest).contains(&found.value) {
        _ if is_near(least) || is_near(largest) => Verdict::Undecided,
        true => Verdict::Pass,
        false => Verdict::Fail,
    }
}

/// What the reference of a gate is, and with it what the verdict is worth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// A measurement that no constant was chosen on.
    Measured,
    /// One measurement at a temperature that is not known: rows at several temperatures count as one line.
    UnknownTemperature,
    /// A measurement that a constant was calibrated on or judged with.
    CalibratedOn,
    /// Holds by the form of the laws.
    ByConstruction,
    /// Computed by this project.
    OwnReference,
    /// Computed by the source, not measured.
    ComputedBySource,
}

impl Class {
    /// All classes; the measured ones first.
    pub const ALL: [Self; 6] = [
        Self::Measured,
        Self::UnknownTemperature,
        Self::CalibratedOn,
        Self::ComputedBySource,
        Self::ByConstruction,
        Self::OwnReference,
    ];

    /// Whether verdicts of this class count: those of measurements.
    const fn counts(self) -> bool {
        matches!(self, Self::Measured | Self::UnknownTemperature)
    }

    pub const fn text(self) -> &'static str {
        match self {
            Self::Measured => "measured",
            Self::UnknownTemperature => "measured, temperature unknown",
            Self::CalibratedOn => "calibrated on",
            Self::ByConstruction => "by construction",
            Self::OwnReference => "own reference",
            Self::ComputedBySource => "computed by the source",
        }
    }
}

/// A measurement, our value for it, and the rule that the value is judged by.
#[derive(Clone)]
pub struct Gate {
    pub class: Class,
    /// Gate and condition; distinct, without numbers that are computed.
    pub name: String,
    /// What was measured.
    pub measured: String,
    pub value: Estimate,
    /// Least and largest value; `None` if the value is only printed.
    pub rule: Option<[f64; 2]>,
    pub unit: &'static str,
    /// Decimals of the value.
    pub digits: usize,
    /// What is printed with the value.
    pub note: String,
    /// Least and largest measured value, in the unit of the gate; minus infinity if only a largest one was stated.
    pub reference: Option<[f64; 2]>,
}

impl Gate {
    /// A gate with its unit and the decimals of its value.
    pub fn new(
        class: Class,
        name: impl Into<String>,
        measured: impl Into<String>,
        value: Estimate,
        rule: Option<[f64; 2]>,
        (unit, digits): (&'static str, usize),
    ) -> Self {
        let (name, measured, note) = (name.into(), measured.into(), String::new());
        Self {
            class,
            name,
            measured,
            value,
            rule,
            unit,
            digits,
            note,
            reference: None,
        }
    }

    /// The gate with the measured range, which its picture shows.
    pub fn against(self, range: [f64; 2]) -> Self {
        let reference = Some(range);
        Self { reference, ..self }
    }

    /// `value` over the middle of the measured range, or over its end if only the largest value was stated; of changes in
    /// per cent the quotient of the changed quantities.
    pub fn over_reference(&self, value: f64) -> Option<f64> {
        let quantity = |value: f64| match self.unit {
            "%" => 100.0 + value,
            _ => value,
        };
        let [low, high] = self.reference?.map(quantity);
        let middle = if low.is_finite() {
            0.5 * (low + high)
        } else {
            high
        };
        Some(quantity(value) / middle)
    }

    pub fn noted(self, note: String) -> Self {
        Self { note, ..self }
    }

    pub fn verdict(&self) -> Verdict {
        judge(self.value, self.rule)
    }

    /// The value; what rounds to nothing is nothing, on every processor.
    fn number_text(&self) -> String {
        let digits = self.digits;
        let value = format!("{:.digits$}", self.value.value);
        if value.trim_start_matches(['-', '0', '.']).is_empty() {
            value.trim_start_matches('-').to_owned()
        } else {
            value
        }
    }

    /// The standard error; `None` if nothing was sampled.
    fn error_text(&self) -> Option<String> {
        let digits = self.digits;
        let last_digit = 10f64.powi(-(digits as i32));
        match self.value.standard_error {
            0.0 => None,
            error if error < 0.5 * last_digit => Some(format!("< {last_digit:.digits$}")),
            error => Some(format!("{error:.digits$}")),
        }
    }

    fn rule_text(&self) -> String {
        let text = |end: f64| format!("{end:.*}", self.rule_digits());
        match self.rule {
            None => "printed only".to_owned(),
            Some([f64::NEG_INFINITY, largest]) => format!("at most {}", text(largest)),
            Some([least, f64::INFINITY]) => format!("at least {}", text(least)),
            Some([least, largest]) => format!("{} to {}", text(least), text(largest)),
        }
    }

    /// Decimals of the ends, without zeros at the end.
    fn rule_digits(&self) -> usize {
        let ends = self
            .rule
            .into_iter()
            .flatten()
            .filter(|end| end.is_finite());
        let ends: Vec<f64> = ends.collect();
        let is_whole = |digits: &usize| {
            let steps = 10f64.powi(*digits as i32);
            ends.iter()
                .all(|end| (end * steps - (end * steps).round()).abs() < 1e-9)
        };
        (0..self.digits).find(is_whole).unwrap_or(self.digits)
    }
}

/// The gates that count as Markdown: measurements with a rule.
pub fn table(gates: &[Gate]) -> String {
    let mut text =
        String::from("| gate | reference | rule | here | verdict |\n|---|---|---|---|---|\n");
    let counts = |gate: &&Gate| gate.class.counts() && gate.rule.is_some();
    for gate in gates.iter().filter(counts) {
        let unit = match gate.unit {
            "-" => String::new(),
            unit => format!(" {unit}"),
        };
        let error = gate.error_text().map(|error| format!(" ± {error}"));
        let _ = writeln!(
            text,
            "| {} | {} | {}{unit} | {}{}{} | {} |",
            gate.name,
            gate.measured,
            gate.rule_text(),
            gate.number_text(),
            error.unwrap_or_default(),
            gate.note,
            gate.verdict().text()
        );
    }
    text
}

/// All gates, those that do not count with the reason.
pub fn whole_table(gates: &[Gate]) -> String {
    let mut text = String::from(
        "| gate | reference | class | rule | unit | here | standard error | verdict | remarks |\n|---|---|---|---|---|---|---|---|---|\n",
    );
    for gate in gates {
        let remark = REMARKS.iter().find(|(of, _)| gate.name.starts_with(of));
        let remark = remark.map_or("", |(_, remark)| remark);
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {}{} | {} | {} | {remark} |",
            gate.name,
            gate.measured,
            gate.class.text(),
            gate.rule_text(),
            gate.unit,
            gate.number_text(),
            gate.note,
            gate.error_text().unwrap_or_else(|| "-".to_owned()),
            gate.verdict().text()
        );
    }
    text
}

/// What is to be known of gates that do not count, by the beginnings of their names.
const REMARKS: [(&str, &str); 5] = [
    (
        "T2 ",
        "the Eyring stress of polyalphaolefin was fitted to these losses, with flanks at the 110 °C of the oil; bulk temperatures of the \
         loss with assumed conductances",
    ),
    (
        "T5 ",
        "cannot fail: the limiting shear stress bounds the friction of a film",
    ),
    (
        "T14 ",
        "bounds the wear coefficient; ISO does not state the engagements, and teeth that meet early are not in the model",
    ),
    (
        "T6 ",
        "the limiting shear of ester and polyglycol was assumed with the ratios known",
    ),
    (
        "T9 ",
        "over the same windows; above σ_d/h_c of 3 not a reference, as oil cannot leak around ridges; only the last row has six with smooth \
         thin films, whose loads below 20 and 50 nm differ by more than 0.15",
    ),
];

#[test]
fn a_gate_is_undecided_where_an_end_of_its_rule_lies_within_1_65_standard_errors() {
    let of = |value, standard_error| {
        let found = Estimate {
            value,
            standard_error,
        };
        judge(found, Some([0.055, 0.068]))
    };
    assert_eq!(of(0.060, 0.001), Verdict::Pass);
    assert_eq!(of(0.050, 0.001), Verdict::Fail);
    assert_eq!(of(0.070, 0.001), Verdict::Fail);
    // The ends of the band of 1.65 standard errors, on both sides of both ends of the rule.
    for (value, verdict) in [
        (0.055 - 0.00166, Verdict::Fail),
        (0.055 - 0.00164, Verdict::Undecided),
        (0.055 + 0.00164, Verdict::Undecided),
        (0.055 + 0.00166, Verdict::Pass),
        (0.068 - 0.00166, Verdict::Pass),
        (0.068 - 0.00164, Verdict::Undecided),
        (0.068 + 0.00164, Verdict::Undecided),
        (0.068 + 0.00166, Verdict::Fail),
    ] {
        assert_eq!(of(value, 0.001), verdict, "{value}");
    }
    // Without an error the rule alone decides, its ends included.
    assert_eq!(of(0.055, 0.0), Verdict::Pass);
    assert_eq!(of(0.0549, 0.0), Verdict::Fail);
    let one_sided = Some([f64::NEG_INFINITY, 0.04]);
    assert_eq!(judge(Estimate::exact(-3.0), one_sided), Verdict::Pass);
    assert_eq!(judge(Estimate::exact(0.05), one_sided), Verdict::Fail);
    assert_eq!(judge(Estimate::exact(0.05), None), Verdict::Printed);
}

#[test]
fn values_are_compared_with_the_middle_or_the_end_of_the_measured_range() {
    let gate = |unit| {
        Gate::new(
            Class::Measured,
            "",
            "",
            Estimate::exact(0.0),
            None,
            (unit, 0),
        )
    };
    assert_eq!(gate("W").over_reference(150.0), None);
    // A fall by 44 % where 30 % was measured leaves 56 of 70.
    for (unit, range, value) in [
        ("W", [100.0, 200.0], 120.0),
        ("-", [f64::NEG_INFINITY, 0.05], 0.04),
        ("%", [-30.0, -30.0], -44.0),
    ] {
        let ratio = gate(unit).against(range).over_reference(value);
        assert!((ratio.unwrap() - 0.8).abs() < 1e-12, "{unit}: {ratio:?}");
    }
}

#[test]
fn errors_of_independent_quantities_add_in_squares() {
    let of = |value, standard_error| Estimate {
        value,
        standard_error,
    };
    let change = of(60.0, 1.8).change_to(of(100.0, 4.0));
    assert!((change.value + 0.4).abs() < 1e-15);
    assert!((change.standard_error - 0.6 * 0.05).abs() < 1e-15);
}
