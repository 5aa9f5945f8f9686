//! Errors of traction curves.

use std::fmt::Display;

use asperity::case::STEEPEST_FALL;
use asperity::oil::LubricantError;
use asperity_core::{Code, Fault, RepeatedFault, decimals, number};

/// The base oil is incomplete, or has no state at a temperature.
pub(crate) fn oil(name: impl Display, source: LubricantError) -> Fault {
    Fault::new(Code::E208, format!("{name}: {source}"))
}

/// The viscosity is known at one temperature only.
pub(crate) fn one_viscosity(name: impl Display) -> Fault {
    Fault::new(
        Code::E208,
        format!(
            "{name}: the viscosity is known at one temperature only; traction over temperature needs it at two (law astm-d341 or vogel)"
        ),
    )
}

/// The friction of the film has no shear stress law.
pub(crate) fn no_shear_law(name: impl Display) -> Fault {
    Fault::new(
        Code::E205,
        format!("{name}: the film friction of the case is not computed from a shear stress"),
    )
}

/// A Stribeck curve without the time of rubbing.
pub(crate) fn no_rubbing(file: &str, line: usize) -> Fault {
    Fault::new(
        Code::E322,
        format!(
            "{file}:{line}: the time of rubbing before the reading is not stated; boundary friction may double by rubbing. Give a column rubbing_s, 0 for new specimens, or a time of rubbing for each file"
        ),
    )
}

/// A Stribeck curve of new specimens only.
pub(crate) fn not_rubbed() -> Fault {
    Fault::new(
        Code::E322,
        "all readings are of new specimens; measure again after rubbing",
    )
}

/// Too few points in boundary lubrication.
pub(crate) fn few_boundary(
    kept: usize,
    points: usize,
    ratio: f64,
    thinnest: f64,
    least: usize,
) -> Fault {
    Fault::new(
        Code::E322,
        format!(
            "{kept} of {points} set points after rubbing have a film of at most {ratio} times the roughness (thinnest: {thinnest} times) and a slide-to-roll ratio of at least 0.5 %; at least {least} at two speeds are needed",
            ratio = number(ratio),
            thinnest = decimals(thinnest, 2)
        ),
    )
}

/// Friction that still depends on the speed.
pub(crate) fn sloping(points: usize, percent: f64) -> Fault {
    Fault::new(
        Code::E322,
        format!(
            "the friction of the {points} points in boundary lubrication changes by {percent:+.0} % per decade of speed; at most 10 % are accepted"
        ),
    )
}

/// A table of readings that is not valid.
pub fn of_table(fault: Fault) -> Fault {
    match fault.code() {
        Code::E134 => fault.coded(Code::E317),
        _ => fault,
    }
}

/// A text without a traction curve.
pub(crate) fn no_table(file: impl Display) -> Fault {
    Fault::new(
        Code::E317,
        format!(
            "{file}: no table has the columns Ball Load (N), Rolling Speed (mm/s), SRR (%), Traction Coeff (-) and a temperature"
        ),
    )
}

/// A row of a text that is not valid.
pub(crate) fn row(file: impl Display, line: usize, rule: impl Display) -> Fault {
    Fault::new(Code::E317, format!("{file}:{line}: {rule}"))
}

/// A probe of the oil that reads air.
pub(crate) fn air(file: impl Display, line: usize, lube: f64, pot: f64) -> Fault {
    Fault::new(
        Code::E317,
        format!(
            "{file}:{line}: the probe of the oil reads {lube} °C where the pot has {pot} °C: it reads air. Take the temperature of the pot, if it is the one of the oil",
            lube = number(lube),
            pot = number(pot)
        ),
    )
}

/// Too few points for a fit.
pub(crate) fn few_points(kept: usize, points: usize, dropped: impl Display) -> Fault {
    Fault::new(
        Code::E318,
        format!("{kept} of {points} set points can be used; at least 6 are needed{dropped}"),
    )
}

/// A pressure that does not stiffen the oil.
pub(crate) fn low_pressure(gpa: f64) -> Fault {
    Fault::new(
        Code::E318,
        format!(
            "the largest Hertz pressure is {gpa} GPa; at least 0.4 GPa are needed",
            gpa = decimals(gpa, 2)
        ),
    )
}

/// Curves that no law of pressure explains.
pub(crate) fn unexplained(per_point: f64, worst: impl Display) -> Fault {
    Fault::new(
        Code::E319,
        format!(
            "no law explains the curves: squares of the residuals per point {per_point}, at most 3 are accepted; largest: {worst}",
            per_point = decimals(per_point, 1)
        ),
    )
}

/// A nuisance term of no calibrated machine.
pub(crate) fn nuisance(text: impl Display, deviations: f64, worst: impl Display) -> Fault {
    Fault::new(
        Code::E319,
        format!(
            "for the fit to hold, {text}: {deviations:+.1} standard deviations, at most 3 are accepted; even so the largest residuals are {worst}"
        ),
    )
}

/// A constant of no known oil.
pub(crate) fn no_oil(
    name: impl Display,
    value: f64,
    unit: impl Display,
    low: f64,
    high: f64,
) -> Fault {
    Fault::new(
        Code::E319,
        format!(
            "{name} = {value} {unit}: no known oil has this; known oils have {low} to {high} {unit}",
            low = number(low),
            high = number(high),
            value = decimals(value, 4)
        ),
    )
}

/// A fall of the limiting shear stress that no case takes.
pub(crate) fn too_steep(band: [f64; 2]) -> Fault {
    Fault::new(
        Code::E319,
        format!(
            "the 95 % interval of the fall of the limiting shear stress, {:.4} to {:.4} 1/K, leaves {} to {STEEPEST_FALL} 1/K, where a film has a single temperature: no case takes it",
            band[0], band[1], -STEEPEST_FALL
        ),
    )
}

/// The error of a row, with the rows like it and what the file then seems to have, if they are many.
pub(super) fn repeated(row: Fault, like: &RepeatedFault, seems: &str) -> Fault {
    if like.is_dialect() {
        row.adding(&format!("; {like}; {seems}"))
    } else {
        row
    }
}
