//! A film that carries the whole load, from the elastohydrodynamic solution instead of formulas.

use asperity_core::numerics::NodeInterval;
use asperity_core::quantity::Length;

use super::smooth_position::SmoothPosition;
use crate::result::FullFilmRow;

/// Deviation from the formulas that a run warns about.
pub(crate) const NOTED_DEVIATION: f64 = 0.1;

/// A full film at one mesh position.
#[derive(Debug, Clone)]
pub(crate) struct FullFilm {
    half_width: f64,
    /// Places over the half-width, pressures \[Pa\] and films \[m\] there.
    x: Vec<f64>,
    pressure: Vec<f64>,
    film: Vec<f64>,
    /// Friction coefficient; none for a published law, which has its own.
    pub coefficient: Option<f64>,
    pub row: FullFilmRow,
}

impl FullFilm {
    /// The film of `position`: central gap, minimum film, and flow of mass relative to the formula; friction
    /// coefficient by the solution and by the law.
    pub(crate) fn new(
        SmoothPosition {
            at: position,
            film: formula,
        }: SmoothPosition<'_>,
        fields: FilmFields,
        [central, minimum, flow]: [f64; 3],
        [coefficient, law]: [Option<f64>; 2],
    ) -> Self {
        let off = |value: f64, formula: f64| value / formula - 1.0;
        let largest = fields.pressure.iter().copied().fold(0.0, f64::max);
        let deviation = coefficient
            .zip(law.filter(|law| *law > 0.0))
            .map(|(mu, law)| off(mu, law));
        Self {
            half_width: position.hertz.half_width.si(),
            row: FullFilmRow {
                film_central_um: central * 1e6,
                film_minimum_um: minimum * 1e6,
                p_max_mpa: largest * 1e-6,
                mu: coefficient,
                film_central_deviation: flow - 1.0,
                film_minimum_deviation: off(minimum, formula.film.minimum.si()),
                mu_deviation: deviation,
            },
            x: fields.x,
            pressure: fields.pressure,
            film: fields.film,
            coefficient,
        }
    }

    /// Pressures at the points `x` \[m\]; zero outside the solution.
    pub(crate) fn pressure_at(&self, x: &[f64]) -> Vec<f64> {
        let value = |x: &f64| match self.interval(*x) {
            Some(interval) => interval.mean(|k| self.pressure[k]),
            None => 0.0,
        };
        x.iter().map(value).collect()
    }

    /// Films at the points `x` \[m\]; outside the solution the film of its end and the parabola beyond.
    pub(crate) fn gap_at(&self, x: &[f64], radius: Length) -> Vec<f64> {
        let last = self.x.len() - 1;
        let value = |x: &f64| match self.interval(*x) {
            Some(interval) => interval.mean(|k| self.film[k]),
            None => {
                let end = if *x < 0.0 { 0 } else { last };
                let edge = self.x[end] * self.half_width;
                self.film[end] + (x * x - edge * edge) / (2.0 * radius.si())
            }
        };
        x.iter().map(value).collect()
    }

    /// Interval of the solution's grid that holds `x` \[m\].
    fn interval(&self, x: f64) -> Option<NodeInterval> {
        NodeInterval::from_nodes(&self.x, |node| *node, x / self.half_width).inside()
    }
}

/// Places over the half-width, pressures \[Pa\] and films \[m\] there.
pub(crate) struct FilmFields {
    pub x: Vec<f64>,
    pub pressure: Vec<f64>,
    pub film: Vec<f64>,
}
