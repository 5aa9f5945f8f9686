//! The lubricating oil: every law and every constant of viscosity, density, shear stress and heat.
//!
//! It is used by the physics crates of the film, `case` and `asperity`. It does not know gears, contacts or cases.
//!
//! | property | laws | used by |
//! |---|---|---|
//! | viscosity over temperature | [`AstmD341`], [`Vogel`], [`GivenViscosity`] | [`Lubricant`] |
//! | viscosity over pressure | [`barus`], [`roelands`], [`PressureViscosityLaw`] by name and constants | formulas, elastohydrodynamic solver |
//! | the same in a film under a limiting stress | [`PressureLaw`] by name | [`FilmRheology`] |
//! | viscosity over pressure and temperature | [`HeatedViscosity`] | traction of the elastohydrodynamic film |
//! | pressure-viscosity coefficient | [`gold_pressure_viscosity`] | [`Lubricant`], [`FilmRheology`] |
//! | density | [`DensityLine`] over temperature, [`DensityLaw`] over pressure | [`Lubricant`], elastohydrodynamic solver |
//! | shear stress | [`ShearLaw`], [`ShearLawName`], [`limited_stress`] | [`FilmRheology`], elastohydrodynamic solver |
//! | heat | [`cragoe_conductivity`], [`cragoe_heat_capacity`] | [`Lubricant`] |
//!
//! A case file holds a [`LubricantInput`]: the name of an oil of the library, or its properties, or
//! both (the properties then replace the library's). [`LubricantInput::resolve`] returns a
//! [`Lubricant`] with a list of its assumptions; [`Lubricant::at`] returns the [`LubricantState`] at one
//! temperature, which film and friction formulas use.
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

mod base_oil;
mod density;
mod error;
mod heat;
mod input;
mod library;
mod lubricant;
mod pressure_viscosity;
mod rheology;
mod shear_law;
mod traction_constants;
pub mod viscosity_index;
mod viscosity_pressure;
mod viscosity_table;
mod viscosity_temperature;

pub use base_oil::{BaseOil, BaseOilData, FilmConstantName, Mark, MarkedValue, base_oil_source};
pub use density::{DensityLaw, DensityLine, RelativeDensity, dowson_higginson_density};
pub use error::LubricantError;
pub use heat::{cragoe_conductivity, cragoe_heat_capacity};
pub use input::{LubricantInput, ViscosityLaw};
pub use library::{LibraryOil, library, library_oil};
pub use lubricant::{Assumption, Lubricant, LubricantState};
pub use pressure_viscosity::{
    GOLD_FIT, HIGHEST_PLAUSIBLE, LOWEST_PLAUSIBLE, gold_pressure_viscosity,
    plausible_pressure_viscosity,
};
pub use rheology::{FilmOilState, FilmPoint, FilmRheology, GOLD_TEMPERATURE, LANES, ShearedPoint};
pub use shear_law::{
    LIMIT_POWER, ShearLaw, ShearLawName, ShearThinning, TangentFluidity, limited_stress,
    limited_stress_by,
};
pub use traction_constants::{
    AMBIENT_LIMIT, CarreauConstants, LIMITING_SHEAR_BAND, PRESSURE_VISCOSITY_BAND,
    TractionConstants, eyring_stress_band,
};
pub use viscosity_pressure::{
    HeatedViscosity, LARGEST_BARUS_EXPONENT, PressureLaw, PressureViscosityLaw, RelativeViscosity,
    barus, roelands, roelands_exponent,
};
pub use viscosity_temperature::{AstmD341, GivenViscosity, Vogel};

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
