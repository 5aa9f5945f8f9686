//! Helpers shared by the workspace tests: cases built in the test, and traces to go with them.

/// The programs of the book compile, and those without files run.
#[cfg(doctest)]
mod book {
    #[doc = include_str!("../../docs/howto/embed.md")]
    mod embed {}
    #[doc = include_str!("../../docs/howto/law.md")]
    mod law {}
}
mod case_text;
pub mod markdown;
pub mod parsers;
pub mod picture;
mod planetary_set;
mod table_2;
mod trace;

pub use case_text::{CaseText, constant, contacts, losses, losses_with, run};
pub use planetary_set::planetary_set;
pub use table_2::{petry_johnson, table_2};
pub use trace::trace_csv;

/// Panics unless `actual` is within the relative tolerance of `expected`; returns the deviation.
///
/// # Panics
/// When it is not.
#[track_caller]
#[allow(clippy::panic, reason = "it is an assertion")]
pub fn assert_close(what: &str, actual: f64, expected: f64, relative: f64) -> f64 {
    let deviation = actual / expected - 1.0;
    let close = (actual - expected).abs() <= relative * expected.abs();
    assert!(
        close,
        "{what}: {actual} is not {expected} within {relative} (deviation {deviation:.3e})"
    );
    deviation
}
