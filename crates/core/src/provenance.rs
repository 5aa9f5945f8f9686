//! Tags of the equations that ran, collected while they run.
//!
//! A tagged function calls [`cite!`](crate::cite) with its tag. Outside of [`Provenance::collect`] that
//! costs one look at a thread-local flag; inside it the tag is noted once. A result therefore names an
//! equation exactly when its function ran.
//!
//! ```
//! use asperity_core::{cite, provenance::Provenance};
//!
//! /// F = m·a `[Newton-2]`
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
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// Notes that the equation with this tag is evaluated; the first statement of a tagged function.
///
/// In a loop over many points, call it in the function around the loop.
#[macro_export]
macro_rules! cite {
    ($tag:literal) => {{
        static SITE: $crate::provenance::Site = $crate::provenance::Site::new($tag);
        SITE.note();
    }};
}

/// Tags in the order in which they were first noted; their index is the bit of a tag.
static REGISTRY: Mutex<Vec<&'static str>> = Mutex::new(Vec::new());

/// Bits of a word of a [`BitSet`].
const WORD: usize = u64::BITS as usize;

/// Words of the first tags, which a thread notes without a look at the heap: hot loops do it per point.
const WORDS: usize = 16;

/// Tags noted, by their bits.
#[derive(Default)]
struct BitSet {
    first: [u64; WORDS],
    more: Vec<u64>,
}

impl BitSet {
    fn has(&self, index: usize) -> bool {
        let (word, bit) = (index / WORD, index % WORD);
        let bits = self.first.get(word).or_else(|| self.more.get(word - WORDS));
        bits.is_some_and(|bits| bits >> bit & 1 == 1)
    }

    /// Takes what this thread has noted and leaves it `next`.
    fn exchange(next: Self) -> Self {
        let mut taken = Self {
            more: NOTED_MORE.replace(next.more),
            ..Self::default()
        };
        NOTED.with(|noted| {
            for ((to, from), next) in taken.first.iter_mut().zip(noted).zip(next.first) {
                *to = from.replace(next);
            }
        });
        taken
    }
}

thread_local! {
    static COLLECTING: Cell<bool> = const { Cell::new(false) };
    static NOTED: [Cell<u64>; WORDS] = const { [const { Cell::new(0) }; WORDS] };
    static NOTED_MORE: RefCell<Vec<u64>> = const { RefCell::new(Vec::new()) };
}

/// Place in the code that evaluates an equation; made by [`cite!`](crate::cite).
#[derive(Debug)]
pub struct Site {
    tag: &'static str,
    /// One more than the index in the registry; 0 until first used.
    number: AtomicUsize,
}

impl Site {
    /// The place with this tag.
    #[must_use]
    pub const fn new(tag: &'static str) -> Self {
        Self {
            tag,
            number: AtomicUsize::new(0),
        }
    }

    /// Notes the tag where somebody collects on this thread.
    #[inline]
    pub fn note(&self) {
        if COLLECTING.get() {
            self.note_bit();
        }
    }

    fn note_bit(&self) {
        let index = match self.number.load(Ordering::Relaxed) {
            0 => self.register(),
            number => number - 1,
        };
        let (word, bit) = (index / WORD, 1 << (index % WORD));
        NOTED.with(|noted| match noted.get(word) {
            Some(bits) => bits.set(bits.get() | bit),
            None => NOTED_MORE.with_borrow_mut(|more| {
                let word = word - WORDS;
                more.resize(more.len().max(word + 1), 0);
                more[word] |= bit;
            }),
        });
    }

    fn register(&self) -> usize {
        let mut registry = REGISTRY.lock().unwrap_or_else(PoisonError::into_inner);
        let index = registry
            .iter()
            .position(|known| *known == self.tag)
            .unwrap_or_else(|| {
                registry.push(self.tag);
                registry.len() - 1
            });
        self.number.store(index + 1, Ordering::Relaxed);
        index
    }
}

/// Set of the equations that ran inside [`Provenance::collect`]; clones share the set, so that one
/// goes into every task of a parallel computation.
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

    /// Runs `work` and adds the tags of all equations that it evaluates on this thread.
    ///
    /// Of nested calls the innermost collects. Work that runs on other threads is collected by calling
    /// this in each task.
    pub fn collect<T>(&self, work: impl FnOnce() -> T) -> T {
        let _scope = Scope::enter(self);
        work()
    }

    /// Adds the tags of `other`, of work that was done before and is used again.
    pub fn include(&self, other: &Self) {
        let found = other.tags();
        self.tags
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .extend(found);
    }

    /// Tags collected so far, in alphabetical order.
    #[must_use]
    pub fn tags(&self) -> BTreeSet<&'static str> {
        self.tags
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .clone()
    }
}

/// Collects until dropped, also where the work panics.
struct Scope<'a> {
    into: &'a Provenance,
    outer: Option<BitSet>,
}

impl<'a> Scope<'a> {
    fn enter(into: &'a Provenance) -> Self {
        let noted = BitSet::exchange(BitSet::default());
        Self {
            into,
            outer: COLLECTING.replace(true).then_some(noted),
        }
    }
}

impl Drop for Scope<'_> {
    fn drop(&mut self) {
        COLLECTING.set(self.outer.is_some());
        let noted = BitSet::exchange(self.outer.take().unwrap_or_default());
        let registry = REGISTRY.lock().unwrap_or_else(PoisonError::into_inner);
        let mut tags = self
            .into
            .tags
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        for (index, tag) in registry.iter().enumerate() {
            if noted.has(index) {
                tags.insert(tag);
            }
        }
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
    fn any_number_of_tags_is_told_apart() {
        let names = (0..WORDS * WORD + 70).map(|k| format!("Many-{k}"));
        let sites: Vec<Site> = names.map(|name| Site::new(name.leak())).collect();
        let used = Provenance::new();
        used.collect(|| sites.iter().step_by(3).for_each(Site::note));
        let expected: BTreeSet<_> = sites.iter().step_by(3).map(|site| site.tag).collect();
        assert_eq!(used.tags(), expected);
    }
}
