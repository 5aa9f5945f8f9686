//! The tests of this crate as one program, which is linked only once.

mod common;
mod examples;
mod gear_tool;
mod limits;
mod load_map;
mod load_map_limits;
mod measured_form;
mod properties;
#[path = "common/reference.rs"]
mod reference;
mod validation;
