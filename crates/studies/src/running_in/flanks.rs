//! Flanks that have run in, at a number of engagements, as files that a run reads.

use asperity::flanks::Surfaces;
use asperity::pipeline::HistoryState;
use asperity_core::{DomainError, Fault, Profile};
use asperity_report::tables::BODIES;
use serde::Serialize;

/// A trace of a run-in flank with the name of its file.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RunInTrace {
    pub file: String,
    trace: Profile,
}

/// Point of such a trace.
#[derive(Serialize)]
pub(super) struct FlankPointRow {
    x_um: f64,
    z_um: f64,
}

impl RunInTrace {
    /// The points of its file.
    pub fn points(&self) -> impl Iterator<Item = FlankPointRow> {
        let dx = self.trace.spacing().si();
        let heights = self.trace.heights().iter().enumerate();
        heights.map(move |(i, z)| FlankPointRow {
            x_um: 1e6 * dx * i as f64,
            z_um: 1e6 * z,
        })
    }
}

/// The traces of every tooth in every zone of the face.
pub(super) fn traces(surfaces: &Surfaces) -> Result<Vec<RunInTrace>, Fault> {
    let teeth = surfaces.teeth().unwrap_or([1, 1]);
    let zones = surfaces.zones();
    let mut found = Vec::new();
    for (body, name) in BODIES.iter().enumerate() {
        for tooth in 0..teeth[body] {
            for zone in 0..zones {
                let mut pair = [0, 0];
                pair[body] = tooth;
                let met = surfaces.of_teeth(pair, zone);
                let trace = met.traces().map_err(Fault::from)?[body].clone();
                let numbers = [(teeth[body], tooth), (zones, zone)];
                let numbers = numbers.into_iter().filter(|(count, _)| *count > 1);
                let numbers: String = numbers.map(|(_, k)| format!("_{}", k + 1)).collect();
                found.push(RunInTrace {
                    file: format!("{name}{numbers}.csv"),
                    trace,
                });
            }
        }
    }
    Ok(found)
}

/// The flanks after wear `worn`, between the states of a history: heights fall in proportion to the wear of a package.
pub(super) fn after<'a>(
    states: impl Iterator<Item = &'a HistoryState>,
    worn: f64,
) -> Result<Option<Surfaces>, Fault> {
    let states: Vec<&HistoryState> = states.collect();
    let Some(last) = states.last() else {
        return Ok(None);
    };
    let above = states.iter().position(|state| state.worn > worn);
    let Some((below, above)) = above.and_then(|k| Some((states[k.checked_sub(1)?], states[k])))
    else {
        return Ok(Some(last.surfaces.clone()));
    };
    let part = (worn - below.worn) / (above.worn - below.worn);
    let between = |teeth: [usize; 2], zone: usize| -> Result<[Profile; 2], Fault> {
        let both = [below, above].map(|state| state.surfaces.of_teeth(teeth, zone).traces());
        let [below, above] = [both[0].clone()?, both[1].clone()?];
        let of = |body: usize| -> Result<Profile, DomainError> {
            let pairs = below[body].heights().iter().zip(above[body].heights());
            let heights = pairs.map(|(a, b)| a + part * (b - a));
            Profile::new(below[body].spacing(), heights.collect())
        };
        Ok([of(0)?, of(1)?])
    };
    below.surfaces.with_traces_of_teeth(between).map(Some)
}
