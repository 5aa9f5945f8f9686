//! Involute cylindrical gear pairs, external and internal: geometry, kinematics, load over the flanks, and loss
//! factors.
//!
//! It is used by `flanks`, `case` and `asperity`. It does not know roughness, oil or friction.
//!
//! [`GearPair::new`] derives the working geometry from a [`GearPairInput`] or returns an error. Positions on the path
//! of contact are distances s from T₁, the foot of the perpendicular from the axis of gear 1 to the line of action; A
//! and E are the ends of the path, C is the pitch point. [`LoadMap`] solves for the load over the flanks of elastic
//! teeth; [`planetary::PlanetarySet`] combines the sun-planet and planet-ring pairs.
//!
//! ```
//! use asperity_core::quantity::{Angle, Length};
//! use asperity_gear::{GearPair, GearPairInput, LoadSharing};
//!
//! let pair = GearPair::new(&GearPairInput::standard(
//!     [50, 120],
//!     "1.3 mm".parse()?,
//!     "30 deg".parse()?,
//!     "50 mm".parse()?,
//! ))?;
//! assert!((pair.path().eps_alpha - 1.452764).abs() < 1e-6);
//!
//! let speed = "3000 1/min".parse()?;
//! let torque = "285 N m".parse()?;
//! let mut sliding_loss = 0.0;
//! for position in pair.positions(32, asperity_gear::PositionRule::GaussLegendre)? {
//!     let motion = pair.kinematics(position.s, speed)?;
//!     let load = pair.line_load(position.s, torque, &LoadSharing::Uniform)?;
//!     let friction = 0.05 * load.si();
//!     sliding_loss += position.weight.si() * friction * motion.sliding.si().abs();
//! }
//! let factors = pair.loss_factors(&LoadSharing::Uniform)?;
//! let power = 285.0 * 3000.0 * std::f64::consts::PI / 30.0;
//! assert!((sliding_loss / (0.05 * power) - factors.local).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod centre_distance;
mod chebyshev;
pub mod contact_length;
pub mod edge_contact;
pub mod error;
pub mod flank_coordinate;
pub mod forces;
pub mod gear_train;
mod hertz_compliance;
pub mod input;
pub mod involute;
pub mod iso_stiffness;
pub mod kinematics;
pub mod line_load;
pub mod load_distribution;
pub mod load_map;
pub mod load_sharing;
mod loss_band;
pub mod loss_factor;
pub mod pair;
pub mod pair_compliance;
pub mod path_of_contact;
pub mod planetary;
pub mod positions;
mod quadrature;
mod rack;
pub mod relief;

pub mod shaft_statics;
mod tips;
mod tooth_compliance;
pub mod tooth_outline;
pub mod transverse_tooth;

pub use error::{Gear, GearError};
pub use flank_coordinate::FlankPoint;
pub use forces::Forces;
pub use input::{GearPairInput, Plane};
pub use kinematics::Kinematics;
pub use load_distribution::LoadDistribution;
pub use load_map::{
    LoadCell, LoadConditions, LoadLaw, LoadMap, LoadMapEvidence, LoadMapSettings, LoadSample,
    TransmissionError,
};
pub use load_sharing::LoadSharing;
pub use loss_band::{BandPart, BandSource, EdgeContactNote, LossFactorBand};
pub use loss_factor::LossFactors;
pub use pair::GearPair;
pub use pair_compliance::StiffnessSource;
pub use path_of_contact::PathOfContact;
pub use positions::{MeshPosition, PositionRule};
pub use relief::{
    AmountDirection, EndRelief, MeasuredForm, MicroGeometry, Relief, ReliefExtent, ReliefShape,
};
pub use tooth_outline::RootForm;
pub use transverse_tooth::TransverseTooth;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
