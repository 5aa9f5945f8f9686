//! Maps in the formats of vehicle simulation and of tables.
//!
//! Every file but the wide table, which holds numbers only, states its scope: the mesh only, or the mesh and an added table. Torque is at the input shaft, the
//! pinion; negative if the output drives. The loss torque is at the input shaft and never negative. It depends on the sign
//! of the torque, but not on the sign of the speed.

mod added;
mod efficiency;
mod error;
mod field;
mod fmu;
mod formats;
mod given;
mod lossy_gear;
mod mat5;
mod modelica;
mod names;
mod tables;

pub use added::AddedLoss;
pub use field::Field;
pub use fmu::c_source;
pub use formats::{ExportFile, Format, check, export};
pub use given::With;
pub use lossy_gear::{Lines, lines};
pub use mat5::Mat5;
