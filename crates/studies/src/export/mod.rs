//! Maps in the formats of vehicle simulation and of tables.
//!
//! Every file says what loses: the mesh alone, or the mesh and what a table of the user's adds. Signs: torque of the
//! input shaft, which is the pinion's; negative where the output drives. Loss torque is that of the input shaft and
//! never negative. Loss depends on the torque with its sign and on the speed without.
//!
//! | format | to |
//! |---|---|
//! | [`Format::Csv`] | anything: a row per node, mesh and added loss apart |
//! | [`Format::Vecto`] | VECTO, `.vtlm` |
//! | [`Format::Modelica`] | `CombiTable2Ds` of the Modelica Standard Library, text |
//! | [`Format::Matlab`] | MATLAB, Octave, scipy, Modelica: MAT-file level 4 |
//! | [`Format::Fmu`] | FMI 2.0, model exchange and co-simulation |
//! | [`Format::Co2mpas`] | three parameters of a gear box, fitted, with what is left of the fit |
//! | [`Format::Fastsim`] | one efficiency, weighted by a cycle |
//! | [`Format::Advisor`] | efficiency over speed and torque of the output shaft, `.m` |

mod added;
mod advisor;
mod error;
mod field;
mod fitted;
mod fmu;
mod formats;
mod mat4;
mod modelica;
mod names;
mod tables;

pub use added::{AddedLoss, AddedLossError};
pub use error::ExportError;
pub use field::Field;
pub use fitted::{GearBoxFit, gear_box_fit};
pub use fmu::c_source;
pub use formats::{ExportFile, Format, With, export};
pub use mat4::{Mat4, Matrix};
