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
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

pub(crate) const WORDS: usize = rows::COUNT.div_ceil(u64::BITS as usize);

/// A bit for each equation.
pub(crate) type Bits = [u64; WORDS];

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

    /// Adds the tags of `other`, whose work was done before and is used again.
    pub fn include(&self, other: &Self) {
        let used = *other.lock();
        self.add(used);
    }

    pub(crate) fn used(&self) -> Bits {
        *self.lock()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cite;
    use crate::noted::Noted;
    use crate::task::note;

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
