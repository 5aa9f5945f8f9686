//! Quantities as text.

use asperity::message::Code;
use asperity::quantity::QUANTITIES;
use pyo3::prelude::*;

use crate::failure::Failure;

/// The number in SI units that a text with a unit means; `quantity` is a name of `si_units`, `name` that of the argument, if it is
/// known.
#[pyfunction]
pub fn to_si(quantity: &str, text: &str, name: &str) -> PyResult<f64> {
    let known = QUANTITIES.iter().find(|known| known.type_name == quantity);
    let known =
        known.ok_or_else(|| Failure::new(Code::E501, format!("{quantity}: no such quantity")))?;
    let found = (known.read)(text).map_err(Failure::from);
    Ok(match name {
        "" => found,
        name => found.map_err(|failure| failure.about(name)),
    }?)
}

/// Name and SI unit of every quantity.
#[pyfunction]
pub fn si_units() -> Vec<(&'static str, &'static str)> {
    let quantities = QUANTITIES.iter();
    quantities
        .map(|known| (known.type_name, known.si_unit))
        .collect()
}
