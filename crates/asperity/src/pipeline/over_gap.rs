//! The contact of a position over its mean gap.

use asperity_core::provenance::Provenance;
use asperity_core::quantity::Length;

use super::stages::Stages;
use crate::contacts::Contacts;
use crate::lubrication::{RoughFilm, SmoothPosition};
use asperity_case::case::OperatingCase;
use asperity_case::error::{Error, PositionError};

/// Number of gaps.
const GAPS: usize = 10;
/// Least and largest gap over the gap of first touch.
const RANGE: [f64; 2] = [0.15, 0.7];

/// Contact of a position over its mean gap.
pub(crate) struct OverGap {
    /// Mean gaps.
    pub gaps: Vec<Length>,
    /// Share of the load on the asperities at each.
    pub shares: Vec<f64>,
    /// Flow in the inlet over the flow of a smooth gap, at each.
    pub flows: Vec<f64>,
    /// Standard deviation of the roughness left in the contact \[µm\], gap supplied without asperities over the smooth film,
    /// and mean gap \[µm\].
    pub contact: [f64; 3],
}

/// The contact of position `number` at `gaps`, or at gaps up to the first touch of the first window: a mean over all patches or windows
/// of traces. `None` if the load share does not follow from the contact.
///
/// # Errors
/// When a contact has no solution.
pub(crate) fn over_gap(
    case: &OperatingCase,
    contacts: &Contacts,
    number: usize,
    gaps: Option<&[Length]>,
) -> Result<Option<OverGap>, Error> {
    let stages = Stages::new(case, contacts, &|_, _| {}, Provenance::new())?;
    Ok(at_position(&stages, number, gaps).map_err(Box::new)?)
}

fn at_position(
    stages: &Stages<'_>,
    number: usize,
    gaps: Option<&[Length]>,
) -> Result<Option<OverGap>, PositionError> {
    let lubrication = stages.lubrication();
    let mut positions = stages.mesh.positions.iter();
    let Some(at) = positions.find(|at| at.number == number) else {
        return Ok(None);
    };
    let windows = stages.contacts.at(at)?;
    let position = lubrication.position(at, windows)?;
    let count = windows.len();
    let (mut shares, mut flows, mut contact) = (Vec::new(), Vec::new(), [0.0; 3]);
    let mut at_gaps = gaps.map(<[Length]>::to_vec).unwrap_or_default();
    let mut film = None;
    for (k, window) in windows.iter().enumerate() {
        let Some(solved) = position.offsets[k].solved else {
            return Ok(None);
        };
        if at_gaps.is_empty() {
            let touch = window.table()?.0.first_touch_gap();
            let [least, largest] = RANGE;
            let step = (largest - least) / (GAPS - 1) as f64;
            at_gaps.extend((0..GAPS).map(|k| touch * (least + step * k as f64)));
        }
        if lubrication.surfaces.begins_a_pair(k, count) {
            let (of_pair, ..) = lubrication.surfaces.met(at.zone, k, count);
            let of_position = SmoothPosition {
                at,
                film: &position.film,
            };
            film = RoughFilm::at(lubrication.case, lubrication.laws, of_pair, of_position)?;
        }
        let Some(film) = &mut film else {
            return Ok(None);
        };
        shares.resize(at_gaps.len(), 0.0);
        flows.resize(at_gaps.len(), 0.0);
        let part = 1.0 / count as f64;
        let sums = shares.iter_mut().zip(&mut flows);
        for ((share, flow), gap) in sums.zip(&at_gaps) {
            *share += part * window.share_at_gap(*gap)?;
            *flow += part * film.flow_factor(*gap, solved.attenuated_rms)?;
        }
        let [rms, gap] = [solved.attenuated_rms, solved.mean_gap].map(|of| 1e6 * of.si());
        for (sum, value) in contact.iter_mut().zip([rms, solved.inlet_factor, gap]) {
            *sum += part * value;
        }
    }
    Ok(Some(OverGap {
        gaps: at_gaps,
        shares,
        flows,
        contact,
    }))
}
