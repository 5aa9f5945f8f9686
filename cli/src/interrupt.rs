//! Ctrl-C and SIGTERM.

use std::sync::{Mutex, PoisonError};

use asperity_core::Code;
use asperity_core::cancel::Token;

/// Exit status of a process that was interrupted.
pub const INTERRUPTED: u8 = Code::E502.exit_status();

/// Token of work that ends itself at its next checkpoint; `None` for work that a signal ends at once.
static ENDS_ITSELF: Mutex<Option<Token>> = Mutex::new(None);

fn set(token: Option<Token>) -> Option<Token> {
    let mut current = ENDS_ITSELF.lock().unwrap_or_else(PoisonError::into_inner);
    std::mem::replace(&mut *current, token)
}

/// Removes temporary files on a signal and ends the process. Without the handler the next start would remove them.
pub fn handle() {
    // The handler stays if a process runs several command lines.
    let _ = ctrlc::set_handler(|| match set(None) {
        Some(token) => token.cancel(),
        None => {
            asperity_storage::abandon();
            std::process::exit(i32::from(INTERRUPTED));
        }
    });
}

/// Does `work`, which the first signal cancels, so that it can store what is finished; a second signal ends the process.
pub fn cancelling<T>(work: impl FnOnce() -> T) -> T {
    let token = Token::new();
    set(Some(token.clone()));
    let done = token.run(work);
    set(None);
    done
}
