//! Contacts of several cases, distinct ones solved once.

use asperity_core::task::par_map;
use std::sync::Arc;

use super::stages::contacts;
use crate::contacts::{ContactInputs, Contacts};
use asperity_case::case::LoadedCase;

/// Largest number of contacts stored, some megabytes each.
const MOST: usize = 16;

/// Contacts of several cases, found by all that they follow from.
///
/// ```
/// use asperity::{ContactStore, case};
/// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
/// let case = case::load_with(file, &|input| {
///     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
/// })?;
/// let hotter = case.with_key("operation.bulk_temperature", "120 °C")?;
/// let heavier = case.with_key("operation.torque", "160 N m")?;
/// let mut store = ContactStore::default();
/// store.prepare(&[&case, &hotter]);
/// assert!(store.of(&hotter).is_some() && store.of(&heavier).is_none());
/// # Ok::<(), asperity::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct ContactStore {
    known: Vec<Arc<Contacts>>,
}

impl ContactStore {
    /// Solves the distinct contacts of `cases` that are not stored. Older ones give way, if there are too many. Contacts
    /// without a solution are left to the run of their case, which reports why.
    pub fn prepare(&mut self, cases: &[&LoadedCase]) {
        let mut missing: Vec<(ContactInputs, &LoadedCase)> = Vec::new();
        for case in cases {
            let inputs = ContactInputs::from_case(case);
            let is_known = self.known.iter().any(|known| known.are_by(&inputs));
            if !is_known && missing.iter().all(|(other, _)| *other != inputs) {
                missing.push((inputs, case));
            }
        }
        let solved = par_map(missing, |(_, case)| contacts(case, &[]).ok().map(Arc::new));
        self.known.extend(solved.into_iter().flatten());
        let most = MOST.max(cases.len());
        self.known.drain(..self.known.len().saturating_sub(most));
    }

    /// The contacts of `case`, if they are stored.
    #[must_use]
    pub fn of(&self, case: &LoadedCase) -> Option<Arc<Contacts>> {
        let inputs = ContactInputs::from_case(case);
        let mut known = self.known.iter();
        known.find(|known| known.are_by(&inputs)).cloned()
    }
}
