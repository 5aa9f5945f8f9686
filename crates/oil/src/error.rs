//! Errors of a lubricant.

use std::fmt::Display;

use asperity_core::numerics::RootError;
use asperity_core::{Code, DomainError, Fault, did_you_mean, nearest_name, number};

/// Errors of the properties of a lubricant.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LubricantError {
    /// An input outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
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
    /// An error that no caller distinguishes from others.
    #[error(transparent)]
    Fault(#[from] Fault),
}

impl LubricantError {
    /// Neither an oil of the library nor a viscosity law.
    pub(crate) fn no_viscosity() -> Self {
        Self::Fault(Fault::new(
            Code::E208,
            "the lubricant has no viscosity: name an oil of the library, or give a viscosity law (astm-d341, vogel or given)",
        ))
    }

    /// No density.
    pub(crate) fn no_density() -> Self {
        Self::Fault(Fault::new(
            Code::E208,
            "the lubricant has no density: give density, at 15 °C or at density_temperature",
        ))
    }

    /// A viscosity at one temperature does not give its slope.
    pub(crate) fn no_temperature_coefficient() -> Self {
        Self::Fault(Fault::new(
            Code::E208,
            "the lubricant has no temperature coefficient: a viscosity given at one temperature needs beta_T = -(d eta/dT)/eta, typically 0.02 to 0.06 1/K; give temperature_coefficient, or use the law astm-d341 or vogel",
        ))
    }

    /// A temperature coefficient in addition to a law that already determines it.
    pub(crate) fn second_temperature_coefficient(law: &'static str) -> Self {
        Self::Fault(Fault::new(
            Code::E208,
            format!(
                "temperature_coefficient is given, but the viscosity law {law} already fixes it; leave it out"
            ),
        ))
    }

    /// Neither a density nor α or a class of base oil.
    pub(crate) fn no_density_nor_pressure_viscosity() -> Self {
        Self::Fault(Fault::new(
            Code::E208,
            "the lubricant has no density and no pressure-viscosity coefficient: give density, at 15 °C or at density_temperature, and base_oil (mineral, naphthenic, group-iii, pao, ester, polyglycol) or pressure_viscosity",
        ))
    }

    /// Neither α nor a class of base oil to estimate it from.
    pub(crate) fn no_pressure_viscosity() -> Self {
        Self::Fault(Fault::new(
            Code::E208,
            "the lubricant has no pressure-viscosity coefficient: give pressure_viscosity, or base_oil (mineral, naphthenic, group-iii, pao, ester, polyglycol) to estimate it",
        ))
    }

    /// No family of base oil, which film friction needs.
    pub fn no_base_oil() -> Self {
        Self::Fault(Fault::new(
            Code::E208,
            "the lubricant has no base_oil (mineral, naphthenic, group-iii, pao, ester, polyglycol), which film friction needs: its limiting shear stress is that of the family. Where nobody knows it, set lubricant.assume_base_oil",
        ))
    }

    /// A name that the oil library does not have.
    pub(crate) fn unknown_oil(name: &str, known: &[String]) -> Self {
        Self::Fault(Fault::new(
            Code::E208,
            format!(
                "there is no oil \"{name}\" in the library; it has: {}{}{}",
                known.join(", "),
                did_you_mean(nearest_name(name, known).as_deref()),
                as_grade(name)
            ),
        ))
    }

    /// The viscosity law has no value between -60 °C and 500 °C.
    pub(crate) fn no_viscosity_at_any_temperature() -> Self {
        Self::Fault(Fault::new(
            Code::E208,
            "the oil has no viscosity between -60 °C and 500 °C",
        ))
    }

    /// The data file of the base oils cannot be read.
    pub(crate) fn base_oils(reason: impl Display) -> Self {
        Self::Fault(Fault::new(Code::E208, format!("oil families: {reason}")))
    }

    /// The iteration for the shear stress of a film with its own heat does not converge.
    pub(crate) fn heated_stress(what: RootError) -> Self {
        Self::Fault(Fault::new(
            Code::E208,
            format!("the shear stress of the heated film has no solution: {what}"),
        ))
    }

    /// A data file of the library that cannot be read.
    pub(crate) fn library(file: &'static str, reason: impl Display) -> Self {
        Self::Fault(Fault::new(
            Code::E208,
            format!("the oil library file {file} cannot be read: {reason}"),
        ))
    }
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

impl From<LubricantError> for Fault {
    fn from(error: LubricantError) -> Self {
        match error {
            LubricantError::Fault(fault) => fault,
            error @ LubricantError::ImplausiblePressureViscosity { .. } => {
                Self::from_cause(Code::E207, error)
            }
            error @ LubricantError::Domain(_) => Self::from_cause(Code::E208, error),
        }
    }
}
