//! Measurements that would decide a difference: what of its interval is left if their quantity is known.

use asperity_core::numerics::add_times;
use asperity_uncertainty::{Common, Component, Predictive, median_with_ends};
use serde::{Deserialize, Serialize};

use super::difference::{DrawnMesh, differences};

/// A measurement with what it leaves of the interval of a difference at best: if it were exact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct DecidingMeasurement {
    /// The measurement in words.
    pub measurement: String,
    /// Whether it is made for the first and for the other run.
    pub of: [bool; 2],
    /// Whether its quantity is one for both, so that one measurement serves both.
    pub is_common: bool,
    /// 5 and 95 % quantiles of the difference about its present median \[W\].
    pub quantiles_w: [f64; 2],
    /// Width of this interval over the present one.
    pub width: f64,
}

/// Least gain that is worth a row, in widths.
const LEAST: f64 = 0.98;
/// ρ above which a quantity of two runs is one quantity for a measurement.
const OF_ONE_THING: f64 = 0.5;

/// Measurements that narrow the difference of two runs with their draws in common, the one that leaves the narrowest interval first.
///
/// The components of a measurement are at their medians in the run that it is made for, and in both if they are common to both.
#[must_use]
pub fn deciding(first: &[DrawnMesh<'_>], other: &[DrawnMesh<'_>]) -> Vec<DecidingMeasurement> {
    let sides = [first, other];
    let (Some(own), Some(theirs)) = (first.first(), other.first()) else {
        return Vec::new();
    };
    let total = |meshes: &[DrawnMesh<'_>], held: &dyn Fn(&DrawnMesh<'_>) -> Vec<Component>| {
        let mut total: Vec<f64> = Vec::new();
        for mesh in meshes {
            let losses = mesh.predictive.losses_holding(mesh.common, &held(mesh));
            total.resize(losses.len(), 0.0);
            add_times(&mut total, f64::from(mesh.count), &losses);
        }
        total
    };
    let drawn = sides.map(|meshes| total(meshes, &|_| Vec::new()));
    let now = median_with_ends(&differences([&drawn[0], &drawn[1]]));
    let width = now.high - now.low;
    let has_flanks = own.common.flanks == theirs.common.flanks;
    // One measurement states what both have in common for the most part.
    let is_shared =
        |rho: &dyn Fn(&Common) -> f64| rho(&own.common).min(rho(&theirs.common)) > OF_ONE_THING;
    let is_common = |component: Component, of: &Predictive| match component {
        Component::Constant(k) => {
            let axis = of.constants[k].kind as usize;
            is_shared(&|common| common.constants[axis])
        }
        Component::Sampling => has_flanks && is_shared(&|common| common.sampling),
        Component::Model => has_flanks && is_shared(&|common| common.model),
        Component::Relief => is_shared(&|common| common.relief),
        Component::FilmLaw | Component::PressureLaw => own.common.curves && theirs.common.curves,
        _ => true,
    };
    let remedies = sides.map(|meshes| {
        let parts = meshes.iter().flat_map(|mesh| &mesh.uncertainty.loss.parts);
        let remedies: Vec<&str> = parts.map(|part| &*part.remedy).collect();
        asperity_core::unique(remedies)
    });
    let all = asperity_core::unique(remedies.iter().flatten().copied());
    let held = |mesh: &DrawnMesh<'_>, remedy: &str| -> Vec<(Component, bool)> {
        let parts = mesh.uncertainty.loss.parts.iter();
        let named: Vec<&str> = parts
            .filter(|part| part.remedy == remedy)
            .map(|part| &*part.name)
            .collect();
        let of_mesh = Component::all(mesh.predictive);
        let of_mesh = of_mesh.filter(|component| named.contains(&component.name(mesh.predictive)));
        of_mesh
            .map(|component| (component, is_common(component, mesh.predictive)))
            .collect()
    };
    let row = |remedy: &str, of: [bool; 2]| {
        let left = [0, 1].map(|side: usize| {
            let held = |mesh: &DrawnMesh<'_>| -> Vec<Component> {
                let held = held(mesh, remedy).into_iter();
                let held = held.filter(|(_, is_common)| of[side] || *is_common);
                held.map(|(component, _)| component).collect()
            };
            let is_changed = sides[side].iter().any(|mesh| !held(mesh).is_empty());
            is_changed.then(|| total(sides[side], &held))
        });
        let left = [0, 1].map(|side: usize| left[side].as_deref().unwrap_or(&drawn[side]));
        let found = median_with_ends(&differences(left));
        let moved = now.value - found.value;
        let of_measurement = (found.high - found.low) / width;
        (of_measurement < LEAST).then(|| DecidingMeasurement {
            measurement: remedy.to_owned(),
            of,
            is_common: false,
            quantiles_w: found.ends().map(|end| end + moved),
            width: of_measurement,
        })
    };
    let mut rows = Vec::new();
    if width <= 0.0 {
        return rows;
    }
    for remedy in all {
        let mut components = sides
            .into_iter()
            .flatten()
            .flat_map(|mesh| held(mesh, remedy));
        if components.all(|(_, is_common)| is_common) {
            rows.extend(row(remedy, [true; 2]).map(|row| DecidingMeasurement {
                is_common: true,
                ..row
            }));
            continue;
        }
        let is_of = [0, 1].map(|side: usize| remedies[side].contains(&remedy));
        let sides = [[true, false], [false, true], [true; 2]];
        let sides = sides
            .into_iter()
            .filter(|of| (0..2).all(|side| !of[side] || is_of[side]));
        rows.extend(sides.filter_map(|of| row(remedy, of)));
    }
    rows.sort_by(|a, b| a.width.total_cmp(&b.width));
    rows
}
