//! Errors of a lubricant.

use asperity_core::numerics::RootError;
use asperity_core::{DomainError, number};

/// Errors of the properties of a lubricant.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LubricantError {
    /// An input outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// Neither an oil of the library nor a viscosity law.
    #[error(
        "the lubricant has no viscosity: name an oil of the library, or give a viscosity law (astm-d341, vogel or given)"
    )]
    NoViscosity,
    /// No density.
    #[error("the lubricant has no density: give density, at 15 °C or at density_temperature")]
    NoDensity,
    /// A viscosity at one temperature does not give its slope.
    #[error(
        "the lubricant has no temperature coefficient: a viscosity given at one temperature needs beta_T = -(d eta/dT)/eta, typically 0.02 to 0.06 1/K; give temperature_coefficient, or use the law astm-d341 or vogel"
    )]
    NoTemperatureCoefficient,
    /// A temperature coefficient in addition to a law that already determines it.
    #[error(
        "temperature_coefficient is given, but the viscosity law {law} already fixes it; leave it out"
    )]
    SecondTemperatureCoefficient {
        /// The viscosity law.
        law: &'static str,
    },
    /// Neither a density nor α or a class of base oil.
    #[error(
        "the lubricant has no density and no pressure-viscosity coefficient: give density, at 15 °C or at density_temperature, and base_oil (mineral, naphthenic, group-iii, pao, ester, polyglycol) or pressure_viscosity"
    )]
    NoDensityNorPressureViscosity,
    /// Neither α nor a class of base oil to estimate it from.
    #[error(
        "the lubricant has no pressure-viscosity coefficient: give pressure_viscosity, or base_oil (mineral, naphthenic, group-iii, pao, ester, polyglycol) to estimate it"
    )]
    NoPressureViscosity,
    /// No family of base oil, which film friction needs.
    #[error(
        "the lubricant has no base_oil (mineral, naphthenic, group-iii, pao, ester, polyglycol), which film friction needs: its limiting shear stress is that of the family. Where nobody knows it, set lubricant.assume_base_oil"
    )]
    NoBaseOil,
    /// α far from every oil: almost always a wrong unit.
    #[error("alpha = {value} m2/N is {}", verdict(*.value, *.low, *.shift), value = number(*value))]
    ImplausiblePressureViscosity {
        /// The coefficient seen \[1/Pa\].
        value: f64,
        /// Lowest plausible coefficient \[1/Pa\].
        low: f64,
        /// Highest plausible coefficient \[1/Pa\].
        high: f64,
        /// Power of ten that makes the coefficient plausible, when a slip of the unit explains it.
        shift: Option<i32>,
    },
    /// A name that the oil library does not have.
    #[error("there is no oil \"{name}\" in the library; it has: {}{}", .known.join(", "), as_grade(name))]
    UnknownOil {
        /// The requested name.
        name: String,
        /// The names there are.
        known: Vec<String>,
    },
    /// The viscosity law has no value between -60 °C and 500 °C.
    #[error("the oil has no viscosity between -60 °C and 500 °C")]
    NoViscosityAtAnyTemperature,
    /// The data file of the base oils cannot be read.
    #[error("oil families: {reason}")]
    BaseOils {
        /// Message of the JSON reader.
        reason: String,
    },
    /// The iteration for the shear stress of a film with its own heat does not converge.
    #[error("the shear stress of the heated film has no solution: {0}")]
    HeatedStress(RootError),
    /// A data file of the library that cannot be read.
    #[error("the oil library file {file} cannot be read: {reason}")]
    Library {
        /// The file.
        file: &'static str,
        /// Cause.
        reason: String,
    },
}

/// The keys of an oil known by its grade, for the end of the message if `name` is one.
fn as_grade(name: &str) -> String {
    let lower = name.to_lowercase();
    let number = lower
        .trim_start_matches("iso")
        .trim_start()
        .trim_start_matches("vg")
        .trim();
    match number.parse::<u32>() {
        Ok(grade) if number.len() < lower.len() => format!(
            ". A grade is a viscosity: viscosity = {{ grade = \"ISO VG {grade}\", viscosity_index = ... }} with base_oil and density"
        ),
        _ => String::new(),
    }
}

fn verdict(value: f64, low: f64, shift: Option<i32>) -> String {
    let side = if value < low { "below" } else { "above" };
    match shift {
        Some(shift) => format!(
            "10^{} {side} any oil. Did you mean {:e} m2/N?",
            shift.abs(),
            // Rounded to the digits that a data sheet can have.
            (value * 10f64.powi(shift) * 1e15).round() / 1e15
        ),
        None => format!("{side} any oil"),
    }
}
