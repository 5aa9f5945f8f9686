//! Cancelling long work from another thread.
//!
//! A program gives a piece of work a [`Token`], which [`Task`](crate::task::Task) takes to other threads. The loops of the library
//! call [`checkpoint`], which returns [`Cancelled`] once the token is cancelled; the error passes up as any other. Without a token a
//! checkpoint costs the reading of a thread-local flag.
//!
//! ```
//! use asperity_core::cancel::{Cancelled, Token, checkpoint};
//! let token = Token::new();
//! token.cancel();
//! let endless = token.run(|| -> Result<(), Cancelled> {
//!     loop {
//!         checkpoint()?;
//!     }
//! });
//! assert_eq!(endless, Err(Cancelled));
//! ```

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::task::Task;

/// The work was cancelled; it has no result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, thiserror::Error)]
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
    if Task::is_cancelled() {
        Err(Cancelled)
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
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
