//! A full film by its elastohydrodynamic solution, in a result.

use serde::{Deserialize, Serialize};

/// Elastohydrodynamic solution of a full film compared with the formulas.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct FullFilmRow {
    /// Gap in the middle, of records the mean gap, thermal reduction of smooth films included \[µm\].
    pub film_central_um: f64,
    /// Minimum film, thermal reduction included \[µm\].
    pub film_minimum_um: f64,
    /// Largest pressure \[MPa\].
    pub p_max_mpa: f64,
    /// Friction coefficient; absent where a published law gives it.
    pub mu: Option<f64>,
    /// Central film relative to the formula, minus 1, both as flow of mass at ambient density.
    pub film_central_deviation: f64,
    /// Minimum film relative to the formula, minus 1.
    pub film_minimum_deviation: f64,
    /// Friction coefficient relative to the friction law, minus 1.
    pub mu_deviation: Option<f64>,
}

impl FullFilmRow {
    /// Largest deviation from a formula.
    pub(crate) fn largest_deviation(&self) -> f64 {
        let films = self
            .film_central_deviation
            .abs()
            .max(self.film_minimum_deviation.abs());
        self.mu_deviation.map_or(films, |mu| films.max(mu.abs()))
    }
}
