//! The oil: viscosity, density, pressure-viscosity coefficient and heat properties.
//!
//! A case file holds a [`LubricantInput`]: the name of an oil of the library, or its numbers, or
//! both (numbers then replace those of the library). [`LubricantInput::resolve`] makes a
//! [`Lubricant`] of it and lists what it had to assume; [`Lubricant::at`] gives everything the
//! film and friction formulas ask for at one temperature.
//!
//! ```
//! use asperity_oil::{LubricantInput, BaseOil, ViscosityLaw};
//! let input = LubricantInput {
//!     viscosity: Some(ViscosityLaw::AstmD341 { at_40: "100 mm2/s".parse()?, at_100: "11.2 mm2/s".parse()? }),
//!     density: Some("880 kg/m3".parse()?),
//!     base_oil: Some(BaseOil::Mineral),
//!     ..LubricantInput::default()
//! };
//! let oil = input.resolve("60 °C".parse()?)?;
//! let state = oil.at("60 °C".parse()?)?.value;
//! assert!((state.kinematic_viscosity.si() - 39.86e-6).abs() < 1e-8);
//! assert!(state.temperature_coefficient.si() > 0.04);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod density;
mod error;
mod heat;
mod input;
mod library;
mod pressure_viscosity;
mod resolved;
mod viscosity_pressure;
mod viscosity_temperature;

pub use density::{DensityLine, dowson_higginson_density};
pub use error::LubricantError;
pub use heat::{cragoe_conductivity, cragoe_heat_capacity};
pub use input::{LubricantInput, ViscosityLaw};
pub use library::{LibraryOil, library};
pub use pressure_viscosity::{
    BaseOil, HIGHEST_PLAUSIBLE, LOWEST_PLAUSIBLE, gold_pressure_viscosity,
    plausible_pressure_viscosity,
};
pub use resolved::{Assumption, Lubricant, LubricantState};
pub use viscosity_pressure::{barus, roelands, roelands_exponent};
pub use viscosity_temperature::{AstmD341, GivenViscosity, Vogel};
