//! Quantities as text.

use asperity::quantity::*;
use pyo3::prelude::*;

use crate::failure::Failure;

macro_rules! by_name {
    ($($type:ident),+) => {
        /// The number in SI units that a text with a unit means; `quantity` is a name of `si_units`.
        #[pyfunction]
        pub fn to_si(quantity: &str, text: &str) -> PyResult<f64> {
            match quantity {
                $(stringify!($type) => Ok(text.parse::<$type>().map_err(Failure::from)?.si()),)+
                _ => Err(Failure::new("E501", format!("{quantity}: no such quantity")).into()),
            }
        }

        /// Name and SI unit of every quantity.
        #[pyfunction]
        pub fn si_units() -> Vec<(&'static str, &'static str)> {
            vec![$((stringify!($type), <$type as Quantity>::SI_UNIT)),+]
        }
    };
}

by_name!(
    Length,
    Angle,
    Time,
    Speed,
    AngularSpeed,
    Mass,
    Area,
    Force,
    LineLoad,
    Torque,
    Power,
    Energy,
    LineEnergy,
    Pressure,
    DynamicViscosity,
    KinematicViscosity,
    Density,
    PressureViscosity,
    Temperature,
    ThermalConductivity,
    ThermalConductance,
    SpecificHeat,
    PerKelvin
);
