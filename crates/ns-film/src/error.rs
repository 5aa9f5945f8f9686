//! Errors of a film.

use asperity_core::DomainError;

/// Errors of the film pressure.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FilmError {
    /// An input outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// Not enough points along the film.
    #[error("{points} points are too few for a film: give at least {least}")]
    TooFewPoints {
        /// Points given.
        points: usize,
        /// Points needed.
        least: usize,
    },
    /// Two arrays that belong together differ in length.
    #[error("{name} has {got} values where {need} are needed")]
    WrongLength {
        /// The array.
        name: &'static str,
        /// Values needed.
        need: usize,
        /// Values given.
        got: usize,
    },
    /// An array holds a value that it may not hold.
    #[error("{name}[{index}] = {value} {unit}: {rule}")]
    BadElement {
        /// The array.
        name: &'static str,
        /// Index in the array.
        index: usize,
        /// The value there.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// Expectation.
        rule: &'static str,
    },
}
