//! Tables of a calibration and a design.

use std::fmt::Write as _;

use asperity::result::loss_band::Digits;
use asperity_core::Estimate;
use asperity_core::numerics::Z_95;
use asperity_report::{Cell, Column, Kind, Table, columns, wrapped};

use crate::design::Design;
use crate::result::{Calibration, Identifiability, IdentifiedParameter};

/// Display unit of a key with its size in units of SI.
pub(crate) fn unit_of(key: &str) -> (&'static str, f64) {
    match key {
        "boundary_layer" => ("nm", 1e9),
        "eyring_stress" => ("MPa", 1e-6),
        _ => ("", 1.0),
    }
}

/// A constant in its display unit, with its interval in brackets.
pub(crate) fn shown(key: &str, constant: Estimate) -> String {
    let (unit, factor) = unit_of(key);
    let constant = constant.map(|value| factor * value);
    let unit = match unit {
        "" => String::new(),
        unit => format!(" {unit}"),
    };
    Digits::of_interval(constant.ends()).interval_with(&unit, constant)
}

/// The value in its display unit with the digits that its interval leaves, without the unit.
fn bare(key: &str, constant: Estimate) -> Cell {
    let constant = constant.map(|value| unit_of(key).1 * value);
    let digits = Digits::of_interval(constant.ends());
    Cell::number(constant.value, |value| digits.rounded(value))
}

/// An interval in the display unit, in brackets, with the digits that it leaves.
fn range(key: &str, ends: Option<[f64; 2]>) -> Cell {
    let ends = ends.map(|ends| ends.map(|end| unit_of(key).1 * end));
    let digits = ends.map_or(Digits::of_decimals(0), Digits::of_interval);
    Cell::range(ends, digits)
}

/// A name with its unit.
pub(crate) fn in_unit(name: &str, unit: &str) -> String {
    match unit {
        "" => name.to_owned(),
        unit => format!("{name} [{unit}]"),
    }
}

/// The scatter of a fit relative to the stated errors.
pub(crate) fn scatter(calibration: &Calibration) -> String {
    let ratio = calibration.birge_ratio;
    let widened = if ratio > 1.0 {
        format!(
            "the residuals are {ratio:.2} times the stated errors, and widen the intervals by this Birge ratio"
        )
    } else {
        format!("the stated errors explain the residuals, which are {ratio:.2} times as large")
    };
    format!(
        "{widened}; chi squared {:.1} at {} degrees of freedom",
        calibration.chi_squared, calibration.freedom
    )
}

/// Summary of the identifiability, printed before the fit.
#[must_use]
pub(crate) fn before_the_fit(identifiability: &Identifiability) -> String {
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
    let line = format!(
        "identifiability by {} operating points (temperatures {} °C, Lambda* {lambda_star})",
        identifiability.points,
        temperatures.join(", ")
    );
    let _ = writeln!(text, "{}", wrapped(&line, "  "));
    text.push_str(&identified(&identifiability.parameters).text("  "));
    if let Some((first, other, value)) = &identifiability.worst_correlation {
        let _ = writeln!(
            text,
            "  hardest to separate: {first} and {other}, correlation {value:+.2}"
        );
    }
    if let Some(best) = identifiability.next() {
        let line = format!(
            "  would help most: {:.0} N m, {:.0} 1/min, {:.0} °C ({} {:.1} % instead of {:.1} %)",
            best.torque_nm,
            best.speed_rpm,
            best.temperature_c,
            best.gains_most,
            share(best.deviation[1]),
            share(best.deviation[0]),
        );
        text.push_str(&wrapped(&line, "    "));
        text.push('\n');
    }
    text
}

/// Standard deviations of the logarithms of the parameters before the fit, each without its own prior.
pub(crate) fn identified(parameters: &[IdentifiedParameter]) -> Table {
    columns! { one in parameters;
        head name "parameter" "";
        number deviation "expected by the points" "%" "{:.0}" = one.deviation.map(share);
        number prior "prior of the fit" "%" "{:.0}" = share(one.prior);
        text verdict "expected" "" = one.verdict.text();
    }
}

/// The same with the standard deviations after the fit.
pub(crate) fn before_and_after(calibration: &Calibration) -> Table {
    let after = calibration.parameters.iter().map(|one| {
        let deviation = one.fitted.log_width() / (2.0 * Z_95);
        Cell::number(share(deviation), |percent| format!("{percent:.0}"))
    });
    let after = Column::new(Kind::Number, "after the fit", "%", after);
    identified(&calibration.identifiability.parameters).with([after])
}

/// A share in percent.
fn share(share: f64) -> f64 {
    100.0 * share
}

/// Columns of the fitted parameters that the page has and the terminal has no room for.
const FOLDED: [&str; 3] = ["profile likelihood", BOOTSTRAP, "default"];
const BOOTSTRAP: &str = "bootstrap over assemblies";
/// Number of assemblies from which a bootstrap over them is shown.
pub(crate) const BOOTSTRAPPED: usize = 3;
/// Heading of the temperatures held out.
pub(crate) const HELD_OUT: &str = "Every temperature predicted from the others";

/// Fitted parameters with their bands, in their display units.
pub(crate) fn fitted(calibration: &Calibration) -> Table {
    let table = columns! { one in &calibration.parameters;
        head parameter "parameter" "" = named(&one.name, &one.key);
        file unit = unit_of(&one.key).0;
        number value "value" "" = bare(&one.key, one.fitted);
        range range "5 to 95 %" "" = range(&one.key, Some(one.fitted.ends()));
        range profile_range "profile likelihood" "" = range(&one.key, Some(one.profile_range));
        range bootstrap "bootstrap over assemblies" "" = range(&one.key, one.bootstrap);
        number default "default" "" = bare(&one.key, one.default);
        range default_range "5 to 95 % before" "" = range(&one.key, Some(one.default.ends()));
        text verdict "by the points" "" = if one.is_open.contains(&true) { format!("{} (open)", one.verdict.text()) } else { one.verdict.text().to_owned() };
    };
    let table = table.brief(&FOLDED);
    let table = if calibration.assemblies.len() < BOOTSTRAPPED {
        table.unshown_of(&[BOOTSTRAP])
    } else {
        table
    };
    table.in_file("parameters.csv")
}

/// A name, shown with its unit.
fn named(name: &str, key: &str) -> Cell {
    Cell::shown(in_unit(name, unit_of(key).0), name.into())
}

/// Deviations of the losses at each temperature from the prediction by the others.
pub(crate) fn held_out(calibration: &Calibration) -> Table {
    columns! { one in &calibration.held_out;
        number temperature_c "temperature" "°C" "{:.0}";
        number points "points" "";
        number rms_error "deviation (rms)" "%" "{:.1}" = share(one.rms_error);
        number expected_error "expected" "%" "{:.1}" = share(one.expected_error);
        number mean_error "mean" "%" "{:+.1}" = share(one.mean_error);
    }
}

/// Points of a design.
pub(crate) fn design_points(design: &Design) -> Table {
    let table = columns! { point in &design.points;
        number torque_nm "torque" "N m" "{:.1}";
        number speed_rpm "speed" "1/min" "{:.0}";
        number temperature_c "temperature" "°C" "{:.0}";
        number repeats "repeats" "";
        number loss_w "expected loss of the mesh" "W" = Cell::number(point.loss_w, two_digits);
        number lambda_star "Λ*" "" "{:.2}";
    };
    table.in_file("points.csv")
}

/// A power with two digits, as far as it is known before its measurement.
fn two_digits(watts: f64) -> String {
    Digits::of_decimals(1 - watts.abs().max(f64::MIN_POSITIVE).log10().floor() as i32)
        .rounded(watts)
}

/// Bands of the parameters that a design is expected to leave.
pub(crate) fn design_bands(design: &Design) -> Table {
    let table = columns! { one in &design.parameters;
        head parameter "parameter" "" = named(&one.identified.name, &one.identified.key);
        file unit = unit_of(&one.identified.key).0;
        percent deviation "standard deviation" "%" "{:.0}" = one.identified.deviation;
        range range "5 to 95 %" "" = range(&one.identified.key, Some(one.expected.ends()));
        range default_range "5 to 95 % before" "" = range(&one.identified.key, Some(one.default_range));
        text verdict "verdict" "" = one.identified.verdict.text();
    };
    table.in_file("expected_bands.csv")
}
