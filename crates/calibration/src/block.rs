//! The table `calibration` of a case, as text to paste.

use std::fmt::Write as _;

use asperity::case::CalibratedName;

use crate::result::{FittedParameter, Verdict};

/// Largest correlation that is written: a case refuses those of no distribution.
const MOST: f64 = 0.995;

/// The block of the parameters that were found; `correlations` are those of all `parameters`.
#[must_use]
pub fn block(source: &str, parameters: &[FittedParameter], correlations: &[Vec<f64>]) -> String {
    let found: Vec<(usize, &FittedParameter)> = parameters
        .iter()
        .enumerate()
        .filter(|(_, parameter)| is_told(parameter))
        .collect();
    let mut text = String::from("[calibration]\n");
    let quoted = source.replace('\\', "/").replace('"', "'");
    // Writing into a string cannot fail.
    let _ = writeln!(text, "source = \"{quoted}\"");
    for (_, parameter) in &found {
        let [value, low, high] = [parameter.value, parameter.band[0], parameter.band[1]]
            .map(|value| quantity(&parameter.key, value));
        let _ = writeln!(
            text,
            "{} = {{ value = {value}, low = {low}, high = {high} }}",
            parameter.key
        );
    }
    if found.len() > 1 {
        text.push_str("correlations = [\n");
        for (place, (i, first)) in found.iter().enumerate() {
            for (j, other) in &found[place + 1..] {
                let value = correlations[*i][*j].clamp(-MOST, MOST);
                let _ = writeln!(
                    text,
                    "  {{ between = [\"{}\", \"{}\"], value = {value:.3} }},",
                    first.key, other.key
                );
            }
        }
        text.push_str("]\n");
    }
    text
}

/// Whether a parameter goes into the block: the points find it, or leave less of its range than a case has without.
fn is_told(parameter: &FittedParameter) -> bool {
    let width = |[low, high]: [f64; 2]| (high / low).ln();
    match parameter.verdict {
        Verdict::Found => true,
        Verdict::Partly => width(parameter.band) < width(parameter.default_range),
        Verdict::NotFound => false,
    }
}

/// A value as a case has it.
fn quantity(key: &str, value: f64) -> String {
    match key {
        key if key == CalibratedName::BoundaryLayer.key() => {
            format!("\"{} nm\"", digits(1e9 * value))
        }
        key if key == CalibratedName::EyringStress.key() => {
            format!("\"{} MPa\"", digits(1e-6 * value))
        }
        _ => digits(value),
    }
}

/// Four digits.
fn digits(value: f64) -> String {
    let decimals = (3 - value.abs().log10().floor() as i32).clamp(0, 12);
    format!("{value:.*}", decimals as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity::case::CalibrationInput;

    fn found(key: &str, value: f64, verdict: Verdict) -> FittedParameter {
        FittedParameter {
            key: key.to_owned(),
            name: key.to_owned(),
            value,
            band: [0.9 * value, 1.2 * value],
            profile_band: [0.9 * value, 1.2 * value],
            is_open: [false; 2],
            profile: Vec::new(),
            bootstrap: None,
            default: value,
            default_range: [0.5 * value, 2.0 * value],
            deviation: 0.05,
            verdict,
        }
    }

    #[test]
    fn the_block_reads_back_as_the_table_of_a_case() {
        let all = [
            found("boundary_friction", 0.083_21, Verdict::Found),
            found("boundary_layer", 11.234e-9, Verdict::Partly),
            found("limiting_shear", 0.04, Verdict::NotFound),
            found("eyring_stress", 4.321e6, Verdict::Found),
        ];
        let correlations = vec![vec![-0.9; 4]; 4];
        let text = block("rig.csv \"first\"", &all, &correlations);
        let head = "gears = { teeth = [23, 68], module = \"2 mm\", face_width = \"30 mm\" }\n\
                    operation = { torque = \"100 N m\", speed = \"3000 1/min\", temperature = \"60 °C\" }\n\
                    lubricant = { oil = \"m100\" }\nsurface = { pinion = { rq = \"0.3 um\" } }\n";
        let case: asperity::CaseInput = format!("{head}{text}").parse().unwrap();
        let read: CalibrationInput = case.calibration.unwrap();
        assert_eq!(read.source.as_deref(), Some("rig.csv 'first'"));
        assert_eq!(read.boundary_friction.unwrap().value, 0.08321);
        assert!((read.boundary_layer.unwrap().low.si() - 10.11e-9).abs() < 1e-15);
        assert!(read.limiting_shear.is_none());
        assert_eq!(read.eyring_stress.unwrap().value.si(), 4.321e6);
        assert_eq!(read.correlations.unwrap().len(), 3);
    }
}
