//! Draws of the energy lost over a cycle.
//!
//! ```text
//! E_j = Σ_i P_i exp(L_j(T_i, ω_i)) Δt_i
//! ```
//!
//! Constants, structure, tip relief and the error of the model are common to all points. The standard error of the sampling
//! is 0.75 of the sum over the points, see [`OF_ENERGY`].

use std::collections::BTreeMap;

use asperity::uncertainty::{Predictive, Quantiles};

use super::energy::{CycleFinish, WATT_HOUR};
use super::trace::Cycle;
use crate::map::{Drawn, FinishMap, Map, Place};

/// Standard error of an energy by the sampling of the flanks over the sum of the errors of its points: the points lie at other
/// places of the same traces. 0.74 measured over six points; independent points would have 0.45.
const OF_ENERGY: f64 = 0.75;

/// Energies of all draws \[Wh\].
fn energies(drawn: &Drawn<'_>, finish: &CycleFinish, cycle: &Cycle, celsius: f64) -> Vec<f64> {
    let mut of_places: BTreeMap<Place, f64> = BTreeMap::new();
    for (point, loss) in cycle.points.iter().zip(&finish.loss_w) {
        let place = drawn.place(point.torque_nm, point.speed_rpm, celsius);
        *of_places.entry(place).or_default() += loss * point.weight_s / WATT_HOUR;
    }
    let mut energies = vec![0.0; Predictive::count()];
    for (place, energy) in of_places {
        for (sum, ratio) in energies.iter_mut().zip(drawn.ratios(place)) {
            *sum += energy * ratio;
        }
    }
    energies
}

/// Adds median and quantiles of the energy and of the loss at each point, if the map has draws.
pub(super) fn add_draws(result: &mut CycleFinish, finish: &FinishMap, cycle: &Cycle, celsius: f64) {
    let Some(drawn) = finish.drawn(0, OF_ENERGY) else {
        return;
    };
    let found = Quantiles::of(&energies(&drawn, result, cycle, celsius));
    result.lost_median_wh = Some(found.median_w);
    result.lost_quantiles_wh = Some(found.quantiles_w);
    let Some(drawn) = finish.drawn(0, 1.0) else {
        return;
    };
    let mut of_places: BTreeMap<Place, [f64; 3]> = BTreeMap::new();
    let points = cycle.points.iter().zip(&result.loss_w);
    let of_point = points.map(|(point, loss)| {
        let place = drawn.place(point.torque_nm, point.speed_rpm, celsius);
        let ratios = of_places.entry(place);
        ratios
            .or_insert_with(|| drawn.quantiles(place))
            .map(|ratio| ratio * loss)
    });
    result.drawn_w = of_point.collect();
}

/// Adds the differences from the first finish, draw by draw; errors of model and sampling are drawn apart unless the flanks are
/// the same.
pub(super) fn add_differences(
    finishes: &mut [CycleFinish],
    map: &Map,
    cycle: &Cycle,
    celsius: f64,
) {
    let Some(((first, others), of_first)) = finishes.split_first_mut().zip(map.finishes.first())
    else {
        return;
    };
    let Some(drawn) = of_first.drawn(0, OF_ENERGY) else {
        return;
    };
    let base = energies(&drawn, first, cycle, celsius);
    for (result, finish) in others.iter_mut().zip(&map.finishes[1..]) {
        let flanks = |of: &FinishMap| [of.files.clone(), of.coast_files.clone()];
        let is_same = flanks(finish) == flanks(of_first);
        let Some(drawn) = finish.drawn(usize::from(!is_same), OF_ENERGY) else {
            continue;
        };
        let own = energies(&drawn, result, cycle, celsius);
        let deltas: Vec<f64> = own
            .iter()
            .zip(&base)
            .map(|(own, base)| own - base)
            .collect();
        let found = Quantiles::of(&deltas);
        result.difference_median_wh = Some(found.median_w);
        result.difference_quantiles_wh = Some(found.quantiles_w);
    }
}
