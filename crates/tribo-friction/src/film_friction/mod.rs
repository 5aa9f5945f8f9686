//! Friction of a film that separates the flanks: no asperities anywhere in it.
//!
//! | file | holds |
//! |---|---|
//! | `oil_family` | limiting shear stress, Eyring stress, conductivity by family of base oil |
//! | `traction_constants` | the same constants for one oil, and those of the Carreau-Yasuda law |
//! | `rheology` | shear stress over pressure, temperature and rate, with the film's own heat |
//! | `line_contact` | the integral over a Hertz line contact and the heat of its surfaces |
//!
//! The default is Eyring's law on Barus' viscosity below a limiting shear stress; `carreau`, `newton` and
//! `roelands` are choices by name. An elastic term is left out: it rules below slide-to-roll ratios of
//! about 5·10⁻⁴, where no loss is.

mod line_contact;
mod oil_family;
mod rheology;
mod traction_constants;
mod viscosity_table;

pub use line_contact::{
    FilmFrictionSolution, FilmHeat, FilmLineContact, FilmSettings, LoadedFilm, solve,
};
pub use oil_family::{Mark, MarkedValue, OilFamily, OilFamilyData, family_source};
pub use rheology::{FilmOilState, FilmRheology, PressureLaw, ShearLaw};
pub use traction_constants::{CarreauConstants, TractionConstants};
