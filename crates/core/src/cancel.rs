//! Cancelling work that nobody waits for any more.
//!
//! A program that runs long work gives each of its threads a [`Token`]; the loops of the library call [`checkpoint`].
//! Once the token is cancelled, the next checkpoint unwinds the thread, as a panic does but without its message, and
//! [`Token::run`] gives [`Cancelled`] in place of a result. Without a token a checkpoint costs a look at a
//! thread-local flag.
//!
//! ```
//! use asperity_core::cancel::{Cancelled, Token, checkpoint};
//! let token = Token::new();
//! token.cancel();
//! let endless = token.run(|| loop {
//!     checkpoint();
//! });
//! assert_eq!(endless, Err::<(), _>(Cancelled));
//! ```

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

thread_local! {
    static CURRENT: RefCell<Option<Token>> = const { RefCell::new(None) };
}

/// The work was cancelled; it has no result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the work was cancelled")]
pub struct Cancelled;

/// Shared flag of one piece of work; clones share it.
#[derive(Debug, Clone, Default)]
pub struct Token(Arc<AtomicBool>);

impl Token {
    /// A token that is not cancelled.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Ends the work at its next checkpoints.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether the work was cancelled.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Makes this the token of the thread for good; for the threads of a pool that is made for one piece of work.
    pub fn adopt(&self) {
        CURRENT.set(Some(self.clone()));
    }

    /// Runs `work` with this as the token of the thread.
    ///
    /// # Errors
    /// When the token was cancelled before the work came to its end.
    pub fn run<T>(&self, work: impl FnOnce() -> T) -> Result<T, Cancelled> {
        let outer = CURRENT.replace(Some(self.clone()));
        // Whatever the work had borrowed is given up with it.
        let done = catch_unwind(AssertUnwindSafe(work));
        CURRENT.set(outer);
        done.map_err(|payload| match payload.downcast::<Cancelled>() {
            Ok(cancelled) => *cancelled,
            Err(payload) => resume_unwind(payload),
        })
    }
}

/// Ends the work on this thread where its token was cancelled; called in every loop that may take long.
#[inline]
pub fn checkpoint() {
    let is_cancelled = CURRENT.with_borrow(|token| token.as_ref().is_some_and(Token::is_cancelled));
    if is_cancelled {
        resume_unwind(Box::new(Cancelled));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_that_is_not_cancelled_has_its_result() {
        let token = Token::new();
        let done = token.run(|| {
            checkpoint();
            7
        });
        assert_eq!(done, Ok(7));
    }

    #[test]
    fn a_thread_that_has_adopted_the_token_is_ended() {
        let token = Token::new();
        let worker = std::thread::spawn({
            let token = token.clone();
            move || {
                token.adopt();
                for _ in 0..u64::MAX {
                    checkpoint();
                }
            }
        });
        token.cancel();
        let ended = worker.join().unwrap_err();
        assert!(ended.is::<Cancelled>());
    }

    #[test]
    fn the_token_of_the_thread_is_the_outer_one_again() {
        let (outer, inner) = (Token::new(), Token::new());
        let done = outer.run(|| {
            inner.cancel();
            assert_eq!(inner.run(checkpoint), Err(Cancelled));
            checkpoint();
        });
        assert_eq!(done, Ok(()));
        checkpoint();
    }

    #[test]
    fn other_panics_go_on() {
        let panicked = catch_unwind(|| Token::new().run(|| resume_unwind(Box::new("other"))));
        assert!(panicked.unwrap_err().is::<&str>());
    }
}
