//! A task: what a thread works on, with the equations that it evaluates and the token that cancels it.
//!
//! The functions of the library see the task of their thread by [`cite!`](crate::cite) and
//! [`checkpoint`] only. [`Task::enter`] sets it, and `par_map` is the way to other threads: it takes the
//! task along, so that a parallel loop collects its equations and ends when it is cancelled.

use std::cell::{Cell, RefCell};
#[cfg(feature = "threads")]
use std::sync::atomic::{AtomicBool, Ordering};

use crate::provenance::{Bits, Provenance, WORDS};
use crate::token::{Cancelled, Token};

thread_local! {
    /// The equations that ran in the innermost task.
    static USED: [Cell<u64>; WORDS] = const { [const { Cell::new(0) }; WORDS] };
    /// The innermost task.
    static CURRENT: RefCell<Task> = const { RefCell::new(Task { used: None, token: None }) };
}

/// Work of a thread; clones are the same task.
#[derive(Debug, Clone, Default)]
pub struct Task {
    used: Option<Provenance>,
    token: Option<Token>,
}

impl Task {
    /// The task of this thread.
    #[must_use]
    pub fn current() -> Self {
        CURRENT.with_borrow(Clone::clone)
    }

    /// The task with its equations in `used`.
    #[must_use]
    pub fn collecting(self, used: &Provenance) -> Self {
        Self {
            used: Some(used.clone()),
            ..self
        }
    }

    /// The task that `token` cancels.
    #[must_use]
    pub fn cancelled_by(self, token: &Token) -> Self {
        Self {
            token: Some(token.clone()),
            ..self
        }
    }

    /// Does `work` as this task on this thread. Of nested tasks the innermost collects.
    pub fn enter<T>(&self, work: impl FnOnce() -> T) -> T {
        let _scope = Scope {
            used: exchanged([0; WORDS]),
            outer: CURRENT.replace(self.clone()),
        };
        work()
    }
}

impl Token {
    /// Runs `work` with this as the token of the task.
    pub fn run<T>(&self, work: impl FnOnce() -> T) -> T {
        Task::current().cancelled_by(self).enter(work)
    }
}

/// Called in every loop that may take long.
///
/// # Errors
/// When the token of this thread is cancelled.
#[inline]
pub fn checkpoint() -> Result<(), Cancelled> {
    let is_cancelled =
        CURRENT.with_borrow(|task| task.token.as_ref().is_some_and(Token::is_cancelled));
    if is_cancelled { Err(Cancelled) } else { Ok(()) }
}

impl Provenance {
    /// Runs `work` and adds the tags of all equations that it evaluates on this thread, and on others by `par_map`.
    ///
    /// Of nested calls the innermost collects.
    pub fn collect<T>(&self, work: impl FnOnce() -> T) -> T {
        Task::current().collecting(self).enter(work)
    }

    /// Notes the equations of this set, whose work was done before and is used here, as if they ran here.
    pub fn note(&self) {
        note_all(self.used());
    }
}

/// Records that the equation with this tag is evaluated; the first statement of a tagged function.
#[macro_export]
macro_rules! cite {
    ($tag:literal) => {{
        const PLACE: usize = $crate::provenance::place($tag);
        $crate::task::note(PLACE)
    }};
}

/// Records that the equation at this place of the table is evaluated.
#[inline]
pub fn note(place: usize) {
    let bits = u64::BITS as usize;
    USED.with(|used| {
        let word = &used[place / bits];
        word.set(word.get() | 1 << (place % bits));
    });
}

/// Notes these equations, which ran before.
pub(crate) fn note_all(bits: Bits) {
    USED.with(|used| {
        for (word, more) in used.iter().zip(bits) {
            word.set(word.get() | more);
        }
    });
}

/// Replaces the bits of this thread; returns the former ones.
fn exchanged(bits: Bits) -> Bits {
    USED.with(|used| std::array::from_fn(|k| used[k].replace(bits[k])))
}

/// Adds what ran to the equations of the task and restores the outer one when dropped, also if the work panics.
struct Scope {
    used: Bits,
    outer: Task,
}

impl Drop for Scope {
    fn drop(&mut self) {
        let used = exchanged(self.used);
        let task = CURRENT.replace(std::mem::take(&mut self.outer));
        if let Some(collection) = task.used {
            collection.add(used);
        }
    }
}

/// Items of a parallel loop: ranges, slices, vectors, and tuples of them.
#[cfg(feature = "threads")]
pub trait Items:
    rayon::iter::IntoParallelIterator<Iter: rayon::iter::IndexedParallelIterator>
{
}

#[cfg(feature = "threads")]
impl<I> Items for I where
    I: rayon::iter::IntoParallelIterator<Iter: rayon::iter::IndexedParallelIterator>
{
}

/// `work` of each of `items` on the threads of the pool, in the order of the items, as the task of this thread.
///
/// ```
/// use asperity_core::{cite, provenance::Provenance, task::par_map};
/// let used = Provenance::new();
/// let lengths = used.collect(|| {
///     par_map(&["a", "bc"], |text| {
///         cite!("P8");
///         text.len()
///     })
/// });
/// assert_eq!(lengths, [1, 2]);
/// assert!(used.tags().contains("P8"));
/// ```
#[cfg(feature = "threads")]
#[expect(
    clippy::disallowed_methods,
    reason = "the way to other threads, which takes the task along"
)]
pub fn par_map<I: Items, R: Send>(items: I, work: impl Fn(I::Item) -> R + Sync + Send) -> Vec<R> {
    use rayon::iter::ParallelIterator;
    let task = Task::current();
    let items = items.into_par_iter();
    items.map(|item| task.enter(|| work(item))).collect()
}

/// As [`par_map`], of work that can fail: after an error no further item is begun.
///
/// # Errors
/// The first error that was found, in the order of the items.
#[cfg(feature = "threads")]
pub fn try_par_map<I: Items, R: Send, E: Send>(
    items: I,
    work: impl Fn(I::Item) -> Result<R, E> + Sync + Send,
) -> Result<Vec<R>, E> {
    let has_failed = AtomicBool::new(false);
    let found = par_map(items, |item| {
        if has_failed.load(Ordering::Relaxed) {
            return None;
        }
        let found = work(item);
        has_failed.fetch_or(found.is_err(), Ordering::Relaxed);
        Some(found)
    });
    // An item is left out only beside an error.
    found.into_iter().flatten().collect()
}

/// Does `work` as the task of this thread on `count` threads of its own.
///
/// # Errors
/// When the system gives no threads.
#[cfg(feature = "threads")]
#[expect(
    clippy::disallowed_methods,
    reason = "the way to other threads, which takes the task along"
)]
pub fn on_threads<R: Send>(
    count: usize,
    work: impl FnOnce() -> R + Send,
) -> Result<R, rayon::ThreadPoolBuildError> {
    let task = Task::current();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build()?;
    Ok(pool.install(|| task.enter(work)))
}

/// Number of threads of [`par_map`] here.
#[cfg(feature = "threads")]
#[must_use]
pub fn threads() -> usize {
    rayon::current_num_threads()
}

#[cfg(feature = "threads")]
#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn one_of_two(k: usize) {
        if k == 0 {
            cite!("P1");
        } else {
            cite!("P2");
        }
    }

    #[test]
    fn a_parallel_loop_collects_where_it_was_called() {
        for count in [1, 4] {
            let used = Provenance::new();
            used.collect(|| on_threads(count, || par_map(0..2, one_of_two)))
                .unwrap();
            assert_eq!(used.tags(), BTreeSet::from(["P1", "P2"]));
        }
    }

    /// While a thread waits for the items of a loop it does those of another one.
    #[test]
    fn nested_loops_keep_their_equations_apart() {
        let found = on_threads(2, || {
            par_map(0..16, |k| {
                let used = Provenance::new();
                used.collect(|| par_map(0..8, |_| one_of_two(k % 2)));
                used.tags()
            })
        });
        for (k, tags) in found.unwrap().into_iter().enumerate() {
            assert_eq!(tags, BTreeSet::from([["P1", "P2"][k % 2]]));
        }
    }

    #[test]
    fn a_loop_that_fails_has_an_error_and_ends() {
        let odd = |k: usize| if k % 2 == 1 { Err(k) } else { Ok(k) };
        assert!(on_threads(4, || try_par_map(0..99, odd)).unwrap().is_err());
        assert_eq!(on_threads(1, || try_par_map(0..99, odd)).unwrap(), Err(1));
        assert_eq!(try_par_map([2, 4], odd), Ok(vec![2, 4]));
    }

    #[test]
    fn a_token_ends_a_parallel_loop_and_no_other() {
        let token = Token::new();
        let ended = on_threads(4, || {
            token.run(|| {
                par_map(0..64, |k| {
                    if k == 0 {
                        token.cancel();
                    }
                    while k > 0 && checkpoint().is_ok() {}
                    checkpoint()
                })
            })
        });
        assert!(ended.unwrap().contains(&Err(Cancelled)));
        assert!(par_map(0..4, |_| checkpoint()).iter().all(Result::is_ok));
    }
}

#[cfg(test)]
mod tests_of_tokens {
    use super::*;
    use std::panic::{AssertUnwindSafe, catch_unwind};

    #[test]
    fn work_that_is_not_cancelled_has_its_result() {
        assert_eq!(Token::new().run(|| checkpoint().map(|()| 7)), Ok(7));
    }

    #[test]
    fn the_token_of_the_thread_is_the_outer_one_again() {
        let (outer, inner) = (Token::new(), Token::new());
        outer.run(|| {
            inner.cancel();
            assert_eq!(inner.run(checkpoint), Err(Cancelled));
            assert_eq!(checkpoint(), Ok(()));
            // After a panic as well.
            let panicked = catch_unwind(AssertUnwindSafe(|| inner.run(|| panic!("a fault"))));
            assert!(panicked.is_err());
            assert_eq!(checkpoint(), Ok(()));
        });
        assert_eq!(checkpoint(), Ok(()));
    }
}
