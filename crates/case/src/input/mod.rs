//! The keys of a case as the user writes them: one row each, with its unit, range and text.

pub mod bulk_input;
pub mod calibration;
pub mod case_input;
pub mod contact_name;
pub mod files;
pub mod film_friction_input;
pub mod finish;
pub mod flank_place;
pub mod formulation;
pub mod gear_input;
pub mod gearbox_input;
pub mod input_tables;
pub mod key_ranges;
pub mod law_names;
pub mod mesh_input;
pub mod micropitting_input;
pub mod model;
pub mod one_or_two;
pub mod path_point;
pub mod ranges;
pub mod rows;
pub mod running_in_input;
pub mod trace_list;
pub mod train_heat_input;
pub mod window_pressures;
