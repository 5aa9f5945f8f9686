//! The number of offsets of a case that does not state one.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | K | offsets of each pair of traces against each other | - |
//! | ω_i | share of the sliding loss that position i makes | - |
//! | s_i | standard deviation over the offsets of the loss of position i, over its mean | - |
//! | n_max | independent windows of the traces | - |

use std::borrow::Cow;

use asperity_core::cite;
use asperity_core::numerics::{deviation, mean};
use asperity_core::quantity::Length;

use crate::lubrication::LubricatedPosition;
use crate::sampling::{Scatter, windows_of_traces};
use asperity_case::case::{Formulation, LoadedCase};

/// Standard error of the mean over the offsets that is sought, over the mean.
const SOUGHT: f64 = 0.01;
/// Most offsets.
const MOST: usize = 256;
/// Offsets for each independent window beyond which more say nothing new.
const OVERLAP: f64 = 4.0;

/// Whether the number of offsets of `loaded` follows from its loss: the case states none, and its load share
/// follows from windows of traces whose place on the flank is not known.
pub fn chooses_offsets(loaded: &LoadedCase) -> bool {
    let (case, surfaces) = (&loaded.case, &loaded.surfaces);
    case.input.model.offsets.is_none()
        && case.formulation == Formulation::Corrected
        && case.load_share().supply().is_some()
        && surfaces.are_measured()
        && surfaces.placement().is_none()
}

/// `loaded` with this number of offsets, unless it states or must have another.
pub(super) fn with_offsets(loaded: &LoadedCase, offsets: usize) -> Cow<'_, LoadedCase> {
    if offsets == loaded.case.model.offsets || !chooses_offsets(loaded) {
        return Cow::Borrowed(loaded);
    }
    let mut more = loaded.clone();
    more.case.model.offsets = offsets;
    for used in &mut more.case.defaults {
        if used.key == "model.offsets" {
            used.value = offsets.to_string();
        }
    }
    Cow::Owned(more)
}

/// The number of offsets for a standard error of 1 %, from the scatter over the offsets of `positions`.
///
/// ```text
/// K = min(256, max(K₀, min(⌈Σ(ω_i s_i)²/0.01²⌉, 4 n_max)))                  [Adaptive-offsets]
/// ```
///
/// Each position has other places of the traces in contact, so that the scatters add in squares.
pub(super) fn offsets_needed(loaded: &LoadedCase, positions: &[LubricatedPosition]) -> usize {
    cite!("Adaptive-offsets");
    let least = loaded.case.model.offsets;
    let found = Scatter::of(positions.iter().map(|position| {
        let sliding = position.at.weight * position.at.mean_sliding();
        let losses = position
            .offsets
            .iter()
            .map(|offset| sliding * offset.friction_force);
        let losses: Vec<f64> = losses.collect();
        [
            mean(losses.iter().copied()),
            deviation(&losses).unwrap_or(0.0),
        ]
    }));
    let half_widths = positions
        .iter()
        .map(|position| position.at.hertz.half_width.si());
    let widest = Length::from_si(half_widths.fold(0.0, f64::max));
    let windows = windows_of_traces(loaded, widest).unwrap_or(f64::INFINITY);
    let wanted = (found.squares / (SOUGHT * SOUGHT))
        .ceil()
        .min(OVERLAP * windows);
    // Several pairs share the error.
    let of_each = (wanted / loaded.surfaces.pairs() as f64).ceil() as usize;
    of_each.max(least).min(MOST.max(least))
}
