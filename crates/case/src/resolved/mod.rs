//! A case with every choice made and checked.

pub mod assumed_relief;
pub mod bulk;
pub mod calibrated;
pub mod constant;
pub mod gearbox;
pub mod gears;
pub mod load_inputs;
pub mod measured;
pub mod oil_at;
pub mod oil_file;
#[cfg(feature = "case-files")]
pub mod oil_file_text;
pub mod overrides;
pub mod own_laws;
pub mod plausibility;
#[cfg_attr(not(feature = "case-files"), path = "no_oil_file.rs")]
pub mod read_oil_file;
pub mod resolve;
pub mod running_in;
pub mod shafting;
pub mod share_law;
pub mod solved_teeth;
pub mod steel;
