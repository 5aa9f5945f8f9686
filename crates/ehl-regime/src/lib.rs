//! Elastohydrodynamic film thickness, thermal reduction and the lubrication regime.
//!
//! It is used by `mixed-film`, `case` and `asperity`. It does not know gears, files or cases.
//!
//! From the speed, load and curvature of one mesh position to the smooth film
//! ([`FilmLaw`]), its reduction by inlet heating ([`ThermalLaw`]), the film parameter Λ* of the
//! measured roughness ([`lambda_star()`]) and the share of the load that the film carries
//! ([`LoadShareLaw`]).
//!
//! ```
//! use asperity_ehl_regime::{FilmConditions, FilmLaw};
//! let pitch_point = FilmConditions {
//!     entrainment: "4.5679 m/s".parse()?,
//!     radius: "11.627 mm".parse()?,
//!     load: "113.41 N/mm".parse()?,
//!     modulus: "115.3846 GPa".parse()?,
//!     viscosity: "97.5 mPa s".parse()?,
//!     pressure_viscosity: "20 1/GPa".parse()?,
//!     contact_length: None,
//! };
//! let film = FilmLaw::DowsonToyoda.film(&pitch_point)?.value;
//! assert!((film.central.si() - 1.961e-6).abs() < 1e-9);
//! assert!((film.minimum.si() - 1.549e-6).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod attenuation;
pub mod dimensionless;
pub mod error;
pub mod film_elliptic;
pub mod film_law;
pub mod film_line;
pub mod film_thickness_law;
pub mod flow_table;
pub mod gap_law;
pub mod inlet_flow;
pub mod lambda_star;
pub mod light_load;
pub mod micropitting;
pub mod patch;
mod patch_flow;
pub mod patch_pair;
pub mod published_shares;
pub mod regime;
pub mod rough_inlet;
pub mod starvation;
pub mod steady_film;
pub mod thermal_reduction;

pub use attenuation::{Attenuation, MoesNumbers, Ripples, TraceSpectrum};
pub use dimensionless::{FilmConditions, FilmGroups};
pub use error::RegimeError;
pub use film_law::{FilmLaw, FilmThickness};
pub use film_thickness_law::FilmThicknessLaw;
pub use flow_table::FlowTable;
pub use gap_law::GapLaw;
pub use inlet_flow::{CentralFilm, Lay};
pub use lambda_star::{AsperityShape, LambdaStar, Orientation, lambda_star};
pub use patch::{Patch, PatchGrid, PatchSpectrum};
pub use patch_pair::PatchPair;
pub use regime::{FULL_FILM, LoadShareLaw, Regime, film_ratio};
pub use rough_inlet::{PairSpectrum, RoughInlet};
pub use thermal_reduction::{ThermalLaw, thermal_loading};
