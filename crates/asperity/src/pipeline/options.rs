//! What a run of a mesh holds, draws and knows.

use super::kept::Kept;
use crate::contacts::Contacts;

/// Progress callback, called with (done, total).
pub type Progress<'a> = &'a (dyn Fn(usize, usize) + Sync);

/// Options of a run of a mesh.
#[derive(Clone)]
pub(crate) struct Options<'a> {
    pub kept: Kept,
    pub interval: bool,
    pub progress: Progress<'a>,
    /// Contacts that were computed before.
    pub known: Vec<&'a Contacts>,
    /// Whether an equilibrium of a bulk temperature that is hotter than the first is sought.
    pub seeks_hotter: bool,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self {
            kept: Kept::All,
            interval: false,
            progress: &|_, _| {},
            known: Vec::new(),
            seeks_hotter: true,
        }
    }
}

impl<'a> Options<'a> {
    /// Those of losses by these contacts.
    pub fn known(contacts: &'a Contacts) -> Self {
        Self {
            known: vec![contacts],
            ..Self::default()
        }
    }
}
