//! A run of a mesh with its draws and contacts.

use crate::contacts::Contacts;
use crate::result::MeshOutcome;
use asperity_uncertainty::Predictive;

/// A run of a mesh.
pub(crate) struct MeshRun {
    pub outcome: MeshOutcome,
    /// Its draws; `None` if they were not requested or the case has no uncertainty.
    pub drawn: Option<Predictive>,
    pub contacts: Contacts,
}
