//! The tests of this crate as one program, which is linked only once.

mod bulk_temperature;
mod examples;
mod gearbox;
mod limits;
mod loss_table;
mod properties;
mod swept;
mod validation;
