//! The text of a case with the places of its keys, and errors at these places.

pub mod case_error;
pub mod defaults;
pub mod section;
pub mod source_text;
