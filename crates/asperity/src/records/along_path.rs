//! Records at a few places of the path, and what holds between them.

use std::sync::atomic::{AtomicUsize, Ordering};

use asperity_core::numerics::{NodeInterval, interpolate};
use asperity_core::provenance::{Provenance, TAGS};
use asperity_core::quantity::Length;
use asperity_core::task::note;
use asperity_core::task::par_map;
use asperity_ehl::{RecordMean, RecordSettings, transient};

use super::path_record::PathRecord;
use super::store::RecordStore;
use crate::mesh::{MeshPosition, Resolution};
use crate::reference_solution::{Inlet, ReferenceContact, ReferenceError, ReferenceSettings};
use crate::result::RecordedFriction;
use asperity_case::case::OperatingCase;
use asperity_case::error::PositionError;
use asperity_case::flanks::{AVERAGING_WIDTH, is_substituted};
use asperity_case::recorded_share::RecordedShare;

/// A record at its place on the path.
#[derive(Debug, Clone)]
pub(crate) struct PlacedRecord {
    pub position: MeshPosition,
    pub record: PathRecord,
    /// Friction of the film with its heat over that without, smooth flanks; 1 for published laws.
    pub heat: f64,
}

/// Records of a case, in order along the path.
#[derive(Debug, Clone)]
pub(crate) struct PathRecords {
    pub places: Vec<PlacedRecord>,
    /// Friction at the lay of the flanks over that with ridges across rolling, which the records have.
    pub of_lay: f64,
    /// Boundary friction of the records.
    boundary_friction: f64,
}

impl PathRecords {
    /// Solves the records of `loaded` along its `positions`, or reads them if they are stored; `smooth` gives
    /// the friction of the smooth film with its heat, and none for a published law. None where a flank was not
    /// measured, and where friction follows from pressures in the windows.
    ///
    /// # Errors
    /// When a record has no solution.
    pub(crate) fn solve(
        loaded: &OperatingCase,
        positions: &[MeshPosition],
        smooth: &(dyn Fn(&MeshPosition) -> Result<Option<f64>, PositionError> + Sync),
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Option<Self>, PositionError> {
        let case = loaded;
        if case.formulation.pressures().is_some() || !loaded.surfaces.are_measured() {
            return Ok(None);
        }
        let chosen = chosen(loaded, positions);
        let store = RecordStore::new(loaded.record_folder());
        let contacts = contacts(loaded, &chosen)?;
        let found: Vec<_> = contacts
            .iter()
            .map(|contact| {
                let name = RecordStore::name(contact);
                let record = store.find(&name);
                (name, record)
            })
            .collect();
        let missing = found.iter().filter(|(_, record)| record.is_none()).count();
        let done = AtomicUsize::new(0);
        let records: Vec<Result<PathRecord, PositionError>> =
            par_map((&contacts, found), |(contact, (name, record))| {
                if let Some(record) = record {
                    return Ok(record);
                }
                let record = solved(contact)?;
                store.keep(&name, &record);
                progress(1 + done.fetch_add(1, Ordering::Relaxed), missing);
                Ok(record)
            });
        let places = chosen.into_iter().zip(records).map(|(position, record)| {
            let record = record?;
            let heat = match smooth(&position)? {
                Some(hot) if record.smooth_friction > 0.0 => hot / record.smooth_friction,
                _ => 1.0,
            };
            Ok(PlacedRecord {
                position,
                record,
                heat,
            })
        });
        let places: Vec<_> = places.collect::<Result<_, PositionError>>()?;
        Ok((!places.is_empty()).then_some(Self {
            places,
            of_lay: 1.0,
            boundary_friction: case.model.boundary_friction,
        }))
    }

    /// Notes the equations of the records, solved now or before.
    pub(crate) fn cite(&self) {
        let tags = self.places.iter().flat_map(|place| &place.record.tags);
        let place = |tag: &String| TAGS.iter().position(|known| known == tag);
        tags.filter_map(place).for_each(note);
    }

    /// Records that a run has to solve at most.
    pub(crate) fn count(loaded: &OperatingCase, positions: &[MeshPosition]) -> usize {
        chosen(loaded, positions).len()
    }

    /// Shares and friction at `s` in the expectation over the two rules of boundary friction; `smooth` is the friction of the
    /// smooth film there. Beyond the first and the
    /// last record those hold.
    pub(crate) fn at(&self, s: Length, smooth: Option<f64>) -> RecordedShare {
        let between = self.between(s);
        let mean = |of: &dyn Fn(&PlacedRecord) -> f64| between.mean(|k| of(&self.places[k]));
        let estimate = |of: fn(&PathRecord) -> RecordMean| {
            let [low, high] = [between.low, between.high].map(|k| of(&self.places[k].record));
            let [a, b] = [1.0 - between.part, between.part];
            RecordMean {
                mean: a * low.mean + b * high.mean,
                standard_error: (a * low.standard_error).hypot(b * high.standard_error),
            }
        };
        RecordedShare {
            solid_share: estimate(|record| record.solid_share),
            boundary_part: mean(&|place| place.record.expected_boundary_part()),
            lubricated_coefficient: mean(&|place| place.heat * place.record.lubricated_friction),
            film_coefficient: smooth.map(|smooth| {
                let ratio =
                    |place: &PlacedRecord| place.record.expected_film_ratio(self.boundary_friction);
                smooth * mean(&ratio)
            }),
            mean_gap: estimate(|record| record.mean_film),
            max_pressure: mean(&|place| place.record.mean_max_pressure.mean),
        }
    }

    /// Mean pressure over p₀ and mean film \[m\] on the nodes `x`/a at `s`.
    pub(crate) fn profile(&self, s: Length) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let between = self.between(s);
        let [low, high] = [between.low, between.high].map(|k| &self.places[k].record);
        // Windows differ where one is at light load; nodes of the narrower one lie in both.
        let inlet = |record: &PathRecord| record.x.first().copied().unwrap_or(0.0);
        let x = if inlet(low) > inlet(high) {
            &low.x
        } else {
            &high.x
        };
        let mixed = |of: fn(&PathRecord) -> &Vec<f64>| {
            let [a, b] = [low, high].map(|record| on_nodes(x, &record.x, of(record)));
            let pairs = a.iter().zip(&b);
            pairs.map(|(a, b)| a + between.part * (b - a)).collect()
        };
        (
            x.clone(),
            mixed(|record| &record.pressure),
            mixed(|record| &record.film),
        )
    }

    /// Standard error of the weighted mean of the solid share over places with their weights: records are
    /// independent, places between the same two are not.
    pub(crate) fn mean_share_error(&self, weighted: impl Iterator<Item = (Length, f64)>) -> f64 {
        let of_record = self.weights(weighted);
        let total: f64 = of_record.iter().sum();
        let square = |(weight, place): (f64, &PlacedRecord)| {
            (weight / total * place.record.solid_share.standard_error).powi(2)
        };
        let squares = of_record.into_iter().zip(&self.places).map(square);
        squares.sum::<f64>().sqrt()
    }

    /// Error of the sliding loss by the records' friction, over places with the power \[W\] that a friction coefficient of one would
    /// take there; records are independent, places between the same two are not. `None` without power.
    pub(crate) fn friction_error(
        &self,
        powers: impl Iterator<Item = (Length, f64)>,
    ) -> Option<RecordedFriction> {
        let of_record = self.weights(powers);
        let sum = |of: &dyn Fn(&PlacedRecord) -> f64| -> f64 {
            let weighted = of_record.iter().zip(&self.places);
            weighted.map(|(weight, place)| weight * of(place)).sum()
        };
        let layer = self.boundary_friction;
        let friction = sum(&|place| place.record.hot_friction(layer, place.heat));
        let stepped = sum(&|place| place.record.hot_stepped_friction(layer, place.heat));
        let squares = of_record.iter().zip(&self.places);
        let squares = squares.map(|(weight, place)| {
            (weight * place.heat * place.record.friction.standard_error).powi(2)
        });
        (friction > 0.0).then(|| RecordedFriction {
            standard_error: squares.sum::<f64>().sqrt() / (0.5 * (friction + stepped)),
            stepped: stepped / friction,
            windows: self
                .places
                .iter()
                .map(|place| place.record.travel)
                .sum::<f64>()
                / AVERAGING_WIDTH,
        })
    }

    /// Weight of each record in a weighted sum over places.
    fn weights(&self, weighted: impl Iterator<Item = (Length, f64)>) -> Vec<f64> {
        let mut of_record = vec![0.0; self.places.len()];
        for (s, weight) in weighted {
            let between = self.between(s);
            of_record[between.low] += weight * (1.0 - between.part);
            of_record[between.high] += weight * between.part;
        }
        of_record
    }

    fn between(&self, s: Length) -> NodeInterval {
        let position = |place: &PlacedRecord| place.position.s.si();
        NodeInterval::from_nodes(&self.places, position, s.si()).held()
    }
}

/// The values at nodes `of` on nodes `x`, linear between nodes.
fn on_nodes(x: &[f64], of: &[f64], values: &[f64]) -> Vec<f64> {
    if x == of {
        return values.to_vec();
    }
    let line: Vec<(f64, f64)> = of.iter().copied().zip(values.iter().copied()).collect();
    x.iter().map(|x| interpolate(&line, *x)).collect()
}

/// MeshPositions of the records: evenly among those whose contact the traces resolve and that carry the loss.
fn chosen(loaded: &OperatingCase, positions: &[MeshPosition]) -> Vec<MeshPosition> {
    let carries = |position: &&MeshPosition| {
        position.resolution == Resolution::Required && !is_substituted(&loaded.surfaces, position)
    };
    let mut able: Vec<&MeshPosition> = positions.iter().filter(carries).collect();
    if able.is_empty() {
        able = positions.iter().filter(|s| s.load.si() > 0.0).collect();
    }
    let count = loaded.case.model.ehl.records.min(able.len());
    let last = able.len().saturating_sub(1);
    let steps = count.saturating_sub(1).max(1);
    // The nearest whole number of k/(count − 1) of the way.
    (0..count)
        .map(|k| able[(2 * k * last + steps) / (2 * steps)].clone())
        .collect()
}

fn contacts(
    loaded: &OperatingCase,
    positions: &[MeshPosition],
) -> Result<Vec<ReferenceContact>, PositionError> {
    let choices = &loaded.case.model.ehl;
    let numbered = positions.iter().enumerate();
    numbered
        .map(|(beginning, position)| {
            let settings = ReferenceSettings {
                record: RecordSettings {
                    cells: choices.cells,
                    length: choices.travel,
                    ..RecordSettings::default()
                },
                eyring_stress: None,
                with_heat: false,
                beginning,
                shortest_wave: None,
                inlet: Inlet::ByLoad,
            };
            Ok(ReferenceContact::at(loaded, position.clone(), &settings)?)
        })
        .collect()
}

fn solved(contact: &ReferenceContact) -> Result<PathRecord, PositionError> {
    let law = contact.record.friction.ok_or(ReferenceError::NoBaseOil)?;
    let used = Provenance::new();
    let solve = || -> Result<_, PositionError> {
        let record = transient::record(&contact.rough, &contact.record)?;
        Ok(PathRecord::new(contact, &record, &law))
    };
    let record = used.collect(solve)?;
    let tags = used.tags().into_iter().map(str::to_owned).collect();
    Ok(PathRecord { tags, ..record })
}
