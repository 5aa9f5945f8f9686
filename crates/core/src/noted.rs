//! Values that are made once.

use std::sync::OnceLock;

use crate::provenance::{Bits, Provenance};
use crate::task::note_all;

/// A value that is made once, at first need, with the equations of its making: they are noted at each use, so that a result names
/// them whichever work made the value.
#[derive(Debug, Clone)]
pub struct Noted<T>(OnceLock<(Bits, T)>);

impl<T> Noted<T> {
    /// The value, if it is made.
    #[must_use]
    pub fn get(&self) -> Option<&T> {
        let (used, value) = self.0.get()?;
        note_all(*used);
        Some(value)
    }

    /// The value, made by `make` if there is none; other threads wait for it. `make` must not run in parallel, as a thread that waits for
    /// its loops could come here again.
    pub fn get_or_init(&self, make: impl FnOnce() -> T) -> &T {
        let (used, value) = self.0.get_or_init(|| {
            let used = Provenance::new();
            let made = used.collect(make);
            (used.used(), made)
        });
        note_all(*used);
        value
    }

    /// The value, made by `make` if there is none. Threads that come at once each make it, and all get the same one.
    ///
    /// # Errors
    /// The errors of `make`.
    pub fn get_or_make<E>(&self, make: impl FnOnce() -> Result<T, E>) -> Result<&T, E> {
        if let Some(known) = self.get() {
            return Ok(known);
        }
        let used = Provenance::new();
        let made = used.collect(make)?;
        let used = used.used();
        let (used, value) = self.0.get_or_init(|| (used, made));
        note_all(*used);
        Ok(value)
    }
}

impl<T> Default for Noted<T> {
    fn default() -> Self {
        Self(OnceLock::new())
    }
}

impl<T: PartialEq> PartialEq for Noted<T> {
    fn eq(&self, other: &Self) -> bool {
        let [own, other] = [self, other].map(|one| one.0.get().map(|(_, value)| value));
        own == other
    }
}
