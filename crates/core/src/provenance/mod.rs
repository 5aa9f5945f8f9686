//! Tags of the equations that ran, collected while they run.
//!
//! A tagged function calls [`cite!`](crate::cite) with its tag, which sets one bit of its thread. A result therefore names
//! an equation exactly if its function ran. A tag without a row in the table of equations does not compile.
//!
//! ```
//! use asperity_core::{cite, provenance::Provenance};
//!
//! /// Composite root mean square height: σ = √(σ₁² + σ₂²) `[P8]`
//! fn composite(first: f64, second: f64) -> f64 {
//!     cite!("P8");
//!     first.hypot(second)
//! }
//!
//! let used = Provenance::new();
//! assert_eq!(used.collect(|| composite(0.3, 0.4)), 0.5);
//! assert!(used.tags().contains("P8"));
//! ```
//!
//! ```compile_fail
//! asperity_core::cite!("no such equation");
//! ```

mod rows;

pub use rows::{ROWS, TAGS, place};

use std::collections::BTreeSet;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use crate::task::{self, Task};

/// Records that the equation with this tag is evaluated; the first statement of a tagged function.
#[macro_export]
macro_rules! cite {
    ($tag:literal) => {{
        const PLACE: usize = $crate::provenance::place($tag);
        $crate::provenance::note(PLACE)
    }};
}

pub(crate) const WORDS: usize = rows::COUNT.div_ceil(u64::BITS as usize);

/// A bit for each equation.
pub(crate) type Bits = [u64; WORDS];

/// Records that the equation at this place of [`TAGS`] is evaluated.
#[inline]
pub fn note(place: usize) {
    Task::note(place);
}

/// Set of the equations that ran inside [`Provenance::collect`]; clones share the set.
#[derive(Debug, Clone, Default)]
pub struct Provenance {
    used: Arc<Mutex<Bits>>,
}

impl Provenance {
    /// An empty set.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Runs `work` and adds the tags of all equations that it evaluates on this thread, and on others by
    /// [`par_map`](crate::task::par_map).
    ///
    /// Of nested calls the innermost collects.
    pub fn collect<T>(&self, work: impl FnOnce() -> T) -> T {
        Task::current().collecting(self).enter(work)
    }

    /// Adds the tags of `other`, whose work was done before and is used again.
    pub fn include(&self, other: &Self) {
        let used = *other.lock();
        self.add(used);
    }

    /// Notes the equations of this set, whose work was done before and is used here, as if they ran here.
    pub fn note(&self) {
        let used = *self.lock();
        task::note_all(used);
    }

    /// Tags collected so far, in alphabetical order. Work that is still running inside [`Self::collect`] adds its own at its end.
    #[must_use]
    pub fn tags(&self) -> BTreeSet<&'static str> {
        let used = *self.lock();
        let bits = u64::BITS as usize;
        let is_used = |place: &usize| used[place / bits] >> (place % bits) & 1 == 1;
        let places = (0..TAGS.len()).filter(is_used);
        places.map(|place| TAGS[place]).collect()
    }

    pub(crate) fn add(&self, used: Bits) {
        // Most tasks of a fine loop evaluate no equation that the set lacks.
        if used == [0; WORDS] {
            return;
        }
        for (word, more) in self.lock().iter_mut().zip(used) {
            *word |= more;
        }
    }

    fn lock(&self) -> MutexGuard<'_, Bits> {
        self.used.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A value that is made once, at first need, with the equations of its making: they are noted at each use, so that a result names
/// them whichever work made the value.
#[derive(Debug, Clone)]
pub struct Noted<T>(OnceLock<(Bits, T)>);

impl<T> Noted<T> {
    /// The value, if it is made.
    #[must_use]
    pub fn get(&self) -> Option<&T> {
        let (used, value) = self.0.get()?;
        task::note_all(*used);
        Some(value)
    }

    /// The value, made by `make` if there is none.
    ///
    /// # Errors
    /// The errors of `make`.
    pub fn get_or_make<E>(&self, make: impl FnOnce() -> Result<T, E>) -> Result<&T, E> {
        if let Some(known) = self.get() {
            return Ok(known);
        }
        let used = Provenance::new();
        let made = used.collect(make)?;
        let used = *used.lock();
        let (used, value) = self.0.get_or_init(|| (used, made));
        task::note_all(*used);
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

#[cfg(test)]
mod tests {
    use super::*;

    fn first() {
        cite!("P1");
    }

    fn second() {
        cite!("P2");
    }

    #[test]
    fn only_what_ran_inside_is_named() {
        first();
        let used = Provenance::new();
        used.collect(second);
        assert_eq!(used.tags(), BTreeSet::from(["P2"]));
        first();
        assert_eq!(used.tags(), BTreeSet::from(["P2"]));
    }

    #[test]
    fn the_innermost_of_nested_calls_collects() {
        let (outer, inner) = (Provenance::new(), Provenance::new());
        outer.collect(|| {
            first();
            inner.collect(second);
        });
        assert_eq!(outer.tags(), BTreeSet::from(["P1"]));
        assert_eq!(inner.tags(), BTreeSet::from(["P2"]));
    }

    #[test]
    fn a_value_that_was_made_before_notes_its_equations_at_each_use() {
        let value = Noted::default();
        for _ in 0..2 {
            let used = Provenance::new();
            let make = || {
                first();
                Ok::<_, ()>(7)
            };
            assert_eq!(used.collect(|| value.get_or_make(make)), Ok(&7));
            assert_eq!(used.tags(), BTreeSet::from(["P1"]));
        }
    }

    #[test]
    fn every_tag_has_a_place_of_its_own() {
        for (k, tag) in TAGS.iter().enumerate() {
            assert_eq!(place(tag), k);
            let used = Provenance::new();
            used.collect(|| note(k));
            assert_eq!(used.tags(), BTreeSet::from([*tag]));
        }
        let tags = ROWS.lines().filter(|line| !line.starts_with('#'));
        let tags = tags.filter_map(|line| line.split(" | ").next().filter(|tag| !tag.is_empty()));
        assert!(tags.eq(TAGS));
    }

    #[test]
    fn work_that_panics_leaves_its_tags_to_its_collection() {
        let (outer, inner) = (Provenance::new(), Provenance::new());
        outer.collect(|| {
            let work = || {
                inner.collect(|| -> () {
                    second();
                    std::panic::resume_unwind(Box::new("stopped"));
                })
            };
            assert!(std::panic::catch_unwind(std::panic::AssertUnwindSafe(work)).is_err());
            first();
        });
        assert_eq!(outer.tags(), BTreeSet::from(["P1"]));
        assert_eq!(inner.tags(), BTreeSet::from(["P2"]));
    }
}
