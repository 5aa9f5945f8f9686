//! Maps in the formats of vehicle simulation and of tables.
//!
//! Every file states its scope: the mesh only, or the mesh and an added table. Torque is at the input shaft, the
//! pinion; negative if the output drives. The loss torque is at the input shaft and never negative. It depends on the sign
//! of the torque, but not on the sign of the speed.
//!
//! | format | to |
//! |---|---|
//! | [`Format::Csv`] | any program: one row per node, mesh and added loss in separate columns |
//! | [`Format::Vecto`] | VECTO, `.vtlm` |
//! | [`Format::Modelica`] | `CombiTable2Ds` of the Modelica Standard Library, text |
//! | [`Format::Matlab`] | MATLAB, Octave, scipy, Modelica: MAT-file level 4 |
//! | [`Format::Fmu`] | FMI 2.0, model exchange and co-simulation |
//! | [`Format::Co2mpas`] | three fitted parameters of a gear box, with the residuals |
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

pub use added::AddedLoss;
pub use field::Field;
pub use fitted::{GearBoxFit, gear_box_fit};
pub use fmu::c_source;
pub use formats::{ExportFile, Format, With, check, export};
pub use mat4::{Mat4, Matrix};
