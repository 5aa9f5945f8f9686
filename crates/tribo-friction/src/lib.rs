//! Friction coefficients, rolling resistance, mixed friction and flash temperature of lubricated
//! gear flanks.
//!
//! It is used by `mixed-film`, `case` and `asperity`. It does not know gears or cases; what it needs of a contact are quantities.
//!
//! One file a law in [`friction_law`], each with its own function in the units a reader expects; [`FrictionLaw`]
//! chooses between them by the name in a case file and takes what it needs from
//! [`FrictionConditions`].
//!
//! | equation | place |
//! |---|---|
//! | shear stress of the film, its limit | [`FilmRheology`](asperity_oil::FilmRheology) |
//! | the same over the contact, with heat | [`film_friction`]; without heat at the mean pressure [`eyring`] |
//! | friction where asperities carry a share | `asperity-mixed-film` |
//!
//! ```
//! use asperity_tribo_friction::xu::{XuConditions, XuLaw};
//! let position = XuConditions {
//!     slide_to_roll: 0.2,
//!     max_pressure: "1 GPa".parse()?,
//!     viscosity: "10 mPa s".parse()?,
//!     entrainment: "10 m/s".parse()?,
//!     radius: "10 mm".parse()?,
//!     combined_roughness: "0.1 um".parse()?,
//! };
//! let coefficient = XuLaw::default().coefficient(&position)?;
//! assert!((coefficient.value - 0.0127168).abs() < 1e-7);
//! assert!(coefficient.outside.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod boundary;
pub mod conditions;
pub mod error;
pub mod film_friction;
pub mod film_friction_law;
pub mod flash;
pub mod friction_law;
pub mod mixed;
pub mod point_film;
pub mod published_law;
pub mod rolling;

pub use conditions::{FrictionConditions, MeshConditions};
pub use error::FrictionError;
pub use film_friction::{
    FilmFrictionSolution, FilmHeat, FilmLineContact, FilmRipple, FilmSettings, LoadedFilm,
};
pub use film_friction_law::{FilmContact, FilmFriction, FilmTraction, NamedFriction};
pub use flash::flash_temperature;
pub use friction_law::*;
pub use mixed::{MixedFriction, mixed_friction};
pub use point_film::FilmPointContact;
pub use published_law::PublishedLaw;
pub use rolling::rolling_force;

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
