//! Reference solution of the load share: the transient mixed lubrication of a case at one place of the path.
//!
//! [`ReferenceContact::new`] makes of a case and a place the rough contact and the record that
//! [`asperity_ehl`] solves; [`lubrication::shares`](crate::lubrication::shares) compares the laws of load sharing with it.
//!
//! Its ridges go across the whole face and cannot leak. Where the roughness that is left in the contact is above
//! [`LARGEST_ROUGHNESS`] smooth films it is not a reference: measurement decides.

mod error;
mod record_json;
mod settings;
mod yielding;

pub use error::ReferenceError;
pub use record_json::{estimate_json, nanometres, record_json};
pub use settings::{
    Inlet, LARGEST_ROUGHNESS, ReferenceContact, ReferenceSettings, attenuated_roughness,
    formula_film,
};
pub(crate) use settings::{rheology, smooth_contact};
pub use yielding::{elastic_above_flow, record_warnings};
