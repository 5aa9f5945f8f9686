//! The tests of this crate as one program, which is linked only once.

mod film_friction;
mod limits;
mod properties;
mod reference_case;
mod validation;
