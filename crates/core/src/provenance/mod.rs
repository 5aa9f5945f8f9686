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

use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Records that the equation with this tag is evaluated; the first statement of a tagged function.
#[macro_export]
macro_rules! cite {
    ($tag:literal) => {{
        const PLACE: usize = $crate::provenance::place($tag);
        $crate::provenance::note(PLACE)
    }};
}

const WORDS: usize = rows::COUNT.div_ceil(u64::BITS as usize);

/// A bit for each equation.
type Bits = [u64; WORDS];

thread_local! {
    /// The equations that ran in the innermost collection.
    static USED: [Cell<u64>; WORDS] = const { [const { Cell::new(0) }; WORDS] };
    /// The innermost collection.
    static CURRENT: RefCell<Option<Provenance>> = const { RefCell::new(None) };
}

/// Records that the equation at this place of [`TAGS`] is evaluated.
#[inline]
pub fn note(place: usize) {
    let bits = u64::BITS as usize;
    USED.with(|used| {
        let word = &used[place / bits];
        word.set(word.get() | 1 << (place % bits));
    });
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

    /// Runs `work` and adds the tags of all equations that it evaluates on this thread, and on others in functions
    /// [`carried`] there.
    ///
    /// Of nested calls the innermost collects.
    pub fn collect<T>(&self, work: impl FnOnce() -> T) -> T {
        let _scope = Scope {
            used: exchanged([0; WORDS]),
            outer: CURRENT.replace(Some(self.clone())),
        };
        work()
    }

    /// Adds the tags of `other`, whose work was done before and is used again.
    pub fn include(&self, other: &Self) {
        let used = *other.lock();
        self.add(used);
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

    fn add(&self, used: Bits) {
        for (word, more) in self.lock().iter_mut().zip(used) {
            *word |= more;
        }
    }

    fn lock(&self) -> MutexGuard<'_, Bits> {
        self.used.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// `work` for the tasks of a parallel loop: on whichever thread it runs, its tags are added to the set that collects
/// where `carried` is called.
pub fn carried<A, T>(work: impl Fn(A) -> T + Sync) -> impl Fn(A) -> T + Sync {
    let used = CURRENT.with_borrow(Clone::clone).unwrap_or_default();
    move |input| used.collect(|| work(input))
}

/// Replaces the bits of this thread; returns the former ones.
fn exchanged(bits: Bits) -> Bits {
    USED.with(|used| std::array::from_fn(|k| used[k].replace(bits[k])))
}

/// Adds what ran to the collection and restores the outer one when dropped, also if the work panics.
struct Scope {
    used: Bits,
    outer: Option<Provenance>,
}

impl Drop for Scope {
    fn drop(&mut self) {
        let used = exchanged(self.used);
        if let Some(collection) = CURRENT.replace(self.outer.take()) {
            collection.add(used);
        }
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
    fn tasks_on_other_threads_share_a_clone() {
        let used = Provenance::new();
        std::thread::scope(|scope| {
            for work in [first, second] {
                let used = used.clone();
                scope.spawn(move || used.collect(work));
            }
        });
        assert_eq!(used.tags(), BTreeSet::from(["P1", "P2"]));
    }

    #[test]
    fn a_carried_function_collects_where_it_was_made() {
        let used = Provenance::new();
        let work = used.collect(|| carried(|work: fn()| work()));
        std::thread::scope(|scope| {
            scope.spawn(|| work(first));
            scope.spawn(|| Provenance::new().collect(|| work(second)));
        });
        assert_eq!(used.tags(), BTreeSet::from(["P1", "P2"]));
        // Without a collection its tags go nowhere, whatever the thread that runs it collects.
        let (alone, other) = (carried(|work: fn()| work()), Provenance::new());
        other.collect(|| alone(first));
        assert!(other.tags().is_empty());
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
