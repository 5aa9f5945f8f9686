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

pub use crate::task::checkpoint;
pub use crate::token::{Cancelled, Token};
