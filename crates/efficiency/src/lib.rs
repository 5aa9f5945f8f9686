//! Power losses of a gear mesh, their breakdown, its efficiency, and losses of the gearbox around it.
//!
//! It is used by `case` and `asperity`. It does not know gear geometry, roughness or the oil in a contact.
//!
//! The crate needs no gear geometry. From forces per metre of contact line and speeds at weighted
//! positions of a mesh cycle it computes powers, energies per engagement and the efficiency.
//!
//! ```
//! use asperity_core::quantity::Length;
//! use asperity_efficiency::{
//!     LossKind, MeshOperation, PositionLoss, RollingSurfaces, mesh_efficiency, mesh_loss,
//! };
//!
//! let position = PositionLoss {
//!     weight: "80 mm".parse()?,
//!     sliding_force: "5 N/mm".parse()?,
//!     sliding_speed: "-0.7 m/s".parse()?,
//!     rolling_force: "160 N/m".parse()?,
//!     entrainment_speed: "4.5 m/s".parse()?,
//! };
//! let loss = mesh_loss(&[position], RollingSurfaces::Both)?;
//! let operation = MeshOperation {
//!     pinion_torque: "285 N m".parse()?,
//!     pinion_speed: "3000 1/min".parse()?,
//!     teeth: [50, 120],
//! };
//! let losses = [(LossKind::Sliding, loss.sliding), (LossKind::Rolling, loss.rolling)];
//! let mesh = mesh_efficiency(&operation, &losses)?;
//! // 280 W of sliding and 115.2 W of rolling out of 89.5 kW.
//! assert!((mesh.flow.efficiency - 0.995_586).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod breakdown;
pub mod bulk_temperature;
pub mod deformation;
pub mod error;
pub mod loss_table;
pub mod mesh_loss;
pub mod oil_jet;
pub mod output_torque;
pub mod plausibility;
pub mod rolling_bearing;
pub mod shaft_seal;
pub mod swept;

pub use breakdown::{Breakdown, LossComponent, LossKind, MeshEfficiency, mesh_efficiency};
pub use deformation::{RunningIn, SurfaceDeformation, SurfaceDeformationPower};
pub use error::EfficiencyError;
pub use mesh_loss::{MeshLoss, PositionLoss, RollingSurfaces, mesh_loss};
pub use output_torque::{MeshOperation, PowerFlow};
pub use plausibility::equivalent_friction;
pub use swept::{SweptDeformation, SweptPosition, swept_deformation};
