//! Summaries of a calibration and a design for a terminal.

use std::fmt::Write as _;

use asperity::message::Warning;
use asperity_report::wrapped;

use crate::design::Design;
use crate::result::{Calibration, FittedParameter, Identifiability, IdentifiedParameter};

/// Display unit of a key with its size in units of SI, and the decimals of its values.
pub(crate) fn unit_of(key: &str) -> (&'static str, f64, usize) {
    match key {
        "boundary_layer" => ("nm", 1e9, 2),
        "eyring_stress" => ("MPa", 1e-6, 3),
        _ => ("", 1.0, 4),
    }
}

/// A value with its display unit.
pub(crate) fn shown(key: &str, value: f64) -> String {
    let (unit, ..) = unit_of(key);
    format!("{} {unit}", bare(key, value)).trim_end().to_owned()
}

/// A value in its display unit, without the unit.
fn bare(key: &str, value: f64) -> String {
    let (_, factor, decimals) = unit_of(key);
    format!("{:.decimals$}", factor * value)
}

pub(crate) fn range(key: &str, [low, high]: [f64; 2]) -> String {
    format!("({}..{})", bare(key, low), bare(key, high))
}

/// A standard deviation of a logarithm.
pub(crate) fn percent(deviation: Option<f64>) -> String {
    deviation.map_or("-".to_owned(), |value| format!("{:.0} %", 100.0 * value))
}

/// A standard deviation of a logarithm with the digits that show the gain of a single point.
pub(crate) fn tenths(deviation: f64) -> String {
    format!("{:.1} %", 100.0 * deviation)
}

/// The scatter of a fit relative to the stated errors.
pub(crate) fn scatter(calibration: &Calibration) -> String {
    let ratio = calibration.birge_ratio;
    let widened = match ratio > 1.0 {
        true => format!("errors are {ratio:.2} times what you stated: bands widened by {ratio:.2}"),
        false => "the stated errors explain the scatter".to_owned(),
    };
    format!(
        "chi squared {:.1} at {} degrees of freedom, Birge ratio {ratio:.2}: {widened}",
        calibration.chi_squared, calibration.freedom
    )
}

/// Summary of the identifiability, printed before the fit.
#[must_use]
pub fn before_the_fit(identifiability: &Identifiability) -> String {
    let mut text = String::new();
    let temperatures: Vec<String> = identifiability
        .temperatures_c
        .iter()
        .map(|value| format!("{value:.0}"))
        .collect();
    let lambda_star = identifiability
        .lambda_star
        .map_or("unknown".to_owned(), |[low, high]| {
            format!("{low:.2} to {high:.2}")
        });
    // Writing into a string cannot fail.
    let _ = writeln!(
        text,
        "identifiability by {} operating points (temperatures {} °C, Lambda* {lambda_star}): standard deviations",
        identifiability.points,
        temperatures.join(", ")
    );
    for parameter in &identifiability.parameters {
        text.push_str(&identified(parameter));
    }
    if let Some((first, other, value)) = &identifiability.worst_correlation {
        let _ = writeln!(
            text,
            "  hardest to separate: {first} and {other}, correlation {value:+.2}"
        );
    }
    if let Some(best) = identifiability.helpful.first() {
        let line = format!(
            "  would help most: {:.0} N m, {:.0} 1/min, {:.0} °C ({} {} instead of {})",
            best.torque_nm,
            best.speed_rpm,
            best.temperature_c,
            best.gains_most,
            tenths(best.deviation[1]),
            tenths(best.deviation[0]),
        );
        text.push_str(&wrapped(&line, "    "));
        text.push('\n');
    }
    text
}

fn identified(parameter: &IdentifiedParameter) -> String {
    format!(
        "  {:<18} {:>8}   {}\n",
        parameter.name,
        percent(parameter.deviation),
        parameter.verdict.text()
    )
}

/// Summary of a calibration: parameters with bands, quality of the fit, and the block.
pub(crate) fn summary(calibration: &Calibration) -> String {
    let mut text = String::new();
    if calibration.is_simulated {
        text.push_str("SIMULATED losses: a rehearsal, not a measurement\n");
    }
    let _ = writeln!(
        text,
        "parameter                value   95 % band            default range"
    );
    for parameter in &calibration.parameters {
        text.push_str(&row(parameter));
    }
    let fit = format!("fit  {}", scatter(calibration));
    text.push_str(&wrapped(&fit, "     "));
    text.push('\n');
    for held in &calibration.held_out {
        let _ = writeln!(
            text,
            "held out  {:.0} °C: {:.1} % from the prediction by the others ({:.1} % expected, mean {:+.1} %)",
            held.temperature_c,
            100.0 * held.rms_error,
            100.0 * held.expected_error,
            100.0 * held.mean_error,
        );
    }
    text.push_str(&listed(&calibration.warnings));
    text.push_str("for the case:\n");
    text.push_str(&calibration.block);
    text
}

fn row(parameter: &FittedParameter) -> String {
    let key = parameter.key.as_str();
    let open = if parameter.is_open.contains(&true) {
        " (open)"
    } else {
        ""
    };
    let verdict = match parameter.verdict {
        crate::result::Verdict::Identified => String::new(),
        other => format!("   {}", other.text()),
    };
    let text = format!(
        "{:<18} {:>11}   {:<18}   {:<15}{open}{verdict}",
        parameter.name,
        shown(key, parameter.value),
        range(key, parameter.band),
        range(key, parameter.default_range),
    );
    format!("{}\n", text.trim_end())
}

/// Summary of a design: points and expected bands.
pub(crate) fn design_summary(design: &Design) -> String {
    let mut text = format!(
        "{} points for each of {} assemblies, of {} candidates (D-optimal)\n",
        design.size() / design.limits.assemblies.max(1),
        design.limits.assemblies,
        design.candidates
    );
    let _ = writeln!(
        text,
        "   torque    speed  temperature  repeats   loss W  Lambda*"
    );
    for point in &design.points {
        let ratio = point
            .lambda_star
            .map_or("-".to_owned(), |value| format!("{value:.2}"));
        let _ = writeln!(
            text,
            "{:>9.1} {:>8.0} {:>12.0} {:>8} {:>8.1} {ratio:>8}",
            point.torque_nm, point.speed_rpm, point.temperature_c, point.repeats, point.loss_w
        );
    }
    let _ = writeln!(
        text,
        "expected with {:.1} % per point   95 % band            default range",
        100.0 * design.limits.sigma
    );
    for parameter in &design.parameters {
        let identified = &parameter.identified;
        let _ = writeln!(
            text,
            "{:<18} {:>9}   {:<18}   {:<15}   {}",
            identified.name,
            percent(identified.deviation),
            range(&identified.key, parameter.band),
            range(&identified.key, parameter.default_range),
            identified.verdict.text(),
        );
    }
    text.push_str(&listed(&design.warnings));
    text
}

fn listed(warnings: &[Warning]) -> String {
    let lines = warnings
        .iter()
        .map(|warning| wrapped(&warning.to_string(), "     ") + "\n");
    lines.collect()
}
