//! Rough contacts of the windows of a mesh: they depend on neither oil, speed nor temperature.

mod displacements;
pub mod dry_contact;
mod inputs;
mod offsets;
mod pressed;
pub mod running_in;
mod tables;
mod window_contact;

pub use dry_contact::{DryContact, dry_contact};
pub use tables::Contacts;

pub(crate) use displacements::Displacements;
pub(crate) use inputs::{ContactInputs, Offsets};
pub(crate) use pressed::{
    LoadStep, Pressed, Pressing, full_film, pressing_history, settings, softer,
};
pub(crate) use window_contact::WindowContact;
