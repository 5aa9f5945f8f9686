//! Cases from texts and files, checks of all that is wrong with one, and keys set by name.

pub mod check;
pub mod load_case;
pub mod page;
pub mod set;
