//! The number of offsets of a case that does not state one. It follows from the contacts only, so that it is the same for every
//! oil, speed and temperature and in every study.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | K | offsets of each pair of traces against each other | - |
//! | g_i | mean gap at position i: the mean over the offsets at φ = 0.28, at least 0.2 µm | m |
//! | φ_ik | asperity share of position i at offset k under the mean gap g_i | - |
//! | μ_ik | friction coefficient that represents it | - |
//! | w_i | line load times sliding per turn, times the contact line of position i | J |
//! | s_i | standard deviation of μ_ik over the offsets | - |
//! | n_max | independent windows of the traces | - |

use std::sync::Arc;

use asperity_core::cite;
use asperity_core::numerics::{deviation, mean};
use asperity_core::quantity::Length;
use asperity_core::task::par_map;

use super::inputs::WindowInputs;
use super::window_contact::WindowContact;
use crate::mesh::{MeshPosition, numbered};
use crate::sampling::{LossScatter, windows_of_traces};
use asperity_case::case::LEAST_OFFSETS;
use asperity_case::error::{Error, PositionError};

/// Thinnest mean gap under which the windows of a position are compared: a film from the middle of the range of gears.
const THINNEST: Length = Length::from_si(0.2e-6);
/// Friction coefficients of film and of asperities, own choice: at the low pressures of part load they scatter as the loss does; at high
/// pressures, where both coefficients are close, they ask for more offsets than the loss needs.
const FRICTION: [f64; 2] = [0.03, 0.09];
/// Standard error of the mean over the offsets that is sought, over the mean.
const SOUGHT: f64 = 0.01;
/// Most offsets.
const MOST: usize = 256;
/// Offsets for each independent window beyond which more say nothing new.
const OVERLAP: f64 = 4.0;

/// The windows of the first offsets at a position.
type OffsetWindows<'a> =
    &'a (dyn Fn(&MeshPosition) -> Result<&'a [Arc<WindowContact>], PositionError> + Sync);

/// The number of offsets for a standard error of 1 %, from the scatter of the first ones.
///
/// ```text
/// μ_ik = 0.03 (1 − φ_ik) + 0.09 φ_ik
/// K = min(256, max(K₀, min(⌈Σ(w_i s_i)²/(0.01 Σ w_i μ_i)²⌉, 4 n_max)))        [Adaptive-offsets]
/// ```
///
/// Each position has other places of the traces in contact, so that the scatters add in squares.
///
/// # Errors
/// With the number of the position, when a contact has no solution.
pub(super) fn offsets_needed(
    windows: &WindowInputs,
    first: OffsetWindows<'_>,
    positions: &[MeshPosition],
) -> Result<usize, Error> {
    cite!("Adaptive-offsets");
    let [film, asperities] = FRICTION;
    let of_position = |at: &MeshPosition| {
        let row = first(at)?;
        let windows = || row.iter().filter(|window| window.window.is_some());
        let gaps: Result<Vec<f64>, PositionError> = windows()
            .map(|window| {
                let gap = window.middle_gap();
                Ok(gap.map_err(|error| window.keeping(error, at))?.si())
            })
            .collect();
        let gap = mean(gaps?).max(THINNEST.si());
        let friction = windows().map(|window| {
            let share = window.share_at_gap(Length::from_si(gap));
            let share = share.map_err(|error| window.keeping(error, at))?;
            Ok(film * (1.0 - share) + asperities * share)
        });
        let friction = friction.collect::<Result<Vec<f64>, PositionError>>()?;
        let scatter = deviation(&friction).unwrap_or(0.0);
        let weight = at.weight * at.load.si() * at.mean_sliding();
        Ok([mean(friction.iter().copied()), scatter].map(|value| weight * value))
    };
    let found = numbered(par_map(positions, of_position))?;
    let scatter = LossScatter::from_positions(found.into_iter());
    let half_widths = positions.iter().map(|at| at.hertz.half_width.si());
    let widest = Length::from_si(half_widths.fold(0.0, f64::max));
    let independent = windows_of_traces(&windows.surfaces, windows.reach, widest);
    let wanted = (scatter.squares / (SOUGHT * SOUGHT))
        .ceil()
        .min(OVERLAP * independent.unwrap_or(f64::INFINITY));
    // Several pairs share the error.
    let of_each = (wanted / windows.surfaces.pairs() as f64).ceil() as usize;
    Ok(of_each.clamp(LEAST_OFFSETS, MOST))
}
