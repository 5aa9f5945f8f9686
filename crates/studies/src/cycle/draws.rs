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
use crate::map::{Drawn, FinishMap, Place};

/// Standard error of an energy by the sampling of the flanks over the sum of the errors of its points: the points lie at other
/// places of the same traces. 0.74 measured over six points; independent points would have 0.45.
const OF_ENERGY: f64 = 0.75;

/// Joules per watt-hour.
pub(super) const WATT_HOUR: f64 = 3600.0;

/// Draws of a finish over a cycle at one temperature.
#[derive(Clone, Copy)]
pub(super) struct Draws<'a> {
    pub finish: &'a FinishMap,
    pub cycle: &'a Cycle,
    /// Temperature of the flanks \[°C\].
    pub celsius: f64,
    /// Loss at each point, with every constant at its median \[W\].
    pub loss_w: &'a [f64],
}

impl Draws<'_> {
    /// Energies of all draws \[Wh\], for a difference with those in common with the first finish; `None` on a map without draws.
    pub fn energies_wh(&self, is_beside_first: bool) -> Option<Vec<f64>> {
        let drawn = self.finish.drawn(is_beside_first, OF_ENERGY)?;
        let mut of_places: BTreeMap<Place, f64> = BTreeMap::new();
        let weights = self
            .cycle
            .points
            .iter()
            .map(|point| point.weight_s / WATT_HOUR);
        for ((place, loss), hours) in self.places(&drawn).zip(weights) {
            *of_places.entry(place).or_default() += loss * hours;
        }
        let mut energies = vec![0.0; Predictive::count()];
        for (place, energy) in of_places {
            add_times(&mut energies, energy, &drawn.ratios(place));
        }
        Some(energies)
    }

    /// Median with 5 % and 95 % quantiles of the loss at each point \[W\]; `None` on a map without draws.
    pub fn losses_w(&self) -> Option<Vec<Estimate>> {
        let drawn = self.finish.drawn(false, 1.0)?;
        let mut of_places: BTreeMap<Place, Estimate> = BTreeMap::new();
        let of_point = self.places(&drawn).map(|(place, loss)| {
            let ratios = of_places.entry(place);
            let ratios = ratios.or_insert_with(|| drawn.quantiles(place));
            ratios.map(|ratio| ratio * loss)
        });
        Some(of_point.collect())
    }

    /// Place between the nodes and loss of each point.
    fn places(&self, drawn: &Drawn<'_>) -> impl Iterator<Item = (Place, f64)> {
        let points = self.cycle.points.iter().zip(self.loss_w);
        points.map(|(point, loss)| {
            let place = drawn.place(point.torque_nm, point.speed_rpm, self.celsius);
            (place, *loss)
        })
    }
}
