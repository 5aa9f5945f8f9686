//! Draws of the energy lost over a cycle.
//!
//! ```text
//! E_j = Σ_i P_i exp(L_j(T_i, ω_i)) Δt_i
//! ```
//!
//! Constants, structure, tip relief and the error of the model are common to all points. The standard error of the sampling
//! is 0.75 of the sum over the points, see [`OF_ENERGY`].

use asperity_core::Estimate;
use std::collections::BTreeMap;

use asperity::uncertainty::Predictive;
use asperity_core::numerics::add_times;

use super::trace::Cycle;
use crate::map::{Beside, FinishMap, MapPlace};

/// Standard error of an energy by the sampling of the flanks over the sum of the errors of its points: the points lie at other
/// places of the same traces. 0.74 measured over six points; independent points would have 0.45.
const OF_ENERGY: f64 = 0.75;

/// Joules per watt-hour.
pub(super) const WATT_HOUR: f64 = 3600.0;

/// Draws of a finish over a cycle at one temperature.
pub(super) struct CycleDraws<'a> {
    finish: &'a FinishMap,
    cycle: &'a Cycle,
    /// Place of each point between the nodes, and its loss with every constant at its median \[W\].
    points: Vec<(MapPlace, f64)>,
    /// Quantiles of the loss at the places over the loss with every constant at its median.
    ratios: BTreeMap<MapPlace, Estimate>,
}

impl<'a> CycleDraws<'a> {
    /// The draws of a finish with the losses `loss_w` \[W\] at the points of the cycle, which are medians; `None` on a map without
    /// draws.
    pub fn new(
        finish: &'a FinishMap,
        celsius: f64,
        cycle: &'a Cycle,
        loss_w: &[f64],
    ) -> Option<Self> {
        let drawn = finish.drawn(Beside::Nothing, 1.0)?;
        let mut ratios = BTreeMap::new();
        let points = cycle.points.iter().zip(loss_w).map(|(point, loss)| {
            let place = drawn.place(point.torque_nm, point.speed_rpm, celsius);
            let of_place = ratios.entry(place);
            let found: &mut Estimate = of_place.or_insert_with(|| drawn.quantiles(place));
            (place, loss / found.value)
        });
        Some(Self {
            finish,
            cycle,
            points: points.collect(),
            ratios,
        })
    }

    /// Energy with every constant at its median \[Wh\].
    pub(crate) fn at_medians_wh(&self) -> f64 {
        self.hours().map(|((_, loss), hours)| loss * hours).sum()
    }

    /// Energies of all draws \[Wh\], in common with those of another finish; `None` on a map without draws.
    pub(crate) fn energies_wh(&self, beside: Beside<'_>) -> Option<Vec<f64>> {
        let drawn = self.finish.drawn(beside, OF_ENERGY)?;
        let mut of_places: BTreeMap<MapPlace, f64> = BTreeMap::new();
        for ((place, loss), hours) in self.hours() {
            *of_places.entry(*place).or_default() += loss * hours;
        }
        let mut energies = vec![0.0; Predictive::count()];
        for (place, energy) in of_places {
            add_times(&mut energies, energy, &drawn.ratios(place));
        }
        Some(energies)
    }

    /// Median with 5 % and 95 % quantiles of the loss at each point \[W\].
    pub fn losses_w(&self) -> Vec<Estimate> {
        let of_point = |(place, loss): &(MapPlace, f64)| {
            let ratios = self.ratios.get(place);
            ratios.map(|ratios| ratios.map(|ratio| ratio * loss))
        };
        self.points.iter().filter_map(of_point).collect()
    }

    /// Points with the hours that they stand for.
    fn hours(&self) -> impl Iterator<Item = (&(MapPlace, f64), f64)> {
        let hours = self
            .cycle
            .points
            .iter()
            .map(|point| point.weight_s / WATT_HOUR);
        self.points.iter().zip(hours)
    }
}
