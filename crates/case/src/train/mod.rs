//! A case of any number of meshes.

pub mod gear_train;
pub mod planetary;
pub mod train_input;
pub mod train_parts;
