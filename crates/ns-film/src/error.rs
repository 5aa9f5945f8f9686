//! Errors of film computations.

use asperity_core::{DomainError, number};

/// Errors of the film pressure.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FilmError {
    /// An input outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// Too few points along the film.
    #[error("{points} points are too few for a film: give at least {least}")]
    TooFewPoints {
        /// Number of points.
        points: usize,
        /// Least number of points.
        least: usize,
    },
    /// An array does not have one value per point.
    #[error("{name} has {got} values where {need} are needed")]
    WrongLength {
        /// The array.
        name: &'static str,
        /// Number of values required.
        need: usize,
        /// Number of values of the array.
        got: usize,
    },
    /// An array has an invalid value.
    #[error("{name}[{index}] = {value} {unit}: {rule}", value = number(*value))]
    BadElement {
        /// The array.
        name: &'static str,
        /// Index in the array.
        index: usize,
        /// The value there.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// Rule that it violates.
        rule: &'static str,
    },
}
