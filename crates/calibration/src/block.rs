//! The table `calibration` of a case file, as text.

use asperity_core::Estimate;
use std::fmt::Write as _;

use nalgebra::DMatrix;

use crate::result::{FittedParameter, Verdict};
use crate::summary::unit_of;

/// Factors on the correlations. The first one is used for which the rounded correlations are positive definite: a case
/// rejects contradictory correlations.
const FACTORS: [f64; 5] = [1.0, 0.995, 0.99, 0.97, 0.9];
/// Square of the smallest pivot of such correlations.
const LEAST_PIVOT: f64 = 1e-3;

/// Writes the block of the identified parameters, fitted to measurements `source` or to simulated ones; `correlations` are
/// between all `parameters`.
#[must_use]
pub fn block(
    source: &str,
    is_simulated: bool,
    parameters: &[FittedParameter],
    correlations: &[Vec<f64>],
) -> String {
    let included: Vec<(usize, &FittedParameter)> = parameters
        .iter()
        .enumerate()
        .filter(|(_, parameter)| is_identified(parameter))
        .collect();
    let mut text = origin(source, is_simulated);
    for (_, parameter) in &included {
        let written = Estimate::new(parameter.fitted.value, parameter.band);
        text.push_str(&constant(&parameter.key, written));
        text.push('\n');
    }
    let numbers: Vec<usize> = included.iter().map(|(number, _)| *number).collect();
    let written = rounded(&numbers, correlations);
    if included.len() > 1 {
        text.push_str("correlations = [\n");
        for (i, (_, first)) in included.iter().enumerate() {
            for (j, (_, other)) in included.iter().enumerate().skip(i + 1) {
                let value = written[(i, j)];
                // Writing into a string cannot fail.
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

/// First lines of the table: the measurements, and whether they were simulated.
pub(crate) fn origin(source: &str, is_simulated: bool) -> String {
    let simulated = if is_simulated {
        "simulated = true\n"
    } else {
        ""
    };
    format!("[calibration]\nsource = {}\n{simulated}", quoted(source))
}

/// A constant with its 2.5 % and 97.5 % quantile.
pub(crate) fn constant(key: &str, Estimate { value, low, high }: Estimate) -> String {
    let [value, low, high] = [value, low, high].map(|value| quantity(key, value));
    format!("{key} = {{ value = {value}, low = {low}, high = {high} }}")
}

/// A text in quotation marks, with other marks instead of those that TOML does not take there.
pub(crate) fn quoted(source: &str) -> String {
    let plain = |letter: char| match letter {
        '\\' => '/',
        '"' => '\'',
        letter if letter.is_control() => ' ',
        letter => letter,
    };
    format!("\"{}\"", source.chars().map(plain).collect::<String>())
}

/// Correlations of the parameters `numbers`, rounded as in the block.
pub(crate) fn rounded(numbers: &[usize], correlations: &[Vec<f64>]) -> DMatrix<f64> {
    /// Steps per unit of a written correlation.
    const STEPS: f64 = 1000.0;
    let count = numbers.len();
    let scaled = |factor: f64| {
        DMatrix::from_fn(count, count, |i, j| match i == j {
            true => 1.0,
            // A zero is added so that no negative zero is written.
            false => (STEPS * factor * correlations[numbers[i]][numbers[j]]).round() / STEPS + 0.0,
        })
    };
    let holds = |matrix: &DMatrix<f64>| {
        let pivots = matrix
            .clone()
            .cholesky()
            .map(|factor| factor.l().diagonal().map(|d| d * d).min());
        pivots.is_some_and(|least| least > LEAST_PIVOT)
    };
    let mut tried = FACTORS.into_iter().map(scaled);
    tried
        .find(holds)
        .unwrap_or_else(|| DMatrix::identity(count, count))
}

/// Whether a parameter is written: the points identify it, if only in part, and narrow its range of a case without
/// calibration.
fn is_identified(parameter: &FittedParameter) -> bool {
    parameter.verdict != Verdict::NotIdentified && is_narrower(parameter.fitted, parameter.default)
}

/// Whether the ratio of the ends of `fitted` is smaller than of `before`.
pub(crate) fn is_narrower(fitted: Estimate, before: Estimate) -> bool {
    fitted.log_width() < before.log_width()
}

/// A value in the unit of a case file.
fn quantity(key: &str, value: f64) -> String {
    match unit_of(key) {
        ("", _) => digits(value),
        (unit, factor) => format!("\"{} {unit}\"", digits(factor * value)),
    }
}

/// A number with four digits.
pub(crate) fn digits(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let decimals = (3 - value.abs().log10().floor() as i32).clamp(0, 12);
    format!("{value:.*}", decimals as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity::case::CalibrationInput;

    fn fitted(key: &str, value: f64, verdict: Verdict) -> FittedParameter {
        FittedParameter {
            key: key.to_owned(),
            name: key.to_owned(),
            fitted: Estimate::new(value, [0.92 * value, 1.15 * value]),
            band: [0.9 * value, 1.2 * value],
            profile_range: [0.92 * value, 1.15 * value],
            is_open: [false; 2],
            profile: Vec::new(),
            bootstrap: None,
            default: Estimate::new(value, [0.5 * value, 2.0 * value]),
            deviation: 0.05,
            verdict,
        }
    }

    #[test]
    fn the_block_reads_back_as_the_table_of_a_case() {
        let all = [
            fitted("boundary_friction", 0.083_21, Verdict::Identified),
            fitted("boundary_layer", 11.234e-9, Verdict::Partly),
            fitted("limiting_shear", 0.04, Verdict::NotIdentified),
            fitted("eyring_stress", 4.321e6, Verdict::Identified),
        ];
        let correlations = vec![vec![-0.3; 4]; 4];
        let text = block("rig.csv \"first\"", true, &all, &correlations);
        let head = "gears = { teeth = [23, 68], module = \"2 mm\", face_width = \"30 mm\" }\n\
                    operation = { torque = \"100 N m\", speed = \"3000 1/min\", bulk_temperature = \"60 °C\" }\n\
                    lubricant = { oil = \"m100\" }\nsurface = { pinion = { rq = \"0.3 um\" } }\n";
        let case: asperity::CaseInput = format!("{head}{text}").parse().unwrap();
        let read: CalibrationInput = case.calibration.unwrap();
        assert_eq!(read.simulated, Some(true));
        assert_eq!(read.source.as_deref(), Some("rig.csv 'first'"));
        assert_eq!(read.boundary_friction.unwrap().value, 0.08321);
        assert!((read.boundary_layer.unwrap().low.si() - 10.11e-9).abs() < 1e-15);
        assert!(read.limiting_shear.is_none());
        assert_eq!(read.eyring_stress.unwrap().value.si(), 4.321e6);
        assert_eq!(read.correlations.unwrap().len(), 3);
    }

    #[test]
    fn correlations_stay_those_of_a_distribution_when_they_are_rounded() {
        // Singular: the third is the sum of the others.
        let r = 0.5f64.sqrt();
        let all = vec![vec![1.0, 0.0, r], vec![0.0, 1.0, r], vec![r, r, 1.0]];
        let written = rounded(&[0, 1, 2], &all);
        assert!(written.clone().cholesky().is_some());
        assert!((written[(0, 2)] - r).abs() < 0.012, "{written}");
        assert_eq!(rounded(&[0, 1], &all)[(0, 1)], 0.0);
        let plain = vec![vec![1.0, -0.9126], vec![-0.9126, 1.0]];
        assert_eq!(rounded(&[0, 1], &plain)[(1, 0)], -0.913);
    }
}
