//! Tags of the equations that ran, collected while they run.
//!
//! A tagged function calls [`cite!`](crate::cite) with its tag. Outside of [`Provenance::collect`] that
//! reads one thread-local flag; inside it the tag is added to the set. A result therefore names an
//! equation exactly if its function ran.
//!
//! ```
//! use asperity_core::{cite, provenance::Provenance};
//!
//! /// Force on an accelerated mass: F = m·a `[Newton-2]`
//! fn force(mass: f64, acceleration: f64) -> f64 {
//!     cite!("Newton-2");
//!     mass * acceleration
//! }
//!
//! let used = Provenance::new();
//! let weight = used.collect(|| force(2.0, 9.81));
//! assert_eq!(weight, 19.62);
//! assert!(used.tags().contains("Newton-2"));
//! ```

use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Records that the equation with this tag is evaluated; the first statement of a tagged function.
///
/// In a loop over many points, call it in the function around the loop.
#[macro_export]
macro_rules! cite {
    ($tag:literal) => {
        $crate::provenance::note($tag)
    };
}

/// Slots of the table of tags that a thread has already added; a power of two well above the number of calls of
/// [`cite!`](crate::cite).
const SLOTS: usize = 1024;

thread_local! {
    static COLLECTING: Cell<bool> = const { Cell::new(false) };
    static CURRENT: RefCell<Option<Provenance>> = const { RefCell::new(None) };
    static ADDED: [Cell<Option<&'static str>>; SLOTS] = const { [const { Cell::new(None) }; SLOTS] };
}

/// Adds `tag` to the set that this thread collects into, if any.
#[inline]
pub fn note(tag: &'static str) {
    if COLLECTING.get() {
        add(tag);
    }
}

/// Hot loops call this for every point, so a tag reaches the shared set once: a hash table of addresses with linear
/// probing filters the others.
fn add(tag: &'static str) {
    // Fibonacci hashing: the upper bits of the product with 2⁶⁴ over the golden ratio.
    let hash = (tag.as_ptr() as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let start = (hash >> (u64::BITS - SLOTS.ilog2())) as usize;
    let is_new = ADDED.with(|added| {
        // Nearly always the first slot; the loop below costs twice as much.
        if added[start]
            .get()
            .is_some_and(|known| std::ptr::eq(known, tag))
        {
            return false;
        }
        for slot in added[start..].iter().chain(&added[..start]) {
            match slot.get() {
                Some(known) if std::ptr::eq(known, tag) => return false,
                Some(_) => {}
                None => {
                    slot.set(Some(tag));
                    break;
                }
            }
        }
        true
    });
    if is_new {
        CURRENT.with_borrow(|current| {
            if let Some(used) = current {
                used.lock().insert(tag);
            }
        });
    }
}

/// Set of the equations that ran inside [`Provenance::collect`]; clones share the set.
#[derive(Debug, Clone, Default)]
pub struct Provenance {
    tags: Arc<Mutex<BTreeSet<&'static str>>>,
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
            outer: collect_into(Some(self.clone())),
        };
        work()
    }

    /// Adds the tags of `other`, whose work was done before and is used again.
    pub fn include(&self, other: &Self) {
        let tags = other.tags();
        self.lock().extend(tags);
    }

    /// Tags collected so far, in alphabetical order.
    #[must_use]
    pub fn tags(&self) -> BTreeSet<&'static str> {
        self.lock().clone()
    }

    fn lock(&self) -> MutexGuard<'_, BTreeSet<&'static str>> {
        self.tags.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// `work` for the tasks of a parallel loop: on whichever thread it runs, its tags are added to the set that collects
/// where `carried` is called.
pub fn carried<A, T>(work: impl Fn(A) -> T + Sync) -> impl Fn(A) -> T + Sync {
    let used = CURRENT.with_borrow(Clone::clone).unwrap_or_default();
    move |input| used.collect(|| work(input))
}

/// Makes this thread collect into `next`; returns the set before.
fn collect_into(next: Option<Provenance>) -> Option<Provenance> {
    ADDED.with(|added| added.iter().for_each(|slot| slot.set(None)));
    COLLECTING.set(next.is_some());
    CURRENT.replace(next)
}

/// Restores the outer collection when dropped, also if the work panics.
struct Scope {
    outer: Option<Provenance>,
}

impl Drop for Scope {
    fn drop(&mut self) {
        collect_into(self.outer.take());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first() {
        cite!("Test-1");
    }

    fn second() {
        cite!("Test-2");
    }

    #[test]
    fn only_what_ran_inside_is_named() {
        first();
        let used = Provenance::new();
        used.collect(second);
        assert_eq!(used.tags(), BTreeSet::from(["Test-2"]));
        first();
        assert_eq!(used.tags(), BTreeSet::from(["Test-2"]));
    }

    #[test]
    fn the_innermost_of_nested_calls_collects() {
        let (outer, inner) = (Provenance::new(), Provenance::new());
        outer.collect(|| {
            first();
            inner.collect(second);
        });
        assert_eq!(outer.tags(), BTreeSet::from(["Test-1"]));
        assert_eq!(inner.tags(), BTreeSet::from(["Test-2"]));
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
        assert_eq!(used.tags(), BTreeSet::from(["Test-1", "Test-2"]));
    }

    #[test]
    fn a_carried_function_collects_where_it_was_made() {
        let used = Provenance::new();
        let work = used.collect(|| carried(|work: fn()| work()));
        std::thread::scope(|scope| {
            scope.spawn(|| work(first));
            scope.spawn(|| Provenance::new().collect(|| work(second)));
        });
        assert_eq!(used.tags(), BTreeSet::from(["Test-1", "Test-2"]));
        // Without a collection its tags go nowhere, whatever the thread that runs it collects.
        let (alone, other) = (carried(|work: fn()| work()), Provenance::new());
        other.collect(|| alone(first));
        assert!(other.tags().is_empty());
    }

    #[test]
    fn any_number_of_tags_is_distinguished() {
        let names = (0..SLOTS + 70).map(|k| format!("Many-{k}"));
        let tags: Vec<&'static str> = names.map(|name| &*name.leak()).collect();
        let used = Provenance::new();
        for _ in 0..2 {
            used.collect(|| tags.iter().step_by(3).for_each(|tag| note(tag)));
        }
        let expected: BTreeSet<_> = tags.iter().step_by(3).copied().collect();
        assert_eq!(used.tags(), expected);
        let all = Provenance::new();
        all.collect(|| tags.iter().chain(&tags).for_each(|tag| note(tag)));
        assert_eq!(all.tags().len(), tags.len());
    }
}
