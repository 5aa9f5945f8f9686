//! Rough contacts of the windows of a mesh: they depend on neither oil, speed nor temperature.

mod displacements;
pub mod dry_contact;
mod inputs;
mod offsets;
mod pressed;
pub mod running_in;
mod tables;
mod window_contact;

pub use displacements::Displacements;
pub use dry_contact::{DryContact, dry_contact};
pub use tables::Contacts;

pub(crate) use inputs::{ContactInputs, Offsets};
pub(crate) use pressed::{Pressing, pressing_history};
pub(crate) use window_contact::WindowContact;
